"""Runs inside FreeCAD's window: the cross-check's table, its colours and its legend."""

import csv
import time

import FreeCADGui
import numpy as np
import window
from window import Heartbeat, live, press, wait

from fieldfab_workbench import kernel
from fieldfab_workbench.deviations import colours, deviations, nice_reach
from fieldfab_workbench.objects import frep_solid
from fieldfab_workbench.objects import solid as solids
from fieldfab_workbench.panels import check_panel
from fieldfab_workbench.views import legend
from fieldfab_workbench.shim import QtCore, QtWidgets


def frep(document, text, voxel):
    solid = solids.create(frep_solid.FrepSolid, document)
    solid.Expression, solid.VoxelSize = text, voxel
    document.recompute()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(solid)
    FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    return solid


def count(picture, good):
    """Returns the number of matching pixels in the lower left corner of the 3D view, with the legend."""
    view = legend.view_widget()
    corner = view.mapTo(FreeCADGui.getMainWindow(), QtCore.QPoint(0, view.height()))
    return sum(good(picture.pixelColor(x, y)) for y in range(corner.y() - 220, corner.y() - 10, 2)
               for x in range(corner.x() + 10, corner.x() + 160, 2))


def test_the_table_the_colours_and_the_legend(document, monkeypatch, tmp_path):
    solid = frep(document, "difference(box(20, 20, 20), sphere(r = 12))", 1)
    made = []
    real = check_panel.CheckPanel.__init__
    monkeypatch.setattr(check_panel.CheckPanel, "__init__", lambda self, obj: made.append(self) or real(self, obj))
    steps, touched = document.UndoCount, solid.ViewObject.SwitchNode.whichChild.getValue()
    with Heartbeat() as beat:
        FreeCADGui.runCommand("Fieldfab_CrossCheck")
        panel = made[0]
        wait(lambda: panel.report is not None, what="the report")
    seen = window.shot("check")
    assert panel.table.rowCount() == len(panel.report.rows) > 10 and "passed" in panel.verdict.text()
    assert panel.table.item(0, 1).text().startswith(panel.report.rows[0].name) and panel.table.item(0, 0).text() == "✓"
    assert "on average" in panel.figures.text()

    def red(c):
        return c.red() > 150 and c.red() > c.green() + 60 and c.red() > c.blue() + 60

    def light(c):
        return c.lightness() > 235

    assert count(seen, light) > 3000 and count(seen, red) > 100, "the legend is there"
    panel.colour.setChecked(False)
    assert count(window.shot("check_without_colours"), light) < 300
    monkeypatch.setattr(QtWidgets.QFileDialog, "getSaveFileName", lambda *_: (str(tmp_path / "table.csv"), ""))
    panel.save.click()
    rows = list(csv.DictReader((tmp_path / "table.csv").open()))
    assert (len(rows) == len(panel.report.rows) and all(row["passed"] == "yes" for row in rows)
            and float(rows[-1]["bound"]) == panel.report.rows[-1].bound)
    panel.colour.setChecked(True)
    press(QtWidgets.QDialogButtonBox.Close)
    assert (not FreeCADGui.Control.activeDialog() and solid.ViewObject.SwitchNode.whichChild.getValue() == touched
            and document.UndoCount == steps)
    assert count(window.shot("check_closed"), light) < 300, "nothing of it is left"
    print(f"longest silence {1000 * beat.longest:.0f} ms")


def test_closing_ends_a_long_check(document, monkeypatch):
    frep(document, "sphere(r = 20)", 0.12)
    made = []
    real = check_panel.CheckPanel.__init__
    monkeypatch.setattr(check_panel.CheckPanel, "__init__", lambda self, obj: made.append(self) or real(self, obj))
    FreeCADGui.runCommand("Fieldfab_CrossCheck")
    wait(lambda: made[0].coloured is not None, what="the colours, which come first")
    with Heartbeat() as beat:
        live(0.3)
    task = made[0].work._task
    assert made[0].report is None and task.is_alive()
    press(QtWidgets.QDialogButtonBox.Close)
    closed = time.monotonic()
    wait(lambda: not task.is_alive(), "the thread's end")
    print(f"longest silence {1000 * beat.longest:.0f} ms, ended after {1000 * (time.monotonic() - closed):.0f} ms")
    assert not FreeCADGui.Control.activeDialog() and task.error.kind == "cancelled"


def test_deviations_are_those_that_were_planted():
    fieldfab = kernel.load()
    mesh = fieldfab.mesh(fieldfab.parse("box(20, 20, 20)"), voxel=1)
    ball = fieldfab.mesh(fieldfab.parse("sphere(r = 10)"), voxel=0.25)
    grown = fieldfab.Solid(fieldfab.parse("sphere(r = 10.3)"))
    off = deviations(grown, ball.vertices, ball.triangles)
    assert np.abs(off + 0.3).max() < 0.04 and nice_reach(off) == 0.5
    off = deviations(fieldfab.Solid(fieldfab.parse("box(20, 20, 20)")), mesh.vertices, mesh.triangles)
    assert np.abs(off).max() < 1e-5
    # The values are not distances: their slope is 10.
    steep = fieldfab.Solid(fieldfab.parse("10 * sphere(r = 10.3)"))
    assert np.abs(deviations(steep, ball.vertices, ball.triangles) + 0.3).max() < 0.04
    assert (colours(np.array([-1, 1]))[0][2] > 0.7) and (colours(np.array([-1, 1]))[1][0] > 0.7)
