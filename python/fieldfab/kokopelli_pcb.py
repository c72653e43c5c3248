"""kokopelli's library of circuit boards: `koko.lib.pcb`. Lengths are inches in its parts, angles degrees.

    from fieldfab.kokopelli_pcb import PCB, ATtiny44_SOIC  # in kokopelli's scripts: from koko.lib.pcb import *
    board = PCB(0, 0, 1, 1.5)
    chip = ATtiny44_SOIC(0.5, 0.7, 0, "IC1")
    board += chip
    board.connectH(chip["PA4"], (0.8, 0.2))
    layout = board.layout
"""

from __future__ import annotations

import functools
import math
import operator

from . import kokopelli as k
from .pcb import placed_point

LABEL = 0.03  # height of letters, inches
WIDTH = 0.016  # default width of traces, inches


def _all(shapes):
    shapes = [each for each in shapes if each is not None]
    return functools.reduce(operator.add, shapes) if shapes else None


class Point:
    def __init__(self, x, y):
        self.x, self.y = x, y

    def __iter__(self):
        return iter([self.x, self.y])


class Pin:
    """A pad at (x, y) of its component; `shape` is relative to the pad's centre."""

    def __init__(self, x, y, shape, name=""):
        self.x, self.y, self.shape, self.name = x, y, shape, name

    @property
    def pad(self):
        return k.move(self.shape, self.x, self.y)


class BoundPin:
    """A pin at its position on the board."""

    def __init__(self, pin, component):
        self.pin, self.component = pin, component

    def _place(self):
        component = self.component
        return placed_point((self.pin.x, self.pin.y), component.x, component.y, math.radians(component.rot))

    x = property(lambda self: self._place()[0])
    y = property(lambda self: self._place()[1])


def _placed(place) -> Point | BoundPin:
    """Returns a pin as it is, and coordinates as a point."""
    return place if isinstance(place, BoundPin) else Point(*place)


class Component:
    """A component at (x, y), rotated by `rot` degrees; its class defines `pins`. component["GND"] is a pin by name,
    component[1] the first pin.
    """

    pins: list = []
    prefix = ""

    def __init__(self, x, y, rot=0, name=""):
        self.x, self.y, self.rot, self.name = x, y, rot, name

    def __getitem__(self, which):
        if isinstance(which, str):
            found = [pin for pin in self.pins if pin.name == which]
        else:
            found = self.pins[which - 1:][:1]  # 0 is the last
        if not found:
            known = ", ".join(pin.name for pin in self.pins if pin.name)
            raise IndexError(f"{type(self).__name__} has no pin {which!r}; it has {len(self.pins)}: {known}")
        return BoundPin(found[0], self)

    @property
    def pads(self):
        return k.move(k.rotate(_all(pin.pad for pin in self.pins), self.rot), self.x, self.y)

    @property
    def pin_labels(self):
        bound = [BoundPin(pin, self) for pin in self.pins if pin.name]
        return _all(k.text(each.pin.name, each.x, each.y, LABEL) for each in bound)

    @property
    def label(self):
        return k.text(self.name, self.x, self.y, LABEL)


class Connection:
    """A trace through pins and points. Each segment except the last is extended by half a width, to fill the corner."""

    def __init__(self, width, *points):
        self.width = width
        self.points = [_placed(each) for each in points]

    @property
    def traces(self):
        pieces = []
        for a, b in zip(self.points[:-1], self.points[1:]):
            long = math.hypot(b.x - a.x, b.y - a.y) + (self.width / 2 if b is not self.points[-1] else 0)
            straight = k.rectangle(0, long, -self.width / 2, self.width / 2)
            pieces.append(k.move(k.rotate(straight, math.degrees(math.atan2(b.y - a.y, b.x - a.x))), a.x, a.y))
        return _all(pieces)


