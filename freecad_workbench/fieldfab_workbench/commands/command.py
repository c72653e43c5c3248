"""What all commands have in common."""

import FreeCADGui

from ..icons import icon
from ..words import tr


class Command:
    """A command with its icon and its texts: in the menu, as tip (of the pointer and in the status bar), and as the longer help of Shift+F1. FreeCAD
    translates them with the command's name as context. Registering gives it that name; `ready` says whether what it needs is chosen."""

    name = ""

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
