"""Runs inside FreeCAD's window: results of a simulation, and its cancellation."""

import math
import time

import FreeCAD
import FreeCADGui
import pointer
import pytest
import window
from simulating import HEAD, Button, button, document, opened, simulated
from window import live, press, wait

from fieldfab_workbench import meshes
from fieldfab_workbench.objects import simulation
from fieldfab_workbench.shim import QtCore


def test_the_stock_of_a_moment_is_kept(document, opened, tmp_path):
    panel = simulated(document, opened, tmp_path, target=False, cell=0.5)
    playback = panel.playback
    assert playback.legend is None and not playback.see_deviation.isVisible()
    playback.line.setValue(7)
    wait(lambda: playback.player.idle)
    button("Keep as object").click()
    wait(lambda: panel.task is None)
    kept = document.Objects[-1]
    assert kept.Mesh.isSolid() and "line 7" in kept.Label
    volume = meshes.from_bms(meshes.bms_of(kept.Mesh)).volume
    assert 50 * 40 * 12 - volume == pytest.approx(3 * (24 * 6 + math.pi * 9), rel=0.01)
    press(Button.Ok)


def test_a_reopened_document_shows_events_and_plays_when_asked(document, opened, tmp_path):
    panel = simulated(document, opened, tmp_path, cell=0.5)
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
        assert (panel.run is None and len(panel.playback.events.events) == len(panel.obj.Events) > 1
                and verdict in panel.message.text())
        button("Simulate").click()
        wait(lambda: panel.run is not None and panel.playback.shown > 0)
        assert panel.obj.Verdict == verdict
        press(Button.Cancel)
    finally:
        FreeCAD.closeDocument(again.Name)


def test_stop_ends_the_work_and_mistakes_are_told(document, opened, tmp_path):
    long = HEAD + "".join(f"G1 X{x / 10} Y{y / 10} Z{-3 + 0.01 * (x % 50)} F900\n" for y in range(-120, 120, 2)
                          for x in range(-120, 120, 1)) + "M2\n"
    path = tmp_path / "long.ngc"
    path.write_text(long)
    FreeCADGui.runCommand("Fieldfab_SimulateProgram")
    live(0.3)
    panel, form = opened[-1], opened[-1].setup
    button("Simulate").click()
    assert "choose a program" in panel.message.text()
    form.program.line.setText(str(path))
    form.program.line.editingFinished.emit()
    # The bounding box of the program.
    assert [box.value() for box in form.lower + form.upper] == pytest.approx([-17, -17, -8, 16.9, 16.8, 0])
    form.tools.item(0, 2).setText("wide")
    button("Simulate").click()
    assert "Diameter is a number" in panel.message.text()
    form.tools.item(0, 2).setText("1")
    form.cell.setValue(0.05)
    button("Simulate").click()
    live(0.7)
    assert panel.task is not None and panel.bar.value() >= 0
    button("Stop").click()
    wait(lambda: panel.task is None)
    assert "stopped" in panel.message.text() and not panel.obj.Mesh.CountFacets
    press(Button.Cancel)
    assert not document.Objects


def test_a_document_may_be_closed_while_it_plays(opened, tmp_path):
    other = FreeCAD.newDocument()
    panel = simulated(other, opened, tmp_path, cell=0.5)
    playback = panel.playback
    player = playback.player
    playback.buttons["first"].click()
    playback.buttons["play"].click()
    live(0.5)
    assert player.task.is_alive()
    FreeCAD.closeDocument(other.Name)
    wait(lambda: not player.task.is_alive())
    if FreeCADGui.Control.activeDialog():
        FreeCADGui.Control.closeDialog()


def event(kind, line, amount, last=None):
    return {"kind": kind, "line": line, "first_line": line, "last_line": last or line, "amount": amount,
            "message": f"{kind} of {amount}", "place": [0, 0, 0]}


def rows(item):
    return [tuple(item.child(i).text(column) for column in (1, 2)) for i in range(item.childCount())]


def test_events_are_grouped_sorted_by_any_column_and_all_there(document, opened):
    FreeCADGui.runCommand("Fieldfab_SimulateProgram")
    live(0.3)
    events = opened[-1].playback.events
    opened[-1].tabs.setCurrentIndex(1)
    opened[-1]._allow(True)
    events.set_events([event("gouge", 40, -0.2), event("gouge", 7, -0.9, 12), event("rapid contact", 9, 3),
                       event("gouge", 100, -0.5)])
    assert [events.topLevelItem(i).text(0) for i in range(2)] == ["rapid contact", "gouge: 3"], "the worst kind first"
    rapid, gouges = events.topLevelItem(0), events.topLevelItem(1)
    assert rapid.childCount() == 0 and (rapid.text(1), rapid.text(2)) == ("9", "3 mm\u00b3")
    assert rows(gouges) == [("7\u201312", "-0.9 mm"), ("100", "-0.5 mm"),
                            ("40", "-0.2 mm")], "a pass is one event with its range of lines"
    live(0.2)
    window.shot("events")
    head = events.header()
    for column, expected in ((1, ["7\u201312", "40", "100"]), (2, ["7\u201312", "100", "40"])):
        at = QtCore.QPoint(head.sectionPosition(column) + 12, head.height() // 2)
        live(0.6)
        pointer.click(head.viewport(), at)
        group = next(events.topLevelItem(i) for i in range(2) if events.topLevelItem(i).childCount())
        forth = [row[0] for row in rows(group)]
        live(0.6)  # two clicks, not a double click
        pointer.click(head.viewport(), at)
        group = next(events.topLevelItem(i) for i in range(2) if events.topLevelItem(i).childCount())
        back = [row[0] for row in rows(group)]
        assert expected in (forth, back) and forth == back[::-1], (column, forth, back)
    told = []
    events.chosen.connect(told.append)
    group = next(events.topLevelItem(i) for i in range(2) if events.topLevelItem(i).childCount())
    events.itemClicked.emit(group, 0)
    events.itemClicked.emit(group.child(0), 0)
    assert told[0]["amount"] == -0.9 and told[1]["line"] == int(group.child(0).text(1).split("\u2013")[0])
    began = time.monotonic()
    events.set_events([event("gouge", i, -0.1 - i % 7) for i in range(35000)])
    print(f"35,000 events in {time.monotonic() - began:.2f} s")
    assert events.topLevelItem(0).childCount() == 35000 and time.monotonic() - began < 10
    press(Button.Cancel)


def test_a_program_is_read_as_its_dialect_says(document, opened, tmp_path):
    path = tmp_path / "fanuc.ngc"
    path.write_text("%\nO1000 (PART)\nG21 G90 G17\nG0 G80 G40 G49\nT1 M6\nS5000 M3\nG0 X-10 Y0 Z5\nG1 Z-1 F300\n"
                    "X10 F900\nG0 Z5\nM30\n%\n")
    FreeCADGui.runCommand("Fieldfab_SimulateProgram")
    live(0.3)
    panel, form = opened[-1], opened[-1].setup
    assert form.dialect.currentText() == "the machine's"
    form.program.line.setText(str(path))
    form.program.line.editingFinished.emit()
    form.cell.setValue(0.5)
    button("Simulate").click()
    wait(lambda: panel.task is None)
    assert "G80" in panel.message.text() and panel.run is None
    form.dialect.setCurrentIndex(form.dialect.findData("fanuc"))
    window.shot("simulation_dialect")
    button("Simulate").click()
    wait(lambda: panel.run is not None, "the simulation")
    assert panel.obj.Dialect == "fanuc" and panel.obj.isValid() and panel.obj.Removed.Value > 50
    press(Button.Ok)
