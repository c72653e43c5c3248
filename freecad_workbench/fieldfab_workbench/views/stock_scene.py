"""Scene of a playback in the 3D view: the stock in pieces, the tool, and a marked point."""

import numpy as np
from pivy import coin

from .coin_fields import fill
from .section import STOCK

TOOL_LOOKS = {"cutting": ((0.80, 0.68, 0.30), 0.0), "shank": ((0.52, 0.54, 0.57), 0.0),
              "holder": ((0.30, 0.32, 0.36), 0.45)}
MARK_COLOUR = (0.90, 0.10, 0.35)


class Surface:
    """A face set with a colour for each vertex."""

    def __init__(self):
        self.arrays = None  # displayed vertices, normals, corners, cuts
        self.node = coin.SoSeparator()
        self.look, self.faces = coin.SoVertexProperty(), coin.SoIndexedFaceSet()
        self.look.normalBinding = self.look.materialBinding = coin.SoVertexProperty.PER_VERTEX_INDEXED
        self.faces.vertexProperty = self.look
        self.node.addChild(self.faces)

    def show(self, arrays, colours):
        self.arrays = arrays
        fill(self.look.vertex, arrays[0])
        fill(self.look.normal, arrays[1])
        fill(self.look.orderedRGBA, colours)
        fill(self.faces.coordIndex, arrays[2].reshape(-1))


class StockScene:
    """`root` is a node for a scene graph. Everything is in part coordinates; `turn` transforms them to the
    machine's."""

    def __init__(self):
        self.root, self.turn = coin.SoSeparator(), coin.SoMatrixTransform()
        self.root.renderCaching = coin.SoSeparator.OFF
        self.root.setName(STOCK)
        self.root.addChild(self.turn)
        self.stock, self.pieces, self.whole = coin.SoSwitch(), {}, Surface()
        self.pieces_node = coin.SoGroup()
        for node in (self.pieces_node, self.whole.node):
            self.stock.addChild(node)
        self.root.addChild(self._stock_node())
        self.paths = coin.SoSwitch()
        self.root.addChild(self.paths)
        self.tool, self.tool_place, self.tool_parts = coin.SoSwitch(), coin.SoTransform(), {}
        self.root.addChild(self._tool_node())
        self.mark, self.mark_place, self.mark_size = coin.SoSwitch(), coin.SoTranslation(), coin.SoSphere()
        self.root.addChild(self._mark_node())
        self.stock.whichChild, self.tool.whichChild, self.mark.whichChild = 0, -3, -1

    def _stock_node(self):
        """Returns the stock's node with a small depth offset, so that coincident parts and paths are visible in front
        of it."""
        behind, group = coin.SoPolygonOffset(), coin.SoSeparator()
        behind.factor, behind.units = 1.0, 1.0
        self.stock_shown = coin.SoSwitch()
        self.stock_shown.addChild(self.stock)
        for node in (self._hints(), behind, self.stock_shown):
            group.addChild(node)
        self.stock_shown.whichChild = -3
        return group

    @staticmethod
    def _hints():
        hints = coin.SoShapeHints()
        hints.vertexOrdering, hints.shapeType, hints.faceType = (
            coin.SoShapeHints.COUNTERCLOCKWISE, coin.SoShapeHints.SOLID, coin.SoShapeHints.CONVEX)
        return hints

    def _tool_node(self):
        self.tool_group = coin.SoSeparator()
        self.tool_group.addChild(self.tool_place)
        edges = self._hints()
        edges.creaseAngle = 0.6  # smooth around the axis, sharp at edges
        self.tool_group.addChild(edges)
        for role, (colour, transparency) in TOOL_LOOKS.items():
            part, material, points, faces = (
                coin.SoSwitch(), coin.SoMaterial(), coin.SoCoordinate3(), coin.SoIndexedFaceSet())
            material.diffuseColor, material.specularColor, material.shininess, material.transparency = (
                colour, (0.5, 0.5, 0.5), 0.5, transparency)
            group = coin.SoSeparator()
            for node in (material, points, faces):
                group.addChild(node)
            part.addChild(group)
            part.whichChild = -3
            self.tool_parts[role] = (part, points, faces)
            self.tool_group.addChild(part)
        self.tool.addChild(self.tool_group)
        return self.tool

    def _mark_node(self):
        group, material = coin.SoAnnotation(), coin.SoMaterial()  # visible through other objects
        material.diffuseColor, material.emissiveColor, material.transparency = MARK_COLOUR, MARK_COLOUR, 0.35
        for node in (self.mark_place, material, self.mark_size):
            group.addChild(node)
        self.mark.addChild(group)
        return self.mark

    def show_pieces(self, pieces):
        """Updates changed pieces: {index: (arrays, colours)}."""
        for index, (arrays, colours) in pieces.items():
            if index not in self.pieces:
                self.pieces[index] = Surface()
                self.pieces_node.addChild(self.pieces[index].node)
            self.pieces[index].show(arrays, colours)
        self.stock.whichChild = 0

    def show_whole(self, arrays=None, colours=None):
        """Shows the finished stock as one surface. Without arguments, shows the surface of the last call."""
        if arrays is not None:
            self.whole.show(arrays, colours)
        self.stock.whichChild = 1

    def show_tool(self, parts):
        """Sets the tool's parts: {role: arrays}, with the tip at the origin and the axis along z."""
        for role, (vertices, _, corners) in parts.items():
            _, points, faces = self.tool_parts[role]
            fill(points.point, vertices)
            fill(faces.coordIndex, corners.reshape(-1))

    def move_tool(self, tip, axis):
        self.tool_place.translation = tuple(tip)
        self.tool_place.rotation = coin.SbRotation(coin.SbVec3f(0, 0, 1), coin.SbVec3f(*axis))

    def set_seen(self, role, seen):
        self.tool_parts[role][0].whichChild = -3 if seen else -1

    def show_stock(self, seen):
        self.stock_shown.whichChild = -3 if seen else -1

    def show_paths(self, nodes=()):
        """Shows paths as Coin nodes. Without nodes, hides the paths."""
        if nodes:
            self.paths.removeAllChildren()
            for node in nodes:
                self.paths.addChild(node)
        self.paths.whichChild = -3 if nodes else -1

    def set_turn(self, matrix):
        """Sets the (4, 4) matrix from part to machine coordinates."""
        self.turn.matrix = coin.SbMatrix(*(float(v) for v in np.asarray(matrix).T.reshape(-1)))  # Coin uses row vectors

    def set_mark(self, place=None, size=1.0):
        """Marks a point in part coordinates. None removes the mark."""
        if place is not None:
            self.mark_place.translation, self.mark_size.radius = tuple(place), size
        self.mark.whichChild = -1 if place is None else 0

    def cut_hit_by(self, origin, direction):
        """Returns the point and the cut at which a ray, in part coordinates, first enters the stock, or None if it
        misses."""
        best = None
        for piece in self.pieces.values():
            vertices, _, corners, cuts = piece.arrays
            hit = first_hit(vertices, corners, origin, direction)
            if hit is not None and (best is None or hit[0] < best[0]):
                best = (hit[0], int(cuts[hit[1]]))
        return best and (np.asarray(origin) + best[0] * np.asarray(direction), best[1])


