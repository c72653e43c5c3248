"""Runs inside FreeCAD's window: the commands, the stacked panels and the pictures of CAM."""

import os
import time

import FreeCADGui
import numpy as np
import pytest
import window
from window import Heartbeat, live, press, wait

from fieldfab_workbench import path_shim
from fieldfab_workbench.commands import cam as commands
from fieldfab_workbench.icons import icon
from fieldfab_workbench.objects import cam_setup, frep_solid
from fieldfab_workbench.objects import solid as solids
from fieldfab_workbench.panels.program_preview import ProgramPreview
from fieldfab_workbench.panels.tool_table import ToolTable
from fieldfab_workbench.shim import QtCore, QtGui, QtWidgets

Button = QtWidgets.QDialogButtonBox
BITS = os.path.join(path_shim.folder(), "Tools", "Bit")


@pytest.fixture
def document(document):
    make_room()
    return document


def make_room():
    """Widens the panel as a user would."""
    main = FreeCADGui.getMainWindow()
    for dock in main.findChildren(QtWidgets.QDockWidget):
        if dock.objectName() == "Combo View":
            main.resizeDocks([dock], [400], QtCore.Qt.Horizontal)
        elif dock.objectName() in ("Python console", "Report view"):
            dock.hide()
    live(0.2)


def part(document, text="sphere(r = 12) & box(40, 40, 16)", voxel=1.0):
    solid = solids.create(frep_solid.FrepSolid, document)
    solid.Expression, solid.VoxelSize = text, voxel
    document.recompute()
    FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    return solid


def seen(kind, words=None):
    """Returns the visible widgets of a class, with that text if one is given."""
    return [w for w in FreeCADGui.getMainWindow().findChildren(kind)
            if w.isVisible() and (words is None or w.text() == words)]


def row(name):
    """Returns the editor next to a label of the panel."""
    [label] = seen(QtWidgets.QLabel, name)
    form = label.parent().layout()
    place, role = form.getWidgetPosition(label)
    return form.itemAt(place, QtWidgets.QFormLayout.FieldRole).widget()


def type_into(name, text):
    [line] = row(name).findChildren(QtWidgets.QLineEdit)
    line.setText(text)
    live(0.1)


def show(name):
    """Scrolls the panel to a setting."""
    area = row(name).parent()
    while not isinstance(area, QtWidgets.QScrollArea):
        area = area.parent()
    area.ensureWidgetVisible(row(name), 0, 120)
    live(0.1)


def click(words):
    [button] = seen(QtWidgets.QPushButton, words)
    button.click()
    live(0.1)


def coloured(picture, colour):
    """Returns the number of pixels of the 3D view near a colour."""
    picture = picture.convertToFormat(QtGui.QImage.Format_RGB32)
    pixels = np.frombuffer(picture.constBits(),
                           np.uint8).reshape(picture.height(), -1, 4)[150:, 450 : picture.width(), 2::-1].astype(int)
    return int((np.abs(pixels - colour).max(axis=2) < 40).sum())


def seen_dialogs():
    return [widget for widget in QtWidgets.QApplication.topLevelWidgets()
            if isinstance(widget, ProgramPreview) and widget.isVisible()]


def new_setup(solid):
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(solid)
    FreeCADGui.runCommand("Fieldfab_NewCamSetup")
    live(0.4)
    setup = next(o for o in solid.Document.Objects if cam_setup.is_setup(o))
    setup.Operations[0].Cell = 0.5
    return setup


def planned_in_panel():
    click("Plan")
    wait(lambda: seen(QtWidgets.QPushButton, "Plan") and any("About" in w.text() for w in seen(QtWidgets.QLabel)),
         "the plan")


def test_from_a_solid_to_a_machine_file(document, tmp_path, monkeypatch):
    solid = part(document)
    steps = document.UndoCount
    setup = new_setup(solid)
    assert setup.Part == solid and len(setup.Operations) == 1
    boxes = [b.text() for b in seen(QtWidgets.QToolButton) if b.isCheckable() and b.text()]
    stages = ["Part", "Stock", "Tools", "Operations", "Height map", "Rough", "Moves", "Machine"]
    assert [b for b in boxes if b in stages] == stages, "one panel a stage, in the chain's order"
    window.shot("cam_setup")
    type_into("Stepdown", "0.2 in")
    assert setup.Operations[0].Proxy.given(setup.Operations[0])["stepdown"] == pytest.approx(5.08)
    type_into("Stepdown", "3")
    type_into("Feed", "900")
    planned_in_panel()
    [program] = cam_setup.programs_of(setup)
    assert program.Seconds > 0 and setup.Operations[0].Feed.getValueAs("mm/min").Value == pytest.approx(900)
    picture = window.shot("cam_planned")
    blue, red = coloured(picture, (26, 107, 217)), coloured(picture, (217, 38, 31))
    assert blue > 500 and red > 20, "cuts and rapids are seen"
    press(Button.Ok)
    assert document.UndoCount == steps + 1 and not FreeCADGui.Control.activeDialog() and program.isValid()
    path = str(tmp_path / "dome.ngc")
    asked = []
    monkeypatch.setattr(QtWidgets.QFileDialog, "getSaveFileName", lambda *a: asked.append(a[2]) or (path, ""))
    solid.Label = "Dome: left/right"
    FreeCADGui.runCommand("Fieldfab_WriteMachineFile")
    live(0.3)
    [preview] = seen_dialogs()
    lines = preview.program.model()
    told = [lines.data(lines.index(row, 0)) for row in range(lines.rowCount())]
    assert ([int(words.split()[0]) for words in told] == list(range(1, len(told) + 1))
            and any("G1" in words for words in told))
    window.shot("cam_preview")
    assert not os.path.exists(path)
    preview.findChild(Button).button(Button.Save).click()
    assert [os.path.basename(name) for name in asked] == ["Dome_ left_right.ngc"], "the part's name"
    assert open(path).read().startswith("%") and path in FreeCADGui.getMainWindow().statusBar().currentMessage()
    opened = []
    monkeypatch.setattr(commands.webbrowser, "open", opened.append)
    FreeCADGui.runCommand("Fieldfab_SetupSheet")
    assert "3 mm end mill" in open(opened[0][len("file://"):]).read()
    document.undo()
    assert document.Objects == [solid]


