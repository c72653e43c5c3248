"""Designing with the library's shapes."""

import FreeCAD
import FreeCADGui

from ..objects import frep_solid, solid
from ..views.solid_view import icon


class ShapeGallery:
    """Opens the gallery; the shape chosen there becomes a solid whose numbers are properties, with its task panel open: one undo step."""

    def GetResources(self):
        return {"Pixmap": icon("ShapeGallery"), "MenuText": "Shape gallery", "ToolTip": "Choose a shape by its picture and make a solid of it"}

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog()

    def Activated(self):
        from ..panels.gallery import Gallery

        self.gallery = Gallery(FreeCADGui.getMainWindow(), whole=True)
        self.gallery.inserted.connect(make)
        self.gallery.show()


def make(text):
    """Adds an f-rep solid of a text and opens its panel."""
    if FreeCADGui.Control.activeDialog():
        FreeCAD.Console.PrintError("Fieldfab: close the task panel first\n")
        return
    document = FreeCAD.ActiveDocument or FreeCAD.newDocument()
    document.openTransaction("Shape gallery")
    obj = solid.create(frep_solid.FrepSolid, document)
    obj.Expression = text
    document.recompute([obj])
    if len(document.Objects) == 1:
        FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    FreeCADGui.ActiveDocument.setEdit(obj.Name)


TITLE = "Fieldfab design"
COMMANDS = {"Fieldfab_ShapeGallery": ShapeGallery()}