class PCB:
    """A board with its lower left corner at (x0, y0), inches."""

    def __init__(self, x0, y0, width, height):
        self.x0, self.y0, self.width, self.height = x0, y0, width, height
        self.components, self.connections = [], []
        self._cutout = None

    def __iadd__(self, other):
        if isinstance(other, Component):
            self.components.append(other)
        elif isinstance(other, Connection):
            self.connections.append(other)
        else:
            raise TypeError(f"boards take components and connections, not {type(other).__name__}")
        return self

    def _connect(self, points, width, corner):
        """Returns a trace; `corner` computes the point between two pins."""
        points = [_placed(each) for each in points]
        through = []
        for a, b in zip(points[:-1], points[1:]):
            through.append(a)
            between = Point(*corner(a, b))
            if (between.x, between.y) != (a.x, a.y):
                through.append(between)
        if (between.x, between.y) != (b.x, b.y):
            through.append(b)
        self.connections.append(Connection(width, *through))

    def connectH(self, *points, width=WIDTH):
        """Connects pins or points, first along x, then along y."""
        self._connect(points, width, lambda a, b: (b.x, a.y))

    def connectV(self, *points, width=WIDTH):
        """Connects pins or points, first along y, then along x."""
        self._connect(points, width, lambda a, b: (a.x, b.y))

    @property
    def cutout(self):
        """The outline of the board."""
        if self._cutout is not None:
            return self._cutout
        return k.rectangle(self.x0, self.x0 + self.width, self.y0, self.y0 + self.height)

    def _on_board(self, shapes):
        shape = _all(shapes)
        if shape is not None:
            shape.bounds = self.cutout.bounds
        return shape

    @property
    def traces(self):
        return self._on_board([each.pads for each in self.components] + [each.traces for each in self.connections])

    @property
    def part_labels(self):
        return self._on_board(each.label for each in self.components)

    @property
    def pin_labels(self):
        return self._on_board(each.pin_labels for each in self.components)

    @property
    def layout(self):
        """Labels of parts and pins, and traces, each in its colour."""
        layers = ((self.part_labels, (125, 200, 60)), (self.pin_labels, (255, 90, 60)), (self.traces, (125, 90, 60)))
        return [k.color(shape, rgb) for shape, rgb in layers if shape is not None]


# Parts: half the sides of their pads, and the positions of their pins


def _pad(dx, dy):
    return k.rectangle(-dx, dx, -dy, dy)


def _pins(pad, *places):
    return [Pin(x, y, pad, *name) for x, y, *name in places]


def _row(pad, x, y, dx, dy, names):
    """Returns pins from (x, y) on, in steps of (dx, dy)."""
    return [Pin(x + i * dx, y + i * dy, pad, name) for i, name in enumerate(names.split())]


def _part(name, text, prefix, pins):
    return type(name, (Component,), {"__doc__": text, "__module__": __name__, "prefix": prefix, "pins": pins})


_1206 = _pad(0.032, 0.034)
_header = _pad(0.06, 0.025)
_sot23 = _pad(0.02, 0.012)
_soic = _pad(0.041, 0.015)
_usb, _usb_foot = _pad(0.0075, 0.04), _pad(0.049, 0.043)
_tqfp_h, _tqfp_v = _pad(0.025, 0.008), _pad(0.008, 0.025)

R_1206 = _part("R_1206", "1206 resistor.", "R", _pins(_1206, (-0.06, 0), (0.06, 0)))
C_1206 = _part("C_1206", "1206 capacitor.", "C", _pins(_1206, (-0.06, 0), (0.06, 0)))
SJ = _part("SJ", "Solder jumper.", "SJ", _pins(_pad(0.02, 0.03), (-0.029, 0), (0.029, 0)))
D_SOD_123 = _part("D_SOD_123", "Diode.", "D", _pins(_pad(0.02, 0.024), (-0.07, 0, "A"), (0.07, 0, "C")))
USB_mini_B = _part("USB_mini_B", "USB mini B connector, Hirose UX60-MB-5ST.", "J", _pins(
    _usb, (0.063, 0.24, "G"), (0.0315, 0.24), (0, 0.24, "+"), (-0.0315, 0.24, "-"), (-0.063, 0.24, "V")) + _pins(
    _usb_foot, (0.165, 0.21), (-0.165, 0.21), (0.165, 0), (-0.165, 0)))
