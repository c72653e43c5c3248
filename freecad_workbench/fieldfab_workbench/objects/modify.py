"""Modifications of one solid: offset, shell, infill, copies and transforms."""

import functools
import math

import FreeCAD

from .. import kernel
from ..openscad import OpenScadSource
from ..sources import Source
from ..words import marked, tr
from .solid import Solid, csg_of, source_of

# {operation: properties that it needs}
OPERATIONS = marked({
    "Offset": ("Distance",),
    "Shell": ("Wall",),
    "Lattice infill": ("Wall", "Lattice", "Period", "Strut"),
    "Mirror": ("Direction", "Centre", "KeepOriginal"),
    "Linear array": ("Step", "Count"),
    "Polar array": ("Direction", "Centre", "Count", "Angle"),
    "Transform": ("Factors", "Turn", "Direction", "Centre", "Step"),
})
# {operation: the property whose magnitude is the needed distance from the source's surface}
REACHES = {"Offset": "Distance", "Shell": "Wall", "Lattice infill": "Wall"}
# {kind of lattice: its function of the library}
LATTICES = marked({
    "gyroid": "gyroid",
    "schwarz_p": "schwarz_p",
    "diamond": "diamond",
    "spinodal": "spinodal",
    "cubic struts": "cubic_struts",
    "BCC struts": "bcc_struts",
    "FCC struts": "fcc_struts",
    "octet struts": "octet_struts",
    "honeycomb": "honeycomb_walls",
})


def _mirrored(field, normal, centre):
    return field.translate(*(-centre)).mirror(normal).translate(*centre)


def _turned(field, axis, centre, angle):
    return field.translate(*(-centre)).rotate(axis, angle).translate(*centre)


