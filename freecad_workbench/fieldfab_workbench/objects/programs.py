"""Sources of machine programs: files and document objects. FreeCAD's Path Jobs also provide tools, stock and part."""

import os
import re
from collections import namedtuple

from ..tool_bits import SHAPES, shape_of, tool_from
from ..words import tr

# text: bytes; name: actual or hypothetical file name, whose extension selects the language; path: str or None.
Program = namedtuple("Program", "text name path")

_FEED = re.compile(r"\bF(-?[0-9.]+)")


def is_job(obj):
    return hasattr(obj, "Operations") and hasattr(obj.Operations, "Group") and hasattr(obj, "Stock")


def is_planned(obj):
    """Returns whether it is one of Fieldfab's machine programs, whose job is also a complete set-up for simulation."""
    return getattr(getattr(obj, "Proxy", None), "NAME", "") == "MachineProgram"


def offers_program(obj):
    """Returns whether the object is of a kind that program_of() accepts: a machine program, a Path operation or a Path
    Job."""
    return (bool(getattr(obj, "ProgramFile", "")) or is_planned(obj) or is_job(obj)
            or (hasattr(obj, "Path") and hasattr(obj.Path, "toGCode")))


def program_from_file(path):
    """Returns the Program in a file. Raises ValueError with a line for the user."""
    try:
        with open(path, "rb") as file:
            return Program(file.read(), os.path.basename(path), path)
    except OSError as error:
        raise ValueError(
            tr("the program {path} cannot be read: {error}").format(path=path, error=error.strerror)) from None


def program_of(obj):
    """Returns the Program of an object. Raises ValueError with a line for the user."""
    if getattr(obj, "ProgramFile", ""):
        return program_from_file(obj.ProgramFile)
    if is_planned(obj):
        return Program(obj.Proxy.program(obj), f"program{obj.Extension}", None)
    if is_job(obj):
        text = _text_of_job(obj)
    elif hasattr(obj, "Path"):
        text = _text_of(obj)
    else:
        raise ValueError(tr("{label} has no program").format(label=obj.Label))
    if not text.strip():
        raise ValueError(tr("the program of {label} is empty").format(label=obj.Label))
    return Program(f"(from {obj.Label})\nG17 G21 G40 G90\n{text}M2\n".encode(), f"{obj.Name}.ngc", None)


def _text_of(operation):
    """Returns the G-code of a Path object, with FreeCAD's feeds in mm/s converted to mm/min."""
    text = operation.Path.toGCode()
    return _FEED.sub(lambda feed: f"F{60 * float(feed[1]):.6g}", text)


def _text_of_job(job):
    """Returns the G-code of all active operations in order, with a tool change before an operation if its tool
    differs."""
    text, tool = [], None
    for operation in job.Operations.Group:
        if not getattr(operation, "Active", True) or not hasattr(operation, "Path"):
            continue
        controller = controller_of(operation)
        if controller is not None and controller != tool:
            text.append(_text_of(controller))
            tool = controller
        text.append(f"({operation.Label})\n{_text_of(operation)}")
    return "".join(part if part.endswith("\n") else part + "\n" for part in text)


def controller_of(operation):
    """Returns the tool controller of a Path operation, for a dress-up that of its base operation, or None."""
    while operation is not None:
        if getattr(operation, "ToolController", None) is not None:
            return operation.ToolController
        operation = getattr(operation, "Base", None)
        operation = operation if hasattr(operation, "PropertiesList") else None
    return None


def tools_of(obj):
    """Returns the tools of a Path Job or operation as tables of a set-up, in mm and degrees: [{"number": 1, "shape":
    "flat", "diameter": 6, ...}]. Unknown shapes count as flat; tools without a diameter are left out."""
    controllers = obj.Tools.Group if is_job(obj) else [controller_of(obj)]
    tools = [_tool(c) for c in controllers if c is not None and getattr(c, "Tool", None) is not None]
    return [tool for tool in tools if tool]


def _tool(controller):
    bit = controller.Tool
    shape = shape_of(bit)
    try:
        tool = tool_from(bit.Label, shape if shape in SHAPES else "endmill", lambda name: getattr(bit, name, None))
    except ValueError:
        return None
    tool.pop("flutes", None)  # set-ups have none
    return {"number": controller.ToolNumber, **tool}


_MOTION = re.compile(r"\bG0*([0-3]|8[0-9])(?!\d)")


def _words(program):
    """Returns a G-code program's text without comments, and the length of its unit in mm."""
    text = re.sub(r"\([^)\n]*\)|;[^\n]*", "", program.text.decode("latin-1").upper())
    return text, 25.4 if re.search(r"\bG0*20(?!\d)", re.sub(r"(?=[GM])", " ", text)) else 1.0


def highest_cut(program):
    """Returns the highest Z, mm, at which a G-code program moves sideways in a feed, or None if it never does."""
    text, unit = _words(program)
    height = highest = None
    cutting = False
    for line in text.splitlines():
        if found := _MOTION.findall(re.sub(r"(?=[A-Z])", " ", line)):
            cutting = found[-1] in "123"
        if up := re.search(r"Z\s*([-+]?(?:\d+\.?\d*|\.\d+))", line):
            height = float(up[1]) * unit
        if cutting and height is not None and re.search(r"[XY]", line):
            highest = height if highest is None else max(highest, height)
    return highest


def extent(program):
    """Returns the corners ((x, y, z), (x, y, z)), mm, of the box spanned by a G-code program's X, Y and Z words, or
    None if an axis has no words. This is only an initial guess of the stock: incremental words (G91), offsets and words
    in subroutines are read as positions."""
    text, unit = _words(program)
    spans = []
    for letter in "XYZ":
        values = [float(v) * unit for v in re.findall(letter + r"\s*([-+]?(?:\d+\.?\d*|\.\d+))", text)]
        if not values:
            return None
        spans.append((min(values), max(values)))
    return tuple(s[0] for s in spans), tuple(s[1] for s in spans)
