"""Fixtures of the tests that run inside FreeCAD. A plugin of pytest, since a second conftest.py would shadow the
first."""

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
