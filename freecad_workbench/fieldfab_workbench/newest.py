"""Background computation of the newest request during a drag. Requests that become outdated while they wait are
dropped."""

import time

from . import work
from .shim import QtCore

PATIENCE = 0.5  # seconds that a run may take while a newer request waits


class Newest:
    """`ask(function, then)` runs `function(progress)` on a thread and then `then(result)` in the window's thread. A
    call during a run replaces the waiting call. `failed(error)` receives exceptions of the function. `busy(fraction,
    message)` receives progress, and (None, "") at the end."""

    def __init__(self, failed, busy=lambda fraction, message: None):
        self._failed, self._busy = failed, busy
        self._task = self._then = self._waiting = None
        self._timer = QtCore.QTimer()
        self._timer.setInterval(10)
        self._timer.timeout.connect(self._look)

    def ask(self, function, then):
        self._waiting = (function, then)
        if self._task is None:
            self._start()

    def idle(self):
        return self._task is None

    def stop(self):
        """Cancels the running call and drops the waiting one. Makes no further callbacks."""
        self._timer.stop()
        if self._task is not None:
            self._task.cancel()
        self._task = self._then = self._waiting = None

    def _start(self):
        (function, self._then), self._waiting = self._waiting, None
        self._task, self._began = work.Task(function), time.monotonic()
        self._task.start()
        self._timer.start()

    def _look(self):
        if self._task.is_alive():
            if self._waiting and time.monotonic() - self._began > PATIENCE:
                self._task.cancel()
            self._busy(self._task.fraction, self._task.message)
            return
        task, then, self._task = self._task, self._then, None
        self._timer.stop()
        self._busy(None, "")
        try:
            result = task.outcome()
        except work.Cancelled:
            then = None
        except Exception as error:  # the panel reports errors of any kind
            self._failed(error)
            then = None
        if then is not None:
            then(result)
        if self._waiting and self._task is None:
            self._start()
