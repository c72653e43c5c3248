"""Runs inside FreeCAD's window: commands and panels of the solids."""

import FreeCAD
import FreeCADGui
import window
from window import Heartbeat, live, press

from fieldfab_workbench.objects import frep_solid, modify
from fieldfab_workbench.objects import solid as solids
from fieldfab_workbench.shim import QtCore, QtWidgets

Button = QtWidgets.QDialogButtonBox


def frep(document, text, voxel=0.5):
    solid = solids.create(frep_solid.FrepSolid, document)
    solid.Expression, solid.VoxelSize = text, voxel
    document.recompute()
    return solid


def choose(*objects):
    FreeCADGui.Selection.clearSelection()
    for obj in objects:
        FreeCADGui.Selection.addSelection(obj)


def test_a_difference_of_what_is_selected_is_one_step(document):
    a, b = frep(document, "box(20, 20, 20)"), frep(document, "sphere(r = 12)")
    steps = document.UndoCount
    choose(a, b)
    FreeCADGui.runCommand("Fieldfab_Difference")
    live(0.3)
    made = document.Objects[-1]
    assert made.Operation == "Difference" and made.Sources == [a, b] and made.isValid()
    assert (not a.ViewObject.Visibility and not b.ViewObject.Visibility
            and made.ViewObject.Proxy.claimChildren() == [a, b])
    FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    window.shot("difference")
    press(Button.Ok)
    assert document.UndoCount == steps + 1 and not FreeCADGui.Control.activeDialog()
    document.undo()
    assert [o.Name for o in document.Objects] == [a.Name, b.Name] and a.ViewObject.Visibility


def test_cancel_takes_a_new_solid_back(document):
    a = frep(document, "box(20, 20, 20)")
    choose(a)
    FreeCADGui.runCommand("Fieldfab_Shell")
    live(0.3)
    assert len(document.Objects) == 2
    press(Button.Cancel)
    assert document.Objects == [a] and a.ViewObject.Visibility


def test_the_panel_follows_the_operation(document):
    a = frep(document, "box(20, 20, 20)")
    choose(a)
    FreeCADGui.runCommand("Fieldfab_Shell")
    live(0.3)
    made = document.Objects[-1]
    form = [w for w in FreeCADGui.getMainWindow().findChildren(QtWidgets.QComboBox)
            if w.isVisible() and w.findText("Polar array") >= 0][0]
    form.setCurrentText("Polar array")
    form.activated.emit(form.currentIndex())
    live(0.3)
    labels = [w.text() for w in FreeCADGui.getMainWindow().findChildren(QtWidgets.QLabel) if w.isVisible()]
    assert "Count" in labels and "Wall" not in labels
    made.Centre = FreeCAD.Vector(40, 0, 0)
    press(Button.Cancel)


def test_the_window_answers_during_a_recompute_and_cancel_ends_it(document):
    a = frep(document, "sphere(r = 10)")
    volume = a.Volume.Value
    a.Expression, a.VoxelSize = "shell(gyroid(period = 3), 0.4) & sphere(r = 30)", 0.1
    seen = []

    def look():
        for dialog in FreeCADGui.getMainWindow().findChildren(QtWidgets.QProgressDialog):
            if dialog.isVisible():
                seen.append(dialog.labelText())
                dialog.cancel()

    timer = QtCore.QTimer()
    timer.timeout.connect(look)
    timer.start(700)
    with Heartbeat() as beat:
        document.recompute()
    timer.stop()
    assert seen and not a.isValid() and "cancelled" in a.getStatusString() and a.Volume.Value == volume
    assert beat.answers(), beat.gaps


def test_modified_solids_show_their_parameters_only(document):
    a = frep(document, "sphere(r = 10)")
    obj = solids.create(modify.Modify, document)
    obj.Source = a
    for operation, needed in modify.OPERATIONS.items():
        obj.Operation = operation
        assert all("Hidden" not in obj.getEditorMode(name) for name in needed)
        assert "Hidden" in obj.getEditorMode("Wall") or "Wall" in needed
