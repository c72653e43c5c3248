"""Runs inside FreeCAD's window: what a simulation leaves, and how its work is stopped."""

import math

import FreeCAD
import FreeCADGui
import pytest
import window
from simulating import HEAD, Button, button, document, opened, simulated  # noqa: F401
from window import live, press, wait

from fieldfab_workbench import meshes
from fieldfab_workbench.objects import simulation


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
    wait(lambda: not player.task.is_alive(), 5)
    if FreeCADGui.Control.activeDialog():
        FreeCADGui.Control.closeDialog()
