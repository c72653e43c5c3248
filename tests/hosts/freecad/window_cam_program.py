"""Runs inside FreeCAD's window: machine programs are shown, reopened, and passed to FreeCAD's Path jobs."""

import FreeCAD
import FreeCADGui
import numpy as np
import window
from window import clock, live, press
from window_cam import document, new_setup, part, planned_in_panel, seen, type_into

from fieldfab_workbench.objects import cam_setup, machine_program
from fieldfab_workbench.shim import QtCore, QtWidgets

Button = QtWidgets.QDialogButtonBox


def test_a_million_moves_are_drawn_at_once(document):
    setup = cam_setup.create(document, part(document))
    program = machine_program.create(setup)

    class Plan:
        text, digest, extension, program, sheet, notes, zero = "", "made up", ".ngc", b"", b"", [], (0, 0, 0)
        seconds = planned_seconds = 1.0
        reports = [{"name": "many", "cut": 1.0, "rapid": 0.0, "seconds": 1.0}]
        sections = [{"name": "many", "tool": 1, "tilted": False, "coolant": "", "spindle": 0}]
        turn = np.linspace(0, 2000, 1_000_000)
        moves = [np.stack([0.01 * turn * np.cos(turn), 0.01 * turn * np.sin(turn), 0 * turn, 600 + 0 * turn, 0 * turn,
                           0 * turn, 0 * turn, 1 + 0 * turn], axis=1)]

    began = clock()
    machine_program.take(program, Plan)
    live(0.05)
    took = clock() - began
    print(f"a million moves: {took:.2f} s")
    assert took < 4 and program.ViewObject.Proxy.lines.getNumChildren() == 2


def test_paths_become_a_job_of_freecads(document):
    setup = new_setup(part(document))
    type_into("Stepdown", "3")
    planned_in_panel()
    press(Button.Ok)
    steps, before = document.UndoCount, len(document.Objects)
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(cam_setup.programs_of(setup)[0])
    FreeCADGui.runCommand("Fieldfab_ToPath")
    live(0.5)
    jobs = [o for o in document.Objects if hasattr(o, "PostProcessor")]
    assert len(jobs) == 1 and jobs[0].Operations.Group[0].Path.Size > 50 and document.UndoCount == steps + 1
    window.shot("cam_path_job")
    document.undo()
    assert len(document.Objects) == before


def test_a_document_that_is_opened_shows_its_ways(document, tmp_path):
    setup = new_setup(part(document))
    type_into("Stepdown", "3")
    planned_in_panel()
    press(Button.Ok)
    path = str(tmp_path / "saved.FCStd")
    document.saveCopy(path)
    again = FreeCAD.openDocument(path)
    live(0.5)
    program = next(o for o in again.Objects if o.Name.startswith("MachineProgram"))
    assert program.ViewObject.Proxy.lines.getNumChildren() == 2
    setup = program.Setup
    FreeCADGui.ActiveDocument.setEdit(setup.Operations[0].Name)
    live(0.4)
    window.shot("cam_operation")
    assert seen(QtWidgets.QLabel, "Stepdown")
    press(Button.Cancel)
    assert setup.ViewObject.Proxy.claimChildren() == [*setup.Tools, *setup.Operations, program]
    FreeCAD.closeDocument(again.Name)


def test_what_belongs_to_a_set_up_goes_with_it(document):
    solid = part(document)
    setup = new_setup(solid)
    press(Button.Ok)
    machine_program.create(setup)
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(setup)
    asked = []

    def agree():  # FreeCAD asks, since the program refers to the set-up
        for box in FreeCADGui.getMainWindow().findChildren(QtWidgets.QMessageBox):
            if box.isVisible():
                asked.append(box.text())
                box.button(QtWidgets.QMessageBox.Yes).click()

    timer = QtCore.QTimer()
    timer.timeout.connect(agree)
    timer.start(200)
    FreeCADGui.runCommand("Std_Delete")
    live(0.3)
    timer.stop()
    assert len(asked) <= 1
    assert document.Objects == [solid]
    document.undo()
    assert len(document.Objects) == 5
