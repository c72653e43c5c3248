"""Section plane that cuts the contents of a 3D view, so that the inside of solids is visible. The cut faces have one
flat colour."""

import ctypes
import functools

import FreeCAD
import FreeCADGui
from pivy import coin

from ..shim import QtCore
from ..words import tr
from .handles import immediate_sensor
from .part_view import is_there
from .scan_slices import ScanSlices
from .section_measure import SectionMeasure

CAP_COLOUR = (0.96, 0.66, 0.28)
FRAME_COLOUR = (0.75, 0.35, 0.05)
STOCK = "Fieldfab_stock"  # name of a playback's node
TICK = 300  # ms between checks for new nodes
SLICE = 40  # ms from a move of the plane to new pictures of scans
CULL_FACE, COUNTERCLOCKWISE = 0x0B44, 0x0901  # of OpenGL
HANDLE = 0.12  # size of the handle relative to the scene's diagonal


class Section:
    """Cuts the contents of a document's active view with a plane across the axis that points most towards the viewer.
    The plane starts in the middle; a handle moves it.

    In the cut of a closed surface, its back faces are visible exactly where the plane is inside the solid. They are
    rendered separately from the front faces and without lighting, as the cut face. This also works for previews and for
    a stock during playback. `close()` restores the view. Raises ValueError if no solid is visible."""

    def __init__(self, document):
        self._document, self._view = document, FreeCADGui.getDocument(document.Name).ActiveView
        self._scene = self._view.getSceneGraph()
        lower, upper = self._bounds()
        towards = -self._view.getViewDirection()
        axis = max(range(3), key=lambda i: abs(towards[i]))
        self.normal = FreeCAD.Vector(*(float(i == axis) for i in range(3))) * (1 if towards[axis] > 0 else -1)
        self.middle = (lower + upper) / 2
        self._clip = coin.SoClipPlane()
        self._nodes, self._caps, self._solids = self._handle(axis, lower, upper), self._caps_node(), coin.SoGroup()
        self._caps.addChild(self._solids)
        self._front = _overriding(coin.SoShapeHints, vertexOrdering=coin.SoShapeHints.COUNTERCLOCKWISE,
                                  shapeType=coin.SoShapeHints.SOLID)
        self._front.creaseAngle.setIgnored(True)
        self._slices, self._measured, self.measure = ScanSlices(document), coin.SoSeparator(), None
        # These precede the plane, which cuts all nodes after it.
        for place, node in enumerate((self._nodes, self._slices.root, self._measured, self._clip)):
            self._scene.insertChild(node, place)
        self._end = coin.SoCallback()
        self._end.setCallback(_show_back_faces)
        self._scene.addChild(self._caps)
        self._slice_timer = QtCore.QTimer(singleShot=True, interval=SLICE)
        self._slice_timer.timeout.connect(self._show_slices)
        self._look()
        self._sensor = immediate_sensor(self.dragger.translation, self._moved)
        self._moved()
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._look)
        self._timer.start(TICK)

    @property
    def offset(self):
        """Distance of the plane from the middle towards the viewer, mm."""
        return self.dragger.translation.getValue()[0] * self._size

    @property
    def at(self):
        """A point of the plane."""
        return self.middle + self.normal * self.offset

    def close(self):
        self._stop()
        for node in (self._nodes, self._slices.root, self._measured, self._clip, self._caps, self._end):
            self._scene.removeChild(node)
        self._take([])

    def _stop(self):
        self.measuring(False)
        self._sensor.detach()
        self._timer.stop()
        self._slice_timer.stop()
        self._slices.close()

    def _moved(self):
        self._clip.plane = coin.SbPlane(coin.SbVec3f(*(-self.normal)), coin.SbVec3f(*self.at))
        if self.measure:
            self.measure.forget()
        self._slice_timer.start()

    def _show_slices(self):
        self._slices.show(self.normal, self.at)

    def measuring(self, on):
        """Begins or ends measuring by clicks."""
        if on and not self.measure:
            self.measure = SectionMeasure(self, self._document)
            self._measured.addChild(self.measure.root)
        elif not on and self.measure:
            self.measure.close()
            self._measured.removeAllChildren()
            self.measure = None

    def _look(self):
        """Adapts to added and removed nodes."""
        if not is_there(self._document):
            self._timer.stop()
            self._sensor.detach()
            self._slice_timer.stop()
            self._slices.close()
            return
        self._show_slices()
        last = self._scene.getNumChildren() - 1
        if self._scene.findChild(self._end) != last:  # also behind what was added meanwhile
            if self._scene.findChild(self._end) >= 0:
                self._scene.removeChild(self._end)
            self._scene.addChild(self._end)
        wanted = self._wanted()
        if wanted != list(self._solids.getChildren() or ()):
            self._take(wanted)

    def _take(self, wanted):
        """Sets the nodes to cut. Each renders its front faces at its own place in the scene, and its back faces among
        the cut faces."""
        for node in self._solids.getChildren() or ():
            node.removeChild(self._front)
        self._solids.removeAllChildren()
        for node in wanted:
            node.insertChild(self._front, 0)
            self._solids.addChild(node)

    def _wanted(self):
        """Returns the nodes of everything that bounds solids."""
        meshes = [obj.ViewObject.RootNode for obj in self._document.Objects if hasattr(obj, "Mesh")]
        return meshes + [node for node in self._scene.getChildren() if node.getName().getString() == STOCK]

    def _bounds(self):
        measure = coin.SoGetBoundingBoxAction(coin.SbViewportRegion(*self._view.getSize()))
        found = coin.SbBox3f()
        for node in self._wanted():
            measure.apply(node)
            found.extendBy(measure.getBoundingBox())
        if found.isEmpty():
            raise ValueError(tr("The view shows no solid to cut"))
        return [FreeCAD.Vector(*corner.getValue()) for corner in (found.getMin(), found.getMax())]

    # Coin.
    def _handle(self, axis, lower, upper):
        """Returns a dragger along the normal, and the plane's outline, which follows it."""
        size = upper - lower
        self._size = HANDLE * size.Length
        root, place, scale, follow = coin.SoSeparator(), coin.SoTransform(), coin.SoScale(), coin.SoTranslation()
        place.translation = tuple(self.middle)
        place.rotation = coin.SbRotation(coin.SbVec3f(1, 0, 0), coin.SbVec3f(*self.normal))
        scale.scaleFactor = (self._size,) * 3
        self.dragger = coin.SoTranslate1Dragger()
        follow.translation.connectFrom(self.dragger.translation)
        frame, colour, light, points, lines = (
            coin.SoSeparator(), coin.SoBaseColor(), coin.SoLightModel(), coin.SoCoordinate3(), coin.SoLineSet())
        light.model, colour.rgb = coin.SoLightModel.BASE_COLOR, FRAME_COLOUR
        back = FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), self.normal).inverted()
        others = [FreeCAD.Vector(*(float(i == other) for i in range(3))) * size[other] * 0.55 / self._size
                  for other in range(3) if other != axis]
        corners = [back.multVec(others[0] * a + others[1] * b) for a, b in ((1, 1), (-1, 1), (-1, -1), (1, -1), (1, 1))]
        points.point.setValues(0, 5, [tuple(corner) for corner in corners])
        for node in (follow, light, colour, points, lines):
            frame.addChild(node)
        for node in (place, scale, self.dragger, frame):
            root.addChild(node)
        return root

    @staticmethod
    def _caps_node():
        """Returns a node that renders only back faces, in one colour and without lines. It cannot be picked."""
        root = coin.SoSeparator()
        for node in (
            _overriding(coin.SoShapeHints, vertexOrdering=coin.SoShapeHints.CLOCKWISE,
                        shapeType=coin.SoShapeHints.SOLID),
            _overriding(coin.SoMaterial, diffuseColor=CAP_COLOUR),
            _overriding(coin.SoMaterialBinding, value=coin.SoMaterialBinding.OVERALL),
            _overriding(coin.SoLightModel, model=coin.SoLightModel.BASE_COLOR),
            _overriding(coin.SoDrawStyle, linePattern=0),
            _overriding(coin.SoPickStyle, style=coin.SoPickStyle.UNPICKABLE),
        ):
            root.addChild(node)
        return root


def _show_back_faces(data, action):
    """Ends OpenGL's culling of faces at the end of the scene. Coin leaves it as it is, and FreeCAD's background and
    navigation cube would be culled."""
    if action.isOfType(coin.SoGLRenderAction.getClassTypeId()) and _opengl():
        _opengl().glDisable(CULL_FACE)
        _opengl().glFrontFace(COUNTERCLOCKWISE)


@functools.lru_cache(maxsize=None)
def _opengl():
    try:
        return ctypes.CDLL("libGL.so.1")
    except OSError:  # another system
        return None


def _overriding(kind, **fields):
    """Returns a node that overrides later nodes of its kind."""
    node = kind()
    for name, value in fields.items():
        setattr(node, name, value)
    node.setOverride(True)
    return node


_sections = []


def section_of(document):
    """Returns the Section of a document, or None."""
    _sections[:] = [each for each in _sections if is_there(each._document)]
    return next((each for each in _sections if each._document == document), None)


def toggle(document):
    """Adds a section to a document's view, or removes it. Raises ValueError if no solid is visible."""
    if shown := section_of(document):
        _sections.remove(shown)
        shown.close()
    else:
        _sections.append(Section(document))
