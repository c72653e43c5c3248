"""Commands that simulate machine programs."""

import FreeCAD
import FreeCADGui

from ..objects import programs, simulation, solid
from ..words import tr
from .command import Command


class SimulateProgram(Command):
    """Adds a simulation and opens its task panel, in one undo step. If the selected object has a program, the
    simulation takes it."""

    def Activated(self):
        document = FreeCAD.ActiveDocument or FreeCAD.newDocument()
        chosen = [obj for obj in FreeCADGui.Selection.getSelection() if programs.offers_program(obj)]
        planned = [obj for obj in document.Objects if programs.is_planned(obj) and obj.MadeFrom]
        chosen = chosen or (planned if len(planned) == 1 else [])
        document.openTransaction(self.title)
        obj = solid.create(simulation.Simulation, document)
        obj.Label = tr("Simulation")
        if chosen:
            obj.Program = chosen[0]
            obj.SetupFile = getattr(chosen[0], "SetupFile", "")
        FreeCADGui.ActiveDocument.setEdit(obj.Name)


class PlaySimulation(Command):
    """Opens the panel of the selected simulation."""

    def ready(self):
        return bool(self._chosen())

    def Activated(self):
        FreeCADGui.ActiveDocument.setEdit(self._chosen()[0].Name)

    @staticmethod
    def _chosen():
        return [obj for obj in FreeCADGui.Selection.getSelection()
                if isinstance(getattr(obj, "Proxy", None), simulation.Simulation)]


TITLE = "Simulation"
COMMANDS = {
    "Fieldfab_SimulateProgram": SimulateProgram(
        "Simulation", "Simulate program",
            "Simulate a machine's program on a stock: from a file, or from the selected Path operation, Job or "
            "machine program",
        "Simulates a machine's program on a stock and plays it in the 3D view. Select a machine program, a Path "
        "operation or a Job, or choose a file in the panel, which also asks for the stock, the tools, the machine "
        "and the target."),
    "Fieldfab_PlaySimulation": PlaySimulation(
        "PlaySimulation", "Play simulation", "Show the selected simulation move by move, its events and deviations",
        "Opens the panel of the selected simulation: the stock at any moment, tool and axes, the program's lines, "
        "events with the worst first, and deviations in colours."),
}
