"""A small library for circuit boards: parts with named pads, traces, and shapes for a mill or a laser cutter.

    import fieldfab as ff
    from fieldfab import pcb
    board = pcb.Board(30, 20)
    chip = board.add(pcb.soic("ATtiny45", 8), 8, 10)
    led = board.add(pcb.chip_1206("LED"), 22, 10, angle=90)
    board.connect(chip["1"], (15, 12), led["2"])
    ff.render(board.copper, mode="bitmap", size=2000, bounds=board.bounds).save("traces.png")

Lengths are mm, angles degrees. Copper, outline and holes are flat shapes.
"""

import math

from . import shapes as s


class Part:
    """A footprint: flat shapes `copper` and `holes` about the origin (None if absent), and `pads`, a map from names
    to (x, y), mm.
    """

    def __init__(self, name, copper, pads, holes=None):
        self.name, self.copper, self.pads, self.holes = name, copper, dict(pads), holes


def _two_pads(name, dx, dy, span):
    return Part(name, s.footprint_chip(dx, dy, span), {"1": (-span / 2, 0.0), "2": (span / 2, 0.0)})


def chip_1206(name="1206"):
    """A resistor, capacitor or LED of size 1206."""
    return _two_pads(name, 1.6, 1.8, 3.4)


def chip_0805(name="0805"):
    """A resistor, capacitor or LED of size 0805."""
    return _two_pads(name, 1.3, 1.5, 2.1)


def soic(name="SOIC", pins=8, pitch=1.27, span=5.4, pad=(1.6, 0.6)):
    """A small-outline package; pins are numbered counter-clockwise from the upper left."""
    rows = pins // 2
    copper = s.footprint_soic(pins, pitch, span, *pad)
    top = pitch * (rows - 1) / 2
    pads = {str(i + 1): (-span / 2, top - i * pitch) for i in range(rows)}
    pads.update({str(rows + i + 1): (span / 2, -top + i * pitch) for i in range(rows)})
    return Part(name, copper, pads)


def header(name="header", columns=2, rows=3, pitch=2.54, pad=1.7, hole=1.0):
    """A pin header; pins are numbered row by row from the upper left."""
    left, top = -pitch * (columns - 1) / 2, pitch * (rows - 1) / 2
    pads = {str(r * columns + c + 1): (left + c * pitch, top - r * pitch) for r in range(rows) for c in range(columns)}
    return Part(name, s.footprint_header(columns, rows, pitch, pad), pads,
                s.footprint_header(columns, rows, pitch, hole))


def placed_point(point, x, y, angle):
    """Returns a point of a part placed at (x, y) and rotated by an angle in radians."""
    cos, sin = math.cos(angle), math.sin(angle)
    return (x + cos * point[0] - sin * point[1], y + sin * point[0] + cos * point[1])


class Placed:
    """A part on a board; part["1"] is the position of its pad 1."""

    def __init__(self, part, x, y, angle):
        self.part, self.x, self.y, self.angle = part, x, y, math.radians(angle)

    def __getitem__(self, pad):
        if pad not in self.part.pads:
            raise KeyError(f"{self.part.name} has no pad '{pad}'; it has {', '.join(self.part.pads)}")
        return placed_point(self.part.pads[pad], self.x, self.y, self.angle)

    def placed(self, shape):
        return s.move(s.rotate_z(shape, self.angle), self.x, self.y)


class Board:
    """A board of width x height mm with its lower left corner at the origin."""

    def __init__(self, width, height, corner=0.0, trace=0.4):
        self.width, self.height, self.corner, self.trace_width = width, height, corner, trace
        self.parts, self._traces = [], []

    def add(self, part, x, y, angle=0):
        placed = Placed(part, x, y, angle)
        self.parts.append(placed)
        return placed

    def connect(self, *points, width=None):
        """Adds a trace through points: pads of placed parts, or (x, y)."""
        self._traces.append(s.trace(self.trace_width if width is None else width, *points))

    @property
    def copper(self):
        """Pads and traces without the holes."""
        shapes = self._traces + [p.placed(p.part.copper) for p in self.parts]
        if not shapes:
            raise ValueError("the board has neither parts nor traces")
        copper = s.union(*shapes) if len(shapes) > 1 else shapes[0]
        return copper if self.holes is None else s.difference(copper, self.holes)

    @property
    def holes(self):
        """The drilled holes, or None."""
        shapes = [p.placed(p.part.holes) for p in self.parts if p.part.holes is not None]
        return None if not shapes else s.union(*shapes) if len(shapes) > 1 else shapes[0]

    @property
    def outline(self):
        """The outline of the board."""
        return s.move(s.rounded_rectangle(self.width, self.height, self.corner), self.width / 2, self.height / 2)

    @property
    def bounds(self):
        return (0, 0, 0, self.width, self.height, 0)
