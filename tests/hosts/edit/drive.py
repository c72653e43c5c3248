"""Drives the real window of `fieldfab edit` on a model file. argv[1]: the file; argv[2]: the file of the screenshot.
Prints its observations."""

import json
import os
import pathlib
import sys
import time
import traceback
from typing import Any

import numpy as np
try:
    from PySide2 import QtCore, QtGui, QtWidgets
except ImportError:
    from PySide6 import QtCore, QtGui, QtWidgets

import fieldfab as ff
from fieldfab import edit

seen: dict[str, Any] = {}
model, shot = pathlib.Path(sys.argv[1]), sys.argv[2]
application = QtWidgets.QApplication([])
window = edit.Window(str(model))
window.resize(640, 480)
window.show()
fine = []
window.view.shown.connect(fine.append)


def wait(condition, seconds=60):
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            raise SystemExit(f"waited in vain at line {[f.lineno for f in traceback.extract_stack()][:-1]}; "
                             f"error: {window.view.error!r}")
        application.processEvents(QtCore.QEventLoop.AllEvents, 50)
        time.sleep(0.005)


def wait_for_picture():
    wait(lambda: window.view.fine)


def save(text=None):
    """Writes the model file, or has the sliders write it, and waits for the picture of its new text."""
    before = window.view.model
    window.write() if text is None else model.write_text(text)
    wait(lambda: window.view.model is not before)
    wait_for_picture()


def shown():
    """Returns the view's pixels on the screen."""
    image = window.view.grab().toImage().convertToFormat(QtGui.QImage.Format_RGB888)
    lines = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return lines[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(int)


def rendered():
    """Returns the expected picture, by render() alone."""
    view = window.view
    picture = ff.render(ff.load(model), size=max(view.width(), view.height()), **view.settings())
    pixels = picture.pixels if picture.channels == 3 else np.repeat(picture.pixels[:, :, None], 3, 2)
    return pixels.astype(int)


wait(lambda: fine)
seen["coarse_first"] = not fine[0]
wait_for_picture()
seen["exact"] = int(np.abs(shown() - rendered()).max())
first = shown()

# A save updates the view.
save("difference(box(10, 10, 10), sphere(6))\n")
seen["changed_by_save"] = float((shown() != first).mean())
seen["exact_after_save"] = int(np.abs(shown() - rendered()).max())

# Zooming with the wheel and panning evaluate anew.
wheel = QtGui.QWheelEvent(
    QtCore.QPointF(400, 200), window.view.mapToGlobal(QtCore.QPoint(400, 200)), QtCore.QPoint(0, 0),
    QtCore.QPoint(0, 480), QtCore.Qt.NoButton, QtCore.Qt.NoModifier, QtCore.Qt.NoScrollPhase, False)
before = window.view.scale
application.sendEvent(window.view, wheel)
wait_for_picture()
seen["zoomed"] = window.view.scale / before
seen["exact_after_zoom"] = int(np.abs(shown() - rendered()).max())
for kind, at in ((QtCore.QEvent.MouseButtonPress, (200, 200)), (QtCore.QEvent.MouseMove, (260, 220))):
    event = QtGui.QMouseEvent(kind, QtCore.QPointF(*at), QtCore.Qt.LeftButton, QtCore.Qt.LeftButton,
                              QtCore.Qt.NoModifier)
    application.sendEvent(window.view, event)
wait_for_picture()
seen["exact_after_turn"] = int(np.abs(shown() - rendered()).max())
application.sendEvent(window.view, QtGui.QKeyEvent(QtCore.QEvent.KeyPress, QtCore.Qt.Key_F, QtCore.Qt.NoModifier))
wait_for_picture()
window.grab().save(shot)

# Sliders of the text's parameters; only the button writes the file.
text = "size = 10  # 4 to 12, ½\nbox(size, size, size)\n"
save(text)
window.sliders.slider("size").setValue(500)
wait(lambda: window.view.model.bounds[3] < 4.2)
seen["slid"] = window.sliders.values["size"]
seen["untouched"] = model.read_text() == text
window.grab().save(shot.replace(".png", "-sliders.png"))
save()
seen["written"] = model.read_text()
assert not window.sliders.values
save("difference(box(10, 10, 10), sphere(6))\n")
seen["no_sliders"] = not window.sliders.isVisible()

# An error is shown, and the last valid picture stays.
good = shown()
model.write_text("difference(box(10, 10, 10), spheer(6))\nr = q  # ½\n")
wait(lambda: window.view.error)
application.processEvents()
seen["message"] = window.view.error
seen["kept_below_message"] = bool((shown()[120:] == good[120:]).all())
window.grab().save(shot.replace(".png", "-error.png"))

# Flat models are bitmaps.
save("circle(5) & !circle(3)\n")
seen["error_gone"] = window.view.error == ""
seen["flat_mode"] = window.view.settings()["mode"]
seen["exact_flat"] = int(np.abs(shown() - rendered()).max())

# A newer version of the file replaces an endless script.
os.rename(model, model.with_suffix(".old"))
wait(lambda: window.view.error)
seen["missing"] = window.view.error
window.close()
print(json.dumps(seen))
os._exit(0)  # worker threads may still be running
