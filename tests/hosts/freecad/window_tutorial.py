"""Runs inside FreeCAD's window: follows docs/tutorial.md step by step, types the contents of its boxes, and takes its
pictures."""

import pathlib
import re

import FreeCAD
import FreeCADGui
import pytest
import window
from family import sample_or_all
from window import live, press, wait

from fieldfab_workbench.panels import check_panel, edit_panel
from fieldfab_workbench.panels.program_preview import ProgramPreview
from fieldfab_workbench.shim import QtCore, QtWidgets

Button = QtWidgets.QDialogButtonBox
ROOT = pathlib.Path(__file__).resolve().parents[3]
TUTORIAL = (ROOT / "docs" / "tutorial.md").read_text()
WIDTH = 430  # of the panel, pixels


def coarser(name, value):
    """Returns a value of the tutorial, or for a sample of `./dev test --full` one that plans and cuts in less time."""
    factor = sample_or_all(2 if name == "Cell" else 1, 1)
    return value if factor == 1 else f"{factor * float(value):g}"


def step(number):
    """Returns the boxes under a heading of the tutorial in order: a formula's text, the columns of a tool, or names and
    values."""
    [words] = re.findall(rf"^## {number}\. .*?(?=^## |\Z)", TUTORIAL, re.M | re.S)
    boxes = re.findall(r"^```(\w+)\n(.*?)^```", words, re.M | re.S)
    return [text if kind == "frep" else text.strip().split(", ") if kind == "tool"
            else [(name, coarser(name, value)) for name, value in (line.split(" = ") for line in text.splitlines())]
            for kind, text in boxes]


class Desk:
    """Actions of a user in the window."""

    def __init__(self, monkeypatch):
        self.monkeypatch, self.panels = monkeypatch, []
        for kind in (edit_panel.EditPanel, check_panel.CheckPanel):
            monkeypatch.setattr(kind, "__init__", self._remembering(kind.__init__))

    def _remembering(self, real):
        def init(panel, *arguments):
            self.panels.append(panel)
            real(panel, *arguments)

        return init

    @property
    def panel(self):
        return self.panels[-1]

    def choose(self, *objects):
        FreeCADGui.Selection.clearSelection()
        for obj in objects:
            FreeCADGui.Selection.addSelection(obj)
        live(0.1)

    def command(self, name):
        """Presses an enabled button of a toolbar."""
        words = FreeCADGui.Command.get(name).getInfo()["menuText"]
        FreeCADGui.updateGui()
        [action] = {a.text(): a for bar in FreeCADGui.getMainWindow().findChildren(QtWidgets.QToolBar)
                    if bar.isVisible()
                    for a in bar.actions() if a.text().replace("&", "") == words}.values()
        wait(action.isEnabled, f"{words} to be of use")
        action.trigger()
        live(0.3)
        self.make_room()

    def file(self, path, dialog="getOpenFileName"):
        """Sets the answer to the next file dialog."""
        self.monkeypatch.setattr(QtWidgets.QFileDialog, dialog, lambda *_: (str(path), ""))

    def make_room(self):
        main = FreeCADGui.getMainWindow()
        for dock in main.findChildren(QtWidgets.QDockWidget):
            if dock.objectName() == "Combo View":
                main.resizeDocks([dock], [WIDTH], QtCore.Qt.Horizontal)
            elif dock.objectName() in ("Python console", "Report view"):
                dock.hide()
        live(0.2)

    def fill(self, values):
        """Types values into the panel's rows by name."""
        for name, value in values:
            field = self.field(name)
            boxes = [w for w in [field, *field.findChildren(QtWidgets.QWidget)]
                     if isinstance(w, (QtWidgets.QAbstractSpinBox, QtWidgets.QComboBox))]
            lines = [w for w in [field, *field.findChildren(QtWidgets.QLineEdit)] if isinstance(w, QtWidgets.QLineEdit)]
            if boxes:
                parts = value.split(", ") if len(boxes) > 1 else [value]
                assert len(boxes) == len(parts), name
                for box, part in zip(boxes, parts):
                    self.type(box, part)
            else:
                [line] = lines
                line.setText(value)
                line.editingFinished.emit()
            live(0.1)

    @staticmethod
    def type(box, text):
        if isinstance(box, QtWidgets.QComboBox):
            at = box.findText(text)
            assert at >= 0, f"{text} is not among {[box.itemText(i) for i in range(box.count())]}"
            box.setCurrentIndex(at)
            box.activated.emit(at)
        elif isinstance(box, (QtWidgets.QDoubleSpinBox, QtWidgets.QSpinBox)):
            assert box.isEnabled()
            box.setValue(type(box.value())(text.split()[0]))
        else:  # FreeCAD's editor of quantities with units
            box.setProperty("value", FreeCAD.Units.Quantity(text))

    def field(self, name):
        """Returns the editor next to a visible label."""
        labels = [w for w in FreeCADGui.getMainWindow().findChildren(QtWidgets.QLabel)
                  if w.isVisible() and w.text() == name]
        assert len(labels) == 1, f"{len(labels)} rows {name!r}"
        [label] = labels
        for form in FreeCADGui.getMainWindow().findChildren(QtWidgets.QFormLayout):
            row, role = form.getWidgetPosition(label)
            if row >= 0:
                return form.itemAt(row, QtWidgets.QFormLayout.FieldRole).widget()
        line = label.parent().layout()
        return line.itemAt(line.indexOf(label) + 1).widget()

    def tick(self, words):
        [box] = [b for b in FreeCADGui.getMainWindow().findChildren(QtWidgets.QCheckBox)
                 if b.isVisible() and b.text() == words]
        box.click()

    def click(self, words):
        [button] = [b for b in FreeCADGui.getMainWindow().findChildren(QtWidgets.QPushButton)
                    if b.isVisible() and b.text() == words]
        button.click()
        live(0.2)

    def open(self, title):
        """Opens a box of the stacked panels."""
        [button] = [b for b in FreeCADGui.getMainWindow().findChildren(QtWidgets.QToolButton)
                    if b.isVisible() and b.isCheckable() and b.text() == title]
        if not button.isChecked():
            button.click()
        live(0.1)

    def tool(self, name, shape, diameter):
        """Types a tool into the table's last row."""
        table = self.panel.tools.table
        row = table.rowCount() - 1
        table.item(row, 1).setText(name)
        self.type(table.cellWidget(row, 2), shape)
        table.item(row, 3).setText(diameter)
        live(0.1)

    def look(self):
        FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
        FreeCADGui.SendMsgToActiveView("ViewFit")
        live(0.3)


