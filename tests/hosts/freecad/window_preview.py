"""Runs inside FreeCAD's window: previews during edits, their latency, and the responsiveness of the window."""

import pathlib
import time

import FreeCAD
import FreeCADGui
import pytest
import window
from panels import PART, Button, document, edit, frep, panels, shown, silhouette
from window import Heartbeat, clock, live, press, wait

from fieldfab_workbench import meshes, sources
from fieldfab_workbench.objects import frep_solid
from fieldfab_workbench.objects import solid as solids
from fieldfab_workbench.shim import QtWidgets
from fieldfab_workbench.views.preview import Preview

MTM = pathlib.Path(__file__).resolve().parents[2] / "data" / "frep" / "mtm_az" / "mtm_az_00.math"


class Busy(Heartbeat):
    """Also measures the working time of the window's thread between two beats."""

    def __enter__(self):
        self.busiest, self._worked = 0.0, time.thread_time()
        return super().__enter__()

    def _beat(self):
        super()._beat()
        worked = time.thread_time()
        self.busiest, self._worked = max(self.busiest, worked - self._worked), worked


def test_ok_takes_the_mesh_that_was_shown(document, panels, monkeypatch):
    solid = frep(document, PART)
    edit(solid)
    panels[-1].rows["size"].box.setValue(22)
    shown(panels[-1].preview, "final", "detail")
    wait(lambda: not panels[-1].preview._task.is_alive(),
         "the solid's own mesh, which follows blocks on a busy machine")
    made, real = [], sources.kept
    monkeypatch.setattr(sources, "kept", lambda key, make: real(key, lambda: made.append(key) or make()))
    press(Button.Ok)
    assert solid.size == 22 and solid.isValid() and not made


def test_cancel_gives_the_object_its_look_back(document, panels):
    solid = frep(document, PART)
    before = silhouette("look")
    children = solid.ViewObject.RootNode.getNumChildren()
    edit(solid)
    panels[-1].text.setPlainText("sphere(r = 3)")
    shown(panels[-1].preview, "final", "detail")
    assert silhouette("small") < before / 4
    press(Button.Cancel)
    assert (silhouette("look_again") == pytest.approx(before, rel=0.02)
            and solid.ViewObject.RootNode.getNumChildren() == children)
    edit(solid)
    panels[-1].text.setPlainText("sphere(r = 3)")
    shown(panels[-1].preview, "coarse", "finer", "final", "detail")
    FreeCADGui.Control.closeDialog()  # without its buttons
    live(0.5)
    assert silhouette("look_once_more") == pytest.approx(before, rel=0.02)


def test_a_document_may_be_closed_meanwhile(panels):
    document = FreeCAD.newDocument()
    edit(frep(document, PART))
    panels[-1].rows["size"].box.setValue(21)
    live(0.05)
    FreeCAD.closeDocument(document.Name)
    live(0.5)
    assert not panels[-1].preview._timer.isActive()


def test_the_first_picture_comes_within_100_ms(document, panels):
    """Time from a change to its picture; repeated until it succeeds, since other programs share the processor."""
    for name, text, other in (("mtm_az", MTM.read_text(), MTM.read_text().replace("f-4.5", "f-4.4")),
                              ("default", frep_solid.DEFAULT, frep_solid.DEFAULT.replace("2.4", "2.5"))):
        solid = frep(document, "box(10, 10, 2)" if name == "mtm_az" else "box(40, 40, 40)")
        preview, latencies = Preview(solid), [1.0]
        while min(latencies) > 0.1 and len(latencies) < 60:
            i, preview.latency = len(latencies), None
            preview.show(frep_solid.source_of_text(other if i % 2 else text), {})
            wait(lambda: preview.latency is not None)
            latencies.append(preview.latency)
        preview.close()
        print(name, [round(1000 * t) for t in latencies[1:]], "ms")
        assert min(latencies) < 0.1
        document.removeObject(solid.Name)


