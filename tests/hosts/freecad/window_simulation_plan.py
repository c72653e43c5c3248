"""Runs inside FreeCAD's window: simulations of planned programs, their visible objects, and changes of set-ups."""

import FreeCADGui
import numpy as np
import pointer
import pytest
import window
from simulating import Button, button, document, opened, view_pixels
from window import live, press, wait

from fieldfab_workbench.objects import (cam_operation, cam_setup, cam_tool, frep_solid, machine_program, programs,
                                        simulation)
from fieldfab_workbench.objects import solid as solids
from fieldfab_workbench.shim import QtCore, QtWidgets


@pytest.fixture
def planned(document):
    part = solids.create(frep_solid.FrepSolid, document)
    part.Expression, part.VoxelSize = "box(24, 24, 8) | move(box(8, 8, 4), 0, 0, 5)", 1
    document.recompute()
    setup = cam_setup.create(document, part)
    cam_tool.add(setup, {"diameter": 4, "length": 40})
    operation = cam_operation.add(setup, "rough")
    operation.Cell = 0.5
    program = machine_program.create(setup)
    document.recompute()
    assert program.isValid(), program.getStatusString()
    document.UndoMode = 1
    FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    FreeCADGui.Selection.clearSelection()
    return program


def simulated(opened, cell=0.4):
    """Adds a simulation by the command without a selection, and runs it by the panel's button."""
    FreeCADGui.runCommand("Fieldfab_SimulateProgram")
    live(0.3)
    panel = opened[-1]
    panel.setup.cell.setValue(cell)
    button("Simulate").click()
    wait(lambda: panel.task is None, "the simulation")
    assert panel.run is not None, panel.message.text()
    wait(lambda: panel.playback.shown > 0 and panel.playback.player.idle)
    live(0.2)
    return panel


