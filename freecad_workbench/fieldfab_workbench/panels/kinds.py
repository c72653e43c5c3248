"""Panels by the kind of object."""

from ..objects.cam_setup import setup_of
from .cam_operation_panel import OperationPanel
from .cam_setup_panel import SetupPanel
from .frep_panel import FrepPanel
from .property_panel import PropertyPanel
from .scan_panel import ScanPanel
from .script_panel import ScriptPanel
from .simulation_panel import SimulationPanel


def _of_part_of_setup(obj, setup):
    """Returns the panel of the set-up, which also edits its tools and programs, or a property panel for an object
    without a set-up."""
    return PropertyPanel(obj) if setup is None else SetupPanel(setup)


PANELS = {
    "DocumentObject": PropertyPanel,
    "FrepSolid": FrepPanel,
    "Scan": ScanPanel,
    "ScriptSolid": ScriptPanel,
    "Simulation": SimulationPanel,
    "CamSetup": SetupPanel,
    "CamTool": lambda tool: _of_part_of_setup(tool, setup_of(tool)),
    "MachineProgram": lambda program: _of_part_of_setup(program, program.Setup),
    "CamOperation": OperationPanel,
}