Header_4 = _part("Header_4", "Header of 2 x 2 pins.", "J", _pins(
    _header, (-0.107, 0.05), (-0.107, -0.05), (0.107, -0.05), (0.107, 0.05)))
Header_ISP = _part("Header_ISP", "Header for in-system programming.", "J", _row(
    _header, -0.107, 0.1, 0, -0.1, "GND MOSI V") + _row(_header, 0.107, -0.1, 0, 0.1, "MISO SCK RST"))
Header_FTDI = _part("Header_FTDI", "Header of an FTDI cable.", "J", _row(
    _header, 0, 0.25, 0, -0.1, "GND CTS VCC TX RX RTS"))
NMOS_SOT23 = _part("NMOS_SOT23", "NMOS transistor in a SOT-23 case.", "Q", _pins(
    _sot23, (0.045, -0.0375, "G"), (0.045, 0.0375, "S"), (-0.045, 0, "D")))
PMOS_SOT23 = _part("PMOS_SOT23", "PMOS transistor in a SOT-23 case.", "Q", _pins(
    _sot23, (-0.045, -0.0375, "G"), (-0.045, 0.0375, "S"), (0.045, 0, "D")))
Regulator_SOT23 = _part("Regulator_SOT23", "Voltage regulator in a SOT-23 case.", "U", _pins(
    _sot23, (-0.045, -0.0375, "Out"), (-0.045, 0.0375, "In"), (0.045, 0, "GND")))
XTAL_NX5032GA = _part("XTAL_NX5032GA", "Clock crystal.", "X", _pins(_pad(0.039, 0.047), (-0.079, 0), (0.079, 0)))
ATtiny45_SOIC = _part("ATtiny45_SOIC", "Microcontroller.", "U", _row(
    _soic, -0.14, 0.075, 0, -0.05, "RST PB3 PB4 GND") + _row(
    _soic, 0.14, -0.075, 0, 0.05, "PB0 PB1 PB2 VCC"))
ATtiny44_SOIC = _part("ATtiny44_SOIC", "Microcontroller; the pad of pin 1 is round.", "U", _row(
    _soic + k.circle(-0.041, 0, 0.015), -0.12, 0.15, 0, -0.05, "VCC") + _row(
    _soic, -0.12, 0.1, 0, -0.05, "PB0 PB1 PB3 PB2 PA7 PA6") + _row(
    _soic, 0.12, -0.15, 0, 0.05, "PA5 PA4 PA3 PA2 PA1 PA0 GND"))
ATmega88_TQFP = _part("ATmega88_TQFP", "Microcontroller.", "U", _row(
    _tqfp_h, -0.18, 0.1085, 0, -0.031, "PD3 PD4 GND VCC GND VCC PB6 PB7") + _row(
    _tqfp_v, -0.1085, -0.18, 0.031, 0, "PD5 PD6 PD7 PB0 PB1 PB2 PB3 PB4") + _row(
    _tqfp_h, 0.18, -0.1085, 0, 0.031, "PB5 AVCC ADC6 AREF GND ADC7 PC0 PC1") + _row(
    _tqfp_v, 0.1085, 0.18, -0.031, 0, "PC2 PC3 PC4 PC5 PC6 PD0 PD1 PD2"))
CBA = _part("CBA", "The logo of the Center for Bits and Atoms.", "", [
    Pin(0.06 * (i - 1), 0.06 * (j - 1), k.circle(0, 0, 0.02) if i == 2 - j and j >= 1 else _pad(0.02, 0.02))
    for i in range(3) for j in range(3)])
