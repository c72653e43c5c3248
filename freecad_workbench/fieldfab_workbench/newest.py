"""Answers while someone drags: the newest question is worked on beside the window, those between are left out."""

import time

from . import work
from .shim import QtCore

PATIENCE = 0.5  # seconds that work may go on once something newer waits


class Newest:
    """`ask(function, then)` runs `function(progress)` on a thread and then `then(result)` in the window's thread. A
    call while one runs replaces the one that waits. `failed(error)` gets what a function raised. `busy(fraction,
    message)` is told the progress, and (None, "") at the end."""

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
        """Ends what runs, forgets what waits; nothing is told any more."""
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
        except Exception as error:  # whatever it is, the panel says it
            self._failed(error)
            then = None
        if then is not None:
            then(result)
        if self._waiting and self._task is None:
            self._start()
