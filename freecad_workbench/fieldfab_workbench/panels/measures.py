"""Inputs for lengths, speeds and volumes in the user's unit scheme. Their values are in mm, mm/min and mm³."""

import FreeCADGui

from .. import units
from ..shim import QtGui, QtWidgets

PLACES = {"mm": 4, "mm/min": 1, "mm³": 2}  # decimals
MORE_PLACES = {"mm": 1, "mm/min": 1, "mm³": 5}  # additional decimals in inches
STEP = 1.27  # factor of steps in inches: a step of 1 mm becomes 1.27 mm = 0.05 in


class MeasureBox(QtWidgets.QDoubleSpinBox):
    """A number with its unit. value(), setValue() and the limits are in `unit`, a key of PLACES. The user may enter
    other units (units.read). `zero`: text displayed for the minimum."""

    def __init__(self, value=0.0, unit="mm", low=0.0, high=1e6, zero="", step=1.0):
        super().__init__()
        self.unit = unit
        self._places = PLACES[unit] + (MORE_PLACES[unit] if units.in_inches() else 0)
        self.setDecimals(9)
        self.setRange(low, high)
        self.setSingleStep(step * (STEP if units.in_inches() else 1))
        self.setSuffix(f" {units.shown_unit(unit)}")
        if zero:
            self.setSpecialValueText(zero)
        self.setValue(value)

    # Overrides of Qt methods.
    def textFromValue(self, value):
        number = f"{units.shown(value, self.unit):.{self._places}f}"
        return (number.rstrip("0").rstrip(".") if "." in number else number).replace(".", self.locale().decimalPoint())

    def valueFromText(self, text):
        if self.specialValueText() and text == self.specialValueText():
            return self.minimum()
        return units.read(text, self.unit)

    def validate(self, text, place):
        try:
            fits = self.minimum() <= self.valueFromText(text) <= self.maximum()
        except ValueError:
            fits = False
        return (QtGui.QValidator.Acceptable if fits else QtGui.QValidator.Intermediate), text, place


def quantity_box(obj, name):
    """Returns FreeCAD's own input for a property, which accepts expressions. In US customary units it also shows
    thousandths and feet."""
    box = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
    if units.in_inches():
        box.setProperty("decimals", 4)
    box.setProperty("value", getattr(obj, name))
    if hasattr(FreeCADGui, "ExpressionBinding"):
        FreeCADGui.ExpressionBinding(box).bind(obj, name)
    return box


def place_boxes(values, low=-1e6):
    """Returns a box for each coordinate of a point, narrow enough for three in a row."""
    boxes = []
    for value in values:
        box = MeasureBox(value, low=low)
        box.setButtonSymbols(QtWidgets.QAbstractSpinBox.NoButtons)
        box.setMinimumWidth(60)
        boxes.append(box)
    return boxes