def test_the_stock_is_seen_alone_and_part_and_paths_by_switches(document, opened, planned):
    part = planned.Setup.Part
    assert part.ViewObject.Visibility and planned.ViewObject.Visibility
    panel = simulated(opened)
    assert panel.obj.Program == planned, "the only set-up's program is chosen already"
    playback = panel.playback
    assert not part.ViewObject.Visibility and not planned.ViewObject.Visibility and not panel.obj.ViewObject.Visibility
    playback.see_tool.click()
    playback.see_holder.click()
    playback.see_deviation.click()
    playback.buttons["last"].click()
    wait(lambda: playback.player.idle)
    stock = view_pixels(panel, "plan_stock")
    pointer.click(playback.see_paths, QtCore.QPoint(8, playback.see_paths.height() // 2))
    paths = view_pixels(panel, "plan_paths")
    red = lambda picture: int(((picture[..., 0] > 180) & (picture[..., 1] < 90)
                               & (picture[..., 2] < 90)).sum())
    assert (red(paths) > red(stock) + 50 and playback.colours.isVisible()
            and [words for _, words, _ in playback.colours.entries] == ["cuts of tool 1", "rapids"])
    playback.see_paths.click()
    assert playback.colours is None
    playback.see_stock.click()
    live(0.2)
    assert np.abs(view_pixels(panel, "plan_nothing") - stock).max(axis=2).mean() > 1
    playback.see_part.click()
    live(0.2)
    assert part.ViewObject.Visibility
    alone = view_pixels(panel, "plan_part")
    assert np.abs(alone - stock).max(axis=2).mean() > 0.1
    press(Button.Ok)
    assert part.ViewObject.Visibility and planned.ViewObject.Visibility, "as it was"


def test_a_program_file_made_of_the_planned_one_keeps_its_set_up(document, opened, planned, tmp_path):
    panel = simulated(opened)
    form, removed = panel.setup, panel.obj.Removed.Value
    path = tmp_path / "edited.ngc"
    machine_program.write_machine_file(planned, str(path))
    path.write_text(path.read_text().replace("M2\n", "(edited)\nM2\n"))
    panel.tabs.setCurrentIndex(0)
    form.of_object.setCurrentIndex(0)
    form.of_object.activated.emit(0)
    assert form.of_setup.currentData() == planned.Name and not form.by_hand.isVisible()
    form.program.line.setText(str(path))
    form.program.line.editingFinished.emit()
    window.shot("plan_edited")
    panel.run = None
    button("Simulate").click()
    wait(lambda: panel.task is None and panel.run is not None, "the simulation")
    assert (panel.obj.Program is None and panel.obj.SetupProgram == planned
            and panel.obj.Removed.Value == pytest.approx(removed, rel=1e-6))
    press(Button.Ok)


def test_a_hidden_simulation_is_carried_out_once_it_is_shown(document, opened, planned, monkeypatch):
    panel = simulated(opened)
    obj, made = panel.obj, []
    press(Button.Ok)
    real = simulation.Run
    monkeypatch.setattr(simulation, "Run", lambda task, progress: made.append(task) or real(task, progress))
    obj.ViewObject.Visibility = False
    part, volume = planned.Setup.Part, obj.Volume.Value
    part.Expression = "box(20, 20, 8)"
    document.recompute()
    assert not made and obj.Volume.Value == volume and obj.isValid()
    obj.ViewObject.Visibility = True
    wait(lambda: made and obj.Volume.Value != volume, "the simulation")
    obj.ViewObject.Visibility = False
    made.clear()
    document.openTransaction("Delete")
    document.removeObject(part.Name)
    document.recompute()
    document.commitTransaction()
    assert not made, "the part is gone, and nobody looks"
    document.undo()
    document.recompute()
    assert (planned.isValid() and planned.Setup.isValid() and machine_program.machine_file(planned)
            and planned.Setup.Part is not None)
    assert not made


def test_deleting_a_set_up_and_undo_brings_its_program_back(document, planned):
    text, name = machine_program.machine_file(planned), planned.Name
    FreeCADGui.Selection.addSelection(planned.Setup)

    def agree():
        if box := QtWidgets.QApplication.activeModalWidget():  # FreeCAD asks, since the program depends on the set-up
            box.button(QtWidgets.QMessageBox.Yes).click()

    QtCore.QTimer.singleShot(500, agree)
    FreeCADGui.runCommand("Std_Delete")
    live(0.3)
    assert document.getObject(name) is None
    document.undo()
    document.recompute()
    again = document.getObject(name)
    assert (again.isValid() and machine_program.machine_file(again) == text and again.Setup is not None
            and machine_program.sections_of(again))


def test_around_the_program_is_around_all_that_it_cuts():
    def text(*lines):
        return programs.Program("\n".join(lines).encode(), "a.ngc", None)

    assert programs.highest_cut(text("G21 G90", "G0 X0 Y0 Z20", "G1 Z-2 F100", "X10", "G0 Z20 X0", "G1 Z6",
                                     "G1 Y4 Z7.5", "G0 Z20")) == 7.5
    assert programs.highest_cut(text("G20", "g0x0y0z1", "g1z.1f5", "x1(Z9)")) == pytest.approx(2.54)
    assert programs.highest_cut(text("G0 X0 Y0 Z5")) is None


def test_the_button_takes_a_program_above_zero_whole(document, opened, tmp_path):
    path = tmp_path / "high.ngc"
    path.write_text("G21 G90 G17\nT1 M6\nS5000 M3\nG0 X0 Y0 Z30\nG1 Z12 F300\nG1 X10 F900\nG1 Z-4\nG1 Y10\n"
                    "G0 Z30\nM2\n")
    FreeCADGui.runCommand("Fieldfab_SimulateProgram")
    live(0.3)
    form = opened[-1].setup
    form.program.line.setText(str(path))
    form.program.line.editingFinished.emit()
    assert [box.value() for box in (*form.lower, *form.upper)] == [-5, -5, -9, 15, 15, 12]
    press(Button.Cancel)
