"""The panel of each kind of object."""

from ..objects.cam_setup import setup_of
from .cam_operation_panel import OperationPanel
from .cam_setup_panel import SetupPanel
from .frep_panel import FrepPanel
from .property_panel import PropertyPanel
from .scan_panel import ScanPanel
from .simulation_panel import SimulationPanel


def _of_part_of_setup(obj, setup):
    """A set-up's panel edits its tools and programs, too; one without a set-up has its properties only."""
    return PropertyPanel(obj) if setup is None else SetupPanel(setup)


PANELS = {
    "DocumentObject": PropertyPanel,
    "FrepSolid": FrepPanel,
    "Scan": ScanPanel,
    "Simulation": SimulationPanel,
    "CamSetup": SetupPanel,
    "CamTool": lambda tool: _of_part_of_setup(tool, setup_of(tool)),
    "MachineProgram": lambda program: _of_part_of_setup(program, program.Setup),
    "CamOperation": OperationPanel,
}
