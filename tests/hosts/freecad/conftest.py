"""Fixtures of the tests that run inside FreeCAD; imports of FreeCAD stand within them, because other tests read this file, too."""

import pytest


@pytest.fixture
def document():
    """A new document, in the window with the workbench; all documents and panels are closed at the end."""
    import FreeCAD

    if FreeCAD.GuiUp:
        import FreeCADGui
        from window import live

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
