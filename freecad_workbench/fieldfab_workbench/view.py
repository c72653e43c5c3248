"""How an f-rep solid looks in FreeCAD: its icon, its colour, its task panel."""

import os

import FreeCADGui

ICONS = os.path.join(os.path.dirname(os.path.dirname(os.path.realpath(__file__))), "icons")
COLOUR = (0.42, 0.62, 0.86)


class FrepSolidView:
    """View provider of a FrepSolid."""

    def __init__(self, view):
        view.Proxy = self
        view.ShapeColor = COLOUR
        view.Lighting = "Two side"
        view.CreaseAngle = 30.0  # smooth where the solid is, sharp where it is not

    def attach(self, view):
        self.Object = view.Object

    def getIcon(self):
        return os.path.join(ICONS, "new_frep_solid.svg")

    def setEdit(self, view, mode=0):
        from .task_panel import FrepPanel

        FreeCADGui.Control.showDialog(FrepPanel(view.Object))
        return True

    def unsetEdit(self, view, mode=0):
        FreeCADGui.Control.closeDialog()
        return True

    def doubleClicked(self, view):
        view.Document.setEdit(view.Object.Name)
        return True

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads
