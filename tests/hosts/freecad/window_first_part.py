"""Runs inside FreeCAD's window: from a blank document to a machine file by the real pointer alone, with arrows and
defaults. docs/tutorial.md tells the steps, and how many clicks and drags they are."""

import pathlib
import re

import FreeCAD
import FreeCADGui
import pointer
import pytest
import window
from panels import document_tree, panels
from window import live, wait

from fieldfab_workbench.panels.gallery import Gallery
from fieldfab_workbench.shim import QtCore, QtWidgets

TUTORIAL = (pathlib.Path(__file__).resolve().parents[3] / "docs" / "tutorial.md").read_text()


def seen(kind):
    return [widget for widget in QtWidgets.QApplication.allWidgets() if isinstance(widget, kind) and widget.isVisible()]


class Hand:
    """A user with a pointer. Counts clicks and drags."""

    def __init__(self):
        self.clicks = self.drags = 0

    def click(self, widget, place=None, held=None):
        wait(lambda: widget.isEnabled() and pointer.is_seen(widget), f"{widget.objectName() or widget} to be seen")
        pointer.click(widget, place, held)
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
        [button] = [button for button in seen(QtWidgets.QPushButton) if button.text().replace("&", "") == words]
        self.click(button)

    def line(self, tree, words, held=None):
        """Clicks a line of a tree or list, with a key held down."""
        [item] = tree.findItems(words, QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive)
        tree.scrollToItem(item)
        self.click(tree.viewport(), tree.visualItemRect(item).center(), held)

    def row(self, obj, held=None):
        """Clicks an object in the tree of documents."""
        self.line(document_tree(), obj.Label, held)

    def drag(self, document, arrows, number, by):
        pointer.drag_arrow(document, arrows, number, by)
        self.drags += 1


@pytest.fixture
def blank():
    FreeCADGui.activateWorkbench("FieldfabWorkbench")
    document = FreeCAD.newDocument()
    live(0.5)
    yield document
    FreeCADGui.Control.closeDialog()
    FreeCAD.closeDocument(document.Name)


def made():
    wait(lambda: not any(bar.objectName() == "Making" for bar in seen(QtWidgets.QProgressBar)), "the solid")
    live(0.5)


def from_gallery(hand, panels, name, drags):
    """Makes a solid of a shape, drags its arrows, each by a length in mm, and presses OK. Returns the solid."""
    hand.tool("Fieldfab_ShapeGallery")
    [gallery] = seen(Gallery)
    hand.line(gallery.groups, "Solids")
    hand.line(gallery.pictures, name)
    hand.click(gallery.button)
    panel = panels[-1]
    wait(lambda: panel.preview.stage in ("final", "detail") and panel.handles.handles, "the solid and its arrows")
    live(0.5)
    for number, by in drags.items():
        hand.drag(panel.obj.Document, panel.handles.handles, number, by)
    wait(lambda: panel.preview.stage in ("final", "detail"), "the solid")
    hand.button("OK")
    made()
    return panel.obj


def test_a_first_part(blank, panels, monkeypatch, tmp_path):
    hand = Hand()
    block = from_gallery(hand, panels, "rounded box", {0: 4, 1: 4})
    hole = from_gallery(hand, panels, "cylinder", {1: 2})
    assert block.Label == "Rounded box" and hole.Label == "Cylinder"
    assert block.dx == pytest.approx(16, abs=1.5) and block.dy == pytest.approx(14, abs=1.5)
    hand.row(block)
    hand.row(hole, "ctrl")
    hand.tool("Fieldfab_Difference")
    hand.button("OK")
    made()
    part = blank.Objects[-1]
    assert part.isValid() and part.Volume.Value < block.Volume.Value - 90
    hand.row(part)
    hand.tool("Fieldfab_NewCamSetup")
    live(1)
    hand.button("Plan")
    wait(lambda: panels[-1].task is None, "the plan")
    window.shot("first_part")
    hand.button("OK")
    live(1)
    path, asked = tmp_path / "part.ngc", []
    monkeypatch.setattr(QtWidgets.QFileDialog, "getSaveFileName",
                        lambda parent, title, suggested, kinds: asked.append(suggested) or (str(path), ""))
    hand.row(blank.Objects[-1])
    hand.tool("Fieldfab_WriteMachineFile")
    live(1)
    hand.button("Save")
    wait(path.exists, "the machine file")
    assert asked == ["Difference.ngc"] and path.read_text().count("\nG1 ") > 50
    told = re.search(r"(\d+) clicks and (\d+) drags", TUTORIAL)
    assert (hand.clicks, hand.drags) == (int(told[1]), int(told[2]))