def first_hit(vertices, corners, origin, direction):
    """Returns the distance along a ray to the first triangle that it enters from outside, and the triangle's corner
    nearest to the point. None without a hit."""
    if not len(corners):
        return None
    origin, direction = np.asarray(origin, float), np.asarray(direction, float)
    with np.errstate(divide="ignore", invalid="ignore"):
        spans = np.sort(np.stack([vertices.min(0) - origin, vertices.max(0) - origin]) / direction, axis=0)
    if np.nanmax(spans[0]) > np.nanmin(spans[1]) + 1e-6:
        return None  # misses the bounding box
    a, b, c = (vertices[corners[:, k]].astype(float) for k in range(3))
    with np.errstate(divide="ignore", invalid="ignore"):
        ab, ac = b - a, c - a
        across = np.cross(direction, ac)
        scale = (ab * across).sum(1)
        off = origin - a
        u = (off * across).sum(1) / scale
        over = np.cross(off, ab)
        v = (over * direction).sum(1) / scale
        far = (over * ac).sum(1) / scale
        met = np.flatnonzero((scale > 0) & (u >= 0) & (v >= 0) & (u + v <= 1))  # only front faces
    if not len(met):
        return None
    nearest = met[np.argmin(far[met])]
    place = origin + far[nearest] * direction
    three = corners[nearest, :3]
    return far[nearest], three[np.argmin(((vertices[three] - place) ** 2).sum(1))]
