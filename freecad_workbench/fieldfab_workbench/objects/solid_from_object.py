"""Meshes, Part shapes and bodies as solids."""

import hashlib

from .. import meshes
from ..sources import Source
from ..words import tr
from .solid import Solid, source_of


def source_of_geometry(obj, deflection=None):
    """The Source of a mesh or a shape, in the object's own coordinates. `deflection`: how far triangles may be from a shape, mm."""
    if hasattr(obj, "Mesh"):
        mesh = obj.Mesh.copy()
        mesh.Placement = type(mesh.Placement)()
    elif hasattr(obj, "Shape") and not obj.Shape.isNull():
        mesh = _mesh_of_shape(obj, deflection)
    else:
        raise ValueError(tr("{label} has neither a mesh nor a shape").format(label=obj.Label))
    if mesh.CountFacets == 0:
        raise ValueError(tr("{label} is empty").format(label=obj.Label))
    data = meshes.bms_of(mesh)
    return Source(("mesh", hashlib.sha1(data).hexdigest()), lambda progress: meshes.from_bms(data).field(progress, close_holes=True))


def _mesh_of_shape(obj, deflection):
    import MeshPart

    shape = obj.Shape.copy()
    shape.Placement = type(shape.Placement)()
    if not shape.Solids:
        raise ValueError(tr("{label} has no solid: faces and wires bound nothing").format(label=obj.Label))
    return MeshPart.meshFromShape(Shape=shape, LinearDeflection=deflection or shape.BoundBox.DiagonalLength / 2000, AngularDeflection=0.2)


class SolidFromObject(Solid):
    """A solid where another object's mesh or shape is. Holes and overlaps of a mesh do no harm (docs/contouring.md)."""

    NAME = "SolidFromObject"

    def add_own_properties(self, obj):
        self.add(obj, "Link", "Source", "Solid", "A mesh, a Part object or a body")
        self.add(obj, "Length", "Deflection", "Solid", "How far triangles may be from a Part shape; 0 means 1/2000 of its size", 0)

    def source(self, obj):
        if obj.Source is None:
            raise ValueError(tr("{label}: choose a mesh, a Part object or a body as its Source").format(label=obj.Label))
        if obj.Deflection.Value and hasattr(obj.Source, "Shape"):
            return source_of_geometry(obj.Source, obj.Deflection.Value).moved(obj.Source.getGlobalPlacement())
        return source_of(obj.Source)
