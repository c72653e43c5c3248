"""Base class of panels that edit one object in one undo step, with Apply, OK, and Cancel, which reverts all changes."""

import FreeCADGui

from ..kernel_messages import translated
from .. import units, work
from ..certainty import DOUBTFUL, is_uncertain, with_doubt
from ..shim import QtCore, QtWidgets, flags
from ..views.part_view import is_there
from ..views.preview import Preview
from ..words import tr
from .wheel import WheelGuard

COLOURS = {True: "#2c7a3f", False: "#b3261e", DOUBTFUL: "#8a5a00"}
WIDTH = 420  # least width of the dock, pixels: FreeCAD's default is too narrow for three buttons


class EditPanel:
    """A task panel. `form` is the widget; `take_over()` writes its values to the object."""

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
        self.making, self.bar_of_making = None, QtWidgets.QProgressBar()
        self.layout.addWidget(self.bar_of_making)
        self.bar_of_making.setObjectName("Making")
        self.bar_of_making.setTextVisible(False)
        self.bar_of_making.hide()
        self.gauge = work.Gauge(self.bar_of_making)
        self.look_at_making = QtCore.QTimer(self.form)
        self.look_at_making.timeout.connect(self._look_at_making)
        if obj.isValid() and is_uncertain(obj):
            self.say_valid()
        shown = QtCore.QTimer(self.form)  # deleted with the form
        shown.setSingleShot(True)
        shown.timeout.connect(self.make_room)
        shown.start(0)

    def make_room(self):
        """Widens the panel's dock if it is narrow."""
        if dock := self.dock():
            if dock.width() < WIDTH:
                FreeCADGui.getMainWindow().resizeDocks([dock], [WIDTH], QtCore.Qt.Horizontal)

    def dock(self):
        """Returns the dock that shows the panel, or None."""
        return next((dock for dock in FreeCADGui.getMainWindow().findChildren(QtWidgets.QDockWidget)
                     if dock.isVisible() and dock.isAncestorOf(self.form)), None)

    def take_over(self):
        raise NotImplementedError

    def say(self, text, good=False):
        self.message.setText(units.in_words(translated(text)))
        self.message.setStyleSheet(f"color: {COLOURS[good]}")

    def say_valid(self):
        """Clears the message of a valid object, or reports that its mesh may lack parts."""
        self.say(*(with_doubt(tr("Valid"), self.obj.Certainty) if is_uncertain(self.obj) else ("", True)))

    def apply(self):
        """Writes the values to the object and recomputes it. Returns whether the object is valid."""
        self.take_over()
        self.document.recompute([self.obj])
        if self.obj.isValid():
            self.say_valid()
            return True
        self.say(self.obj.getStatusString())
        return False

    # Making a solid's mesh in the background.
    def after_making(self, then):
        """Writes the values to the object, makes the mesh for the recompute in the background, and returns the result
        of `then()`. If this takes longer than a moment, returns False: the window stays responsive, the panel shows
        progress, and `then` is called when the mesh is ready."""
        if self.making is not None:
            return False
        try:
            self.take_over()
        except ValueError as error:
            self.say(str(error))
            return False
        make = self.obj.Proxy.ahead(self.obj) if hasattr(self.obj.Proxy, "ahead") else None
        if make is None:
            return then()
        self._pause_preview(True)
        self.making, self.then = work.Task(make), then
        self.form.destroyed.connect(self.making.cancel)
        self.making.start()
        self.making.join(work.SHOW_AFTER)
        if not self.making.is_alive():
            return self._go_on()
        self._set_making(True)
        return False

    def _go_on(self):
        self.making = None
        result = self.then()
        self._pause_preview(False)  # if the panel is still open
        return result

    def _pause_preview(self, on):
        if isinstance(preview := getattr(self, "preview", None), Preview):
            preview.pause(on)

    def _set_making(self, on):
        if on:
            kept = (self.bar_of_making, self.message)
            self._inputs = [each for each in self.form.children()
                            if isinstance(each, QtWidgets.QWidget) and each.isEnabled() and each not in kept]
        for widget in self._inputs:
            widget.setEnabled(not on)
        self.bar_of_making.setVisible(on)
        if on:
            self.look_at_making.start(30)
        else:
            self.look_at_making.stop()

    def _look_at_making(self):
        task = self.making
        if not is_there(self.obj):
            self.stop_making()
            return
        self.gauge.show(task.fraction)
        if task.is_alive():
            words = tr("Computing: {message}").format(message=task.message) if task.message else tr("Computing")
            if words != self.message.text():
                self.say(words, True)
            return
        self._set_making(False)
        self._go_on()

    def stop_making(self):
        self.look_at_making.stop()
        if self.making is not None:
            self.making.cancel()

    # FreeCAD's interface of a task panel.
    def getStandardButtons(self):
        buttons = QtWidgets.QDialogButtonBox
        return flags(buttons.Ok | buttons.Cancel | buttons.Apply)

    def clicked(self, button):
        if button == QtWidgets.QDialogButtonBox.Apply:
            self.after_making(self.apply)

    def accept(self):
        return self.after_making(self.finish)

    def finish(self):
        """Recomputes the object and closes the panel. Returns False and stays open if the object is invalid."""
        if not self.apply():
            return False
        self.document.commitTransaction()
        self.close()
        self.document.recompute()
        return True

    def reject(self):
        self.document.abortTransaction()  # first: leaving edit mode would commit the transaction
        self.close()
        self.document.recompute()
        return True

    def close(self):
        self.stop_making()
        FreeCADGui.getDocument(self.document.Name).resetEdit()
        FreeCADGui.Control.closeDialog()
