"""View providers by the kind of object."""

from .cam_view import OperationView, SetupView, ToolView
from .part_shape_view import PartShapeView
from .program_view import ProgramView
from .solid_view import SolidView

VIEWS = {
    "Solid": SolidView,
    "PartShape": PartShapeView,
    "CamSetup": SetupView,
    "CamTool": ToolView,
    "CamOperation": OperationView,
    "MachineProgram": ProgramView,
}
