"""Conversion of meshes between the kernel and FreeCAD without a loop over triangles in Python. Meshes go through files,
because FreeCAD 0.20 loses part of what it writes to a Python stream."""

import os
import tempfile

import Mesh

from . import kernel

_HEAD = 272  # bytes of a .bms file before its vertices: magic and version, a comment, two counts


def to_freecad(mesh):
    """Returns a fieldfab.Mesh as a Mesh.Mesh."""
    with tempfile.TemporaryDirectory() as folder:
        return read_bms(write_bms(mesh, os.path.join(folder, "mesh.bms")))


def write_bms(mesh, path):
    """Writes a fieldfab.Mesh for read_bms(), on any thread. Returns the path, or None for an empty mesh."""
    if not len(mesh.triangles):
        return None
    with open(path, "wb") as file:
        file.write(mesh.bms())
    return path


def read_bms(path):
    """Returns the Mesh.Mesh in a file of write_bms(). `None` gives an empty mesh."""
    result = Mesh.Mesh()
    if path is not None:
        result.read(path)
    return result


def bms_of(mesh):
    """Returns a Mesh.Mesh as the bytes of a .bms file, in its own coordinates."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "mesh.bms")
        mesh.write(path)
        with open(path, "rb") as file:
            return file.read()


def from_bms(data):
    """Returns the fieldfab.Mesh in the bytes of a .bms file."""
    vertices, triangles, _ = arrays_of(data)
    return kernel.load().Mesh(vertices, triangles)


def arrays_of(data):
    """Returns vertices (n, 3), triangles (m, 3) and neighbours (m, 3) in the bytes of a .bms file: row t names the
    triangles beyond the sides from the first corner of triangle t to its second, to its third, and to its first."""
    import numpy as np  # imported late: the workbench must load quickly

    points, facets = (int(n) for n in np.frombuffer(data, "<u4", 2, _HEAD - 8))
    vertices = np.frombuffer(data, "<f4", 3 * points, _HEAD).reshape(-1, 3)
    rows = np.frombuffer(data, "<u4", 6 * facets, _HEAD + 12 * points).reshape(-1, 6)
    return vertices, rows[:, :3], rows[:, 3:]
