"""Runs a model script for the `fieldfab` command: `python3 -m fieldfab.script MODEL` prints the result.

MODEL is a Python script (.py) or one of kokopelli's (.ko). Output of the script goes to standard error. The result is
"ok" and .frep text, in which `part(...)` gives a solid its name and colour, or "error", the line and a message.
"""

import ctypes
import os
import runpy
import signal
import sys
import traceback
import types

from . import _core
from ._core import Solid

MOST_NAMES = 10


def parts_of_python(path):
    """Returns the parts of a Python script as (formula, name, colour); name and colour may be None.

    The parts are those of part(...), otherwise the variable `solid`, otherwise the only shape that a variable of
    the script refers to. Raises NoSolid if there is no such shape, or several.
    """
    names = runpy.run_path(path, run_name="__main__")
    made = list(_core.parts_made()) if hasattr(_core, "parts_made") else []
    if made:
        return made
    if isinstance(names.get("solid"), Solid):
        return [(names["solid"], None, None)]
    shapes = _shapes_of(names)
    if not shapes:
        raise NoSolid("the script makes no shape: give one the name 'solid'")
    if len(shapes) > 1:
        raise NoSolid(f"the script makes several shapes, {_listed(list(shapes.values()))}, and none is called 'solid'; "
                      "name the parts with part(...)")
    return [(shape, None, None) for shape in _objects(names, shapes)]


class NoSolid(Exception):
    """Raised for a script that ran but defines no solid, or an ambiguous one."""


def _shapes_of(names):
    """Returns the first variable name of each shape, by identity. Shapes made by imported modules are ignored."""
    imported = {id(value) for module in list(sys.modules.values()) if isinstance(module, types.ModuleType)
                and module.__name__ != "__main__"
                for value in list(vars(module).values()) if isinstance(value, Solid)}
    shapes = {}
    for name, value in names.items():
        if isinstance(value, Solid) and id(value) not in imported:
            shapes.setdefault(id(value), name)
    return shapes


def _objects(names, shapes):
    return [names[name] for name in shapes.values()]


def _listed(names):
    shown = names[:MOST_NAMES]
    if len(names) > MOST_NAMES:
        return ", ".join(shown) + f" and {len(names) - MOST_NAMES} more"
    return ", ".join(shown[:-1]) + " and " + shown[-1]


def text_of_parts(parts):
    """Returns the .frep text of parts, each (formula, name, colour). Raises NoSolid if two parts have the same name."""
    names = [name for _, name, _ in parts if name is not None]
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise NoSolid(f"two parts are called '{twice[0]}'")
    return _core.frep_text([(Solid(formula), name and str(name), colour) for formula, name, colour in parts])


def where(error, path):
    """Returns the line of the script at which an error occurred, or 0."""
    if isinstance(error, SyntaxError) and error.filename == path:
        return error.lineno or 0
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == path]
    return lines[-1] if lines else 0


def answer(path):
    try:
        if path.lower().endswith(".ko"):
            from . import koko_script
            parts = koko_script.parts(path)
        else:
            parts = parts_of_python(path)
        return "ok\n" + text_of_parts(parts)
    except SystemExit as stop:
        return f"error 0 the script ended itself with {stop.code!r}"
    except MemoryError:
        return "error 0 the script needs more memory than there is"
    except KeyboardInterrupt:
        return "error 0 interrupted"
    except BaseException as error:  # the result is one line for any exception
        line = where(error, path)
        ours = isinstance(error, NoSolid) or type(error).__module__ == "fieldfab._core"
        plain = ours or (line == 0 and isinstance(error, ValueError))
        message = error.msg if isinstance(error, SyntaxError) else str(error)
        return f"error {line} {'' if plain else type(error).__name__ + ': '}{' '.join(str(message).split())}"


def bytes_of(text):
    """Encodes text as UTF-8. Surrogate escapes become the original bytes of file names; other surrogates are
    escaped.
    """
    try:
        return text.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        return text.encode("utf-8", "backslashreplace")


def end_with_parent():
    """Requests that the kernel kill this process when its parent ends, even by SIGKILL."""
    PR_SET_PDEATHSIG = 1
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


if __name__ == "__main__":
    end_with_parent()
    with os.fdopen(os.dup(1), "wb") as out:
        os.dup2(2, 1)
        sys.path.insert(0, os.path.dirname(os.path.abspath(sys.argv[1])))
        sys.argv = sys.argv[1:]
        out.write(bytes_of(answer(sys.argv[0])))
