"""Task panel of an operation."""

from ..words import tr
from .edit_panel import EditPanel
from .operation_form import OperationForm


class OperationPanel(EditPanel):
    def __init__(self, obj):
        super().__init__(obj, tr("Operation"))
        self.stages = OperationForm(obj)
        self.layout.addWidget(self.stages)
        self.layout.addWidget(self.message)
        self.layout.addStretch()

    def take_over(self):
        """Does nothing: each change is written to the object at once."""
