"""Arrows in the 3D view that change numbers of a panel which have a place."""

import math
import typing

import FreeCAD
import FreeCADGui
from pivy import coin

from ..shim import QtCore
from .part_view import is_there

SIZE = 0.12  # of an arrow, relative to the diagonal of what it belongs to
SHAFT, HEAD = (0.25, 1.0), (0.9, 1.25)  # where they begin and end, relative to the size
GRIP = 0.8  # a point of the arrow, relative to the size
COLOUR = (0.95, 0.55, 0.1)
ACTIVE = (1.0, 0.9, 0.3)
STEPS = 200  # at least so many steps along the diagonal


class Handle(typing.NamedTuple):
    """An arrow at `start() + read() * rate * along`, mm, in the document's coordinates. `write(value)` is called while
    it is dragged, with a rounded value. `rate`: mm for each unit of the value."""

    start: typing.Callable
    along: FreeCAD.Vector
    read: typing.Callable
    write: typing.Callable
    colour: tuple = COLOUR
    rate: float = 1.0


class Handles:
    """The arrows of one panel, in front of all solids. `refresh()` puts them where their numbers say; `close()` removes
    them."""

    def __init__(self, document, handles, diagonal):
        self._document, self._handles = document, handles
        self._scene = FreeCADGui.getDocument(document.Name).ActiveView.getSceneGraph()
        self.size, self._finest = SIZE * diagonal, diagonal / STEPS
        self._root, self.arrows = coin.SoAnnotation(), []
        self._sensors, self._quiet = [], True
        self._moving = None  # handle and dragger that were moved last
        on_top = coin.SoPickStyle()
        on_top.style = coin.SoPickStyle.SHAPE_ON_TOP
        self._root.addChild(on_top)
        for handle in handles:
            self._add(handle)
        self._scene.insertChild(self._root, 0)  # before the solids, which take clicks
        self.refresh()

    def _add(self, handle):
        branch, place, scale, arrow = coin.SoSeparator(), coin.SoTransform(), coin.SoScale(), coin.SoTranslate1Dragger()
        place.rotation = coin.SbRotation(coin.SbVec3f(1, 0, 0), coin.SbVec3f(*handle.along))
        scale.scaleFactor = (self.size,) * 3
        arrow.setPart("translator", _arrow(handle.colour))
        arrow.setPart("translatorActive", _arrow(ACTIVE))
        for part in ("feedback", "feedbackActive"):
            arrow.setPart(part, coin.SoSeparator())
        for node in (place, scale, arrow):
            branch.addChild(node)
        self._root.addChild(branch)
        self.arrows.append((handle, place, arrow))
        self._sensors.append(immediate_sensor(arrow.translation, lambda: self._moved(handle, arrow)))

    def _moved(self, handle, arrow):
        if self._quiet:
            return
        if self._moving is None:  # later, since this dragger is still at work
            QtCore.QTimer.singleShot(0, self._write)
        self._moving = handle, arrow

    def _write(self):
        (handle, arrow), self._moving = self._moving, None
        if self._root is None or not is_there(self._document):
            return
        value = arrow.translation.getValue()[0] * self.size / handle.rate
        step = 10 ** math.floor(math.log10(self._finest / handle.rate))
        rounded = round(round(value / step) * step, 9)
        if rounded != handle.read():
            handle.write(rounded)
            self.refresh()

    def refresh(self):
        if self._root is None or not is_there(self._document):
            return
        self._quiet = True
        for handle, place, arrow in self.arrows:
            place.translation = tuple(handle.start())
            arrow.translation = (handle.read() * handle.rate / self.size, 0, 0)
        self._quiet = False

    def dragged(self):
        """Whether the pointer has hold of an arrow."""
        return any(arrow.isActive.getValue() for *_, arrow in self.arrows)

    def close(self):
        for sensor in self._sensors:
            sensor.detach()
        if self._root is not None and is_there(self._document):
            self._scene.removeChild(self._root)
        self._root, self._sensors = None, []


def immediate_sensor(field, tell):
    """Returns a sensor that calls `tell()` at once whenever a field changes, until it is detached. By default sensors
    wait in a queue of Coin, which calls them even when they are gone meanwhile."""
    sensor = coin.SoFieldSensor(lambda *_: tell(), None)
    sensor.setPriority(0)
    sensor.attach(field)
    return sensor


def _arrow(colour):
    """Returns an arrow along x."""
    root, paint, turn = coin.SoSeparator(), coin.SoMaterial(), coin.SoRotation()
    paint.diffuseColor, paint.emissiveColor = colour, [0.4 * part for part in colour]
    turn.rotation = coin.SbRotation(coin.SbVec3f(0, 1, 0), coin.SbVec3f(1, 0, 0))  # Coin's solids stand along y
    shaft, head, easy, unseen = coin.SoCylinder(), coin.SoCone(), coin.SoCylinder(), coin.SoDrawStyle()
    shaft.radius, shaft.height = 0.06, SHAFT[1] - SHAFT[0]
    head.bottomRadius, head.height = 0.18, HEAD[1] - HEAD[0]
    easy.radius, easy.height, unseen.style = 0.25, SHAFT[1] - SHAFT[0], coin.SoDrawStyle.INVISIBLE  # to take hold of
    for node in (paint, turn, _lifted(SHAFT), shaft, _lifted(HEAD, SHAFT), head, _lifted(SHAFT, HEAD), unseen, easy):
        root.addChild(node)
    return root


def _lifted(ends, from_ends=(0, 0)):
    """Returns the move from the middle of one part of the arrow to that of another."""
    move = coin.SoTranslation()
    move.translation = (0, sum(ends) / 2 - sum(from_ends) / 2, 0)
    return move
