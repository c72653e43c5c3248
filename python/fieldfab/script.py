"""Runs a model script for the `fieldfab` command: `python3 -m fieldfab.script MODEL`, the answer on standard output.

MODEL is a Python script (.py) or one of kokopelli's (.ko). What the script prints goes to standard error. The answer
is "ok" and .frep text, in which `part(...)` gives a solid its name and colour, or "error", the line and a message.
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
    """The parts of a Python script: (formula, name, colour) each; None for no name and no colour.

    They are those of part(...), else the variable `solid`, else the only shape that the script has a name for."""
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
    """A script that has run and made no solid, or no certain one."""


def _shapes_of(names):
    """The first name of each shape, by its identity; what a module has made does not count."""
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
    """The .frep text of parts, (formula, name, colour) each. Raises NoSolid if two parts have one name."""
    names = [name for _, name, _ in parts if name is not None]
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise NoSolid(f"two parts are called '{twice[0]}'")
    return _core.frep_text([(Solid(formula), name and str(name), colour) for formula, name, colour in parts])


def where(error, path):
    """The line of the script that an error comes from; 0 where it is none of its lines."""
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
    except BaseException as error:  # whatever it raises, the answer is one line
        line = where(error, path)
        ours = isinstance(error, NoSolid) or type(error).__module__ == "fieldfab._core"
        plain = ours or (line == 0 and isinstance(error, ValueError))
        message = error.msg if isinstance(error, SyntaxError) else str(error)
        return f"error {line} {'' if plain else type(error).__name__ + ': '}{' '.join(str(message).split())}"


def bytes_of(text):
    """UTF-8, with the bytes that names of files have; other surrogates as escapes."""
    try:
        return text.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        return text.encode("utf-8", "backslashreplace")


def end_with_parent():
    """Has this process killed when the one that started it ends, even if that is killed itself."""
    PR_SET_PDEATHSIG = 1
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


if __name__ == "__main__":
    end_with_parent()
    with os.fdopen(os.dup(1), "wb") as out:
        os.dup2(2, 1)
        sys.path.insert(0, os.path.dirname(os.path.abspath(sys.argv[1])))
        sys.argv = sys.argv[1:]
        out.write(bytes_of(answer(sys.argv[0])))