def test_the_window_answers_and_the_newest_wins(document, panels):
    solid = frep(document, "wall = 2.4\n" + frep_solid.DEFAULT.replace("wall = 2.4\n", ""), voxel=4)
    edit(solid)
    row, preview = panels[-1].rows["wall"], panels[-1].preview
    wait(lambda: panels[-1].handles.handles, "the arrows: Coin reads its draggers when it makes the first one")
    # Repeated until it succeeds: other programs share the processors, and software rendering adds to the wall-clock
    # time, so that its bound is wider.
    beats = []
    while len(beats) < 8 and not (beats and beats[-1].busiest < 0.1 and beats[-1].longest < 0.3):
        with Busy() as beat:
            for step in range(15):
                row.slider.setValue(400 + 10 * step + len(beats))
                live(0.02)
            live(0.4)
        beats.append(beat)
    print("longest beats", [round(1000 * b.longest) for b in beats], "ms, of which busy",
          [round(1000 * b.busiest) for b in beats], "ms")
    assert beats[-1].busiest < 0.1 and beats[-1].longest < 0.3
    row.box.setValue(1.5)
    panels[-1].voxel.setValue(1.5)
    wait(lambda: preview._refinement.settings == {"voxel": 1.5} and preview.stage == "coarse", "the newest")
    assert not preview._task.cancelled
    press(Button.Cancel)


def test_closer_is_finer(document, panels):
    solid = frep(document, PART, voxel=1)
    edit(solid)
    panels[-1].rows["size"].box.setValue(21)
    preview = panels[-1].preview
    shown(preview, "final", "detail")
    camera = FreeCADGui.ActiveDocument.ActiveView.getCameraNode()
    busiest = [1.0]
    while min(busiest) > 0.1 and len(busiest) < 6:  # other programs share the processors
        with Busy() as beat:
            camera.height = 3
            wait(lambda: preview.stage == "detail", "detail")
        busiest.append(beat.busiest)
        if beat.busiest > 0.1:
            camera.height = 400
            wait(lambda: preview.stage == "final", "the whole")
    print("busy", [round(1000 * busy) for busy in busiest[1:]], "ms at most while blocks are taken in")
    assert min(busiest) < 0.1
    seen = preview._refinement

    def finest():
        nearest = min(seen._blocks(), key=lambda block: seen._distance(block, preview._eye))
        return (max((level for _, level, _ in seen.details[nearest].parts(preview._eye)), default=0)
                if nearest in seen.shown else 0)

    wait(lambda: preview.stage == "detail" and finest() >= 2, "detail")
    window.shot("close")
    camera.height = 400
    wait(lambda: preview.stage == "final", "the whole again")
    press(Button.Cancel)


def test_combining_and_modifying_is_seen_at_once(document, panels):
    a = frep(document, "box(20, 20, 20)", 1)
    whole = silhouette("box")
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(a)
    FreeCADGui.runCommand("Fieldfab_Offset")
    live(0.5)
    panel = panels[-1]
    box, = (w for w in panel.form.findChildren(QtWidgets.QAbstractSpinBox) if w.isVisible())
    box.setProperty("rawValue", -5.0)
    shown(panel.preview, "final", "detail")
    assert silhouette("shrunk") == pytest.approx(whole / 4, rel=0.15)
    press(Button.Ok)
    assert (document.Objects[-1].Distance.Value == -5
            and document.Objects[-1].Volume.Value == pytest.approx(1000, rel=0.05))


def test_a_million_triangles_are_seen_soon(document):
    """Time from the mesh to the object and its first picture. The bound is generous: software rendering on shared
    processors."""
    solid = frep(document, "sphere(r = 5)")
    fieldfab = solids.kernel.load()
    mesh = fieldfab.mesh(fieldfab.parse("sphere(r = 50)"), voxel=0.42, max_error=0, features=False)
    began = clock()
    taken = meshes.to_freecad(mesh)
    made = clock()
    solid.Mesh = taken
    given = clock()
    live(0.01)
    print(f"{len(mesh.triangles)} triangles: {made - began:.3f} s to FreeCAD's form, "
          f"{given - made:.3f} s into the object, {clock() - given:.3f} s until it is drawn")
    assert len(mesh.triangles) > 1e6 and clock() - began < 3