@pytest.fixture
def desk(monkeypatch):
    yield Desk(monkeypatch)
    if FreeCADGui.Control.activeDialog():
        FreeCADGui.Control.closeDialog()
    for name in FreeCAD.listDocuments():
        FreeCAD.closeDocument(name)


def make_bracket(desk, document):
    """Step 2 of the tutorial: the bracket."""
    formula, values = step(2)
    desk.command("Fieldfab_NewFrepSolid")
    bracket = document.Objects[-1]
    desk.panel.text.setPlainText(formula)
    wait(lambda: "thick" in desk.panel.rows, what="the sliders")
    for name, value in values:
        desk.panel.rows[name].box.setValue(float(value))
    wait(lambda: desk.panel.preview.stage in ("final", "detail"), "the bracket's picture")
    desk.look()
    window.shot("bracket")
    press(Button.Ok)
    assert (bracket.isValid() and bracket.thick == 5 and bracket.Volume.Value
            == pytest.approx(50 * 40 * 5 - 4 * 3.14159 * 2.25**2 * 5 - (4 - 3.14159) * 64 * 5, rel=0.01))
    return bracket


def import_head(desk, document, bracket):
    """Step 3 of the tutorial: the head."""
    cut, placing = step(3)
    desk.file(ROOT / "tests" / "data" / "ct" / "cthead" / "042.tif")
    desk.command("Fieldfab_ImportScan")
    wait(lambda: desk.panel.overview is not None and desk.panel.work.idle(), what="the overview")
    scan = document.Objects[-1]
    desk.tick("Automatic")
    desk.fill(cut)
    desk.tick("Largest piece only")
    wait(desk.panel.work.idle)
    bracket.ViewObject.Visibility = False
    desk.look()
    window.shot("scan")
    press(Button.Ok)
    bracket.ViewObject.Visibility = True
    assert scan.isValid() and scan.Triangles > 10000

    desk.choose(scan)
    desk.command("Fieldfab_Transform")
    desk.fill(placing)
    press(Button.Ok)
    head = document.Objects[-1]
    assert (head.isValid() and head.Mesh.BoundBox.ZLength == pytest.approx(23.5, abs=1)
            and head.Mesh.BoundBox.ZMin == pytest.approx(4, abs=1))
    return head


