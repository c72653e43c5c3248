"""Preview of a solid while a panel is open. Meshes are computed in the background: first a coarse one, then finer
ones."""

import queue
import re
import time

import FreeCAD
import FreeCADGui

from .. import units, work
from ..certainty import doubt_of, with_doubt
from ..objects.solid import key_of
from ..shim import QtCore
from ..words import tr
from . import inventor
from .part_view import is_there
from .refinement import ANGLE, Refinement

BUDGET = 0.06  # seconds until the first picture after a change
TICK = 10  # ms between checks of the thread
REST = 0.15  # seconds without a change before finer meshes
STILL = 0.3  # seconds without camera movement before refinement for the view
FRAME = 0.05  # seconds to render a frame; limits the number of triangles
LEAST, MOST = 25_000, 400_000
PATIENCE = 3  # seconds for the final mesh before refinement for the view takes precedence
PIXELS = 3  # largest size of a cell on the screen


def _said(stage):
    return {"coarse": tr("Coarse preview: cells of {cell}"), "finer": tr("Preview: cells of {cell}"),
            "final": tr("Final mesh"),
            "divided": tr("Refining where you look"), "detail": tr("Refined where you look")}[stage]


class Preview:
    """`show(source, settings)` is called after each change; the newest wins. `close()` restores the object's display.
    `say(text, good)`, if given, receives the state: the resolution of the picture, or the error of a solid that cannot
    be made (the last valid picture stays)."""

    most = 50_000  # displayed triangles; all previews adapt this to the rendering time

    def __init__(self, obj, say=None, form=None):
        """`form`: the panel's widget. The preview closes when it is destroyed."""
        self.obj, self.say = obj, say or (lambda text, good: None)
        self.view = obj.ViewObject
        self.cells, self.guess = 20, self._bounds_of_object()
        self._faces_first = False  # whether the exact faces are fast enough for the first picture
        self._seen = obj.MadeFrom if obj.isValid() else None
        # For tests: stage of the picture; seconds from the last change to its first picture.
        self.stage, self.latency = "", None
        self._learnt = False  # whether `cells` follow from the time of a picture
        self._wanted, self._changed, self._began = None, 0.0, 0.0
        self._task, self._refinement, self._said = None, None, queue.SimpleQueue()
        self._paused = None  # (source, settings) to continue with after a pause
        # Whether the first mesh of a change is pending; time since which the picture has its final resolution.
        self._coarse, self._ready = False, None
        self._waiting, self._assembly, self._piece = [], None, None  # pending pictures; nodes of the first one
        self._drawing, self._undrawn, self._triangles = None, False, 0
        self._unseen = self.guess is None  # a new solid without any picture yet
        self._doubt = ""  # doubt about the final mesh, see certainty.doubt_of()
        self._eye, self._eye_moved, self._refined_for = None, 0.0, None
        self._put_in_place()
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._look)
        self._timer.start(TICK)
        if form is not None:
            form.destroyed.connect(self.close)

    def show(self, source, settings):
        """Starts at once, unless the same solid is shown already. A pending first mesh is finished, so that a moving
        slider always shows a picture."""
        key = key_of(source, settings)
        if key == self._seen:
            return
        self._seen = key
        self._wanted, self._changed = (source, dict(settings)), time.monotonic()
        self._look()

    def pause(self, on):
        """Pauses: the picture stays, and nothing is computed. Work continues after the pause, except for a complete
        picture."""
        if on:
            complete = self.stage in ("final", "detail") and self._wanted is None
            self._stop()
            self._paused = (None if complete else self._wanted
                            or self._refinement and (self._refinement.source, self._refinement.settings))
            self._wanted = self._ready = None
        else:
            self._wanted, self._paused = self._wanted or self._paused, None

    def close(self, *_):
        if not self._timer.isActive():
            return
        self._timer.stop()
        self._stop()
        try:
            self.view.RootNode.removeChild(self._root)
            if self._own.whichChild.getValue() < 0:
                self._own.whichChild = self._own_child
        except (ReferenceError, RuntimeError, AttributeError):
            pass  # the object was deleted together with its view

    # Coin.
    def _put_in_place(self):
        from pivy import coin

        self._root, self._solid = coin.SoSeparator(), coin.SoSeparator()
        material, hints, pick = coin.SoMaterial(), coin.SoShapeHints(), coin.SoPickStyle()
        material.diffuseColor = self.view.ShapeColor[:3]
        material.transparency = self.view.Transparency / 100
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        pick.style = coin.SoPickStyle.UNPICKABLE
        before, after = coin.SoCallback(), coin.SoCallback()
        before.setCallback(lambda data, action: self._begin_drawing(action))
        after.setCallback(lambda data, action: self._end_drawing())
        for node in (pick, material, hints, before, self._solid, after):
            self._root.addChild(node)
        self.view.RootNode.addChild(self._root)
        # Switch between an object's display modes; -1 hides all.
        self._own = next(node for node in self.view.RootNode.getChildren() if isinstance(node, coin.SoSwitch))
        self._own_child = self._own.whichChild.getValue()

    def _begin_drawing(self, action):
        from pivy import coin

        if action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
            coin.SoCacheElement.invalidate(action.getState())  # otherwise Coin would render from a cache
            self._drawing = self._drawing or time.monotonic()

    def _end_drawing(self):
        if self._drawing is not None:
            QtCore.QTimer.singleShot(0, self._learn)  # after the frame is on the screen

    def _learn(self):
        """Adapts the number of triangles to the rendering time of the frame."""
        if self._drawing is None or self._refinement is None:
            return
        now, shown = time.monotonic(), self._triangles
        seconds, self._drawing = now - self._drawing, None
        allowed = shown * FRAME / seconds
        if seconds > FRAME or allowed > Preview.most:
            Preview.most = int(min(MOST, max(LEAST, min(allowed, 4 * Preview.most))))
        if self._undrawn:
            self._undrawn, self._learnt, self.latency = False, True, now - self._began
            self.cells = int(min(64, max(8, self.cells * min(1.5, max(0.5, (BUDGET / self.latency) ** 0.5)))))

    def _bounds_of_object(self):
        mesh = self.obj.Mesh.copy()
        if not mesh.CountFacets:
            return None
        mesh.Placement = FreeCAD.Placement()
        box = mesh.BoundBox
        return (box.XMin, box.YMin, box.ZMin, box.XMax, box.YMax, box.ZMax)

    # Methods for the window's thread. Each takes a few ms at most.
    def _look(self):
        if not is_there(self.obj):
            self.close()
            return
        self._take()
        self._assemble()
        self._watch_camera()
        if self._wanted is not None and not (self._task and self._task.is_alive() and self._coarse):
            self._stop()
            source, settings = self._wanted
            self._wanted, self._began, self._doubt = None, self._changed, ""
            self._refinement = Refinement(source, settings, self.guess, self.cells, Preview.most, self._faces_first,
                                          smooth=not self._learnt)
            self._refined_for, self._coarse, self._ready = None, True, None
            self._start(self._whole)
        elif self._needs_detail():
            self._task.cancel()
            if not self._task.is_alive():  # a Refinement is for one thread at a time
                self._stop()
                self._refined_for = self._eye
                self._start(self._detail)

    def _stop(self):
        if self._task:
            self._task.cancel()
        self._said, self._waiting, self._assembly = queue.SimpleQueue(), [], None

    def _start(self, job):
        refinement, eye, said = self._refinement, self._eye, self._said

        def work_on_it(progress):
            try:
                for step in job(refinement, eye, progress):
                    said.put(step)
            except work.Cancelled:
                pass
            except Exception as error:  # errors of any kind go to the panel
                if getattr(error, "kind", "") != "cancelled":
                    said.put(("failed", str(error)))

        self._task = work.Task(work_on_it)
        self._task.start()

    def _take(self):
        while not self._said.empty():
            stage, given = self._said.get()
            if stage == "failed":
                self._coarse = False
                self.say(given, False)
            elif stage == "bounds":
                self.guess = given
                self._ready = self._ready or time.monotonic()
            elif stage == "doubt":
                self._doubt = given
                if given and self.stage:
                    self._say_stage()
            else:
                self._waiting.append((stage, given))

    def _assemble(self):
        """Adds pieces to the scene for a few milliseconds. The pieces of a whole solid become visible together."""
        from pivy import coin

        end = time.monotonic() + 0.008
        while self._waiting and time.monotonic() < end:
            stage, picture = self._waiting[0]
            if self._assembly is None:
                self._assembly, self._piece = (
                    self._solid if stage == "detail" else coin.SoSeparator(), coin.SoSeparator())
            piece, parts = next(iter(picture.items()), (None, None))
            if parts:
                self._piece.addChild(inventor.read(parts.pop()))
            elif piece is not None:
                self._add(piece, picture)
            else:
                self._waiting.pop(0)
                self._come_to_light(stage)

    def _add(self, piece, picture):
        """Adds a complete piece, or replaces the piece with the same name."""
        from pivy import coin

        del picture[piece]
        name = "piece_" + re.sub(r"\W+", "_", str(piece)).strip("_")
        self._piece.setName(name)
        old = [child for child in self._assembly.getChildren() or () if child.getName().getString() == name]
        if old:
            self._assembly.replaceChild(old[0], self._piece)
        else:
            self._assembly.addChild(self._piece)
        self._piece = coin.SoSeparator()

    def _come_to_light(self, stage):
        if self._assembly is not self._solid:
            self._root.replaceChild(self._solid, self._assembly)
            self._solid = self._assembly
        self._assembly, self.stage, self._triangles = None, stage, self._refinement.triangles
        self._own.whichChild = -1
        if self._unseen and self._triangles:
            self._unseen = False
            FreeCADGui.SendMsgToActiveView("ViewFit")
        if stage == "coarse":
            self._coarse, self._undrawn = False, True
        took = self._refinement.source.faces_took
        self._faces_first = took < BUDGET if took is not None else self._faces_first
        self._say_stage()

    def _say_stage(self):
        words = _said("final" if self._refinement.exact else self.stage).format(
            cell=units.told(self._refinement.voxel, digits=3))
        self.say(*with_doubt(words, self._doubt))

    def _watch_camera(self):
        eye = self._find_eye()
        if eye != self._eye:
            self._eye, self._eye_moved = eye, time.monotonic()

    def _find_eye(self):
        """Returns the camera's position in the object's own coordinates. For an orthographic camera, returns the
        equivalent position of a perspective camera. None without a view."""
        try:
            view = FreeCADGui.getDocument(self.obj.Document.Name).ActiveView
            camera, height = view.getCameraNode(), view.getSize()[1]
        except (AttributeError, NameError, ReferenceError, RuntimeError):
            return None
        at, towards = FreeCAD.Vector(*camera.position.getValue().getValue()), view.getViewDirection()
        if hasattr(camera, "height"):
            at = at + towards * camera.focalDistance.getValue() - towards * (
                PIXELS * camera.height.getValue() / height / ANGLE)
        return tuple(self.obj.getGlobalPlacement().inverse().multVec(at))

    def _needs_detail(self):
        still = time.monotonic() - self._eye_moved > STILL
        ready = self._ready and not self._waiting and self._eye is not None
        ready = ready and (not self._task.is_alive() or time.monotonic() - self._ready > PATIENCE)
        return (ready and still and self._refined_for != self._eye
                and (self._refinement.in_blocks or self._refinement.is_coarse_for(self._eye)))

    # Jobs for the background thread.
    @staticmethod
    def _whole(refinement, eye, progress):
        yield "coarse", refinement.coarse(progress)
        end = time.monotonic() + REST
        while time.monotonic() < end:
            time.sleep(0.01)
            if not progress(0, ""):
                return
        for pieces in refinement.finer(progress):
            yield "finer", pieces
        yield "bounds", refinement.extent
        for pieces in refinement.final(progress):
            yield "final", pieces
        yield "doubt", refinement.doubt
        yield "bounds", refinement.extent

    @staticmethod
    def _detail(refinement, eye, progress):
        if refinement.is_coarse_for(eye):
            if not refinement.in_blocks:
                yield "divided", refinement.divided(progress)
            for pieces in refinement.detail(eye, progress):
                yield "detail", pieces
            mesh = refinement.source.mesh(progress, **refinement.settings)  # the recompute will need it
            yield "doubt", doubt_of(mesh)
            if not refinement.suffices(mesh, eye):
                return
        for pieces in refinement.final(progress):
            yield "final", pieces
        yield "doubt", refinement.doubt
