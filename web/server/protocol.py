"""Checks of requests. A worker receives only fields, types and sizes of the tables here and in docs/web.md."""

import math
import re
from typing import Any

import fieldfab as ff

from .limits import LIMITS
from .processes import Refused

MODES = ("shaded", "height", "normals", "bitmap")
FORMULAS, SCRIPTS = ("frep", "math", "vm"), ("py", "ko", "scad")


def wrong(message):
    return Refused(400, "bad_request", message)


def number(value, name, low=-1e9, high=1e9):
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        raise wrong(f"'{name}' must be a number, and finite")
    if not low <= value <= high:
        raise wrong(f"'{name}' is {value:g}; it may be {low:g} to {high:g}")
    return float(value)


def numbers(value, name, count):
    if not isinstance(value, list) or len(value) != count:
        raise wrong(f"'{name}' must be {count} numbers")
    return [number(each, name) for each in value]


def whole(value, name, low, high):
    if isinstance(value, bool) or not isinstance(value, int):
        raise wrong(f"'{name}' must be a whole number")
    return int(number(value, name, low, high))


def flag(value, name):
    if not isinstance(value, bool):
        raise wrong(f"'{name}' must be true or false")
    return value


def one_of(value, name, choices):
    if value not in choices:
        raise wrong(f"'{name}' must be one of {', '.join(choices)}")
    return value


def box(value, name):
    values = numbers(value, name, 6)
    if any(low > high for low, high in zip(values[:3], values[3:])):
        raise wrong(f"'{name}' must be x0, y0, z0, x1, y1, z1, the lower ones first")
    return values


def window(value, name):
    values = numbers(value, name, 4)
    if not (values[0] < values[2] and values[1] < values[3]):
        raise wrong(f"'{name}' must be x0, y0, x1, y1, the lower ones first")
    return values


def section(value, name):
    if not isinstance(value, dict):
        raise wrong(f"'{name}' must be an object with axis, at and keep")
    return {"axis": one_of(value.get("axis"), "axis", ("x", "y", "z")), "at": number(value.get("at"), "at"),
            "keep": one_of(value.get("keep", "below"), "keep", ("below", "above"))}


def optional(check):
    return lambda value, name: None if value is None else check(value, name)


def text(value, name):
    if not isinstance(value, str):
        raise wrong(f"'{name}' must be text")
    if "\0" in value:
        raise wrong(f"'{name}' has a byte of value zero")
    try:
        size = len(value.encode())
    except UnicodeEncodeError:
        raise wrong(f"'{name}' is not Unicode: it has half a surrogate pair") from None
    if size > LIMITS.text:
        raise Refused(413, "too_large", f"the text has {size:,} bytes; {LIMITS.text:,} are possible")
    return value


def parameter_values(value, name):
    if not isinstance(value, dict) or len(value) > 1000:
        raise wrong(f"'{name}' must be an object of numbers by name")
    return {key: number(each, f"{name}.{key}") for key, each in value.items()}


def points(value, name):
    if not isinstance(value, list) or len(value) > LIMITS.points:
        raise wrong(f"'{name}' must be a list of at most {LIMITS.points:,} places")
    return [numbers(each, name, 3) for each in value]


# Keys of tools, without `library`, which is a file.
TOOL_KEYS = ("number", "name", "shape", "diameter", "corner_radius", "angle", "tip_diameter", "flute", "length",
             "shank", "holder_diameter", "holder_length", "flutes", "feed", "plunge", "spindle")
STOCK_KEYS = ("margin", "top", "thickness")
SETTING_NAME = re.compile(r"[a-z][a-z0-9_]{0,39}")


def short_text(value, name):
    if not isinstance(value, str) or len(value) > 100 or not value.isprintable():
        raise wrong(f"'{name}' must be a short text")
    return value


def settings(value, name, keys=None):
    """Checks numbers, flags and short texts by name; `keys`: the permitted names."""
    if not isinstance(value, dict) or len(value) > 60:
        raise wrong(f"'{name}' must be an object of settings by name")
    checked_values = {}
    for key, each in value.items():
        if not SETTING_NAME.fullmatch(key) or (keys is not None and key not in keys):
            raise wrong(f"'{key[:40]}' is not a setting of '{name}'")
        is_text = isinstance(each, str) and each not in ("NaN", "Infinity", "-Infinity")  # JSON constants read as text
        checked_values[key] = (each if isinstance(each, bool) else short_text(each, f"{name}.{key}") if is_text
                               else number(each, f"{name}.{key}"))
    return checked_values


