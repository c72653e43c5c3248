"""Access to FreeCAD's 3D view of a document, for playback."""

import FreeCADGui
import numpy as np
from pivy import coin

from ..shim import QtCore, QtGui, QtWidgets

STILL = 4  # greatest pointer movement during a click, pixels
TICK = 20  # ms between looks at the mouse button


def is_there(thing):
    """Returns False for a closed document or a deleted object."""
    try:
        return bool(thing.Name)
    except (ReferenceError, RuntimeError):  # FreeCAD's errors for deleted objects
        return False


class PartView:
    """Shows nodes in the active view of a document, moves the camera, and converts clicks to rays."""

    def __init__(self, document):
        self.view = FreeCADGui.getDocument(document.Name).ActiveView
        self._clicked, self._pressed = None, None

    def add(self, node):
        self.view.getSceneGraph().addChild(node)

    def remove(self, node):
        self.view.getSceneGraph().removeChild(node)

    def widget(self):
        """Returns the view's widget, to place other widgets over it."""
        wanted = self.view.getSize()
        seen = [w for w in FreeCADGui.getMainWindow().findChildren(QtWidgets.QGraphicsView) if w.isVisible()]
        return min(seen, key=lambda w: abs(w.width() - wanted[0]) + abs(w.height() - wanted[1]))

    def fit(self):
        """Fits the view to everything, in isometric direction."""
        self.view.viewIsometric()
        self.view.fitAll()

    def look_at(self, place):
        """Moves the camera so that a point is in the view's centre."""
        camera = self.view.getCameraNode()
        ahead = camera.orientation.getValue().multVec(coin.SbVec3f(0, 0, -1))
        camera.position = coin.SbVec3f(*(float(v) for v in place)) - ahead * camera.focalDistance.getValue()

    def ray(self, x, y):
        """Returns origin and direction of the ray through a pixel, counted from the lower left."""
        width, height = self.view.getSize()
        near, far = (np.array(p.getValue())
                     for p in self._volume().projectPointToLine(coin.SbVec2f(x / width, y / height)))
        return near, (far - near) / np.linalg.norm(far - near)

    def pixel_of(self, place):
        """Returns the pixel of a point, counted from the lower left."""
        width, height = self.view.getSize()
        seen = self._volume().projectToScreen(coin.SbVec3f(*(float(v) for v in place)))
        return seen[0] * width, seen[1] * height

    def _volume(self):
        width, height = self.view.getSize()
        volume = self.view.getCameraNode().getViewVolume(width / height)
        if width < height:
            volume.scale(height / width)
        return volume

    def tell_clicks(self, function):
        """Calls `function(origin, direction)` at each left click that is not a drag. None ends this."""
        kind = coin.SoMouseButtonEvent.getClassTypeId()
        if self._clicked is not None:
            self.view.removeEventCallbackPivy(kind, self._callback)
        self._clicked = function
        if function is not None:
            self._callback = self.view.addEventCallbackPivy(kind, self._mouse)

    def _mouse(self, callback):
        event = callback.getEvent()
        if event.getButton() != coin.SoMouseButtonEvent.BUTTON1:
            return
        at = tuple(event.getPosition()[axis] for axis in (0, 1))  # its getValue() is opaque in newer pivy
        if event.getState() == coin.SoButtonEvent.DOWN:
            self._pressed, self._cursor = at, QtGui.QCursor.pos()
            QtCore.QTimer.singleShot(TICK, self._look_for_release)
        elif self._pressed:
            self._released(max(abs(a - b) for a, b in zip(at, self._pressed)))

    def _look_for_release(self):
        """FreeCAD keeps the release of the button for itself where it is a selection."""
        if not self._pressed:
            return
        if QtWidgets.QApplication.mouseButtons() & QtCore.Qt.LeftButton:
            QtCore.QTimer.singleShot(TICK, self._look_for_release)
        else:
            self._released((QtGui.QCursor.pos() - self._cursor).manhattanLength())

    def _released(self, way):
        at, self._pressed = self._pressed, None
        if way <= STILL and self._clicked:
            self._clicked(*self.ray(*at))
