"""Fixtures of the tests that run inside FreeCAD. This is a plugin of pytest, since a second conftest.py would hide the
other."""

import FreeCAD
import pytest

if FreeCAD.GuiUp:
    import FreeCADGui
    from window import live


@pytest.fixture
def document():
    """A new document, in the window with the workbench; all documents and panels are closed at the end."""
    if FreeCAD.GuiUp:
        FreeCADGui.activateWorkbench("FieldfabWorkbench")
    made = FreeCAD.newDocument()
    made.UndoMode = 1
    if FreeCAD.GuiUp:
        live(0.2)
    yield made
    if FreeCAD.GuiUp and FreeCADGui.Control.activeDialog():
        FreeCADGui.Control.closeDialog()
    for name in FreeCAD.listDocuments():
        FreeCAD.closeDocument(name)
