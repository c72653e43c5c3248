"""Long work beside the window: it stays alive, shows how far the work is, and can stop it."""

import threading
import time

import FreeCAD

from .words import tr

SHOW_AFTER = 0.4  # seconds before a dialog appears
STANDS = 1.0  # seconds without a change after which a bar says no more how far the work is
STEPS = 1000  # of a bar


class Cancelled(Exception):
    """The user stopped the work."""


class Task(threading.Thread):
    """Runs `function(progress)` on a thread of its own. `progress(fraction, message)` returns False once the work
    should stop."""

    def __init__(self, function):
        super().__init__(daemon=True)
        self.function, self.fraction, self.message = function, 0.0, ""
        self.result, self.error, self.cancelled = None, None, False

    def run(self):
        try:
            self.result = self.function(self.progress)
        except BaseException as error:  # it is raised again where the result is asked for
            self.error = error

    def progress(self, fraction, message):
        self.fraction, self.message = fraction, message
        return not self.cancelled

    def cancel(self):
        self.cancelled = True

    def outcome(self):
        """The result of a thread that has ended. Raises what the function raised, and Cancelled."""
        if self.error is None:
            return self.result
        if self.cancelled and getattr(self.error, "kind", "") in ("cancelled", ""):
            raise Cancelled() from None
        raise self.error


class Gauge:
    """Shows the progress of work on a QProgressBar or QProgressDialog. While the fraction stays the same the bar runs
    to and fro, since the work goes on."""

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
        """Back to the beginning."""
        self._last = None
        self._bar.setRange(0, STEPS)
        self._bar.setValue(0)


def run(function, title):
    """Returns `function(progress)`. With a window, the window is drawn meanwhile; after a moment a dialog shows
    progress and offers to cancel (then Cancelled is raised). The calling thread waits either way: nothing else can
    change the document meanwhile."""
    if not FreeCAD.GuiUp or threading.current_thread() is not threading.main_thread():
        return function(lambda fraction, message: True)
    from .shim import QtCore, QtWidgets  # without a window there need be no Qt

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
        # Input waits until the dialog holds it back: a click must not change the document in the middle of its
        # recompute.
        QtWidgets.QApplication.processEvents(loop.AllEvents if dialog else loop.ExcludeUserInputEvents, 20)
    if dialog is not None:
        dialog.close()
        dialog.deleteLater()
    return task.outcome()
