"""A tool of a CAM set-up. Lengths are mm, angles degrees."""

import re

from .. import units
from ..words import described, marked, tr
from .document_object import DocumentObject, create_object

# {shape: properties that it needs besides the diameter}
SHAPES = marked({
    "flat": (), "ball": (), "bull": ("CornerRadius",), "v": ("Angle", "TipDiameter"),
    "tapered": ("Angle", "CornerRadius"), "drill": ("Angle",),
})
# {name in job files (docs/cam.md): property}
LENGTHS = {
    "diameter": described("Diameter", "Greatest diameter of the cutting part", 3),
    "corner_radius": described("CornerRadius",
                               "Corner radius of a bull-nose, or tip radius of a tapered ball end mill", 0.5),
    "tip_diameter": described("TipDiameter", "Diameter of the flat tip of a V-bit", 0),
    "flute": described("Flute", "Length of the cutting edges; 0: unknown", 0),
    "length": described("StickOut", "Distance from the tip to the holder; 0: unknown", 0),
    "shank": described("Shank", "Shank diameter; 0: that of the cutting part", 0),
    "holder_diameter": described("HolderDiameter", "Diameter of the holder; 0: unknown", 0),
    "holder_length": described("HolderLength", "Length of the holder; 0: unknown", 0),
}


# {shape: default name, with the diameter}
NAMES = {
    "flat": marked("{diameter} end mill"), "ball": marked("{diameter} ball end mill"),
    "bull": marked("{diameter} bull-nose end mill"),
    "v": marked("{diameter} V-bit"), "tapered": marked("{diameter} tapered ball end mill"),
    "drill": marked("{diameter} drill"),
}


class CamTool(DocumentObject):
    """A tool. Its label follows its shape and diameter until the user edits the label."""

    NAME = "CamTool"
    _follows = False  # whether the label before a change was the default name

    def add_properties(self, obj):
        self.add(obj, "IntegerConstraint", "Number", "Tool", "Tool number in the machine", (1, 1, 9999, 1))
        self.add_choice(obj, "Shape", "Tool", "Shape of the tip", SHAPES)
        for name, words, value in LENGTHS.values():
            self.add(obj, "Length", name, "Tool", words, value)
        self.add(obj, "Angle", "Angle", "Tool", "Included angle of the tip", 60)
        self.add(obj, "IntegerConstraint", "Flutes", "Tool", "Number of cutting edges", (2, 1, 100, 1))
        self.add(obj, "Speed", "Feed", "Speeds", "Feed rate of cuts; 0: that of the material or the operation", 0)
        self.add(obj, "Speed", "Plunge", "Speeds", "Feed rate of plunges; 0: that of the material or the operation", 0)
        self.add(obj, "FloatConstraint", "Spindle", "Speeds",
                 "Spindle speed in rpm; 0: that of the material or the operation", (0.0, 0.0, 1e6, 100.0))
        self.show_what_matters(obj)

    def onBeforeChange(self, obj, name):
        if name in ("Shape", "Diameter"):
            self._follows = _in_its_own_history(obj) and any(
                re.fullmatch(re.escape(each) + r"\d*", obj.Label) for each in _names(obj))

    def onChanged(self, obj, name):
        if name == "Shape":
            self.show_what_matters(obj)
        if name in ("Shape", "Diameter") and self._follows and _in_its_own_history(obj):
            self._follows = False
            obj.Label = name_of(obj)

    @staticmethod
    def show_what_matters(obj):
        for name in {name for needed in SHAPES.values() for name in needed}:
            if name in obj.PropertiesList:
                obj.setEditorMode(name, 0 if name in SHAPES[obj.Shape] else 2)

    def execute(self, obj):
        if not obj.Diameter.Value > 0:
            raise ValueError(tr("{label}: Diameter must be above 0").format(label=obj.Label))


def _in_its_own_history(obj):
    return (not obj.Document.Restoring and not obj.Document.Transacting
            and {"Shape", "Diameter"} <= set(obj.PropertiesList))


def name_of(obj):
    """Returns the default name of a tool of this shape and diameter."""
    return _names(obj)[0]


def _names(obj):
    """Returns all default names of a tool: in the user's language and unit, in English, in mm and in inches, and as
    written by earlier versions."""
    diameter, form = obj.Diameter.Value, NAMES[obj.Shape]
    sizes, forms = ((units.told(diameter, digits=6), f"{diameter:g} mm", f"{diameter / units.INCH:.6g} in"),
                    (tr(form), form))
    return *(form.format(diameter=size) for size in sizes for form in forms), f"{diameter:g} mm {obj.Shape}"


def values_of(obj):
    """Returns the tool as {name: value} with the names of job files; the tool's name comes last."""
    needed = SHAPES[obj.Shape]
    told = {"number": obj.Number, "shape": obj.Shape}
    for name, (prop, words, standard) in LENGTHS.items():
        value = getattr(obj, prop).Value
        if value > 0 and (prop not in ("CornerRadius", "TipDiameter") or prop in needed):
            told[name] = value
    if "Angle" in needed:
        told["angle"] = obj.Angle.Value
    for name, value in (("flutes", obj.Flutes), ("feed", obj.Feed.Value * 60), ("plunge", obj.Plunge.Value * 60),
                        ("spindle", obj.Spindle)):
        if value > 0:
            told[name] = value
    return {**told, "name": obj.Label}


def take(obj, told):
    """Sets the object's properties from a tool with the names of job files."""
    for name, value in told.items():
        if name in LENGTHS:
            setattr(obj, LENGTHS[name][0], value)
        elif name in ("feed", "plunge"):
            setattr(obj, name.capitalize(), value / 60)
        elif name == "spindle":
            obj.Spindle = value
        elif name == "name":
            obj.Label = value
        else:
            setattr(obj, name.capitalize(), value)


def add(setup, told=None):
    """Adds a tool, given with the names of job files, to a set-up. If its number is missing or taken, it gets the next
    free one. Returns the object; computes nothing."""
    tool, told = create_object(CamTool, setup.Document, "Tool"), dict(told or {})
    taken = {other.Number for other in setup.Tools}
    if told.get("number", 0) in taken or "number" not in told:
        told["number"] = max(taken, default=0) + 1
    take(tool, told)
    if "name" not in told:
        tool.Label = name_of(tool)
    setup.Tools = [*setup.Tools, tool]
    return tool
