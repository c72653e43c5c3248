"""Live view of a model file: `fieldfab edit MODEL`. The file is edited elsewhere; each save updates the view.

Wheel: zoom about the pointer. Left drag: rotate (pan if the model is flat). Right or middle drag: pan. F: fit.
P: perspective. S: save the picture. The parameters of a .frep text (`width = 20  # 5 to 40`) have sliders. The view
evaluates the model for the window's own pixels; a coarse picture comes first.
"""

import math
import os
import sys
import threading
import time

try:
    from PySide2 import QtCore, QtGui, QtWidgets
except ImportError:  # Qt 6
    from PySide6 import QtCore, QtGui, QtWidgets

from . import _core as ff

COARSE = 4  # the first picture has a quarter of the pixels along each side
SHOWN = 8  # errors at a time
FLAT, SOLID = "bitmap", "shaded"


class Stale(Exception):
    """Raised inside a job whose result is no longer needed."""


class Worker(QtCore.QObject):
    """Runs the latest job of its kind on a thread and cancels older ones."""

    done = QtCore.Signal(object)
    _made = QtCore.Signal(int, object)

    def __init__(self):
        super().__init__()
        self._made.connect(self._deliver)
        self._latest, self._wake, self._job = 0, threading.Condition(), None
        threading.Thread(target=self._run, daemon=True).start()

    def start(self, job):
        """Starts `job(progress)`, a generator. Emits each result unless a later job has started."""
        with self._wake:
            self._latest += 1
            self._job = (self._latest, job)
            self._wake.notify()

    @QtCore.Slot(int, object)
    def _deliver(self, number, result):
        """Passes on a result, on the thread of the window: a later job may have started while it was on its way."""
        if number == self._latest:
            self.done.emit(result)

    def _run(self):
        while True:
            with self._wake:
                while self._job is None:
                    self._wake.wait()
                number, job = self._job
                self._job = None

            def progress(fraction, message):
                if number != self._latest:
                    raise Stale

            try:
                for result in job(progress):
                    if number != self._latest:
                        break
                    self._made.emit(number, result)
            except Stale:
                pass
            except ff.Error as error:
                if error.kind != "cancelled":
                    self._made.emit(number, error)
            except Exception as error:  # the window survives any error of a model
                self._made.emit(number, error)


class Model:
    """A solid with its bounds."""

    def __init__(self, field):
        self.field = field
        bounds = self.field.bounds()
        self.flat = bounds is None
        if self.flat:  # perhaps unbounded along z only
            bounds = (self.field & ff.Solid(abs(ff.Z) - 0.5)).bounds()
        if bounds is None:
            raise ff.Error("there is nothing to show: the solid is empty, or unbounded along x or y")
        grown = max(bounds[3] - bounds[0], bounds[4] - bounds[1]) / 64
        self.bounds = tuple(b - grown for b in bounds[:3]) + tuple(b + grown for b in bounds[3:])
        if self.flat:
            self.bounds = self.bounds[:2] + (0.0,) + self.bounds[3:5] + (0.0,)


def text_of(path):
    """Returns the bytes of a .frep text; empty for another file type, and for a file that cannot be read now."""
    if not path.endswith(".frep"):
        return b""
    try:
        with open(path, "rb") as file:
            return file.read()
    except OSError:
        return b""


def read(path, values, progress):
    """Returns the Model of a file; the given numbers replace the parameters of a .frep text. Raises ff.Error with
    all errors of a text, one per line.
    """
    text, folder = text_of(path), os.path.dirname(path)
    try:
        if values:
            return Model(ff.parse(ff.language.with_values(text, values), folder))
        return Model(ff.run_model(path, progress=progress))
    except ff.Error as error:
        mistakes = ff.language.diagnostics(text, folder) if text and error.kind == "bad_input" else []
        if not mistakes:
            raise
        lines = [f"{os.path.basename(path)}:{m.line}:{m.column}: {m.message}" for m in mistakes[:SHOWN]]
        if len(mistakes) > SHOWN:
            lines.append(f"{len(mistakes) - SHOWN} more")
        raise ff.Error("\n".join(lines)) from None


