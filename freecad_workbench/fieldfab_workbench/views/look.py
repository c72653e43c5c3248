"""How a solid looks besides its triangles: lines along sharp edges, and light from above. With FreeCAD's only light, at
the eye, a box would be a hexagon of one colour."""

import numpy as np
from pivy import coin

from .. import meshes
from . import inventor

LINE_COLOUR = (0.08, 0.09, 0.11)
MOST_TRIANGLES = 1_000_000  # half a second; beyond that a mesh has no lines
MOST_LINES = 200_000
LIGHT_FROM = (0.1, -0.45, 0.9)
FEWEST = 6  # lines that hang together: no solid has fewer edges than a tetrahedron
THIN = 0.05  # height of a triangle relative to its longest side


class Look:
    """Nodes in the scene of a mesh's view provider."""

    def __init__(self, view):
        light, behind, self._lines = coin.SoDirectionalLight(), coin.SoPolygonOffset(), coin.SoGroup()
        light.direction, light.intensity = [-part for part in LIGHT_FROM], 0.3
        # Triangles lie a little farther from the eye than they are, so that lines on them are whole.
        behind.styles, behind.factor, behind.units = coin.SoPolygonOffset.FILLED, 1, 1
        view.RootNode.insertChild(light, 0)
        view.RootNode.insertChild(behind, 0)
        self._modes = view.SwitchNode  # has its nodes only after this call

    def show(self, mesh):
        """Draws the sharp edges of a Mesh.Mesh. None shows none."""
        if self._modes.getNumChildren() and self._modes.getChild(0).findChild(self._lines) < 0:
            self._modes.getChild(0).addChild(self._lines)  # of the display mode Shaded
        self._lines.removeAllChildren()
        if mesh is not None and 0 < mesh.CountFacets <= MOST_TRIANGLES:
            points, pairs = sharp_edges(meshes.bms_of(mesh))
            pairs = without_specks(pairs)
            if 0 < len(pairs) <= MOST_LINES:
                self._lines.addChild(_lines(points, pairs))


def sharp_edges(data):
    """Returns the vertices (n, 3) of a .bms file's bytes, and the pairs of them (m, 2) between triangles whose normals
    differ by more than 30 degrees. A thin triangle has the mean normal of its neighbours: its own can be any."""
    points, corners, neighbours = meshes.arrays_of(data)
    places = points[corners]
    sides = np.roll(places, -1, axis=1) - places
    crosses, longest = np.cross(sides[:, 0], sides[:, 1]), np.einsum("tsx,tsx->ts", sides, sides).max(axis=1)
    thin = np.einsum("tx,tx->t", crosses, crosses) < (THIN * longest) ** 2
    around = neighbours[thin]
    known = np.where(around < len(corners), around, 0)
    for _ in range(2):  # neighbours may be thin, too
        crosses[thin] += (crosses[known] * (around < len(corners))[:, :, None]).sum(axis=1)
    normals = inventor.unit(crosses)
    triangle, side = np.nonzero((neighbours < len(corners)) & (neighbours > np.arange(len(corners))[:, None]))
    across = neighbours[triangle, side]
    sharp = np.einsum("ij,ij->i", normals[triangle], normals[across]) < inventor.CREASE
    triangle, side = triangle[sharp], side[sharp]
    return points, np.stack([corners[triangle, side], corners[triangle, (side + 1) % 3]], axis=1)


def without_specks(pairs):
    """Returns the pairs without groups of fewer than FEWEST that hang together: those are uneven triangles in curved
    faces."""
    if not len(pairs):
        return pairs
    group, a, b = np.arange(pairs.max() + 1), pairs[:, 0], pairs[:, 1]
    while True:  # each vertex takes the least number around it, and the number of that one
        least, before = np.minimum(group[a], group[b]), group.copy()
        np.minimum.at(group, a, least)
        np.minimum.at(group, b, least)
        group = group[group]
        if (group == before).all():
            return pairs[np.bincount(group[a])[group[a]] >= FEWEST]


def _lines(points, pairs):
    used, places = np.unique(pairs, return_inverse=True)
    index = np.full((len(pairs), 3), -1, ">i4")
    index[:, :2] = places.reshape(-1, 2)
    root, pick, colour, model = coin.SoSeparator(), coin.SoPickStyle(), coin.SoBaseColor(), coin.SoLightModel()
    pick.style, colour.rgb, model.model = coin.SoPickStyle.UNPICKABLE, LINE_COLOUR, coin.SoLightModel.BASE_COLOR
    for node in (pick, colour, model,
                 inventor.read_node(inventor.node_bytes("Coordinate3", "point", len(used), points[used].astype(">f4"))),
                 inventor.read_node(inventor.node_bytes("IndexedLineSet", "coordIndex", index.size, index))):
        root.addChild(node)
    return root