def test_feeds_are_adjusted_by_a_tick(document):
    setup = new_setup(part(document))
    planned_in_panel()
    [program] = cam_setup.programs_of(setup)
    seconds = program.Seconds
    [box] = seen(QtWidgets.QCheckBox, "Adjust feeds to the cut")
    box.click()
    planned_in_panel()
    wait(lambda: any("with the planned feeds" in label.text() for label in seen(QtWidgets.QLabel)), "both times")
    assert setup.AdjustFeeds and program.Seconds < seconds == pytest.approx(program.PlannedSeconds)
    window.shot("cam_feeds")
    press(Button.Ok)


def test_what_is_wrong_is_said_beside_the_setting(document):
    setup = new_setup(part(document))
    type_into("Stepdown", "-2")
    assert any(w.text() == "must be above 0 mm" for w in row("Stepdown").findChildren(QtWidgets.QLabel)
               if w.isVisible())
    show("Stepdown")
    window.shot("cam_wrong_value")
    assert "stepdown" not in setup.Operations[0].Proxy.given(setup.Operations[0])
    type_into("Stepdown", "")
    # Errors of the kernel are reported, too.
    operation = setup.Operations[0]
    operation.Plane, operation.Beta = "view", 30
    click("Plan")
    wait(lambda: seen(QtWidgets.QPushButton, "Plan"))
    live(0.2)
    assert any("cannot tilt" in w.text() for w in row("Plane").findChildren(QtWidgets.QLabel) if w.isVisible())
    press(Button.Cancel)
    assert len(document.Objects) == 1


def test_operations_and_tools_are_added_moved_and_removed(document):
    setup = new_setup(part(document))
    panel = [w for w in FreeCADGui.getMainWindow().findChildren(QtWidgets.QListWidget) if w.isVisible()][0]
    [add] = [b for b in seen(QtWidgets.QPushButton, "Add") if b.menu()]
    next(a for a in add.menu().actions() if a.text() == "Finish").trigger()
    live(0.2)
    assert [o.Type for o in setup.Operations] == ["rough", "finish"] and panel.currentRow() == 1
    [lean] = row("Lean").findChildren(QtWidgets.QCheckBox)
    assert not seen(QtWidgets.QLabel, "Lead")
    lean.click()
    live(0.1)
    assert setup.Operations[1].Lean and seen(QtWidgets.QLabel, "Lead"), "what leaning needs is seen now"
    lean.click()
    assert setup.Operations[1].Proxy.given(setup.Operations[1]) == {}
    click("\u2191")
    assert [o.Type for o in setup.Operations] == ["finish", "rough"] and panel.item(0).text() == "Finish"
    [box] = [b for b in seen(QtWidgets.QToolButton, "Tools")]
    box.setChecked(True)
    live(0.2)
    [table] = seen(ToolTable)
    click("Library\N{HORIZONTAL ELLIPSIS}")
    table.library.take_files([os.path.join(BITS, "6mm_Ball_End.fctb"), os.path.join(BITS, "probe.fctb")])
    assert "probe" in table.library.message.text()
    click("Add to job")
    table.library.close()
    live(0.2)
    assert [t.Label for t in setup.Tools] == ["3 mm end mill", "6mm Ball End"]
    window.shot("cam_tools")
    [first] = [b for b in seen(QtWidgets.QPushButton, "Remove") if b.parent() is table]
    first.click()
    live(0.1)
    assert len(setup.Tools) == 1
    choice = [c for c in seen(QtWidgets.QComboBox) if c.findData("shopbot5") >= 0][0]
    choice.setCurrentIndex(choice.findData("shopbot5"))
    choice.activated.emit(choice.currentIndex())
    live(0.2)
    assert setup.Machine == "shopbot5" and seen(QtWidgets.QLabel, "Jog")
    show("Jog")
    window.shot("cam_machine")
    press(Button.Cancel)
    assert len(document.Objects) == 1


def test_the_window_answers_while_a_plan_is_made_and_stop_ends_it(document):
    setup = new_setup(part(document))
    setup.Operations[0].Cell = 0.01
    click("Plan")
    beats = []
    while len(beats) < 8 and min(beats, default=1) >= 0.1:  # until the machine is idle for a moment
        with Heartbeat() as beat:
            live(0.4)
        beats.append(beat.longest)
    [stop] = seen(QtWidgets.QPushButton, "Stop")
    began = time.monotonic()
    stop.click()
    wait(lambda: seen(QtWidgets.QPushButton, "Plan"), "the plan to stop")
    print(f"the window answers within {1000 * min(beats):.0f} ms, "
          f"the plan stops after {1000 * (time.monotonic() - began):.0f} ms")
    assert min(beats) < 0.1 and not cam_setup.programs_of(setup)
    assert any("stopped" in w.text() for w in seen(QtWidgets.QLabel))
    press(Button.Cancel)


def test_icons_are_there():
    for name, command in commands.COMMANDS.items():
        if command is not None:
            assert os.path.exists(command.GetResources()["Pixmap"])
    for name in ("CamSetup", "CamTool", "CamOperation", "CamOperationOff", "MachineProgram"):
        assert os.path.exists(icon(name)) and QtCore.QFileInfo(icon(name)).size() > 300
