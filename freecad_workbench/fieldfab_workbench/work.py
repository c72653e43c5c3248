"""Long work in the background. The window stays responsive, shows progress, and can cancel the work."""

import threading
import time

import FreeCAD

from .kernel_messages import translated
from .words import tr

SHOW_AFTER = 0.4  # seconds before a dialog appears
STANDS = 1.0  # seconds without a change until a bar becomes indeterminate
STEPS = 1000  # range of a progress bar


class Cancelled(Exception):
    """The user cancelled the work."""


class Task(threading.Thread):
    """Runs `function(progress)` on its own thread. `progress(fraction, message)` returns False if the work should
    stop."""

    def __init__(self, function):
        super().__init__(daemon=True)
        self.function, self.fraction, self._phase = function, 0.0, ""
        self.result, self.error, self.cancelled = None, None, False

    def run(self):
        try:
            self.result = self.function(self.progress)
        except BaseException as error:  # outcome() raises it again
            self.error = error

    def progress(self, fraction, message):
        self.fraction, self._phase = fraction, message
        return not self.cancelled

    @property
    def message(self):
        """What is done now, in the user's language; "" where that is not known."""
        return translated(self._phase)

    def cancel(self):
        self.cancelled = True

    def outcome(self):
        """Returns the result of a finished thread. Raises the function's error, or Cancelled."""
        if self.error is None:
            return self.result
        if self.cancelled and getattr(self.error, "kind", "") in ("cancelled", ""):
            raise Cancelled() from None
        raise self.error


class Gauge:
    """Shows progress on a QProgressBar or QProgressDialog. If the fraction stays constant, the bar becomes
    indeterminate, since the work continues."""

    def __init__(self, bar):
        self._bar, self._last, self._since = bar, None, 0.0

    def show(self, fraction):
        now = time.monotonic()
        if fraction != self._last:
            self._last, self._since = fraction, now
        if now - self._since > STANDS:
            self._bar.setRange(0, 0)
        else:
            self._bar.setRange(0, STEPS)
            self._bar.setValue(round(STEPS * fraction))

    def stop(self):
        """Resets the bar."""
        self._last = None
        self._bar.setRange(0, STEPS)
        self._bar.setValue(0)


def run(function, title):
    """Returns `function(progress)`. With a window, redraws it during the work; after a moment a dialog shows progress
    and a Cancel button (Cancelled is raised). The calling thread waits in any case, so that nothing else changes the
    document."""
    if not FreeCAD.GuiUp or threading.current_thread() is not threading.main_thread():
        return function(lambda fraction, message: True)
    from .shim import QtCore, QtWidgets  # Qt may be missing without a window

    task, began, dialog = Task(function), time.monotonic(), None
    task.start()
    loop = QtCore.QEventLoop
    while task.is_alive():
        task.join(0.01)
        if dialog is None and time.monotonic() - began > SHOW_AFTER:
            import FreeCADGui

            dialog = QtWidgets.QProgressDialog(title, tr("Cancel"), 0, STEPS, FreeCADGui.getMainWindow())
            gauge = Gauge(dialog)
            dialog.setWindowTitle("Fieldfab")
            dialog.setWindowModality(QtCore.Qt.ApplicationModal)
            dialog.setAutoClose(False)
            dialog.setAutoReset(False)
            dialog.setMinimumWidth(360)
            dialog.show()
        if dialog is not None and dialog.wasCanceled():
            task.cancel()
            dialog.setLabelText(tr("Stopping"))
        elif dialog is not None:
            gauge.show(task.fraction)
            dialog.setLabelText(f"{title}: {task.message}" if task.message else title)
        # No user input before the modal dialog blocks it: a click must not change the document during its recompute.
        QtWidgets.QApplication.processEvents(loop.AllEvents if dialog else loop.ExcludeUserInputEvents, 20)
    if dialog is not None:
        dialog.close()
        dialog.deleteLater()
    return task.outcome()
