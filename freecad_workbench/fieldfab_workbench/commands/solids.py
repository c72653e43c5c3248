"""Commands that make solids, also from other solids."""

import FreeCAD
import FreeCADGui

from ..objects import combine, frep_solid, modify, script_solid, solid, solid_from_object
from ..words import tr
from .command import Command


class NewSolid(Command):
    """Adds a solid of one kind, made from the selection, and opens its task panel. This is one undo step, which Cancel
    reverts."""

    def __init__(self, kind, words, tip, help, needs=0, **properties):
        super().__init__(properties.get("Operation", kind.NAME), words, tip, help)
        self.kind, self.needs, self.properties = kind, needs, properties

    def ready(self):
        return len(selected()) >= self.needs

    def Activated(self):
        document, chosen = FreeCAD.ActiveDocument or FreeCAD.newDocument(), selected()
        document.openTransaction(self.title)
        obj = solid.create(self.kind, document)
        for name, value in self.properties.items():
            setattr(obj, name, value)
        obj.Label = self.title if self.properties else tr("Solid")  # the kind, in the user's language
        if self.needs and hasattr(obj, "Sources"):
            obj.Sources = chosen
        elif self.needs:
            obj.Source = chosen[0]
        if self.needs:
            document.recompute([obj])  # otherwise the panel previews it in the background and its OK makes it
        for used in chosen if self.needs else []:
            used.ViewObject.Visibility = not obj.isValid()
        if len(document.Objects) == 1:
            FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
            if self.needs:
                FreeCADGui.SendMsgToActiveView("ViewFit")
        FreeCADGui.ActiveDocument.setEdit(obj.Name)


def selected():
    """Returns the selected objects that bound a solid."""
    return [obj for obj in FreeCADGui.Selection.getSelection()
            if hasattr(obj, "Mesh") or getattr(getattr(obj, "Shape", None), "Solids", None)]


TITLE = "Fieldfab"
COMMANDS = {
    "Fieldfab_NewFrepSolid": NewSolid(
        frep_solid.FrepSolid, "New f-rep solid", "Make a solid from a formula, recomputed whenever the formula changes",
        "Makes a solid from .frep text or a prefix math string; nothing needs to be selected. The panel has an editor, "
        "a slider for each number of the text, and the resolution; the solid is seen while it is written."),
    "Fieldfab_NewScriptSolid": NewSolid(
        script_solid.ScriptSolid, "New Python model", "Make a solid by a Python script that the document keeps",
        "Makes a solid by a Python script; nothing needs to be selected. The panel has an editor, a slider for each "
        "named number of the script, and marks the line of an error. The script runs only after you have agreed for "
        "the document, in a process of its own; the document keeps the script and the formula that it made."),
    "Fieldfab_SolidFromObject": NewSolid(
        solid_from_object.SolidFromObject, "Solid from object",
        "Make a solid of the selected mesh, Part object or body",
        "Makes a solid of a mesh, a Part object or a body, which follows that object. Select the object first. "
        "Holes and overlaps of a mesh do no harm; the panel asks how far triangles may be from a Part shape.", 1),
    "Fieldfab_Union": NewSolid(
        combine.Combine, "Union", "Unite the selected solids",
        "Makes one solid of two or more. Select solids, meshes, Part objects or bodies; "
        "the panel lists them and takes others in.", 2, Operation="Union"),
    "Fieldfab_Intersection": NewSolid(
        combine.Combine, "Intersection", "Make the intersection of the selected solids",
        "Makes the common volume of two or more solids. Select solids, meshes, Part objects or bodies; the panel "
        "lists them.", 2,
        Operation="Intersection"),
    "Fieldfab_Difference": NewSolid(
        combine.Combine, "Difference", "Subtract the other selected solids from the first",
        "Subtracts all other selected solids from the one that was selected first. Drag them in the panel to "
        "change their order.", 2,
        Operation="Difference"),
    "Fieldfab_Blend": NewSolid(
        combine.Combine, "Blend", "Unite the selected solids with a fillet",
        "Makes one solid of two or more, with a fillet where they meet. Select them first; "
        "the panel asks for the fillet's radius.", 2, Operation="Blend"),
    "Fieldfab_Morph": NewSolid(
        combine.Combine, "Morph", "Make a solid between two selected solids",
        "Makes a solid between two others. Select both; the panel asks for the weight: 0 gives the first, 1 the "
        "second.",
        2, Operation="Morph"),
    "Fieldfab_Offset": NewSolid(
        modify.Modify, "Offset", "Grow or shrink the selected solid",
        "Makes a solid whose surface lies at a distance from that of the selected one. "
        "The panel asks for the distance: outwards, below 0 inwards.", 1,
        Operation="Offset"),
    "Fieldfab_Shell": NewSolid(
        modify.Modify, "Shell", "Hollow the selected solid",
        "Makes a hollow solid of the selected one, with the same outer surface. The panel asks for the wall's "
        "thickness.", 1,
        Operation="Shell"),
    "Fieldfab_LatticeInfill": NewSolid(
        modify.Modify, "Lattice infill", "Hollow the selected solid and fill it with a lattice",
        "Makes a light solid of the selected one: a wall, and a lattice inside. The panel asks for the wall, "
        "the kind of lattice, the edge of its cell and the thickness of its struts.", 1, Operation="Lattice infill"),
    "Fieldfab_Mirror": NewSolid(
        modify.Modify, "Mirror", "Mirror the selected solid",
        "Makes the mirror image of the selected solid, with or without the original. "
        "The panel asks for the mirror's normal and a point of it.", 1,
        Operation="Mirror"),
    "Fieldfab_LinearArray": NewSolid(
        modify.Modify, "Linear array", "Copy the selected solid in a row",
        "Makes one solid of copies of the selected one in a row. The panel asks for the step from one copy to the "
        "next and for their number.", 1,
        Operation="Linear array"),
    "Fieldfab_PolarArray": NewSolid(
        modify.Modify, "Polar array", "Copy the selected solid around an axis",
        "Makes one solid of copies of the selected one around an axis. "
        "The panel asks for the axis, the number of copies and the angle that they fill.", 1,
        Operation="Polar array"),
    "Fieldfab_Transform": NewSolid(
        modify.Modify, "Transform", "Scale, turn and move the selected solid",
        "Makes a solid of the selected one, scaled along x, y and z, turned about an axis and moved. "
        "The panel asks for all of these.", 1,
        Operation="Transform"),
}
