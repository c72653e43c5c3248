"""Runs inside FreeCAD's window: the editor of f-rep solids, the gallery, the live view."""

import pathlib

import FreeCAD
import FreeCADGui
import pytest
import window
from window import Heartbeat, live, press, wait

from fieldfab_workbench.objects import combine, frep_solid
from fieldfab_workbench.objects import solid as solids
from fieldfab_workbench.panels.frep_panel import FrepPanel
from fieldfab_workbench.shim import QtCore, QtGui, QtWidgets

Button = QtWidgets.QDialogButtonBox
MTM = pathlib.Path(__file__).resolve().parents[2] / "data" / "frep" / "mtm_az" / "mtm_az_00.math"


@pytest.fixture
def document():
    FreeCADGui.activateWorkbench("FieldfabWorkbench")
    made = FreeCAD.newDocument()
    live(0.2)
    yield made
    if FreeCADGui.Control.activeDialog():
        FreeCADGui.Control.closeDialog()
    FreeCAD.closeDocument(made.Name)


def frep(document, text, voxel=0.5):
    solid = solids.create(frep_solid.FrepSolid, document)
    solid.Expression, solid.VoxelSize = text, voxel
    document.recompute()
    FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    live(0.2)
    return solid


@pytest.fixture
def panel(monkeypatch):
    """The panels of f-rep solids that are opened, newest last."""
    opened, real = [], FrepPanel.__init__

    def remember(self, obj):
        real(self, obj)
        opened.append(self)

    monkeypatch.setattr(FrepPanel, "__init__", remember)
    return opened


def edit(solid):
    FreeCADGui.ActiveDocument.setEdit(solid.Name)
    live(0.3)


def settled(preview, stage=("final",), seconds=30):
    wait(lambda: preview.stage in stage and not preview._waiting, seconds, f"{stage} (it is {preview.stage})")


def type_keys(editor, text, key=0, modifiers=QtCore.Qt.NoModifier):
    for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        QtWidgets.QApplication.sendEvent(editor, QtGui.QKeyEvent(kind, key, modifiers, text))


def test_look(document, panel):
    solid = frep(document, "size = 20\nhole = 6  # radius\ndifference(box(size, size, size), sphere(r = hole + 5)) | torus(R = 12, r = 2)")
    edit(solid)
    settled(panel[-1].preview)
    window.shot("panel")
    editor = panel[-1].text
    editor.setPlainText("size = 20\n# a comment\ndifference(box(size, size, size), spheer(r = 4))")
    live(0.4)
    window.shot("mistake")
    editor.setPlainText("")
    for letter in "rou":
        type_keys(editor, letter)
    live(0.3)
    window.shot("completion")
    press(Button.Cancel)
    FreeCADGui.runCommand("Fieldfab_ShapeGallery")
    live(0.5)
    window.shot("gallery")
