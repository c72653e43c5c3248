"""Making solids, and solids of solids."""

import FreeCAD
import FreeCADGui

from ..objects import combine, frep_solid, modify, solid, solid_from_object
from ..views.solid_view import icon


class NewSolid:
    """Adds a solid of one kind, made from what is selected, and opens its task panel: one undo step, which Cancel takes back."""

    def __init__(self, kind, words, tip, needs=0, **properties):
        self.kind, self.words, self.tip, self.needs, self.properties = kind, words, tip, needs, properties
        self.pixmap = icon(properties.get("Operation", kind.NAME))

    def GetResources(self):
        return {"Pixmap": self.pixmap, "MenuText": self.words, "ToolTip": self.tip}

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog() and len(selected()) >= self.needs

    def Activated(self):
        document, chosen = FreeCAD.ActiveDocument or FreeCAD.newDocument(), selected()
        document.openTransaction(self.words)
        obj = solid.create(self.kind, document)
        for name, value in self.properties.items():
            setattr(obj, name, value)
        if self.needs and hasattr(obj, "Sources"):
            obj.Sources = chosen
        elif self.needs:
            obj.Source = chosen[0]
        document.recompute([obj])
        for used in chosen if self.needs else []:
            used.ViewObject.Visibility = not obj.isValid()
        if len(document.Objects) == 1:
            FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
            FreeCADGui.SendMsgToActiveView("ViewFit")
        FreeCADGui.ActiveDocument.setEdit(obj.Name)


def selected():
    """The selected objects that bound something."""
    return [obj for obj in FreeCADGui.Selection.getSelection() if hasattr(obj, "Mesh") or getattr(getattr(obj, "Shape", None), "Solids", None)]


TITLE = "Fieldfab"
COMMANDS = {
    "Fieldfab_NewFrepSolid": NewSolid(frep_solid.FrepSolid, "New f-rep solid", "Make a solid from a formula, recomputed whenever the formula changes"),
    "Fieldfab_SolidFromObject": NewSolid(solid_from_object.SolidFromObject, "Solid from object", "Make a solid of the selected mesh, Part object or body", 1),
    "Fieldfab_Union": NewSolid(combine.Combine, "Union", "Unite the selected solids", 2, Operation="Union"),
    "Fieldfab_Intersection": NewSolid(combine.Combine, "Intersection", "Keep what all selected solids share", 2, Operation="Intersection"),
    "Fieldfab_Difference": NewSolid(combine.Combine, "Difference", "Take the other selected solids out of the first", 2, Operation="Difference"),
    "Fieldfab_Blend": NewSolid(combine.Combine, "Blend", "Unite the selected solids with a fillet", 2, Operation="Blend"),
    "Fieldfab_Morph": NewSolid(combine.Combine, "Morph", "Make what lies between two selected solids", 2, Operation="Morph"),
    "Fieldfab_Offset": NewSolid(modify.Modify, "Offset", "Grow or shrink the selected solid", 1, Operation="Offset"),
    "Fieldfab_Shell": NewSolid(modify.Modify, "Shell", "Hollow the selected solid", 1, Operation="Shell"),
    "Fieldfab_LatticeInfill": NewSolid(modify.Modify, "Lattice infill", "Hollow the selected solid and fill it with a lattice", 1, Operation="Lattice infill"),
    "Fieldfab_Mirror": NewSolid(modify.Modify, "Mirror", "Mirror the selected solid", 1, Operation="Mirror"),
    "Fieldfab_LinearArray": NewSolid(modify.Modify, "Linear array", "Copies of the selected solid in a row", 1, Operation="Linear array"),
    "Fieldfab_PolarArray": NewSolid(modify.Modify, "Polar array", "Copies of the selected solid around an axis", 1, Operation="Polar array"),
    "Fieldfab_Transform": NewSolid(modify.Modify, "Transform", "Scale, turn and move the selected solid", 1, Operation="Transform"),
}
