"""Errors and cancellation, reported to the user in one line. By default FreeCAD prints a traceback with a line for each
call."""

import functools
import sys

import FreeCAD

from .kernel_messages import translated


class _Named(type):
    def __str__(cls):
        return "Fieldfab"  # FreeCAD's report view prints it before the message


class Mistake(ValueError, metaclass=_Named):
    """An error that FreeCAD prints without a traceback: it suppresses tracebacks while an instance of this class
    exists."""

    alive = 0

    def __init__(self, words):
        super().__init__(words)
        Mistake.alive += 1
        sys.tracebacklimit = 0

    def __del__(self):
        Mistake.alive -= 1
        if not Mistake.alive and hasattr(sys, "tracebacklimit"):
            del sys.tracebacklimit


class Stopped(ValueError):
    """Cancellation by the user, which needs no dialog."""


def in_a_line(function, dialog=False):
    """Returns the function with its errors for the user converted to Mistakes. If `dialog` is true, a dialog shows
    them, too."""

    @functools.wraps(function)
    def told(*arguments, **named):
        try:
            return function(*arguments, **named)
        except Mistake:
            raise
        except (ValueError, OSError, ImportError) as error:
            if dialog and not isinstance(error, Stopped):
                show(str(error))
            raise Mistake(translated(str(error))) from None

    return told


def show(words):
    """Shows a message, in the user's language, in a dialog if there is a window. Returns at once."""
    if not FreeCAD.GuiUp:
        return
    import FreeCADGui

    from .shim import QtCore, QtWidgets  # Qt may be missing without a window

    box = QtWidgets.QMessageBox(QtWidgets.QMessageBox.Warning, "Fieldfab", translated(words), QtWidgets.QMessageBox.Ok,
                                FreeCADGui.getMainWindow())
    box.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    box.open()
