"""Triangles as Coin nodes without a loop over triangles. Pivy fills fields number by number and never frees converted
values. Coin's reader of binary Inventor files accepts whole arrays, and reads from memory."""

import struct

import numpy as np

HEAD = b"#Inventor V2.1 binary  \n"
_GROUP = 2  # flag of nodes with children
CREASE = 0.86  # cosine of about 30 degrees: a larger angle between a vertex normal and its facet's means an edge


STEEP_CREASE = 0.17  # 80 degrees: in meshes without features, whose cells cut off edges, these look rounded, not ragged


def corner_normals(vertices, triangles, slopes, crease=CREASE):
    """Returns vertices, normals and triangles for rendering. `slopes`: the solid's gradients at the vertices. If the
    directions of a triangle's normal and of the gradient at its corner differ by more than the angle with the cosine
    `crease`, there is an edge. Then the corner becomes a separate vertex with the triangle's normal."""
    facets, normals = unit(_crosses(vertices, triangles)), unit(slopes)
    apart = np.einsum("tcx,tx->tc", normals[triangles], facets) < crease
    triangle, corner = np.nonzero(apart)
    drawn = triangles.astype(np.int32)
    drawn[triangle, corner] = len(vertices) + np.arange(len(triangle), dtype=np.int32)
    return (np.concatenate([vertices, vertices[triangles[triangle, corner]]]),
            np.concatenate([normals, facets[triangle]]), drawn)


def creased(vertices, triangles):
    """Returns vertices, normals and triangles for rendering flat faces, as FreeCAD renders an object's mesh. A corner's
    normal is the area-weighted mean over those triangles at its vertex whose normals are close to that of its own
    triangle."""
    crosses, corners = _crosses(vertices, triangles), triangles.ravel()
    facets, order, normals = unit(crosses), np.argsort(corners, kind="stable"), np.empty((len(corners), 3), np.float32)
    _, first, count = np.unique(corners[order], return_index=True, return_counts=True)
    for many in np.unique(count):  # all vertices with this number of corners at once
        here = order[first[count == many][:, None] + np.arange(many)]
        alike = np.einsum("vix,vjx->vij", facets[here // 3], facets[here // 3]) > CREASE
        normals[here] = np.einsum("vij,vjx->vix", alike, crosses[here // 3])
    return vertices[corners], unit(normals), np.arange(len(corners), dtype=np.int32).reshape(-1, 3)


def _crosses(vertices, triangles):
    """Returns the triangles' normals, with a length of twice the area."""
    sides = vertices[triangles[:, 1:]] - vertices[triangles[:, :1]]
    return np.cross(sides[:, 0], sides[:, 1])


def unit(vectors):
    lengths = np.sqrt(np.einsum("ij,ij->i", vectors, vectors))
    return np.divide(vectors, lengths[:, None], out=np.zeros_like(vectors), where=lengths[:, None] > 0)


def written(vertices, normals, triangles):
    """Returns the three arrays as the bytes of a binary Inventor file. For any thread."""
    corners = np.full((len(triangles), 4), -1, ">i4")
    corners[:, :3] = triangles
    nodes = (node_bytes("Normal", "vector", len(normals), normals.astype(">f4")),
             node_bytes("Coordinate3", "point", len(vertices), vertices.astype(">f4")),
             node_bytes("IndexedFaceSet", "coordIndex", corners.size, corners))
    return b"".join((HEAD, _name("Separator"), struct.pack(">iii", _GROUP, 0, len(nodes)), *nodes))


def node_bytes(kind, field, count, values):
    """Returns the bytes of a node with one array field. `values` are big-endian."""
    return b"".join((_name(kind), struct.pack(">ii", 0, 1), _name(field), struct.pack(">i", count), values.tobytes(),
                     struct.pack(">i", 0)))


def _name(word):
    data = word.encode()
    return struct.pack(">i", len(data)) + data + b"\0" * (-len(data) % 4)


def read_node(data):
    """Returns the Coin node in the bytes of node_bytes(). For the window's thread."""
    return read(HEAD + data).getChild(0)


def read(data):
    """Returns the Coin separator in the bytes of written(). For the window's thread."""
    from pivy import coin

    source = coin.SoInput()
    source.setBuffer(data)
    node = coin.SoDB.readAll(source)
    node.renderCulling = node.ON  # invisible parts are not rendered
    return node
