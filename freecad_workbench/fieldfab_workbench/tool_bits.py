"""Conversion of FreeCAD's tool bits (.fctb), tool libraries (.fctl) and Path tools to Fieldfab tools: {name: value} as
in job files (docs/cam.md)."""

import json
import os

import FreeCAD

from .words import tr

SHAPES = {
    "endmill": "flat", "ballend": "ball", "bullnose": "bull", "v-bit": "v", "vbit": "v", "chamfer": "v",
    "drill": "drill",
    "taperedballnose": "tapered", "slittingsaw": "flat",
}


def _number(value):
    """Returns a number in mm or degrees from "5.0000 mm", "60.0000 °", a quantity or a number."""
    if isinstance(value, str):
        return FreeCAD.Units.Quantity(value).Value
    return float(getattr(value, "Value", value))


def tool_from(name, shape, parameter):
    """Returns a tool from a tool bit's name, the stem of its shape file, and `parameter(name)`, which returns a value
    or None. Raises ValueError for unknown shapes."""
    known = SHAPES.get(shape.lower().replace(" ", ""))
    if known is None:
        raise ValueError(tr("{name}: Fieldfab does not know the tool shape {shape}").format(name=name, shape=shape))

    def get(*names):
        values = [parameter(n) for n in names]
        return next((_number(v) for v in values if v is not None), 0.0)

    tool = {"name": name, "shape": known, "diameter": get("Diameter"), "length": get("Length"),
            "shank": get("ShankDiameter"),
            "flute": get("CuttingEdgeHeight"), "flutes": int(get("Flutes") or 2)}
    if known == "bull":
        tool["corner_radius"] = get("CornerRadius") or tool["diameter"] / 2 - get("FlatRadius")
    if known in ("v", "drill", "tapered"):
        tool["angle"] = get("CuttingEdgeAngle", "TipAngle", "TaperAngle")
    if known == "v":
        tool["tip_diameter"] = get("TipDiameter")
    if known == "tapered":
        tool["corner_radius"] = get("TaperDiameter") / 2
    if known == "drill":
        tool["flute"] = 0.0  # unknown: the whole tool counts as flute
    if not tool["diameter"] > 0:
        raise ValueError(tr("{name}: it has no diameter").format(name=name))
    return {key: value for key, value in tool.items() if value}


def read_bit(path):
    """Returns the tool in a .fctb file. Raises ValueError, OSError."""
    try:
        with open(path, encoding="utf-8") as file:
            told = json.load(file)
        shape = os.path.splitext(os.path.basename(told["shape"]))[0]
        return tool_from(told.get("name") or os.path.basename(path), shape, told["parameter"].get)
    except (KeyError, AttributeError, TypeError, json.JSONDecodeError) as error:
        raise ValueError(tr("{path}: this is no tool bit ({error})").format(path=path, error=error)) from None


def read_library(path):
    """Returns (tools, notes) of a .fctl file: the tools with their numbers, and a line for each tool that could not be
    read."""
    try:
        with open(path, encoding="utf-8") as file:
            listed = [(int(tool["nr"]), tool["path"]) for tool in json.load(file)["tools"]]
    except (KeyError, TypeError, ValueError) as error:
        raise ValueError(tr("{path}: this is no tool library ({error})").format(path=path, error=error)) from None
    here, tools, notes = os.path.dirname(path), [], []
    for number, name in listed:
        # In the library's folder, or in FreeCAD's layout: Tools/Library and Tools/Bit.
        found = [p for p in (os.path.join(here, name), os.path.join(here, "..", "Bit", name)) if os.path.exists(p)]
        try:
            if not found:
                raise ValueError(tr("{name}: there is no such file beside the library").format(name=name))
            tools.append({**read_bit(found[0]), "number": number})
        except ValueError as error:
            notes.append(str(error))
    return tools, notes


def read(path):
    """Returns (tools, notes) of a tool bit or a library."""
    if path.lower().endswith(".fctl"):
        return read_library(path)
    return [read_bit(path)], []


def shape_of(bit):
    """Returns the name of a tool bit object's shape, as its shape's file is named. Reads FreeCAD's older tools, too."""
    shape = getattr(bit, "ShapeName", "") or os.path.splitext(os.path.basename(getattr(bit, "BitShape", "") or ""))[0]
    if not shape:  # since 1.1
        shape = getattr(bit, "ShapeType", "")
        shape = getattr(bit, "ShapeID", "") if shape == "Custom" else shape
    if not shape:
        shape = {"EndMill": "endmill", "BallEndMill": "ballend", "Drill": "drill", "Engraver": "v-bit",
                 "ChamferMill": "chamfer"}.get(
                     getattr(bit, "ToolType", ""), str(getattr(bit, "ToolType", "") or "tool"))
    return shape.lower()


def of_object(bit):
    """Returns the tool of a tool bit object, as in a Path job's tool controller."""
    return tool_from(getattr(bit, "Label", "") or bit.Name, shape_of(bit), lambda name: getattr(bit, name, None))
