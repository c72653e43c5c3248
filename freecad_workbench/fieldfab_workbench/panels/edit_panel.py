"""What all panels that edit one object share: one undo step, Apply, OK, and a Cancel that takes everything back."""

import FreeCADGui

from .. import units
from ..certainty import DOUBTFUL, is_uncertain, with_doubt
from ..shim import QtCore, QtWidgets, flags
from ..words import tr
from .wheel import WheelGuard

COLOURS = {True: "#2c7a3f", False: "#b3261e", DOUBTFUL: "#8a5a00"}
WIDTH = 420  # pixels of the dock, at least: FreeCAD's own is too narrow for three buttons


class EditPanel:
    """A task panel. `form` is the widget; `take_over()` writes what it holds into the object."""

    def __init__(self, obj, title):
        self.obj, self.document = obj, obj.Document
        if not self.document.HasPendingTransaction:
            self.document.openTransaction(tr("Edit {label}").format(label=obj.Label))
        self.form = QtWidgets.QWidget()
        self.wheel = WheelGuard(self.form)
        self.form.setWindowTitle(title)
        self.form.setWindowIcon(obj.ViewObject.Icon)
        self.layout = QtWidgets.QVBoxLayout(self.form)
        self.message = QtWidgets.QLabel()
        self.message.setWordWrap(True)
        if obj.isValid() and is_uncertain(obj):
            self.say_valid()
        shown = QtCore.QTimer(self.form)  # goes with the form
        shown.setSingleShot(True)
        shown.timeout.connect(self.make_room)
        shown.start(0)

    def make_room(self):
        """Widens the dock in which the panel is, where that is narrow."""
        if dock := self.dock():
            if dock.width() < WIDTH:
                FreeCADGui.getMainWindow().resizeDocks([dock], [WIDTH], QtCore.Qt.Horizontal)

    def dock(self):
        """The dock that shows the panel; None while there is none."""
        return next((dock for dock in FreeCADGui.getMainWindow().findChildren(QtWidgets.QDockWidget) if dock.isVisible() and dock.isAncestorOf(self.form)), None)

    def take_over(self):
        raise NotImplementedError

    def say(self, text, good=False):
        self.message.setText(units.in_words(text))
        self.message.setStyleSheet(f"color: {COLOURS[good]}")

    def say_valid(self):
        """Nothing needs to be said of an object that came out well, except where its mesh may lack parts."""
        self.say(*(with_doubt(tr("Valid"), self.obj.Certainty) if is_uncertain(self.obj) else ("", True)))

    def apply(self):
        """Takes the values over and recomputes; True where the object came out well."""
        self.take_over()
        self.document.recompute([self.obj])
        if self.obj.isValid():
            self.say_valid()
            return True
        self.say(self.obj.getStatusString())
        return False

    # What FreeCAD asks of a task panel.
    def getStandardButtons(self):
        buttons = QtWidgets.QDialogButtonBox
        return flags(buttons.Ok | buttons.Cancel | buttons.Apply)

    def clicked(self, button):
        if button == QtWidgets.QDialogButtonBox.Apply:
            self.apply()

    def accept(self):
        if not self.apply():
            return False
        self.document.commitTransaction()
        self.close()
        self.document.recompute()
        return True

    def reject(self):
        self.document.abortTransaction()  # first: leaving edit mode would commit what is pending
        self.close()
        self.document.recompute()
        return True

    def close(self):
        FreeCADGui.getDocument(self.document.Name).resetEdit()
        FreeCADGui.Control.closeDialog()
