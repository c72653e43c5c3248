"""Runs inside FreeCAD's window: simulating a program, playing it, its events."""

import math
import pathlib
import time

import FreeCAD
import FreeCADGui
import numpy as np
import pytest
import window
from window import Heartbeat, live, press, wait

from fieldfab_workbench.objects import frep_solid, set_ups, simulation
from fieldfab_workbench.objects import solid as solids
from fieldfab_workbench.panels import simulation_panel
from fieldfab_workbench.shim import QtCore, QtGui, QtWidgets

Button = QtWidgets.QDialogButtonBox
ROOT = pathlib.Path(__file__).resolve().parents[3]

# A pocket that is cut in rows, then a rapid through the wall that is left, and a cut that is too deep.
HEAD = "G21 G90 G17\nT1 M6\nS5000 M3\nG0 X-12 Y-12 Z5\n"
ROWS = "".join(f"G1 Y{y} F900\nG1 Z-3 F600\nG1 X{12 if i % 2 == 0 else -12} F900\n" for i, y in enumerate(range(-12, 13, 4)))
FAULTS = "G0 Z5\nG0 X18 Y0\nG0 Z-2\nG0 Z5\nG0 X0 Y0\nG1 Z-5 F300\nG0 Z20\nM2\n"
PROGRAM = HEAD + ROWS + FAULTS
RAPID_LINE = PROGRAM.split("\n").index("G0 Z-2") + 1
DEEP_LINE = PROGRAM.split("\n").index("G1 Z-5 F300") + 1
TOOL = {"number": 1, "shape": "flat", "diameter": 6, "flute": 12, "length": 30, "shank": 6, "holder_diameter": 20, "holder_length": 20}


@pytest.fixture
def document():
    FreeCADGui.activateWorkbench("FieldfabWorkbench")
    for dock in FreeCADGui.getMainWindow().findChildren(QtWidgets.QDockWidget):
        if dock.objectName() in ("Python console", "Report view"):
            dock.hide()
    made = FreeCAD.newDocument()
    live(0.2)
    yield made
    if FreeCADGui.Control.activeDialog():
        FreeCADGui.Control.closeDialog()
    FreeCAD.closeDocument(made.Name)


@pytest.fixture
def opened(monkeypatch):
    """The panels that were made."""
    panels, real = [], simulation_panel.SimulationPanel.__init__
    monkeypatch.setattr(simulation_panel.SimulationPanel, "__init__", lambda self, obj: (panels.append(self), real(self, obj))[1])
    return panels


def button(words):
    found = [b for b in FreeCADGui.getMainWindow().findChildren(QtWidgets.QAbstractButton) if b.isVisible() and b.text() == words]
    assert len(found) == 1, f"{len(found)} buttons {words!r}"
    return found[0]


def simulated(document, opened, tmp_path, text=PROGRAM, target=True):
    """Adds a simulation by the command and has it carried out by the panel's button."""
    path = tmp_path / "part.ngc"
    path.write_text(text)
    made = None
    if target:
        made = solids.create(frep_solid.FrepSolid, document)
        made.Expression, made.VoxelSize = "difference(move(box(50, 40, 12), 0, 0, -6), box(30, 30, 6))", 1
        document.recompute()
        made.ViewObject.Visibility = False
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.runCommand("Fieldfab_SimulateProgram")
    live(0.3)
    panel, form = opened[-1], opened[-1].setup
    form.program.line.setText(str(path))
    form.program.line.editingFinished.emit()
    for boxes, values in ((form.lower, (-25, -20, -12)), (form.upper, (25, 20, 0))):
        for box, value in zip(boxes, values):
            box.setValue(value)
    form.cell.setValue(0.2)
    if target:
        form.target.setCurrentIndex(form.target.findData(made.Name))
    form.tools.setRowCount(0)
    form._add_tool(TOOL)
    window.shot("simulation_setup")
    button("Simulate").click()
    wait(lambda: panel.run is not None and panel.playback.shown > 0 and panel.playback.player.idle, 30, "the simulation")
    live(0.3)
    return panel


