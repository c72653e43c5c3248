"""Runs inside FreeCAD's window: panels with a unit scheme in inches."""

import pathlib
import re

import FreeCAD
import FreeCADGui
import pytest
import window
from panels import Button, document, edit, frep, panels, shown
from pointer import click, type_text
from simulating import opened, simulated
from window import live, press, wait
from window_wheel import KINDS

from fieldfab_workbench import files, units
from fieldfab_workbench.objects import cam_tool
from fieldfab_workbench.panels import check_panel
from fieldfab_workbench.panels.measures import MeasureBox
from fieldfab_workbench.shim import QtCore, QtWidgets
from fieldfab_workbench.views.legend import Legend

US_CUSTOMARY, INTERNAL = 2, 0
CT = pathlib.Path(__file__).resolve().parents[2] / "data" / "ct"
METRIC = re.compile(r"\d *mm\b|\(mm|, mm\b|\bmm[³/]|\u2300 mm")


def use_units(schema):
    """Chooses units as in the preferences; in FreeCAD 1.x each new document takes them over."""
    FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units").SetInt("UserSchema", schema)
    FreeCAD.Units.setSchema(schema)


@pytest.fixture(autouse=True)
def inches():
    use_units(US_CUSTOMARY)
    yield
    use_units(INTERNAL)


def texts(form):
    """Returns all texts of a panel, including tooltips."""
    for widget in form.findChildren(QtWidgets.QWidget):
        yield widget.toolTip()
        if isinstance(widget, (QtWidgets.QLabel, QtWidgets.QAbstractButton, QtWidgets.QLineEdit)):
            yield widget.text()
            yield getattr(widget, "placeholderText", str)()
        elif isinstance(widget, QtWidgets.QAbstractSpinBox):
            yield widget.text()
        elif isinstance(widget, (QtWidgets.QTableWidget, QtWidgets.QTreeWidget)):
            model = widget.model()
            yield from (str(model.headerData(column, QtCore.Qt.Horizontal)) for column in range(model.columnCount()))
            yield from (str(model.index(row, column).data()) for row in range(model.rowCount())
                        for column in range(model.columnCount()))


def metric(form):
    return sorted({text for text in texts(form) if METRIC.search(text)})


def type_into(box, text):
    click(box)
    box.selectAll()
    type_text(text + "\t")


@pytest.mark.parametrize("kind", KINDS)
def test_nothing_is_in_mm(kind, document, panels):
    edit(KINDS[kind](document))
    assert metric(panels[-1].form) == []
    window.shot(f"inches_{kind}")
    press(Button.Cancel)


def test_inches_are_typed_and_mm_are_stored(document, panels):
    solid = frep(document, "box(20, 20, 8)", 1)
    edit(solid)
    panel = panels[-1]
    assert panel.voxel.text() == "0.03937 in" and panel.voxel.value() == 1, "what nobody types stays as it is"
    type_into(panel.voxel, "1/10")
    assert panel.voxel.value() == 2.54 and panel.voxel.text() == "0.1 in"
    type_into(panel.voxel, "3 mm")
    assert panel.voxel.value() == 3 and panel.voxel.text() == "0.11811 in"
    type_into(panel.voxel, "0")
    assert panel.voxel.text() == "automatic"
    type_into(panel.voxel, "0.05")
    shown(panel.preview, "final", "detail")
    assert metric(panel.form) == []
    press(Button.Ok)
    assert solid.VoxelSize.Value == 1.27 and solid.isValid()


