"""Set-ups of simulations as text (docs/simulation.md), made from plain values."""

import json

from ..words import tr

TOOL_KEYS = ("number", "name", "shape", "diameter", "corner_radius", "angle", "tip_diameter", "flute", "length",
             "shank", "holder_diameter", "holder_length", "profile")
DEFAULT_TOOL = {"number": 1, "shape": "flat", "diameter": 6, "flute": 20, "length": 40, "shank": 6,
                "holder_diameter": 30, "holder_length": 30}


def tool_to_line(tool):
    """Returns a tool's table as a line of a property."""
    return json.dumps(tool, ensure_ascii=False)


def tool_from_line(line):
    """Returns the tool's table in a line. Raises ValueError with a line for the user."""
    try:
        tool = json.loads(line)
    except ValueError:
        tool = None
    if not isinstance(tool, dict):
        raise ValueError(tr("a tool has the form {example}, not {line!r}").format(
            example=tool_to_line({"number": 1, "shape": "flat", "diameter": 6}), line=line))
    unknown = [key for key in tool if key not in TOOL_KEYS]
    if unknown:
        raise ValueError(
            tr("a tool has no {unknown!r}; it has {known}").format(unknown=unknown[0], known=", ".join(TOOL_KEYS)))
    return tool


def text(tools, lower, upper, machine="", tolerances=None, more=""):
    """Returns the text of a set-up. `tools`: tables; `lower`, `upper`: corners of the stock, mm; `machine`: an id, or
    "" for three axes; `tolerances`: gouge, excess and touch, mm; `more`: further top-level lines and tables."""
    top = [f"machine = {_value(machine)}"] if machine else []
    stock = {"lower": [float(v) for v in lower], "upper": [float(v) for v in upper]}
    tables = [_table("[stock]", stock), _table("[target]", tolerances or {}),
              *(_table("[[tool]]", tool) for tool in tools)]
    return "\n".join([*top, more.rstrip(), "", *tables])


def _table(head, values):
    return "\n".join([head, *(f"{key} = {_value(value)}" for key, value in values.items()), ""])


def _value(value):
    return json.dumps(value, ensure_ascii=False)  # also valid TOML
