"""Runs inside FreeCAD's window: from a blank document to a machine file by the pointer alone, with handles and defaults.
docs/tutorial.md tells these steps, and how many clicks they are."""

import pathlib
import re

import FreeCAD
import FreeCADGui
import pointer
import pytest
import window
from panels import panels  # noqa: F401
from window import live, wait

from fieldfab_workbench.panels.program_preview import ProgramPreview
from fieldfab_workbench.shim import QtWidgets

ROOT = pathlib.Path(__file__).resolve().parents[3]


class Hand:
    """A user with a pointer. Counts clicks and drags."""

    def __init__(self):
        self.clicks = self.drags = 0

    def click(self, widget, place=None):
        wait(lambda: widget.isEnabled() and pointer.is_seen(widget), 20, f"{widget.objectName() or widget} to be seen")
        pointer.click(widget, place)
        self.clicks += 1
        live(0.3)

    def tool(self, name):
        """Clicks a command's button in a toolbar."""
        words = FreeCADGui.Command.get(name).getInfo()["menuText"].replace("&", "")
        [button] = [button for button in seen(QtWidgets.QToolButton)
                    if button.defaultAction() and button.defaultAction().text().replace("&", "") == words
                    and isinstance(button.parent(), QtWidgets.QToolBar)]
        self.click(button)

    def button(self, words):
        [button] = [button for button in seen(QtWidgets.QPushButton)
                    if button.text().replace("&", "") == words]
        self.click(button)

    def row(self, label):
        """Clicks an object in the tree."""
        for tree in seen(QtWidgets.QTreeWidget):
            for item in tree.findItems(label, window.QtCore.Qt.MatchExactly | window.QtCore.Qt.MatchRecursive):
                tree.scrollToItem(item)
                self.click(tree.viewport(), tree.visualItemRect(item).center())
                return
        raise AssertionError(f"{label} is not in the tree")

    def drag(self, document, arrows, number, by):
        pointer.drag_arrow(document, arrows, number, by)
        self.drags += 1


def seen(kind):
    return [widget for widget in QtWidgets.QApplication.allWidgets() if isinstance(widget, kind) and widget.isVisible()]


@pytest.fixture
def blank():
    FreeCADGui.activateWorkbench("FieldfabWorkbench")
    document = FreeCAD.newDocument()
    live(0.5)
    yield document
    FreeCADGui.Control.closeDialog()
    FreeCAD.closeDocument(document.Name)


def test_a_first_part(blank, panels, monkeypatch, tmp_path):  # noqa: F811
    hand = Hand()
    hand.tool("Fieldfab_NewFrepSolid")
    panel = panels[-1]
    wait(lambda: panel.preview.stage in ("final", "detail"), 30, "the solid")
    wait(lambda: panel.handles.handles, 10, "the arrows")
    FreeCADGui.SendMsgToActiveView("ViewFit")
    live(1)
    window.shot("first_part_solid")
    print(panel.text.toPlainText(), [(a[0].read(), a[0].along, a[0].name if hasattr(a[0], "name") else "") for a in panel.handles.handles.arrows], FreeCADGui.Selection.getSelection())
    hand.button("OK")
    live(2)
    print(FreeCADGui.Selection.getSelection())
    window.shot("first_part_ok")
    hand.row(blank.Objects[-1].Label)
    hand.tool("Fieldfab_NewCamSetup")
    live(2)
    window.shot("first_part_job")
    panel = panels[-1]
    hand.button("Plan")
    wait(lambda: panel.task is None, 300, "the plan")
    window.shot("first_part_plan")
    hand.button("OK")
    live(2)
    print(hand.clicks, hand.drags)
    print([o.Label for o in blank.Objects])
    window.shot("first_part_planned")
    assert False
