"""Base class of all commands."""

import functools

import FreeCADGui

from ..icons import icon
from ..mistakes import Stopped, show
from ..words import tr


def _in_a_dialog(activated):
    """Returns the function with error handling: errors for the user appear in a dialog, cancellation in the status
    bar."""

    @functools.wraps(activated)
    def told(*arguments):
        try:
            activated(*arguments)
        except Stopped as error:
            FreeCADGui.getMainWindow().statusBar().showMessage(str(error), 10000)
        except (ValueError, OSError, ImportError) as error:
            show(str(error))

    return told


class Command:
    """A command with its icon and texts: menu text, tooltip (also shown in the status bar), and the longer help of
    Shift+F1. FreeCAD translates the texts with the command's name as context; registration sets this name. `ready`
    returns whether the selection suits the command."""

    name = ""

    def __init_subclass__(cls, **more):
        super().__init_subclass__(**more)
        if "Activated" in vars(cls):
            cls.Activated = _in_a_dialog(cls.Activated)

    def __init__(self, picture, words, tip, help):
        self.told = {"Pixmap": icon(picture), "MenuText": words, "ToolTip": tip, "StatusTip": tip, "WhatsThis": help}

    def GetResources(self):
        return self.told

    @property
    def title(self):
        """Returns the menu text in the user's language, as the name of undo steps and dialogs."""
        return tr(self.told["MenuText"], self.name)

    def ready(self):
        return True

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog() and self.ready()
