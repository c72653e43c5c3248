"""What all commands have in common."""

import functools

import FreeCADGui

from ..icons import icon
from ..mistakes import Stopped, show
from ..words import tr


def _in_a_dialog(activated):
    """The function; what it raises for the user is said in a dialog, what the user stopped in the status bar."""

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
    """A command with its icon and its texts: in the menu, as tip (of the pointer and in the status bar), and as the
    longer help of Shift+F1. FreeCAD translates the texts with the command's name as context. Registering gives the
    command that name. `ready` says whether the selection is what it needs."""

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
        """Its text in the menu, in the user's language: of undo steps and boxes."""
        return tr(self.told["MenuText"], self.name)

    def ready(self):
        return True

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog() and self.ready()
