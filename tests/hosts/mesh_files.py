"""Readers of mesh files that share nothing with the kernel's."""

import re

import numpy as np


def read_ply(path):
    """Returns the vertices of a .ply file, by the names of their properties, and the triangles, (m, 3)."""
    data = path.read_bytes()
    head, body = data.split(b"end_header\n", 1)
    kinds = {"float": "<f4", "int": "<i4", "uchar": "u1"}
    count = {name: int(n) for name, n in re.findall(r"element (\w+) (\d+)", head.decode())}
    row = np.dtype([(name, kinds[kind])
                    for kind, name in re.findall(r"property (float|int|uchar) (\w+)\n", head.decode())])
    vertices = np.frombuffer(body, row, count["vertex"])
    faces = np.frombuffer(body[vertices.nbytes:], np.dtype([("n", "u1"), ("at", "<i4", 3)]), count["face"])
    assert len(body) == vertices.nbytes + faces.nbytes and (faces["n"] == 3).all()
    return vertices, faces["at"]