class Sliders(QtWidgets.QDockWidget):
    """Sliders for the parameters of a .frep text. Only the button writes the file."""

    STEPS = 1000

    changed = QtCore.Signal()
    written = QtCore.Signal()

    def __init__(self):
        super().__init__("Parameters")
        self.values, self._parameters, self._rows = {}, {}, {}

    def follow(self, text):
        """Shows the parameters of a text, with the numbers of the text."""
        self._parameters = {each.name: each for each in ff.language.parameters(text)}
        self.values, self._rows = {}, {}
        inside = QtWidgets.QWidget()
        rows = QtWidgets.QFormLayout(inside)
        for name, each in self._parameters.items():
            slider, label = QtWidgets.QSlider(QtCore.Qt.Horizontal), QtWidgets.QLabel(f"{each.value:g}")
            slider.setRange(0, self.STEPS)
            low, high = self._range(each)
            slider.setValue(round(self.STEPS * (each.value - low) / (high - low)))
            slider.setToolTip(each.comment)
            slider.valueChanged.connect(lambda step, name=name: self._slid(name, step))
            line = QtWidgets.QHBoxLayout()
            line.addWidget(slider)
            line.addWidget(label)
            label.setMinimumWidth(60)
            rows.addRow(name, line)
            self._rows[name] = slider, label
        button = QtWidgets.QPushButton("Write to the file")
        button.clicked.connect(self.written)
        rows.addRow(button)
        self.setWidget(inside)
        self.setVisible(bool(self._parameters))

    @staticmethod
    def _range(parameter):
        """Returns the limits of a slider: those of the text, or 0 and twice the value; extended to include the
        value.
        """
        value = parameter.value
        low, high = parameter.range or (min(0, 2 * value), max(0, 2 * value) or (0 if value else 1))
        return min(low, value), max(high, value)

    def slider(self, name):
        return self._rows[name][0]

    def _slid(self, name, step):
        low, high = self._range(self._parameters[name])
        digits = max(0, 2 - math.floor(math.log10(high - low)))
        self.values[name] = round(low + (high - low) * step / self.STEPS, digits)
        self._rows[name][1].setText(f"{self.values[name]:g}")
        self.changed.emit()