def view_pixels(panel, name):
    """The 3D view as (height, width, 3) numbers."""
    picture, view = window.shot(name), panel.playback.view.widget()
    at, (width, height) = view.mapTo(FreeCADGui.getMainWindow(), QtCore.QPoint(0, 0)), panel.playback.view.view.getSize()
    scale = width / view.width()  # pixels of the screen in one of Qt's
    picture = picture.copy(round(at.x() * scale), round(at.y() * scale), width, height).convertToFormat(picture.Format_RGB888)
    rows = np.frombuffer(picture.constBits(), np.uint8).reshape(picture.height(), picture.bytesPerLine())
    return rows[:, : 3 * picture.width()].reshape(picture.height(), picture.width(), 3).astype(int)


def test_a_program_is_simulated_played_and_judged(document, opened, tmp_path):
    steps = document.UndoCount
    panel = simulated(document, opened, tmp_path)
    obj, playback = panel.obj, panel.playback
    assert obj.isValid() and obj.Contacts == 1 and obj.Gouges >= 1, obj.Verdict
    at_end = view_pixels(panel, "simulation_deviation")
    # The gouge is red, the legend is there, the tool stands above.
    red = (at_end[..., 0] > 120) & (at_end[..., 0] > at_end[..., 1] + 60) & (at_end[..., 0] > at_end[..., 2] + 60)
    assert red.sum() > 300 and playback.legend.isVisible()
    steel = [playback.view.pixel_of(np.array(playback._moment["tip"]) + [0, 0, h]) for h in (0, 40)]
    assert abs(steel[0][0] - steel[1][0]) < 2 < steel[1][1] - steel[0][1]

    # Without the tool the picture differs where it was.
    playback.see_tool.click()
    playback.see_holder.click()
    live(0.3)
    without = view_pixels(panel, "simulation_without_tool")
    x, y = (playback.view.pixel_of(np.array(playback._moment["tip"]) + [0, 0, 6]))
    row, column = without.shape[0] - int(y), int(x)
    assert np.abs(at_end - without)[row - 4 : row + 4, column - 4 : column + 4].mean() > 20
    playback.see_tool.click()
    playback.see_holder.click()

    # The beginning: an uncut block, other pictures while it plays, numbers and lines that move on.
    playback.buttons["first"].click()
    wait(lambda: playback.player.idle)
    begin = view_pixels(panel, "simulation_begin")
    assert not playback.legend.isVisible() and "-12.000" in playback.axes["X"].text() and 4 <= playback.program.line() <= 6
    assert np.abs(begin - at_end).max(axis=2).mean() > 1
    playback.speed.setCurrentIndex(playback.speed.findText("5\N{MULTIPLICATION SIGN}"))
    shown, began = playback.shown, time.monotonic()
    with Heartbeat() as beat, Heartbeat() as busy:
        busy.clock = time.thread_time
        playback.buttons["play"].click()
        live(2.5)
        playback.buttons["play"].click()
    rate = (playback.shown - shown) / (time.monotonic() - began)
    print(f"played with {rate:.1f} frames a second, the window answered within {1000 * beat.longest:.0f} ms")
    wait(lambda: playback.player.idle)
    live(0.2)
    middle = view_pixels(panel, "simulation_middle")
    assert 4 < playback.program.line() < 28 and np.abs(middle - begin).max(axis=2).mean() > 0.5 and rate > 5 and beat.longest < 0.25
    press(Button.Ok)
    assert document.UndoCount == steps + 1 and not FreeCADGui.Control.activeDialog() and obj.ViewObject.Visibility and obj.isValid()


