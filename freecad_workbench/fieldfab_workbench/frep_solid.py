"""The document object of an f-rep solid: an expression that recomputes to a mesh."""

import os
import tempfile

import FreeCAD
import Mesh

from . import kernel

DEFAULT = """# a rounded box with a gyroid inside
outer = rounded_box(40, 40, 40, 6)
walls = shell(gyroid(period = 14), 1.6)
window = sphere(r = 25)
difference(shell(outer, 2.4), window) | (outer & walls)
"""

# Properties whose change asks for a new mesh.
SHAPING = ("Expression", "VoxelSize", "MaxError", "AutoBounds", "Lower", "Upper")


class FrepSolid:
    """Proxy of a Mesh::FeaturePython object. Lengths are mm."""

    def __init__(self, obj):
        obj.Proxy = self
        add = obj.addProperty
        add("App::PropertyString", "Expression", "F-rep", "The solid as .frep text or as a prefix math string").Expression = DEFAULT
        add("App::PropertyLength", "VoxelSize", "F-rep", "Edge of the smallest cell; 0 means 1/128 of the longest side").VoxelSize = 0
        add("App::PropertyLength", "MaxError", "F-rep", "How far the mesh may be from the solid; 0 means a tenth of the smallest cell").MaxError = 0
        add("App::PropertyBool", "AutoBounds", "Region", "Find the solid's bounds by interval search").AutoBounds = True
        add("App::PropertyVector", "Lower", "Region", "Lower corner of the region, where bounds are not found").Lower = FreeCAD.Vector(-50, -50, -50)
        add("App::PropertyVector", "Upper", "Region", "Upper corner of the region, where bounds are not found").Upper = FreeCAD.Vector(50, 50, 50)
        add("App::PropertyVolume", "Volume", "Result", "Volume of the mesh", 1)
        add("App::PropertyInteger", "Triangles", "Result", "Triangles of the mesh", 1)

    def execute(self, obj):
        """Makes the mesh. What goes wrong is raised: FreeCAD then marks the object, which keeps the mesh it had."""
        fieldfab = kernel.load()
        voxel = obj.VoxelSize.Value or None
        bounds = None if obj.AutoBounds else (*obj.Lower, *obj.Upper)
        try:
            solid = fieldfab.parse(obj.Expression)
            mesh = fieldfab.mesh(solid, bounds=bounds, voxel=voxel, max_error=obj.MaxError.Value or None)
        except fieldfab.Error as error:
            raise ValueError(f"{obj.Label}: {error}") from None
        obj.Mesh = to_freecad(mesh)
        obj.Volume = mesh.volume
        obj.Triangles = len(mesh.triangles)

    # The proxy keeps nothing of its own in the document.
    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads


def to_freecad(mesh):
    """A fieldfab Mesh as a FreeCAD mesh, through a file: the fastest way that FreeCAD's own mesh code offers."""
    result = Mesh.Mesh()
    if len(mesh.triangles) == 0:
        return result
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "solid.ply")
        mesh.save(path)
        result.read(path)
    return result


def create(document, name="FrepSolid"):
    """Adds an f-rep solid to the document; not yet computed."""
    obj = document.addObject("Mesh::FeaturePython", name)
    FrepSolid(obj)
    if FreeCAD.GuiUp:
        from .view import FrepSolidView

        FrepSolidView(obj.ViewObject)
    return obj
