"""Measuring on a section plane: a click gives the thickness of the wall, or the width of the gap, and the distance from
the click before."""

import FreeCAD
import FreeCADGui
import numpy as np
from pivy import coin

from .. import units
from ..outlines import chord_at, nearest_on
from ..words import tr
from .part_view import PartView

COLOUR = (0.05, 0.2, 0.75)
SNAP = 8  # pixels: a click so near to an outline is on it
FLAT = 1e-4  # tolerance of sections, relative to the solid's diagonal


class SectionMeasure:
    """Takes clicks until `close()`. `root`: the node of what was measured."""

    def __init__(self, section, document):
        self._section, self._view, self._document = section, PartView(document), document
        self.root, self._segments, self._at = coin.SoAnnotation(), None, None
        self._last = None  # the point that was clicked last
        self._view.tell_clicks(self.click)
        self.say(tr("Click on a cut face: its thickness there, and the distance from the last click"))

    def close(self):
        self._view.tell_clicks(None)
        self.forget()
        FreeCADGui.getMainWindow().statusBar().clearMessage()

    def forget(self):
        """Removes what was measured: the plane has moved."""
        self.root.removeAllChildren()
        self._segments = self._last = None

    @staticmethod
    def say(words):
        FreeCADGui.getMainWindow().statusBar().showMessage(words)

    # Coordinates on the plane.
    def _axes(self):
        normal = self._section.normal
        first = FreeCAD.Vector(0, 1, 0) if abs(normal.x) > 0.5 else FreeCAD.Vector(1, 0, 0)
        return first, normal.cross(first)

    def _flat(self, point):
        return np.array([FreeCAD.Vector(*point) * axis for axis in self._axes()])

    def _placed(self, flat):
        first, second = self._axes()
        normal = self._section.normal
        return first * float(flat[0]) + second * float(flat[1]) + normal * (self._section.at * normal)

    def _outline(self):
        """Returns the outline of all visible solids on the plane, as outlines.chord_at() takes it."""
        if self._segments is None:
            loops, plane = [], (self._section.at, self._section.normal)
            for obj in self._document.Objects:
                if hasattr(obj, "Mesh") and obj.ViewObject.Visibility:
                    loops += obj.Mesh.crossSections([plane], FLAT * obj.Mesh.BoundBox.DiagonalLength)[0]
            pieces = [np.hstack([flat[:-1], flat[1:]])
                      for flat in (np.array([self._flat(point) for point in loop]) for loop in loops) if len(flat) > 1]
            self._segments = np.vstack(pieces) if pieces else np.zeros((0, 4))
        return self._segments

    def click(self, origin, direction):
        """Measures where a ray meets the plane. Returns what was measured: the outlines.Chord or None, and the distance
        from the last click or None."""
        normal, origin, direction = self._section.normal, FreeCAD.Vector(*origin), FreeCAD.Vector(*direction)
        if abs(direction * normal) < 1e-6:
            return None
        point = origin + direction * ((self._section.at - origin) * normal / (direction * normal))
        segments, flat = self._outline(), self._flat(point)
        if len(segments):
            near, away = nearest_on(segments, flat)
            if away < SNAP * self._pixel(point):
                flat = np.array(near)
        chord = chord_at(segments, flat)
        distance = None if self._last is None else float(np.hypot(*(flat - self._last)))
        self._show(flat, chord, distance)
        self._last = flat
        return chord, distance

    def _pixel(self, point):
        """Returns the size of a pixel at a point, mm."""
        x, y = self._view.pixel_of(point)
        near, way = self._view.ray(x + 1, y)
        return float(FreeCAD.Vector(*point).distanceToLine(FreeCAD.Vector(*near), FreeCAD.Vector(*way)))

    def _show(self, flat, chord, distance):
        self.root.removeAllChildren()
        told = []
        if distance is not None:
            told.append(tr("{length} from the last point").format(length=units.told(distance, "mm", 4)))
            self._line(self._last, flat, "")
        if chord is not None:
            form = tr("{length} thick") if chord.solid else tr("{length} wide")
            words = form.format(length=units.told(chord.length, "mm", 4))
            told.insert(0, words)
            self._line(chord.start, chord.end, words)
        self.say("; ".join(told) or tr("Nothing is cut there"))

    def _line(self, start, end, words):
        """Adds a line between two places on the plane, with words at its middle."""
        branch, light, colour, style, points, line = (coin.SoSeparator(), coin.SoLightModel(), coin.SoBaseColor(),
                                                      coin.SoDrawStyle(), coin.SoCoordinate3(), coin.SoLineSet())
        light.model, colour.rgb = coin.SoLightModel.BASE_COLOR, COLOUR
        style.lineWidth, style.pointSize = 3, 7
        ends = [self._placed(each) for each in (start, end)]
        points.point.setValues(0, 2, [tuple(each) for each in ends])
        for node in (light, colour, style, points, line, coin.SoPointSet()):
            branch.addChild(node)
        if words:
            place, font, text = coin.SoTranslation(), coin.SoFont(), coin.SoText2()
            place.translation = tuple((ends[0] + ends[1]) * 0.5)
            font.size, text.string = 18, words
            for node in (place, font, text):
                branch.addChild(node)
        self.root.addChild(branch)
