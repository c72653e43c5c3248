"""The task panel of an f-rep solid: its text, its resolution, and what is wrong with it."""

import FreeCAD
import FreeCADGui

try:
    from PySide2 import QtGui, QtWidgets
except ImportError:  # FreeCAD 1.x with Qt 6
    from PySide6 import QtGui, QtWidgets

from . import kernel


class FrepPanel:
    """Edits one object in one undo step; Cancel takes everything back, the object's making included."""

    def __init__(self, obj):
        self.obj = obj
        self.document = obj.Document
        if not self.document.HasPendingTransaction:
            self.document.openTransaction("Edit f-rep solid")

        self.form = QtWidgets.QWidget()
        self.form.setWindowTitle("F-rep solid")
        layout = QtWidgets.QVBoxLayout(self.form)
        self.text = QtWidgets.QPlainTextEdit(obj.Expression)
        self.text.setFont(QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.FixedFont))
        self.text.setMinimumHeight(220)
        layout.addWidget(self.text)
        self.message = QtWidgets.QLabel()
        self.message.setWordWrap(True)
        layout.addWidget(self.message)
        numbers = QtWidgets.QFormLayout()
        self.voxel = self._length(obj.VoxelSize.Value, "automatic: 1/128 of the longest side")
        self.max_error = self._length(obj.MaxError.Value, "automatic: a tenth of the smallest cell")
        numbers.addRow("Smallest cell", self.voxel)
        numbers.addRow("Largest error", self.max_error)
        layout.addLayout(numbers)
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
            nodes = fieldfab.parse(self.text.toPlainText()).node_count()
            self._say(f"{nodes} operations", "#2c7a3f")
            return True
        except fieldfab.Error as error:
            self._say(str(error), "#b3261e")
            return False

    def _say(self, text, colour):
        self.message.setText(text)
        self.message.setStyleSheet(f"color: {colour}")

    def apply(self):
        """Takes the values over and recomputes; True where the object came out well."""
        self.obj.Expression = self.text.toPlainText()
        self.obj.VoxelSize = self.voxel.value()
        self.obj.MaxError = self.max_error.value()
        self.document.recompute([self.obj])
        if self.obj.isValid():
            return True
        self._say(self.obj.getStatusString(), "#b3261e")
        return False

    # What FreeCAD asks of a task panel.
    def getStandardButtons(self):
        buttons = QtWidgets.QDialogButtonBox
        wanted = buttons.Ok | buttons.Cancel | buttons.Apply
        return int(getattr(wanted, "value", wanted))  # an enum.Flag with Qt 6

    def clicked(self, button):
        if button == QtWidgets.QDialogButtonBox.Apply:
            self.apply()

    def accept(self):
        if not self.apply():
            return False
        self.document.commitTransaction()
        FreeCADGui.getDocument(self.document.Name).resetEdit()
        FreeCADGui.Control.closeDialog()
        return True

    def reject(self):
        document = self.document
        document.abortTransaction()  # first: leaving edit mode would commit what is pending
        FreeCADGui.getDocument(document.Name).resetEdit()
        FreeCADGui.Control.closeDialog()
        document.recompute()
        return True
