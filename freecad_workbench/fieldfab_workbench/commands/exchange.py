"""Solids checked, and made into the other kinds of FreeCAD's objects."""

import FreeCAD
import FreeCADGui

from ..objects import part_shape
from ..objects.solid import is_solid
from .command import Command


def chosen_meshes():
    """The selected objects that have a mesh: our solids, and plain meshes."""
    return [obj for obj in FreeCADGui.Selection.getSelection() if hasattr(obj, "Mesh") and obj.Mesh.CountFacets]


class _Conversion(Command):
    """Makes something of each selected solid, which is then hidden: one undo step."""

    def ready(self):
        return bool(chosen_meshes())

    def Activated(self):
        document, sources = FreeCAD.ActiveDocument, chosen_meshes()
        document.openTransaction(self.title)
        for source in sources:
            made = self.make(document, source)
            document.recompute([made])
            source.ViewObject.Visibility = not made.isValid()
        document.commitTransaction()


class ToMesh(_Conversion):
    def make(self, document, source):
        return to_mesh(document, source)


def to_mesh(document, source):
    """A plain copy of an object's mesh, where it is and in its colour."""
    made = document.addObject("Mesh::Feature", f"{source.Name}Mesh")
    made.Label = f"{source.Label} mesh"
    mesh = source.Mesh.copy()
    mesh.Placement = FreeCAD.Placement()
    made.Mesh = mesh
    made.Placement = source.getGlobalPlacement()
    if FreeCAD.GuiUp:
        for name in ("ShapeColor", "Transparency"):
            setattr(made.ViewObject, name, getattr(source.ViewObject, name))
    return made


class ToPartShape(_Conversion):
    def make(self, document, source):
        return part_shape.create(document, source)


class CrossCheck(Command):
    def ready(self):
        return len(_chosen_solids()) == 1

    def Activated(self):
        from ..panels.check_panel import CheckPanel

        FreeCADGui.Control.showDialog(CheckPanel(_chosen_solids()[0]))


def _chosen_solids():
    return [obj for obj in FreeCADGui.Selection.getSelection() if is_solid(obj) and obj.Mesh.CountFacets]


TITLE = "Check and exchange"
COMMANDS = {
    "Fieldfab_CrossCheck": CrossCheck(
        "CrossCheck", "Cross-check", "Check the selected solid against OpenVDB and CGAL, and show where its mesh deviates",
        "Checks one selected solid against OpenVDB and CGAL beside the window, and shows each figure with its bound. The mesh takes the colours of its "
        "deviations until the panel is closed; nothing of the document is changed."),
    "Fieldfab_ToMesh": ToMesh(
        "ToMesh", "To mesh", "Make a plain mesh of the selected solid, as it is now",
        "Makes a plain copy of the mesh of each selected solid, which does not follow it, and hides the solid. There is no panel."),
    "Fieldfab_ToPartShape": ToPartShape(
        "PartShape", "To Part shape", "Make a Part shape that follows the selected solid, reduced to some thousand flat faces",
        "Makes an object for Part, Part Design and TechDraw that follows each selected solid. Its faces are flat: the mesh is reduced to the number of "
        "triangles that its property MostTriangles says."),
}
