"""Meshes and Part shapes of a document as sources of solids."""

import hashlib

from . import meshes
from .sources import Source
from .words import tr


def source_of_geometry(obj, deflection=None):
    """Returns the Source of a mesh or a shape, in the object's own coordinates. `deflection`: maximum distance of the
    triangles from a shape, mm. Raises ValueError with a line for the user."""
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
    key = ("mesh", hashlib.sha1(data).hexdigest())
    return Source(key, lambda progress: meshes.from_bms(data).solid(progress, close_holes=True))


def _mesh_of_shape(obj, deflection):
    import MeshPart  # imported late: the workbench must load quickly

    shape = obj.Shape.copy()
    shape.Placement = type(shape.Placement)()
    if not shape.Solids:
        raise ValueError(tr("{label} has no solid: faces and wires enclose no volume").format(label=obj.Label))
    deflection = deflection or shape.BoundBox.DiagonalLength / 2000
    return MeshPart.meshFromShape(Shape=shape, LinearDeflection=deflection, AngularDeflection=0.2)
