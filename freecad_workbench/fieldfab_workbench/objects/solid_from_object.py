"""Solids from meshes, Part shapes and bodies."""

from ..geometry import source_of_geometry
from ..words import tr
from .solid import Solid, source_of


class SolidFromObject(Solid):
    """The solid bounded by another object's mesh or shape. A mesh may have holes and overlaps (docs/contouring.md)."""

    NAME = "SolidFromObject"

    def add_own_properties(self, obj):
        self.add(obj, "Link", "Source", "Solid", "A mesh, a Part object or a body")
        self.add(obj, "Length", "Deflection", "Solid",
                 "Greatest distance of triangles from a Part shape; 0: 1/2000 of its size", 0)

    def source(self, obj):
        if obj.Source is None:
            raise ValueError(
                tr("{label}: choose a mesh, a Part object or a body as its Source").format(label=obj.Label))
        if obj.Deflection.Value and hasattr(obj.Source, "Shape"):
            return source_of_geometry(obj.Source, obj.Deflection.Value).moved(obj.Source.getGlobalPlacement())
        return source_of(obj.Source)