def test_events_lines_and_clicks_find_each_other(document, opened, tmp_path):
    panel = simulated(document, opened, tmp_path)
    playback, events = panel.playback, panel.playback.events
    assert [events.topLevelItem(i).text(0) for i in range(2)] == ["rapid contact", "gouge"] and events.topLevelItem(0).text(1) == str(RAPID_LINE)
    events.itemClicked.emit(events.topLevelItem(0), 0)
    wait(lambda: playback.player.idle)
    live(0.3)
    view_pixels(panel, "simulation_event")
    assert playback.program.line() == RAPID_LINE == playback.line.value() and not playback.legend.isVisible()
    place = events.events[0]["place"]
    width, height = playback.view.view.getSize()
    assert math.dist(playback.view.pixel_of(place), (width / 2, height / 2)) < 3, "it is in the middle"
    assert math.dist(playback._moment["tip"], (18, 0, -2)) < 1e-3 and playback.scene.mark.whichChild.getValue() == 0

    # A gouge is seen where the deviations are.
    deep = [i for i in range(events.topLevelItemCount()) if events.topLevelItem(i).text(1) == str(DEEP_LINE)]
    events.itemClicked.emit(events.topLevelItem(deep[0]), 0)
    wait(lambda: playback.player.idle)
    live(0.2)
    assert playback.legend.isVisible() and playback.program.line() == DEEP_LINE

    # A line of the text, and of the box.
    playback.line.setValue(8)
    wait(lambda: playback.player.idle)
    assert playback.program.line() == 8 and math.dist(playback._moment["tip"][:2], (-12, -8)) < 30
    playback.program.clicked.emit(playback.program.model().index(6, 0))
    wait(lambda: playback.player.idle)
    live(0.1)
    assert math.dist(playback._moment["tip"], (12, -12, -3)) < 1e-3 and playback.line.value() == 7

    # A click on the floor of the pocket: the row that cut it.
    playback.buttons["last"].click()
    wait(lambda: playback.player.idle)
    live(0.2)
    for place, line in (((-4, -10, -3), 7), ((-8, 8.5, -3), PROGRAM.split("\n").index("G1 Y8 F900") + 3)):
        x, y = playback.view.pixel_of(place)
        widget = playback.view.widget().viewport()
        scale = playback.view.view.getSize()[0] / widget.width()  # pixels of the screen in one of Qt's
        at = QtCore.QPoint(round(x / scale), round(widget.height() - y / scale))
        for kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonRelease):
            buttons = QtCore.Qt.LeftButton if kind == QtCore.QEvent.MouseButtonPress else QtCore.Qt.NoButton
            QtWidgets.QApplication.sendEvent(widget, QtGui.QMouseEvent(kind, at, QtCore.Qt.LeftButton, buttons, QtCore.Qt.NoModifier))
        live(0.2)
        view_pixels(panel, f"simulation_click_{line}")
        assert f"line {line} cut this place" in panel.message.text() and playback.program.line() == line
    press(Button.Cancel)
    assert len(document.Objects) == 1


def test_results_are_written_and_kept(document, opened, tmp_path):
    panel = simulated(document, opened, tmp_path, target=False)
    playback = panel.playback
    assert playback.legend is None and not playback.see_deviation.isVisible()
    panel.write_report(str(tmp_path / "report.html"))
    wait(lambda: panel.task is None)
    assert "rapid contact" in (tmp_path / "report.html").read_text() and "written" in panel.message.text()
    panel.write_frames(str(tmp_path / "frames"), 3)
    wait(lambda: panel.task is None)
    assert sorted(p.name for p in (tmp_path / "frames").iterdir()) == [f"frame_000{i}.png" for i in (1, 2, 3)]
    playback.line.setValue(7)
    wait(lambda: playback.player.idle)
    button("Keep as object").click()
    wait(lambda: panel.task is None)
    kept = document.Objects[-1]
    assert kept.Mesh.isSolid() and kept.Mesh.Volume == pytest.approx(50 * 40 * 12 - 3 * (24 * 6 + math.pi * 9), rel=1e-3) and "line 7" in kept.Label
    press(Button.Ok)


