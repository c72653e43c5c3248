"""Runs a model script for the `fieldfab` command: `python3 -m fieldfab.script MODEL.py` with the answer on standard output.

The solid is the script's variable `solid` or, where there is none, the last shape it gave a name. What the script prints goes to
standard error. The answer is "ok" and a .vm program, or "error", the line and a message.
"""

import ctypes
import os
import runpy
import signal
import sys
import traceback

from ._core import Expression


def solid_of(names):
    """The shape that a script made, or None."""
    if isinstance(names.get("solid"), Expression):
        return names["solid"]
    shapes = [value for name, value in names.items() if isinstance(value, Expression) and name not in ("X", "Y", "Z")]
    return shapes[-1] if shapes else None


def where(error, path):
    """The line of the script that an error comes from; 0 where it is none of its lines."""
    if isinstance(error, SyntaxError) and error.filename == path:
        return error.lineno or 0
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == path]
    return lines[-1] if lines else 0


def answer(path):
    try:
        solid = solid_of(runpy.run_path(path, run_name="__main__"))
    except SystemExit as stop:
        return f"error 0 the script ended itself with {stop.code!r}"
    except MemoryError:
        return "error 0 the script needs more memory than there is"
    except KeyboardInterrupt:
        return "error 0 interrupted"
    except BaseException as error:  # whatever it raises, the answer is one line
        kind = "" if type(error).__module__ == "fieldfab._core" else f"{type(error).__name__}: "
        message = error.msg if isinstance(error, SyntaxError) else str(error)
        return f"error {where(error, path)} {kind}{' '.join(str(message).split())}"
    if solid is None:
        return "error 0 the script makes no shape: give one the name 'solid'"
    return "ok\n" + solid.vm()


def end_with_parent():
    """Has this process killed when the one that started it ends, even if that is killed itself."""
    PR_SET_PDEATHSIG = 1
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


if __name__ == "__main__":
    end_with_parent()
    with os.fdopen(os.dup(1), "w") as out:
        os.dup2(2, 1)
        sys.path.insert(0, os.path.dirname(os.path.abspath(sys.argv[1])))
        sys.argv = sys.argv[1:]
        out.write(answer(sys.argv[0]))
