"""Helpers for tests in FreeCAD's window: waiting with a running event loop, buttons, screenshots."""

import os
import time

import FreeCADGui
import numpy as np

from fieldfab_workbench.shim import QtCore, QtGui, QtWidgets


LIMIT = 300  # seconds, on a busy machine


def wait(until, what="it"):
    """Processes events until the condition holds."""
    end = time.monotonic() + LIMIT
    while not until():
        assert time.monotonic() < end, f"waited {LIMIT} s for {what} in vain"
        QtWidgets.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 20)
        time.sleep(0.005)


def live(seconds):
    """Processes events for `seconds`, and for as many rounds as an idle machine processes in that time."""
    end, rounds = time.monotonic() + seconds, iter(range(round(seconds / 0.03)))
    wait(lambda: next(rounds, None) is None and time.monotonic() > end, "the window")


def press(button):
    """Clicks OK, Cancel or Apply of the open task panel, and waits for its solid."""
    boxes = [box for box in FreeCADGui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox)
             if box.isVisible() and box.button(button)]
    assert len(boxes) == 1, f"{len(boxes)} button boxes are seen"
    boxes[0].button(button).click()
    live(0.1)
    wait(lambda: not any(bar.isVisible() for bar in FreeCADGui.getMainWindow().findChildren(
        QtWidgets.QProgressBar, "Making")), "the solid")


def shot(name, panel=True):
    """Takes a picture of the whole window, as a QImage; with `panel=False` nothing lies over the 3D view. It is saved
    as NAME.png in the folder FIELDFAB_SHOTS, if that is set."""
    live(0.3)
    over = [] if panel else _uncover()
    picture = FreeCADGui.getMainWindow().screen().grabWindow(FreeCADGui.getMainWindow().winId()).toImage()
    if folder := os.environ.get("FIELDFAB_SHOTS"):
        picture.save(os.path.join(folder, f"{name}.png"))
    for widget in over:
        widget.show()
    return picture


def _uncover():
    """Hides the task panel where it lies over the 3D view, as by default in FreeCAD 1.1. Returns what was hidden."""
    hidden = []

    def is_free():  # FreeCAD may show it again a moment after a panel was closed
        over = [widget for widget in FreeCADGui.getMainWindow().findChildren(QtWidgets.QTabWidget)
                if widget.metaObject().className() == "Gui::OverlayTabWidget" and widget.isVisible()]
        for widget in over:
            widget.hide()
        hidden.extend(over)
        return not over

    wait(is_free, "the whole view")
    return hidden


def pixels(picture, x, y, width, height):
    """Returns a part of a picture, as an array of shape (height, width, 3)."""
    picture = picture.copy(x, y, width, height).convertToFormat(QtGui.QImage.Format_RGB888)
    rows = np.frombuffer(picture.constBits(), np.uint8).reshape(picture.height(), picture.bytesPerLine())
    return rows[:, : 3 * picture.width()].reshape(picture.height(), picture.width(), 3).astype(int)


def view_pixels(name, view):
    """Takes a picture as shot() does, without a panel over the view. Returns the widget of a PartView, as pixels()
    does."""
    at = view.widget().mapTo(FreeCADGui.getMainWindow(), QtCore.QPoint(0, 0))
    return pixels(shot(name, panel=False), at.x(), at.y(), view.widget().width(), view.widget().height())


def clock():
    """Returns seconds without the time that this thread waited for a core (if Linux reports it)."""
    try:
        with open("/proc/thread-self/schedstat", encoding="ascii") as file:
            return time.monotonic() - int(file.read().split()[1]) / 1e9
    except OSError:
        return time.monotonic()


class Heartbeat:
    """Measures by clock() the gaps in which the window does not respond: `with Heartbeat() as beat: ...; assert
    beat.answers(), beat.gaps`."""

    def __enter__(self):
        self.gaps, self._last = [], clock()
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._beat)
        self._timer.start(5)
        return self

    def _beat(self):
        now = clock()
        self.gaps.append(now - self._last)
        self._last = now

    def __exit__(self, *_):
        self._beat()
        self._timer.stop()
        self.gaps.sort()

    @property
    def longest(self):
        return self.gaps[-1]

    def answers(self, within=0.1):
        """Whether the window always responded within `within` seconds. Machines are shared: one gap in fifty may be up
        to five times as long."""
        late = [gap for gap in self.gaps if gap > within]
        return len(late) <= max(1, len(self.gaps) // 50) and self.longest < 5 * within
