"""Simulating machine programs."""

import FreeCAD
import FreeCADGui

from ..objects import programs, simulation, solid
from ..views.solid_view import icon


class SimulateProgram:
    """Adds a simulation, of the selected object's program where it has one, and opens its task panel: one undo step."""

    def GetResources(self):
        tip = "Carry out a machine's program on a stock: of a file, or of the selected Path operation, Job or machine program"
        return {"Pixmap": icon("Simulation"), "MenuText": "Simulate program", "ToolTip": tip}

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog()

    def Activated(self):
        document = FreeCAD.ActiveDocument or FreeCAD.newDocument()
        chosen = [obj for obj in FreeCADGui.Selection.getSelection() if programs.offers_program(obj)]
        document.openTransaction("Simulate program")
        obj = solid.create(simulation.Simulation, document)
        if chosen:
            obj.Program = chosen[0]
            obj.SetupFile = getattr(chosen[0], "SetupFile", "")
        FreeCADGui.ActiveDocument.setEdit(obj.Name)


class PlaySimulation:
    """Opens the panel of the selected simulation."""

    def GetResources(self):
        return {"Pixmap": icon("PlaySimulation"), "MenuText": "Play simulation", "ToolTip": "Show the selected simulation move by move, its events and deviations"}

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog() and bool(self._chosen())

    def Activated(self):
        FreeCADGui.ActiveDocument.setEdit(self._chosen()[0].Name)

    @staticmethod
    def _chosen():
        return [obj for obj in FreeCADGui.Selection.getSelection() if isinstance(getattr(obj, "Proxy", None), simulation.Simulation)]


TITLE = "Simulation"
COMMANDS = {"Fieldfab_SimulateProgram": SimulateProgram(), "Fieldfab_PlaySimulation": PlaySimulation()}
