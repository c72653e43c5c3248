"""Commands for designs made of the library's shapes."""

import FreeCAD
import FreeCADGui

from ..objects import frep_solid, solid
from ..panels.gallery import Gallery
from ..words import tr
from .command import Command


class ShapeGallery(Command):
    """Opens the gallery. The chosen shape becomes a solid with its numbers as properties, and its task panel opens. All
    of this is one undo step."""

    def Activated(self):
        self.gallery = Gallery(FreeCADGui.getMainWindow(), whole=True)
        self.gallery.inserted.connect(lambda text: make(text, self.gallery.chosen.name))
        self.gallery.show()


def make(text, name):
    """Adds an f-rep solid with the given text, labelled after its shape, and opens its panel."""
    if FreeCADGui.Control.activeDialog():
        FreeCAD.Console.PrintError("Fieldfab: " + tr("close the task panel first") + "\n")
        return
    document = FreeCAD.ActiveDocument or FreeCAD.newDocument()
    document.openTransaction(tr("Shape gallery"))
    obj = solid.create(frep_solid.FrepSolid, document)
    obj.Label, obj.Expression = name.replace("_", " ").capitalize(), text
    if len(document.Objects) == 1:
        FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
    FreeCADGui.ActiveDocument.setEdit(obj.Name)


TITLE = "Fieldfab design"
COMMANDS = {
    "Fieldfab_ShapeGallery": ShapeGallery(
        "ShapeGallery", "Shape gallery", "Choose a shape by its picture and make a solid of it",
        "Shows the pictures of all shapes of the library and of the designs, by groups or by words; nothing needs to "
        "be selected. The shape that is chosen becomes an f-rep solid whose numbers are its parameters."),
}
