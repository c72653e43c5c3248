"""Runs inside FreeCAD's window: a new f-rep solid accepts typing at once."""

import time

import FreeCADGui
import pytest
import window
from panels import Button, QtWidgets, document, frep, panels, silhouette
from pointer import click, type_text
from window import Heartbeat, clock, live, press, wait

from fieldfab_workbench import sources, work


def test_the_editor_is_open_at_once_and_no_typing_is_lost(document, panels, monkeypatch):
    waited, real = [], work.run
    monkeypatch.setattr(work, "run", lambda function, title: waited.append(title) or real(function, title))
    began = clock()
    FreeCADGui.runCommand("Fieldfab_NewFrepSolid")
    panel = panels[-1]
    assert not waited and clock() - began < 3, "nothing is computed before the panel is there"
    live(0.3)
    click(panel.text.viewport())
    QtWidgets.QApplication.processEvents()
    panel.text.selectAll()
    type_text("sphere(r = 7)")
    wait(lambda: panel.text.toPlainText() == "sphere(r = 7)", "what was typed")
    live(0.5)
    assert panel.text.hasFocus(), "the popup of completions leaves it the focus"
    assert not [box for box in QtWidgets.QApplication.topLevelWidgets()
                if isinstance(box, QtWidgets.QProgressDialog) and box.isVisible()]
    wait(lambda: panel.preview.stage == "final", "the solid")
    assert silhouette("new_solid") > 100, "it is in the picture"
    window.shot("new_solid_panel")
    press(Button.Ok)
    [solid] = document.Objects
    assert solid.isValid() and abs(solid.Volume.Value - 1436.8) < 15 and document.UndoCount == 1


SECONDS = 5  # duration of the slow meshes


@pytest.fixture
def slow(monkeypatch):
    """Each solid's mesh takes SECONDS, most of them at 95 percent of the progress."""
    real = sources.Source.mesh

    def mesh(self, progress=None, **settings):
        made, end = real(self, progress, **settings), time.monotonic() + SECONDS
        while time.monotonic() < end:
            if not progress(0.95, "sharpening edges"):
                raise work.Cancelled()
            time.sleep(0.02)
        return made

    monkeypatch.setattr(sources.Source, "mesh", mesh)


def dialogs():
    return [box for box in QtWidgets.QApplication.topLevelWidgets()
            if isinstance(box, QtWidgets.QProgressDialog) and box.isVisible()]


def click_on(button):
    [box] = [box for box in FreeCADGui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox)
             if box.isVisible() and box.button(button)]
    box.button(button).click()


def pressed(panels):
    """Returns the panel of a new solid after OK was pressed."""
    FreeCADGui.runCommand("Fieldfab_NewFrepSolid")
    live(0.3)
    panel = panels[-1]
    panel.text.setPlainText("difference(box(20, 20, 20), sphere(r = 12))")
    panel.voxel.setValue(0.25)
    live(0.8)
    click_on(Button.Ok)
    return panel


def test_ok_computes_beside_the_window(document, panels, slow):
    panel = pressed(panels)
    assert panel.making is not None and panel.bar_of_making.isVisible()
    assert not panel.text.isEnabled() and not dialogs() and QtWidgets.QApplication.activeModalWidget() is None
    with Heartbeat() as beat:
        live(1)
    # A blocked window would not respond until the mesh is finished.
    assert beat.longest < SECONDS / 5 and len(beat.gaps) > 5, beat.gaps[-5:]
    direction = FreeCADGui.ActiveDocument.ActiveView.getViewDirection()
    FreeCADGui.ActiveDocument.ActiveView.viewTop()
    wait(lambda: FreeCADGui.ActiveDocument.ActiveView.getViewDirection() != direction, "the view to turn")
    click_on(Button.Ok)  # a second click has no effect
    wait(lambda: panel.bar_of_making.maximum() == 0 and "sharpening edges" in panel.message.text(),
         "the bar to run to and fro at 95 percent")
    assert panel.making is not None
    window.shot("making")
    wait(lambda: not FreeCADGui.Control.activeDialog(), "the solid")
    [solid] = document.Objects
    assert solid.isValid() and solid.Triangles > 10_000 and document.UndoCount == 1 and not dialogs()


def test_cancel_meanwhile_takes_all_of_it_back(document, panels, slow):
    panel = pressed(panels)
    assert panel.making is not None
    click_on(Button.Cancel)
    began = time.monotonic()
    wait(lambda: not panel.making.is_alive(), "the end of the work")
    assert time.monotonic() - began < SECONDS / 2 and not document.Objects and not FreeCADGui.Control.activeDialog()


def test_apply_goes_on_to_the_solid_itself(document, panels, slow):
    solid = frep(document, "sphere(r = 5)")
    FreeCADGui.ActiveDocument.setEdit(solid.Name)
    live(0.3)
    panel = panels[-1]
    panel.text.setPlainText("difference(box(20, 20, 20), sphere(r = 12))")
    live(0.8)
    press(Button.Apply)
    assert solid.isValid() and solid.Triangles > 1000 and panel.text.isEnabled() and FreeCADGui.Control.activeDialog()
    wait(lambda: panel.preview.stage in ("final", "detail"), "the solid's own picture")
    press(Button.Cancel)
    assert solid.Expression == "sphere(r = 5)" and solid.isValid()


def test_a_solid_that_cannot_be_made_leaves_its_panel_open(document, panels):
    solid = frep(document, "sphere(r = 5)")
    FreeCADGui.ActiveDocument.setEdit(solid.Name)
    live(0.3)
    panels[-1].text.setPlainText("gyroid(period = 3)")
    live(0.8)
    click_on(Button.Ok)
    wait(lambda: panels[-1].making is None, "the mistake")
    live(0.1)
    assert FreeCADGui.Control.activeDialog() and "bounds" in panels[-1].message.text() and panels[-1].text.isEnabled()
    press(Button.Cancel)
    assert solid.Expression == "sphere(r = 5)" and solid.isValid()


def test_a_bar_does_not_stand():
    bar = QtWidgets.QProgressBar()
    gauge = work.Gauge(bar)
    for fraction in (0.5, 0.95):
        gauge.show(fraction)
        assert bar.value() == round(1000 * fraction) and bar.maximum() == 1000
    wait(lambda: gauge.show(0.95) or bar.maximum() == 0, "the bar to run to and fro")
    gauge.show(0.96)
    assert bar.value() == 960 and bar.maximum() == 1000