def blend(desk, document, bracket, head):
    """Step 4 of the tutorial: one solid of both."""
    [values] = step(4)
    desk.choose(bracket, head)
    desk.command("Fieldfab_Blend")
    desk.fill(values)
    press(Button.Ok)
    bust = document.Objects[-1]
    desk.look()
    window.shot("blend")
    assert bust.isValid() and bust.Volume.Value > bracket.Volume.Value + head.Volume.Value * 0.9
    return bust


def cross_check(desk, bust):
    """Step 5 of the tutorial: the cross-check."""
    desk.choose(bust)
    desk.command("Fieldfab_CrossCheck")
    wait(lambda: desk.panel.report is not None and desk.panel.coloured is not None, "the report")
    window.shot("check")
    broken = [(row.name, row.measured, row.bound) for row in desk.panel.report.rows if not row.passed]
    assert "passed" in desk.panel.verdict.text() and not broken, (desk.panel.verdict.text(), broken)
    press(Button.Close)


def plan(desk, bust):
    """Step 6 of the tutorial: a program for five axes."""
    machine, first, first_numbers, second, second_numbers, rough, finish = step(6)
    desk.choose(bust)
    desk.command("Fieldfab_NewCamSetup")
    panel, setup = desk.panel, desk.panel.obj
    desk.fill(machine)
    desk.open("Tools")
    desk.tool(*first)
    desk.fill(first_numbers)
    [add] = [b for b in panel.tools.findChildren(QtWidgets.QPushButton) if b.text() == "Add"]
    add.click()
    desk.tool(*second)
    desk.fill(second_numbers)
    panel.list.setCurrentRow(0)
    for values in (rough, finish):
        if values is finish:
            next(action for action in panel.add_button.menu().actions() if action.text() == "Finish").trigger()
            live(0.2)
        desk.open("Height map")
        desk.fill(values)
    [lean] = desk.field("Lean").findChildren(QtWidgets.QCheckBox)
    lean.click()
    desk.click("Plan")
    wait(lambda: panel.task is None, "the plan")
    program = panel.program()
    assert program is not None and program.Seconds > 600, panel.message.text()
    bust.ViewObject.Visibility = False
    desk.look()
    window.shot("plan")
    bust.ViewObject.Visibility = True
    press(Button.Ok)
    assert setup.isValid() and program.isValid()
    return program


def simulate(desk, bust, program):
    """Step 7 of the tutorial: the simulation."""
    [values] = step(7)
    desk.choose(program)
    desk.command("Fieldfab_SimulateProgram")
    panel, simulation = desk.panel, desk.panel.obj
    desk.fill(values)
    program.ViewObject.Visibility = bust.ViewObject.Visibility = False
    desk.click("Simulate")
    wait(lambda: panel.task is None and panel.run is not None and panel.playback.player.idle
         and panel.playback.shown > 0, "the simulation")
    playback = panel.playback
    desk.tick("Tool")
    desk.tick("Shank and holder")
    desk.look()
    window.shot("deviations")
    assert playback.legend.isVisible() and (simulation.Contacts, simulation.Gouges,
                                            simulation.OverTravels) == (0, 0, 0), ("\n".join(simulation.Events))
    desk.tick("Tool")
    desk.tick("Shank and holder")
    playback.slider.setValue(playback.slider.maximum() * 7 // 10)
    wait(lambda: playback.player.idle)
    window.shot("playing")
    press(Button.Ok)


def write_program(desk, program, path):
    """Step 8 of the tutorial: the machine file."""
    desk.file(path, "getSaveFileName")
    desk.choose(program)
    desk.command("Fieldfab_WriteMachineFile")
    live(0.3)
    [preview] = [widget for widget in QtWidgets.QApplication.topLevelWidgets()
                 if isinstance(widget, ProgramPreview) and widget.isVisible()]
    preview.findChild(Button).button(Button.Save).click()
    written = path.read_text()
    assert written.startswith("%") and re.search(r"^G1 .*A-?[\d.]+ C-?[\d.]+", written, re.M), "all five axes move"


def test_the_tutorial(desk, tmp_path):
    FreeCADGui.activateWorkbench("FieldfabWorkbench")
    document = FreeCAD.newDocument()
    desk.make_room()
    bracket = make_bracket(desk, document)
    head = import_head(desk, document, bracket)
    bust = blend(desk, document, bracket, head)
    cross_check(desk, bust)
    program = plan(desk, bust)
    simulate(desk, bust, program)
    write_program(desk, program, tmp_path / "bust.ngc")