def test_a_reopened_document_shows_events_and_plays_when_asked(document, opened, tmp_path):
    panel = simulated(document, opened, tmp_path)
    name, verdict = panel.obj.Name, panel.obj.Verdict
    press(Button.Ok)
    path = str(tmp_path / "saved.FCStd")
    document.saveCopy(path)
    simulation._runs.clear()
    again = FreeCAD.openDocument(path)
    live(0.3)
    try:
        FreeCADGui.getDocument(again.Name).setEdit(name)
        live(0.3)
        panel = opened[-1]
        window.shot("simulation_reopened")
        assert panel.run is None and panel.playback.events.topLevelItemCount() == len(panel.obj.Events) > 1 and verdict in panel.message.text()
        button("Simulate").click()
        wait(lambda: panel.run is not None and panel.playback.shown > 0)
        assert panel.obj.Verdict == verdict
        press(Button.Cancel)
    finally:
        FreeCAD.closeDocument(again.Name)


def test_stop_ends_the_work_and_mistakes_are_told(document, opened, tmp_path):
    long = HEAD + "".join(f"G1 X{x / 10} Y{y / 10} Z{-3 + 0.01 * (x % 50)} F900\n" for y in range(-120, 120, 2) for x in range(-120, 120, 1)) + "M2\n"
    path = tmp_path / "long.ngc"
    path.write_text(long)
    FreeCADGui.runCommand("Fieldfab_SimulateProgram")
    live(0.3)
    panel, form = opened[-1], opened[-1].setup
    button("Simulate").click()
    assert "choose a program" in panel.message.text()
    form.program.line.setText(str(path))
    form.program.line.editingFinished.emit()
    assert [box.value() for box in form.lower + form.upper] == pytest.approx([-17, -17, -8, 16.9, 16.8, 0])  # around the program
    form.tools.item(0, 2).setText("wide")
    button("Simulate").click()
    assert "Diameter is a number" in panel.message.text()
    form.tools.item(0, 2).setText("1")
    form.cell.setValue(0.05)
    button("Simulate").click()
    live(0.7)
    assert panel.task is not None and panel.bar.value() >= 0
    button("Stop").click()
    wait(lambda: panel.task is None, 5)
    assert "stopped" in panel.message.text() and not panel.obj.Mesh.CountFacets
    press(Button.Cancel)
    assert not document.Objects


def test_five_axes_are_shown_turning(document, opened, tmp_path):
    import gzip

    program = tmp_path / "knob.ngc"
    program.write_bytes(gzip.decompress((ROOT / "docs/cam/knob_five_axis.ngc.gz").read_bytes()))
    obj = solids.create(simulation.Simulation, document)
    obj.ProgramFile, obj.SetupFile, obj.Cell = str(program), str(ROOT / "examples/cam/knob_five_axis.toml"), 0.6
    document.recompute()
    assert obj.isValid(), obj.getStatusString()
    FreeCADGui.ActiveDocument.setEdit(obj.Name)
    panel = opened[-1]
    playback = panel.playback
    wait(lambda: playback.shown > 0 and playback.player.idle)
    assert list(playback.axes) == list(panel.run.simulation.axes) and len(playback.axes) == 5
    # Somewhere where the tool leans.
    times = np.linspace(0, playback.player.length, 200)
    leaning = [t for t in times if playback.player.at(t)["axis"][2] < 0.9]
    playback.go_to(leaning[len(leaning) // 2])
    wait(lambda: playback.player.idle)
    still = view_pixels(panel, "simulation_five_axes")
    playback.turning.click()
    live(0.3)
    turned = view_pixels(panel, "simulation_five_axes_turned")
    assert np.abs(still - turned).max(axis=2).mean() > 1
    # In the machine the tool stands upright.
    assert playback._matrix()[:3, :3] @ playback._moment["axis"] == pytest.approx([0, 0, 1], abs=1e-6)
    press(Button.Cancel)
