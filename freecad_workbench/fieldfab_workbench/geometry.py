"""Meshes and Part shapes of the document as sources of solids."""

import hashlib

from . import meshes
from .sources import Source
from .words import tr


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
    import MeshPart  # not before it is needed: it takes half a second

    shape = obj.Shape.copy()
    shape.Placement = type(shape.Placement)()
    if not shape.Solids:
        raise ValueError(tr("{label} has no solid: faces and wires bound nothing").format(label=obj.Label))
    return MeshPart.meshFromShape(Shape=shape, LinearDeflection=deflection or shape.BoundBox.DiagonalLength / 2000, AngularDeflection=0.2)
