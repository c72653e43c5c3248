"""The task panel of an f-rep solid: its text, its resolution, and what is wrong with it."""

from .. import kernel
from ..shim import QtGui, QtWidgets
from .edit_panel import EditPanel


class FrepPanel(EditPanel):
    def __init__(self, obj):
        super().__init__(obj, "F-rep solid")
        self.text = QtWidgets.QPlainTextEdit(obj.Expression)
        self.text.setFont(QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.FixedFont))
        self.text.setMinimumHeight(220)
        self.layout.addWidget(self.text)
        self.layout.addWidget(self.message)
        numbers = QtWidgets.QFormLayout()
        self.voxel = self._length(obj.VoxelSize.Value, "automatic: 1/128 of the longest side")
        self.max_error = self._length(obj.MaxError.Value, "automatic: a tenth of the smallest cell")
        numbers.addRow("Smallest cell", self.voxel)
        numbers.addRow("Largest error", self.max_error)
        self.layout.addLayout(numbers)
        self.text.textChanged.connect(self.check)
        self.check()

    @staticmethod
    def _length(value, zero):
        box = QtWidgets.QDoubleSpinBox()
        box.setDecimals(4)
        box.setRange(0, 1e6)
        box.setSuffix(" mm")
        box.setSpecialValueText(zero)
        box.setValue(value)
        return box

    def check(self):
        """Reads the text as it is typed and shows the first mistake."""
        fieldfab = kernel.load()
        try:
            self.say(f"{fieldfab.parse(self.text.toPlainText()).node_count()} operations", True)
        except fieldfab.Error as error:
            self.say(str(error))

    def take_over(self):
        if self.obj.Expression != self.text.toPlainText():
            self.obj.Expression = self.text.toPlainText()
        self.obj.VoxelSize = self.voxel.value()
        self.obj.MaxError = self.max_error.value()
