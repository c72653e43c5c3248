"""The workbench's commands."""

import os

import FreeCAD
import FreeCADGui

from . import frep_solid
from .view import ICONS


class NewFrepSolid:
    """Adds an f-rep solid, shows it, and opens its task panel."""

    def GetResources(self):
        return {
            "Pixmap": os.path.join(ICONS, "new_frep_solid.svg"),
            "MenuText": "New f-rep solid",
            "ToolTip": "Make a solid from a formula, recomputed whenever the formula changes",
        }

    def IsActive(self):
        return FreeCADGui.Control.activeDialog() is False or not FreeCADGui.Control.activeDialog()

    def Activated(self):
        document = FreeCAD.ActiveDocument or FreeCAD.newDocument()
        document.openTransaction("New f-rep solid")
        solid = frep_solid.create(document)
        document.recompute([solid])
        FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
        FreeCADGui.SendMsgToActiveView("ViewFit")
        FreeCADGui.ActiveDocument.setEdit(solid.Name)


def register():
    """Registers the commands; returns their names in toolbar order."""
    FreeCADGui.addCommand("Fieldfab_NewFrepSolid", NewFrepSolid())
    return ["Fieldfab_NewFrepSolid"]
