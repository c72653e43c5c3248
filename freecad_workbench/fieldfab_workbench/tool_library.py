"""The user's tool library: a file in FreeCAD's folder of user data, for all documents. A tool is {name: value} as in
job files (docs/cam.md), without a number."""

import json
import os

import FreeCAD

from . import kernel, tool_bits
from .words import tr

FORMAT, VERSION = "fieldfab tools", 1


def path():
    return os.path.join(FreeCAD.getUserAppDataDir(), "Fieldfab", "tools.json")


def tools():
    """Returns the tools in their order. Raises ValueError if the file is not a library of this version."""
    try:
        with open(path(), encoding="utf-8") as file:
            held = json.load(file)
        if held["format"] != FORMAT or held["version"] != VERSION:
            raise ValueError(tr("{path} is of another version").format(path=path()))
        return [dict(each) for each in held["tools"]]
    except FileNotFoundError:
        return []
    except (KeyError, TypeError, json.JSONDecodeError, UnicodeDecodeError) as error:
        raise ValueError(tr("{path}: this is no tool library ({error})").format(path=path(), error=error)) from None


def _write(kept):
    os.makedirs(os.path.dirname(path()), exist_ok=True)
    kernel.write_file(path(), json.dumps({"format": FORMAT, "version": VERSION, "tools": kept}, indent=1) + "\n")


def keep(told):
    """Adds tools that the library does not have yet. Returns how many. Raises ValueError, OSError."""
    kept = tools()
    new = [{key: value for key, value in each.items() if key != "number"} for each in told]
    new = [each for place, each in enumerate(new) if each not in kept and each not in new[:place]]
    if new:
        _write(kept + new)
    return len(new)


def remove(places):
    """Removes the tools at these places. Raises ValueError, OSError."""
    _write([each for place, each in enumerate(tools()) if place not in places])


def read(file):
    """Returns (tools, notes) of a library or tool bit of FreeCAD's or Fusion's. Raises ValueError, OSError."""
    if not file.lower().endswith(".json"):
        return tool_bits.read(file)
    try:
        return kernel.load().cam.read_tools(file), []
    except kernel.load().Error as error:
        raise ValueError(str(error)) from None