class View(QtWidgets.QWidget):
    """The picture, and the error message of the file."""

    shown = QtCore.Signal(bool)  # argument: whether it is the fine picture

    def __init__(self):
        super().__init__()
        self.setMinimumSize(160, 120)
        self.setFocusPolicy(QtCore.Qt.StrongFocus)
        self.model, self.error, self.image, self.seconds = None, "", None, 0.0
        self.fine = False  # whether the picture is the fine one of what the settings ask for
        self.alpha, self.beta, self.perspective = 0.5, -0.95, 0.5
        self.offset, self.scale = [0.0, 0.0], None  # mm from the solid's centre; mm per pixel
        self.worker = Worker()
        self.worker.done.connect(self._show)
        self._grabbed = None

    # The visible window

    def set_model(self, model):
        first = self.model is None or self.model.flat != model.flat
        self.model, self.error = model, ""
        if first:
            self.fit()
        else:
            self.render()

    def set_error(self, message):
        self.error = message
        self.update()

    def fit(self):
        self.offset, self.scale = [0.0, 0.0], None
        self.render()

    def centre(self):
        """The centre of the solid in the picture's plane."""
        low, high = self.model.bounds[:3], self.model.bounds[3:]
        x, y, z = ((a + b) / 2 for a, b in zip(low, high))
        if self.model.flat:
            return x, y
        x, y = math.cos(self.alpha) * x - math.sin(self.alpha) * y, math.sin(self.alpha) * x + math.cos(self.alpha) * y
        return x, math.cos(self.beta) * y - math.sin(self.beta) * z

    def window(self):
        """x0, y0, x1, y1 of the widget in the picture's plane, mm."""
        if self.scale is None:
            low, high = self.model.bounds[:3], self.model.bounds[3:]
            sides = [b - a for a, b in zip(low, high)]
            if self.model.flat:
                self.scale = max(sides[0] / self.width(), sides[1] / self.height())
            else:
                self.scale = 1.05 * math.hypot(*sides) / min(self.width(), self.height())
        x, y = self.centre()
        x, y = x + self.offset[0], y + self.offset[1]
        half_x, half_y = self.scale * self.width() / 2, self.scale * self.height() / 2
        return x - half_x, y - half_y, x + half_x, y + half_y

    def settings(self):
        settings = {"mode": FLAT if self.model.flat else SOLID, "window": self.window(), "bounds": self.model.bounds}
        if not self.model.flat:
            settings.update(alpha=self.alpha, beta=self.beta, perspective=self.perspective)
        return settings

    def render(self):
        if self.model is None or self.width() < 8:
            return
        field, settings, size = self.model.field, self.settings(), max(self.width(), self.height())
        self.fine = False

        def job(progress):
            for pixels in (max(8, size // COARSE), size):
                started = time.monotonic()
                image = ff.render(field, size=pixels, progress=progress, **settings)
                yield image, pixels == size, time.monotonic() - started

        self.worker.start(job)

    def _show(self, result):
        if isinstance(result, Exception):
            return self.set_error(str(result))
        picture, self.fine, self.seconds = result
        kind = QtGui.QImage.Format_Grayscale8 if picture.channels == 1 else QtGui.QImage.Format_RGB888
        pixels = picture.pixels
        self.image = QtGui.QImage(pixels.tobytes(), picture.width, picture.height, picture.width * picture.channels,
                                  kind).copy()
        self.update()
        self.shown.emit(self.fine)

    # Qt

    def paintEvent(self, event):
        painter = QtGui.QPainter(self)
        painter.fillRect(self.rect(), QtGui.QColor("#e9edf2"))
        if self.image is not None:
            painter.setRenderHint(QtGui.QPainter.SmoothPixmapTransform, self.image.size() != self.size())
            painter.drawImage(self.rect(), self.image)
        if self.error:
            metrics = painter.fontMetrics()
            box = metrics.boundingRect(self.rect().adjusted(12, 8, -12, -8), QtCore.Qt.TextWordWrap, self.error)
            painter.fillRect(QtCore.QRect(0, 0, self.width(), box.height() + 16), QtGui.QColor(170, 30, 40, 230))
            painter.setPen(QtCore.Qt.white)
            painter.drawText(self.rect().adjusted(12, 8, -12, -8), QtCore.Qt.TextWordWrap, self.error)

    def resizeEvent(self, event):
        self.render()

    def wheelEvent(self, event):
        if self.model is None:
            return
        factor = 0.999 ** event.angleDelta().y()
        at = event.position()
        self.window()  # sets the scale
        for axis, pixels in enumerate((at.x() - self.width() / 2, self.height() / 2 - at.y())):
            self.offset[axis] += pixels * self.scale * (1 - factor)
        self.scale *= factor
        self.render()

    def mousePressEvent(self, event):
        self._grabbed = event.pos()

    def mouseMoveEvent(self, event):
        if self.model is None or self._grabbed is None:
            return
        moved, self._grabbed = event.pos() - self._grabbed, event.pos()
        if event.buttons() & QtCore.Qt.LeftButton and not self.model.flat:
            self.alpha += 0.01 * moved.x()
            self.beta += 0.01 * moved.y()
        else:
            self.window()
            self.offset[0] -= moved.x() * self.scale
            self.offset[1] += moved.y() * self.scale
        self.render()

    def keyPressEvent(self, event):
        if event.key() == QtCore.Qt.Key_F:
            self.fit()
        elif event.key() == QtCore.Qt.Key_P and self.model is not None:
            self.perspective = 0.0 if self.perspective else 0.5
            self.render()
        elif event.key() == QtCore.Qt.Key_S and self.image is not None:
            name, _ = QtWidgets.QFileDialog.getSaveFileName(self, "Save the picture", "", "PNG (*.png)")
            if name:
                self.save(name)
        else:
            super().keyPressEvent(event)

    def save(self, name):
        """Writes the picture as PNG, completely or not at all."""
        buffer = QtCore.QBuffer()
        buffer.open(QtCore.QIODevice.WriteOnly)
        self.image.save(buffer, "PNG")
        try:
            ff.write_file(name, bytes(buffer.data()))
        except ff.Error as error:
            self.set_error(str(error))


class Window(QtWidgets.QMainWindow):
    """The view of one file, which is read again after each change."""

    loaded = QtCore.Signal()

    def __init__(self, path):
        super().__init__()
        self.path = os.path.abspath(path)
        self.setWindowTitle(f"{os.path.basename(path)} – Fieldfab")
        self.view = View()
        self.setCentralWidget(self.view)
        self.resize(900, 700)
        self.loader = Worker()
        self.loader.done.connect(self._loaded)
        self.view.shown.connect(self._tell)
        self.sliders = Sliders()
        self.sliders.changed.connect(self.load)
        self.sliders.written.connect(self.write)
        self.addDockWidget(QtCore.Qt.BottomDockWidgetArea, self.sliders)
        self._seen = None
        self._timer = QtCore.QTimer(self)  # file watchers miss some editors' ways of saving
        self._timer.timeout.connect(self.look)
        self._timer.start(150)
        self.look()

    def look(self):
        """Reads the file if it has changed."""
        try:
            found = os.stat(self.path)
            seen = (found.st_mtime_ns, found.st_size, found.st_ino)
        except OSError as error:
            seen = None
            self.view.set_error(f"{self.path}: {error.strerror}")
        if seen is not None and seen != self._seen:
            self.statusBar().showMessage("reading …")
            self.sliders.follow(text_of(self.path))
            self.load()
        self._seen = seen

    def load(self):
        """Reads the file with the numbers of the sliders."""
        values = dict(self.sliders.values)
        self.loader.start(lambda progress: iter([read(self.path, values, progress)]))

    def write(self):
        """Writes the numbers of the sliders into the file."""
        try:
            ff.write_file(self.path, ff.language.with_values(text_of(self.path), self.sliders.values))
        except ff.Error as error:
            self.view.set_error(str(error))

    def _loaded(self, result):
        if isinstance(result, Exception):
            self.view.set_error(str(result))
            self.statusBar().showMessage("not shown: the picture is of the last version that was in order")
        else:
            self.view.set_model(result)
        self.loaded.emit()

    def _tell(self, fine):
        mm = self.view.scale or 0
        self.statusBar().showMessage(f"{1000 * self.view.seconds:.0f} ms, {mm:.3g} mm a pixel"
                                     + ("" if fine else " (coarse)"))


def main(arguments=None):
    arguments = sys.argv[1:] if arguments is None else arguments
    if len(arguments) != 1:
        print("usage: fieldfab edit MODEL", file=sys.stderr)
        return 2
    application = QtWidgets.QApplication.instance() or QtWidgets.QApplication([arguments[0]])
    window = Window(arguments[0])
    window.show()
    return (application.exec_ if hasattr(application, "exec_") else application.exec)()


if __name__ == "__main__":
    sys.exit(main())