def test_a_job_in_inches(document, panels):
    setup = KINDS["set-up"](document)
    edit(setup)
    panel = panels[-1]
    table = panel.tools.table
    table.item(0, 3).setText("1/4")
    tool = setup.Tools[0]
    assert tool.Diameter.Value == 6.35 and tool.Label == "0.25 in end mill" and table.item(0, 3).text() == "0.25"
    tool.Diameter = 4
    assert tool.Label == cam_tool.name_of(tool) == "0.15748 in end mill"
    FreeCAD.Units.setSchema(INTERNAL)
    tool.Diameter = 5
    assert tool.Label == "5 mm end mill", "the name in inches was its own, too"
    FreeCAD.Units.setSchema(US_CUSTOMARY)
    tool.Diameter = 6.35
    [feed] = [box for box in panel.form.findChildren(MeasureBox)
              if box.unit == "mm/min" and "plunge" not in box.toolTip().lower()][:1]
    feed.setValue(254)
    assert feed.text() == "10 in/min" and tool.Feed.Value * 60 == pytest.approx(254)
    rows = panel.operation_form.rows
    [depth] = [row for stage in rows.values() for row in stage.rows.values() if row.setting.name == "cell"][:1]
    depth.editor.setText("0.02")
    assert setup.Operations[0].Cell.Value == pytest.approx(0.508)
    depth.editor.setText("0.5 mm")
    assert setup.Operations[0].Cell.Value == pytest.approx(0.5)
    depth.editor.setText("-1")
    assert "in" in depth.problem.text() and "mm" not in depth.problem.text()
    depth.editor.setText("0.02")
    panel.plan_button.click()
    wait(lambda: panel.task is None and panel.outcome.text(), "the plan")
    assert metric(panel.form) == [] and " in cut" in panel.outcome.text()
    window.shot("inches_plan")
    press(Button.Cancel)


def test_a_simulation_and_its_legend_in_inches(document, opened, tmp_path):
    panel = simulated(document, opened, tmp_path)
    assert metric(panel.form) == []
    amounts = [event.text(2) for event in panel.playback.events.findItems("", QtCore.Qt.MatchContains)]
    assert any(amount.endswith(" in") for amount in amounts) and any(amount.endswith(" in³") for amount in amounts)
    panel.playback.go_to_line(4)
    wait(lambda: panel.playback.player.idle)
    live(0.2)
    assert f"{-12 / 25.4:.4f}" in panel.playback.axes["X"].text()
    assert (not [text for text in drawn(panel.playback.legend) if "mm" in text]
            and "deviation, in" in drawn(panel.playback.legend))
    tool, obj = panel.setup._tool(0), panel.obj
    panel.setup.write()
    assert tool["diameter"] == 6 and tuple(obj.StockUpper) == (25, 20, 0) and obj.Cell.Value == 0.2, (
        "the same as before")
    panel.setup.tools.item(0, 2).setText("0.5 in")
    assert panel.setup._tool(0)["diameter"] == 12.7
    window.shot("inches_simulation")


def drawn(legend):
    """Returns the texts of a legend."""
    class Recorder:
        def __getattr__(self, name):
            return lambda *arguments: found.append(arguments[-1]) if name == "drawText" else None

    found = []
    legend.paint(Recorder())
    return found


def test_the_cross_check_in_inches(document, monkeypatch):
    made, real = [], check_panel.CheckPanel.__init__
    monkeypatch.setattr(check_panel.CheckPanel, "__init__", lambda self, obj: made.append(self) or real(self, obj))
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(frep(document, "sphere(r = 10)", 1))
    FreeCADGui.runCommand("Fieldfab_CrossCheck")
    wait(lambda: made[0].report is not None, "the report")
    assert metric(made[0].form) == [] and " in on average" in made[0].figures.text()
    [legend] = [legend for legend in FreeCADGui.getMainWindow().findChildren(Legend) if legend.isVisible()]
    assert "Deviation, in" in drawn(legend)
    assert "mm3" in made[0].text(), "tables for others stay in mm"
    made[0].reject()


def test_a_scan_in_inches(document, panels):
    files.insert(str(CT / "engine.nii.gz"), document.Name)
    panel = panels[-1]
    wait(lambda: panel.overview is not None and panel.work.idle(), what="the overview")
    assert metric(panel.form) == [] and " in, " in panel.told.text()
    panel.island.setValue(16387.064)
    assert panel.island.text() == "1 in³" and panel.cut().smallest_island == 16387.064
    press(Button.Cancel)


def test_texts_of_the_kernel():
    assert (units.in_words("24 x 12 mm and 0.5 mm3 at (1.000, -2.5, 3), 600 mm/min, 2 mountains")
            == "0.94 x 0.47 in and 3.051e-05 in³ at (0.03937, -0.098, 0.12), 23.62 in/min, 2 mountains")
    FreeCAD.Units.setSchema(INTERNAL)
    assert (units.in_words("24 x 12 mm at (1, 2, 3)") == "24 x 12 mm at (1, 2, 3)"
            and units.told(24000, "mm/min") == "24000 mm/min")
