"""Rows for the parameters of a text, each with a box and a slider."""

import math

from ..shim import QtCore, QtWidgets

STEPS = 1000  # positions of a slider


def sensible_range(value):
    """Returns the range of a slider in round numbers: from 0 to about twice the value, or symmetric if the value is
    negative."""
    size = abs(value) or 1.0
    unit = 10 ** math.floor(math.log10(size))
    end = unit * next(n for n in (2, 5, 10, 20) if n * unit >= 1.9 * size)
    return (-end if value < 0 else 0.0), end


class ParameterRow(QtWidgets.QWidget):
    """A number with a box and a slider. The slider's range grows to include entered values, and when the slider is
    released at its end."""

    changed = QtCore.Signal(float)

    def __init__(self, value, limits=None):
        super().__init__()
        self.box = QtWidgets.QDoubleSpinBox()
        self.box.setDecimals(4)
        self.box.setRange(-1e9, 1e9)
        self.box.setStepType(QtWidgets.QAbstractSpinBox.AdaptiveDecimalStepType)
        self.box.setKeyboardTracking(True)
        self.box.setFixedWidth(100)
        self.slider = QtWidgets.QSlider(QtCore.Qt.Horizontal)
        self.slider.setRange(0, STEPS)
        layout = QtWidgets.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.slider)
        layout.addWidget(self.box)
        self.low, self.high = limits or sensible_range(value)
        self.set(value)
        self.box.valueChanged.connect(self._typed)
        self.slider.valueChanged.connect(self._slid)
        self.slider.sliderReleased.connect(self._grow)

    def value(self):
        return self.box.value()

    def set(self, value):
        """Shows a value without emitting `changed`."""
        for widget in (self.box, self.slider):
            widget.blockSignals(True)
        self.box.setValue(value)
        self._place(value)
        for widget in (self.box, self.slider):
            widget.blockSignals(False)

    def _place(self, value):
        if not self.low <= value <= self.high:
            low, high = sensible_range(value)
            self.low, self.high = min(self.low, low), max(self.high, high)
        self.slider.setValue(round(STEPS * (value - self.low) / (self.high - self.low)))

    def _typed(self, value):
        self.slider.blockSignals(True)
        self._place(value)
        self.slider.blockSignals(False)
        self.changed.emit(value)

    def _slid(self, step):
        """Sets the value of a slider position, with the fewest digits that distinguish adjacent positions."""
        span = self.high - self.low
        digits = max(0, 2 - math.floor(math.log10(span)))
        self.box.blockSignals(True)
        self.box.setValue(round(self.low + span * step / STEPS, digits))
        self.box.blockSignals(False)
        self.changed.emit(self.box.value())

    def _grow(self):
        if self.slider.value() == STEPS:
            self.high *= 2
        elif self.slider.value() == 0 and self.low < 0:
            self.low *= 2
        self.set(self.value())