def machining_job(value, name):
    """Checks a job of fieldfab.cam; it must not name files."""
    fields = {"machine", "material", "setting", "zero", "stock", "tools", "operations", "adjust_feeds"}
    if not isinstance(value, dict) or set(value) - fields:
        raise wrong(f"'{name}' must be an object of {', '.join(sorted(fields))}")
    lists = {each: value.get(each, []) for each in ("tools", "operations")}
    if any(not isinstance(each, list) or len(each) > 50 for each in lists.values()):
        raise wrong("'tools' and 'operations' must be lists of at most 50")
    if not isinstance(value.get("adjust_feeds", False), bool):
        raise wrong("'adjust_feeds' must be true or false")
    return {"machine": one_of(value.get("machine"), "machine", tuple(ff.cam.machines())),
            "material": short_text(value.get("material", ""), "material"),
            "setting": settings(value.get("setting", {}), "setting"),
            "zero": one_of(value.get("zero", "model"), "zero", ("model", "corner", "centre")),
            "stock": settings(value.get("stock", {}), "stock", STOCK_KEYS),
            "adjust_feeds": value.get("adjust_feeds", False),
            "tools": [settings(each, "tool", TOOL_KEYS) for each in lists["tools"]],
            "operations": [settings(each, "operation") for each in lists["operations"]]}


# {field: (check, default)} of each request; a field without default is required.
MUST = object()
MODEL: dict[str, tuple[Any, Any]] = {
    "text": (text, MUST),
    "language": (lambda v, n: one_of(v, n, FORMULAS + SCRIPTS), "frep"),
    "values": (parameter_values, {}),
}
VIEW: dict[str, tuple[Any, Any]] = {
    "mode": (lambda v, n: one_of(v, n, MODES), "shaded"),
    "alpha": (number, 0.5),
    "beta": (lambda v, n: number(v, n), -0.95),
    "perspective": (lambda v, n: number(v, n, 0, 2), 0.0),
    "section": (optional(section), None),
    "z": (number, 0.0),
}
PICTURE = {
    **MODEL,
    **VIEW,
    "width": (lambda v, n: whole(v, n, 8, LIMITS.side), 800),
    "height": (lambda v, n: whole(v, n, 8, LIMITS.side), 600),
    "window": (optional(window), None),
    "bounds": (optional(box), None),
    "near": (optional(box), None),
    "coarse": (flag, False),
    "smooth": (flag, False),
}
REQUESTS: dict[str, dict[str, tuple[Any, Any]]] = {
    "picture": PICTURE,
    "look": MODEL,
    "values": {**MODEL, "points": (points, MUST)},
    "pick": {**MODEL, **VIEW, "at": (lambda v, n: numbers(v, n, 2), MUST)},
    "parameters": {"text": (text, MUST)},
    "scan": {"name": (lambda v, n: v if isinstance(v, str) else one_of(v, n, ()), MUST)},
    "words": {"text": (text, MUST), "offset": (lambda v, n: whole(v, n, 0, LIMITS.text), MUST)},
    "file": {**MODEL, "extension": (lambda v, n: v if isinstance(v, str) else one_of(v, n, ()), MUST),
             "voxel": (optional(lambda v, n: number(v, n, 1e-6)), None),
             "thickness": (lambda v, n: number(v, n, 1e-6), 1.0)},
    "machine": {**MODEL, "job": (machining_job, MUST), "simulate": (flag, False)},
}


def checked(do, given, folder, allow_scripts, beside=()):
    """Returns the request for a worker. `beside`: fields for the caller only. Raises Refused."""
    fields = REQUESTS[do]
    if not isinstance(given, dict):
        raise wrong("a request is a JSON object")
    if unknown := sorted(set(given) - set(fields) - set(beside)):
        raise wrong(f"'{unknown[0]}' is not a field of '{do}'; these are: {', '.join(fields)}")
    request = {"do": do, "folder": folder}
    for name, (check, default) in fields.items():
        if name not in given and default is MUST:
            raise wrong(f"'{name}' is missing")
        request[name] = check(given[name], name) if name in given else default
    if do == "picture" and request["width"] * request["height"] > LIMITS.pixels:
        raise wrong(f"{request['width']} x {request['height']} pixels are more than {LIMITS.pixels:,}")
    if request.get("language") in SCRIPTS and not allow_scripts:
        raise Refused(403, "scripts", f".{request['language']} scripts can do whatever their user can: "
                      "they run only where the server was started with --allow-scripts")
    return request
