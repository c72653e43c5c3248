"""Helpers for tests in FreeCAD's window: a program with faults, simulated by the panel."""

import pathlib

import FreeCADGui
import pytest
import window
from window import live, wait

from fieldfab_workbench.objects import frep_solid
from fieldfab_workbench.objects import solid as solids
from fieldfab_workbench.panels import simulation_panel
from fieldfab_workbench.shim import QtCore, QtWidgets

Button = QtWidgets.QDialogButtonBox
ROOT = pathlib.Path(__file__).resolve().parents[3]

# A pocket in rows, then a rapid through the remaining wall, and a cut that is too deep.
HEAD = "G21 G90 G17\nT1 M6\nS5000 M3\nG0 X-12 Y-12 Z5\n"
ROWS = "".join(f"G1 Y{y} F900\nG1 Z-3 F600\nG1 X{12 if i % 2 == 0 else -12} F900\n"
               for i, y in enumerate(range(-12, 13, 4)))
FAULTS = "G0 Z5\nG0 X18 Y0\nG0 Z-2\nG0 Z5\nG0 X0 Y0\nG1 Z-5 F300\nG0 Z20\nM2\n"
PROGRAM = HEAD + ROWS + FAULTS
RAPID_LINE = PROGRAM.split("\n").index("G0 Z-2") + 1
DEEP_LINE = PROGRAM.split("\n").index("G1 Z-5 F300") + 1
TOOL = {"number": 1, "shape": "flat", "diameter": 6, "flute": 12, "length": 30, "shank": 6, "holder_diameter": 20,
        "holder_length": 20}


@pytest.fixture
def document(document):
    for dock in FreeCADGui.getMainWindow().findChildren(QtWidgets.QDockWidget):
        if dock.objectName() in ("Python console", "Report view"):
            dock.hide()
    return document


@pytest.fixture
def opened(monkeypatch):
    """Collects the panels."""
    panels, real = [], simulation_panel.SimulationPanel.__init__
    monkeypatch.setattr(simulation_panel.SimulationPanel, "__init__",
                        lambda self, obj: (panels.append(self), real(self, obj))[1])
    return panels


def button(words):
    found = [b for b in FreeCADGui.getMainWindow().findChildren(QtWidgets.QAbstractButton)
             if b.isVisible() and b.text() == words]
    assert len(found) == 1, f"{len(found)} buttons {words!r}"
    return found[0]


def simulated(document, opened, tmp_path, target=True, cell=0.2):
    """Adds a simulation by the command, and runs it by the panel's button."""
    path = tmp_path / "part.ngc"
    path.write_text(PROGRAM)
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
    form.cell.setValue(cell)
    if target:
        form.target.setCurrentIndex(form.target.findData(made.Name))
    form.tools.setRowCount(0)
    form._add_tool(TOOL)
    window.shot("simulation_setup")
    button("Simulate").click()
    wait(lambda: panel.run is not None and panel.playback.shown > 0 and panel.playback.player.idle,
         "the simulation")
    live(0.3)
    return panel


def view_pixels(panel, name):
    """Returns the 3D view as an array of shape (height, width, 3)."""
    picture, view = window.shot(name), panel.playback.view.widget()
    at, (width, height) = (view.mapTo(FreeCADGui.getMainWindow(), QtCore.QPoint(0, 0)),
                           panel.playback.view.view.getSize())
    scale = width / view.width()  # screen pixels per Qt pixel
    return window.pixels(picture, round(at.x() * scale), round(at.y() * scale), width, height)
