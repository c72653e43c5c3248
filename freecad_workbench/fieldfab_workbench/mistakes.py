"""Errors and cancelled work, told to the user in one line. FreeCAD alone would add where in these sources the error was
raised, a line for each call."""

import functools
import sys

import FreeCAD


class _Named(type):
    def __str__(cls):
        return "Fieldfab"  # FreeCAD's report view has this before the words


class Mistake(ValueError, metaclass=_Named):
    """FreeCAD prints it without a traceback: Python shows none as long as there is one of these."""

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
    """The user did it: no dialog has to tell of it."""


def in_a_line(function, dialog=False):
    """Returns the function with its errors for the user turned into Mistakes. On request a dialog of the window shows
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
            raise Mistake(str(error)) from None

    return told


def show(words):
    """Says it in a dialog, where there is a window. Returns at once."""
    if not FreeCAD.GuiUp:
        return
    import FreeCADGui

    from .shim import QtCore, QtWidgets  # without a window there need be no Qt

    box = QtWidgets.QMessageBox(QtWidgets.QMessageBox.Warning, "Fieldfab", words, QtWidgets.QMessageBox.Ok,
                                FreeCADGui.getMainWindow())
    box.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    box.open()
