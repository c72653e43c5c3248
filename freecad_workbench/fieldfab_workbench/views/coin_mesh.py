"""Meshes and boxes as Coin nodes, which panels add to the 3D view. Arrays are passed to Coin as the bytes of a binary
Inventor file."""

import numpy as np
from pivy import coin

from . import inventor


class MeshBytes:
    """Triangles for Coin. Made on any thread; `node()` is for the window's thread. `flat`: flat shading with sharp
    edges, otherwise smooth shading. `colours`: (n, 3) red, green, blue in 0 to 1, one row for each vertex, or None."""

    def __init__(self, vertices, triangles, flat=False, colours=None):
        self.count, self.flat = len(triangles), flat
        normals = (_flat_normals if flat else _smooth_normals)(vertices, triangles)
        index = np.full((len(triangles), 4), -1, ">i4")
        index[:, :3] = triangles
        self._material = (None if colours is None else inventor.node_bytes(
            "Material", "diffuseColor", len(colours), np.asarray(colours, ">f4")))
        self._rest = [inventor.node_bytes("Coordinate3", "point", len(vertices), np.asarray(vertices, ">f4")),
                      inventor.node_bytes("Normal", "vector", len(normals), np.asarray(normals, ">f4")),
                      inventor.node_bytes("IndexedFaceSet", "coordIndex", index.size, index)]

    def node(self, colour=(0.42, 0.62, 0.86)):
        """Returns a separator that cannot be picked. `colour` is used without vertex colours."""
        root, pick, hints = coin.SoSeparator(), coin.SoPickStyle(), coin.SoShapeHints()
        pick.style = coin.SoPickStyle.UNPICKABLE
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE  # without a shape type: two-sided lighting
        normals, colours = coin.SoNormalBinding(), coin.SoMaterialBinding()
        normals.value = coin.SoNormalBinding.PER_FACE if self.flat else coin.SoNormalBinding.PER_VERTEX_INDEXED
        if self._material is None:
            material = coin.SoMaterial()
            material.diffuseColor = colour
        else:
            material = inventor.read_node(self._material)
            colours.value = coin.SoMaterialBinding.PER_VERTEX_INDEXED
        for node in (pick, hints, material, colours, normals, *map(inventor.read_node, self._rest)):
            root.addChild(node)
        return root


def box_node(lower, upper, colour=(1.0, 0.75, 0.1)):
    """Returns the twelve edges of a box."""
    root, material, style, model = coin.SoSeparator(), coin.SoBaseColor(), coin.SoDrawStyle(), coin.SoLightModel()
    material.rgb = colour
    style.lineWidth = 2
    model.model = coin.SoLightModel.BASE_COLOR
    points, lines = coin.SoCoordinate3(), coin.SoIndexedLineSet()
    corners = [[(lower, upper)[i >> axis & 1][axis] for axis in range(3)] for i in range(8)]
    points.point.setValues(0, 8, corners)
    edges = [i for a in range(8) for axis in range(3) if not a >> axis & 1 for i in (a, a | 1 << axis, -1)]
    lines.coordIndex.setValues(0, len(edges), edges)
    for node in (model, material, style, points, lines):
        root.addChild(node)
    return root


def frame_node(origin, axes):
    """Returns the transform from a lattice's coordinates to its origin and axes in space."""
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = axes
    node = coin.SoMatrixTransform()
    node.matrix = coin.SbMatrix(ax, ay, az, 0, bx, by, bz, 0, cx, cy, cz, 0, *origin, 1)
    return node


def _flat_normals(vertices, triangles):
    """Returns the unit normal of each triangle."""
    a, b, c = (vertices[triangles[:, i]] for i in range(3))
    return inventor.unit(np.cross(b - a, c - a))


def _smooth_normals(vertices, triangles):
    """Returns for each vertex the area-weighted mean normal of its triangles."""
    a, b, c = (vertices[triangles[:, i]] for i in range(3))
    faces = np.cross(b - a, c - a)
    corners = triangles.ravel()
    sums = [np.bincount(corners, np.repeat(faces[:, axis], 3), len(vertices)) for axis in range(3)]
    return inventor.unit(np.stack(sums, 1))