class Modify(Solid):
    """Offset, shell, lattice infill, mirror, arrays and transforms of another object's solid."""

    NAME = "Modify"

    def add_own_properties(self, obj):
        if "Operation" not in obj.PropertiesList:
            obj.addProperty("App::PropertyEnumeration", "Operation", "Modify",
                            "How the source is modified").Operation = list(OPERATIONS)
        if "Lattice" not in obj.PropertiesList:
            obj.addProperty("App::PropertyEnumeration", "Lattice", "Modify", "Kind of lattice").Lattice = list(LATTICES)
        elif obj.getEnumerationsOfProperty("Lattice") != list(LATTICES):  # of an earlier version
            chosen, obj.Lattice = obj.Lattice, list(LATTICES)
            obj.Lattice = chosen
        add = functools.partial(self.add, obj)
        add("Link", "Source", "Modify", "A solid, mesh, Part object or body")
        add("Distance", "Distance", "Modify", "Distance outwards; negative values inwards", 1)
        add("Length", "Wall", "Modify", "Thickness of the wall, inwards; 0 for a lattice without one", 1.2)
        add("Length", "Period", "Modify", "Edge length of a lattice cell", 10)
        add("Length", "Strut", "Modify", "Thickness of the lattice's walls or struts", 1)
        add("Vector", "Direction", "Modify",
            "Normal of the mirror plane, or direction of the axis", FreeCAD.Vector(0, 0, 1))
        add("Vector", "Centre", "Modify", "Point on the mirror plane or axis")
        add("Bool", "KeepOriginal", "Modify", "Unite the mirror image with the original", True)
        add("Vector", "Step", "Modify",
            "Step from one copy to the next, or the move of a transform", FreeCAD.Vector(20, 0, 0))
        add("IntegerConstraint", "Count", "Modify", "Number of copies, including the original", (4, 1, 1000, 1))
        add("Angle", "Angle", "Modify", "Angle that the copies fill; 360 degrees is a full turn", 360)
        add("Vector", "Factors", "Modify", "Scale factors along x, y and z", FreeCAD.Vector(1, 1, 1))
        add("Angle", "Turn", "Modify", "Rotation about the axis", 0)
        self.show_what_matters(obj)

    def onChanged(self, obj, name):
        if name == "Operation":
            self.show_what_matters(obj)

    @staticmethod
    def show_what_matters(obj):
        for name in {name for needed in OPERATIONS.values() for name in needed}:
            if name in obj.PropertiesList:
                obj.setEditorMode(name, 0 if name in OPERATIONS[obj.Operation] else 2)

    def csg(self, obj):
        """Returns the OpenSCAD text of a transformed OpenSCAD shape, which may be flat; otherwise None."""
        text = csg_of(obj.Source) if obj.Operation == "Transform" and obj.Source is not None else None
        return text and text.placed(self.matrix(obj).A, obj.Label)

    @staticmethod
    def matrix(obj):
        """Returns the FreeCAD matrix of a transform."""
        scaled = FreeCAD.Matrix()
        scaled.scale(obj.Factors)
        turn = FreeCAD.Rotation(obj.Direction, obj.Turn.Value) if obj.Turn.Value else FreeCAD.Rotation()
        return FreeCAD.Placement(obj.Step, turn, obj.Centre).toMatrix() * scaled

    def source(self, obj):
        if obj.Source is None:
            raise ValueError(tr("{label}: choose a Source").format(label=obj.Label))
        operation = obj.Operation
        values = {name: self._plain(getattr(obj, name)) for name in OPERATIONS[operation]}
        self.check(obj, values)
        text = self.csg(obj)
        if text is not None:
            return OpenScadSource(text, obj.Label)
        source = source_of(obj.Source)
        make = getattr(self, "_" + operation.lower().replace(" ", "_"))
        reach = abs(values[REACHES[operation]]) if operation in REACHES else 0

        def modified(progress):
            return make(source.distances(reach, progress) if reach else source.field(progress), **values)

        return Source(("modify", operation, source.digest, sorted(values.items())), modified)

    @staticmethod
    def _plain(value):
        if isinstance(value, FreeCAD.Vector):
            return tuple(value)
        return getattr(value, "Value", value)

    @staticmethod
    def check(obj, values):
        """Raises ValueError for values that give no valid solid."""
        for name in ("Wall", "Period", "Strut"):
            bare = name == "Wall" and obj.Operation == "Lattice infill" and values[name] == 0
            if name in values and not values[name] > 0 and not bare:
                raise ValueError(tr("{label}: {name} must be above 0").format(label=obj.Label, name=name))
        if "Direction" in values and not any(values["Direction"]) and (obj.Operation != "Transform" or values["Turn"]):
            raise ValueError(tr("{label}: Direction has no length").format(label=obj.Label))
        if "Factors" in values and not all(values["Factors"]):
            raise ValueError(tr("{label}: a factor is 0").format(label=obj.Label))

    @staticmethod
    def _offset(field, Distance):
        return field.offset(Distance)

    @staticmethod
    def _shell(field, Wall):
        return field - field.offset(-Wall)

    @staticmethod
    def _lattice_infill(field, Wall, Lattice, Period, Strut):
        shapes = kernel.load().shapes
        lattice = shapes.shell(getattr(shapes, LATTICES[Lattice])(Period), Strut)
        return (field - field.offset(-Wall)) | (field & lattice) if Wall else field & lattice

    @staticmethod
    def _mirror(field, Direction, Centre, KeepOriginal):
        mirrored = _mirrored(field, Direction, FreeCAD.Vector(*Centre))
        return field | mirrored if KeepOriginal else mirrored

    @staticmethod
    def _linear_array(field, Step, Count):
        return functools.reduce(lambda a, b: a | b, (field.translate(*(i * s for s in Step)) for i in range(Count)))

    @staticmethod
    def _polar_array(field, Direction, Centre, Count, Angle):
        centre = FreeCAD.Vector(*Centre)
        copies = (_turned(field, Direction, centre, math.radians(i * Angle / Count)) for i in range(Count))
        return functools.reduce(lambda a, b: a | b, copies)

    @staticmethod
    def _transform(field, Factors, Turn, Direction, Centre, Step):
        scaled = field.scale(*Factors)
        turned = _turned(scaled, Direction, FreeCAD.Vector(*Centre), math.radians(Turn)) if Turn else scaled
        return turned.translate(*Step)
