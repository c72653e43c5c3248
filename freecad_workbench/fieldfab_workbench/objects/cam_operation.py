"""An operation of a CAM set-up."""

from .. import workflow
from ..words import kernel_name
from .cam_setup import setup_of
from .document_object import WithSettings, create_object

MADE_BY_TOOL = {"feed": "Feed", "plunge": "Plunge", "spindle": "Spindle"}


class CamOperation(WithSettings):
    """An operation with a type, a tool, and a property for each setting of the stages between the part and its
    moves."""

    NAME = "CamOperation"

    def icon_name(self, obj):
        return "CamOperation" if obj.Active else "CamOperationOff"

    def add_properties(self, obj):
        self.add_choice(obj, "Type", "Operation", "Kind of operation", workflow.operation_names())
        self.add(obj, "Link", "Tool", "Operation", "Tool of the operation")
        self.add(obj, "Bool", "Active", "Operation", "Include the operation in the program", True)
        self.settle(obj)

    def stages(self, obj):
        return workflow.stages_of(obj.Type)

    def default(self, obj, setting):
        """Returns the default of a setting: the tool's, otherwise the material's (its own or that of its chip load),
        otherwise the workflow's. The last is limited to the machine's maximum feed."""
        tool, setup = getattr(obj, "Tool", None), setup_of(obj)
        if tool is not None and setting.name in MADE_BY_TOOL:
            own = getattr(tool, MADE_BY_TOOL[setting.name])
            own = own.Value * 60 if hasattr(own, "Value") else own
            if own > 0:
                return own
        machine = workflow.machine(setup.Machine) if setup else {}
        material = machine.get("materials", {}).get(setup.Material, {}) if setup else {}
        if setup and not material and tool is not None and setting.name in MADE_BY_TOOL:
            material = workflow.cutting_values(setup.Machine, setup.Material, tool.Diameter.Value, tool.Flutes,
                                               tool.Spindle)
        value = material.get(setting.name, setting.default)
        fastest = machine.get("max_feed", 0)
        if setting.name in ("feed", "plunge") and fastest and setting.name not in material:
            value = min(value, fastest)
        return value

    def onChanged(self, obj, name):
        if (name in ("Type", "Tool") and "Given" in obj.PropertiesList and not obj.Document.Restoring
                and not obj.Document.Transacting):
            self.settle(obj)
        super().onChanged(obj, name)

    def execute(self, obj):
        self.settle(obj)  # the tool's speeds may have changed
        self.check(obj)


def add(setup, kind, tool=None):
    """Adds an operation at the end of a set-up. Without a given tool it takes the first one. Returns the object;
    computes nothing."""
    operation = create_object(CamOperation, setup.Document, kernel_name(kind))
    operation.Type = kind
    setup.Operations = [*setup.Operations, operation]
    operation.Tool = tool or next(iter(setup.Tools), None)
    return operation
