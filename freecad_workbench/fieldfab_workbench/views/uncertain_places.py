"""Boxes in the 3D view for the places where a solid's mesh may lack parts."""

import FreeCADGui
import numpy as np
from pivy import coin

from ..certainty import uncertain_places

AMBER = (1.0, 0.6, 0.0)
AROUND = 4  # size of the view relative to the place that it is zoomed to
EDGES = [i for a in range(8) for axis in range(3) if not a >> axis & 1 for i in (a, a | 1 << axis)]


class UncertainPlaces:
    """Boxes under the object's placement, visible through its mesh, since missing parts are mostly inside of it.
    `close()` removes them."""

    def __init__(self, obj):
        self._parent, places = obj.ViewObject.RootNode, uncertain_places(obj)
        self.count = len(places)
        self._node = _boxes(places)
        self._parent.addChild(self._node)

    def close(self):
        self._parent.removeChild(self._node)


def look_at_largest(obj):
    """Zooms the document's view to the largest place."""
    lower, upper = uncertain_places(obj)[0]
    placement = obj.getGlobalPlacement()
    points = coin.SoCoordinate3()
    points.point.setValues(0, 8, [tuple(placement.multVec(type(lower)(*corner))) for corner in _corners(lower, upper)])
    place = coin.SoSeparator()
    place.addChild(points)
    place.addChild(coin.SoPointSet())
    view = FreeCADGui.getDocument(obj.Document.Name).ActiveView
    view.getCameraNode().viewAll(place, coin.SbViewportRegion(*view.getSize()), AROUND)


def _corners(lower, upper):
    return [[(lower, upper)[i >> axis & 1][axis] for axis in range(3)] for i in range(8)]


def _boxes(places):
    root, pick, depth, model = coin.SoSeparator(), coin.SoPickStyle(), coin.SoDepthBuffer(), coin.SoLightModel()
    pick.style = coin.SoPickStyle.UNPICKABLE
    depth.test = False
    model.model = coin.SoLightModel.BASE_COLOR
    colour, style, points, lines = coin.SoBaseColor(), coin.SoDrawStyle(), coin.SoCoordinate3(), coin.SoIndexedLineSet()
    colour.rgb = AMBER
    style.lineWidth = 2
    corners = [corner for lower, upper in places for corner in _corners(lower, upper)]
    points.point.setValues(0, len(corners), corners)
    ends = np.array(EDGES, int).reshape(-1, 2)
    of_each = np.column_stack([ends, np.full(len(ends), -1)])
    index = np.concatenate([np.where(of_each < 0, -1, of_each + 8 * n) for n in range(len(places))]).ravel().tolist()
    lines.coordIndex.setValues(0, len(index), index)
    for node in (pick, depth, model, colour, style, points, lines):
        root.addChild(node)
    return root
