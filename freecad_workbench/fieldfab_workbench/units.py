"""Lengths, speeds, areas and volumes in FreeCAD's unit scheme: in mm or in inches. Stored values, arguments and results
of functions are in mm, mm/min, mm² and mm³, and these names are the values of `unit`. Other units are the same in every
scheme."""

import re

import FreeCAD

from .words import marked, tr

INCH = 25.4  # mm
SCHEMES_IN_INCHES = (2, 3, 5, 7)  # FreeCAD's: US customary, its decimal form, building and civil engineering
IN_INCHES = {"mm": ("in", INCH), "mm/min": ("in/min", INCH), "mm²": ("in²", INCH**2), "mm³": ("in³", INCH**3),
             "m": ("in", INCH / 1000)}
QUANTITIES = {"mm": "mm", "mm/min": "mm/min", "mm²": "mm^2", "mm³": "mm^3", "degrees": "deg"}  # FreeCAD's spelling
WORDS = marked(("degrees", "diameters", "rpm", "inches/s", "units/s"))  # units that are words of a language
KERNELS = {"mm2": "mm²", "mm3": "mm³"}  # {the kernel's spelling: ours}
# In the kernel's texts: numbers with a unit after the last one, and points without a unit.
NUMBER = r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?"
LENGTHS = re.compile(
    rf"({NUMBER}(?: (?:x|×) {NUMBER})*) (mm/min|mm[23²³]?|m)(?!\w)|\({NUMBER}, {NUMBER}, {NUMBER}\)|\b[xyz] {NUMBER}")


def in_inches():
    return FreeCAD.Units.getSchema() in SCHEMES_IN_INCHES


def shown_unit(unit):
    """Returns the displayed unit for an internal unit."""
    unit = KERNELS.get(unit, unit)
    if unit in WORDS:
        return tr(unit)
    return IN_INCHES[unit][0] if unit in IN_INCHES and in_inches() else unit


def shown(value, unit="mm"):
    """Converts an internal value to the displayed unit."""
    return value / _size(unit)


def stored(value, unit="mm"):
    """Converts a value in the displayed unit to the internal unit."""
    return round(value * _size(unit), 9)


def _size(unit):
    unit = KERNELS.get(unit, unit)
    return IN_INCHES[unit][1] if unit in IN_INCHES and in_inches() else 1.0


def told(value, unit="mm", digits=4):
    """Formats an internal value with its displayed unit."""
    return f"{_digits(shown(value, unit), digits)} {shown_unit(unit)}".strip()


def told_all(values, unit="mm", digits=4, between=" x "):
    """Formats several internal values with one unit after the last."""
    return f"{between.join(_digits(shown(value, unit), digits) for value in values)} {shown_unit(unit)}"


def _digits(number, digits):
    """Formats with the given significant digits, or as an integer if it has more: 24000, 0.3937."""
    return f"{number:.0f}" if abs(number) >= 10**digits else f"{number:.{digits}g}"


def read(text, unit="mm"):
    """Parses user input as a number in `unit`. Without a unit, it is in the displayed unit ("0.2", "1/4"); other units
    may be named ("5 mm", "2 cm/s"). Raises ValueError with a line for the user."""
    name, text = shown_unit(unit), text.strip().replace(",", ".")
    if name and text.endswith(name):
        text = text[: -len(name)].strip()
    try:
        return stored(float(text), unit)
    except ValueError:
        pass
    try:
        value = FreeCAD.Units.Quantity(text)
        if value.Unit == FreeCAD.Units.Unit():
            return stored(value.Value, unit)
        one = FreeCAD.Units.Quantity(f"1 {QUANTITIES[unit]}")
        if value.Unit != one.Unit:
            raise ValueError
    except Exception:  # FreeCAD raises several types
        raise ValueError(tr("must be a number in {unit}").format(unit=name) if name
                         else tr("must be a number")) from None
    return round(value.Value / one.Value, 9)


def in_words(text):
    """Converts the lengths in one of the kernel's texts from mm to the displayed unit."""
    return LENGTHS.sub(_in_inches, text) if in_inches() else text


def _in_inches(found):
    unit = KERNELS.get(found[2], found[2])
    words = re.sub(NUMBER, lambda number: _number(number[0], unit or "mm"), found[1] or found[0])
    return f"{words} {shown_unit(unit)}" if unit else words


def _number(text, unit):
    """Converts a number. Lengths and speeds get two more decimals than in mm, since an inch is 25.4 mm."""
    value = shown(float(text), unit)
    if unit not in ("mm", "mm/min") or "e" in text:
        return f"{value:.4g}"
    return f"{value:.{len(text.partition('.')[2]) + 2}f}"
