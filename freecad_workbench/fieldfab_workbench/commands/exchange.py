"""Commands that check solids and convert them to other kinds of FreeCAD objects."""

import FreeCAD
import FreeCADGui

from ..certainty import uncertain_places
from ..objects import part_shape
from ..objects.solid import is_solid
from ..words import tr
from .command import Command


def chosen_meshes():
    """Returns the selected objects that have a mesh: Fieldfab solids and plain meshes."""
    return [obj for obj in FreeCADGui.Selection.getSelection() if hasattr(obj, "Mesh") and obj.Mesh.CountFacets]


class _Conversion(Command):
    """Converts each selected solid and hides it, in one undo step."""

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
    """Returns a new plain copy of an object's mesh, with the same placement and colour."""
    made = document.addObject("Mesh::Feature", f"{source.Name}Mesh")
    made.Label = tr("{label} mesh").format(label=source.Label)
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
        from ..panels.check_panel import CheckPanel  # needs numpy

        FreeCADGui.Control.showDialog(CheckPanel(_chosen_solids()[0]))


class ShowUncertainPlaces(Command):
    """Shows the boxes of the selected solids and zooms to the largest box of the first solid. Hides the boxes if all
    are visible."""

    def ready(self):
        return any(uncertain_places(obj) for obj in _chosen_solids())

    def Activated(self):
        from ..views.uncertain_places import look_at_largest  # needs numpy and Coin

        chosen = [obj for obj in _chosen_solids() if uncertain_places(obj)]
        if all(obj.ViewObject.Proxy.shows_places() for obj in chosen):
            for obj in chosen:
                obj.ViewObject.Proxy.hide_places()
            return
        for obj in chosen:
            obj.ViewObject.Visibility = True
            obj.ViewObject.Proxy.show_places(obj)
        look_at_largest(chosen[0])


class SectionPlane(Command):
    """Shows or removes the section plane. Stays available while a panel is open."""

    def IsActive(self):
        return hasattr(FreeCADGui.activeView(), "getSceneGraph")

    def Activated(self):
        from ..views.section import toggle  # needs Coin

        toggle(FreeCAD.ActiveDocument)


class MeasureSection(Command):
    """Measures by clicks on the section plane, which is shown first if there is none; choosing it again ends it."""

    def IsActive(self):
        return hasattr(FreeCADGui.activeView(), "getSceneGraph")

    def Activated(self):
        from ..views.section import section_of, toggle  # needs Coin

        document = FreeCAD.ActiveDocument
        if section_of(document) is None:
            toggle(document)
        shown = section_of(document)
        shown.measuring(shown.measure is None)


def _chosen_solids():
    return [obj for obj in FreeCADGui.Selection.getSelection() if is_solid(obj) and obj.Mesh.CountFacets]


TITLE = "Check and exchange"
COMMANDS = {
    "Fieldfab_CrossCheck": CrossCheck(
        "CrossCheck", "Cross-check",
        "Check the selected solid against OpenVDB and CGAL, and show where its mesh deviates",
        "Checks one selected solid against OpenVDB and CGAL in the background, and shows each figure with its "
        "bound. The mesh has the colours of its deviations until the panel is closed; the document is not changed."),
    "Fieldfab_ShowUncertainPlaces": ShowUncertainPlaces(
        "UncertainPlaces", "Show uncertain places",
        "Show where the mesh of the selected solid may lack parts, or hide these places again",
        "Draws a box around each place where the mesh is not proved to show the whole selected solid, and zooms to "
        "the largest. Choose it again to remove the boxes. It is disabled if the mesh is certain; smaller cells "
        "leave fewer and smaller places."),
    "Fieldfab_Section": SectionPlane(
        "Section", "Section plane", "Cut the view by a plane to see inside, or show everything again",
        "Cuts all solids of the view, also those of panels (scans, the stock of a simulation), across the axis "
        "that points most to you; cut faces are orange, scans that lie along the plane show their densities on it. "
        "Drag the handle on the plane to move it. Choose it again to show everything; the document is not changed."),
    "Fieldfab_MeasureSection": MeasureSection(
        "MeasureSection", "Measure on section", "Measure walls, gaps and distances by clicks on the section plane",
        "Shows the section plane if there is none. A click on it gives the thickness of the wall, or the width of the "
        "gap, from the nearest outline through that point to the other side, and the distance from the last click; "
        "clicks near an outline are on it. Choose it again to end measuring."),
    "Fieldfab_ToMesh": ToMesh(
        "ToMesh", "To mesh", "Make a plain mesh of the selected solid, as it is now",
        "Makes a plain copy of the mesh of each selected solid, which does not follow it, and hides the solid. "
        "There is no panel."),
    "Fieldfab_ToPartShape": ToPartShape(
        "PartShape", "To Part shape",
        "Make a Part shape that follows the selected solid, with flat, round and free-form faces",
        "Makes an object for Part, Part Design and TechDraw that follows each selected solid. Flat, cylindrical, "
        "conical, spherical, toroidal and smooth free-form parts become one face each. Where that gives no valid "
        "shape, all faces are flat: the mesh is reduced to the number of triangles that its property MostTriangles "
        "says."),
}
