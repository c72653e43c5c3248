#!/usr/bin/python3
"""Writes a five-axis program of any length, its set-up and the part that it makes: a ball with twelve leaning slots.

    slotted_ball.py FOLDER [MOVES]

The ball (radius 24 mm) is cut from a block by spirals that come in from outside, ever along its normal and past its
equator, so that the part has overhangs; then a smaller cutter goes along each slot, leaning all the time. Both axes of
the trunnion table turn in nearly every move. The part is known in closed form: all that a cutter of radius R touches is
R away from where its middle went.

Then: fieldfab simulate FOLDER/slotted_ball.ngc --setup FOLDER/slotted_ball.toml -o part.stl
"""

import math
import pathlib
import sys

BALL, REACH = 24.0, math.radians(118)  # mm; how far from the pole the spirals go
BIG, SMALL = 3.0, 1.5  # radii of the cutters, mm
SLOTS, SLOT_RADIUS, LEAN = 12, 14.0, math.radians(35)  # the slots' bottoms are lines at this distance from the middle
# The distance of the cutter's middle, and that between turns.
SPIRALS = [(48 - 3 * i, 3.0) for i in range(7)] + [(BALL + BIG, 0.45)]
DEPTHS = [10.0 - i for i in range(11)]  # of the slots' passes, above their bottoms


def spirals(step):
    """Places of the big cutter's middle, and its axis: down one spiral, up the next."""
    for number, (radius, pitch) in enumerate(SPIRALS):
        angles, angle = [], 0.0
        while angle < REACH:  # even steps along the spiral
            angles.append(angle)
            a_turn = pitch / (2 * math.pi * radius)  # what it goes on in a radian
            angle += min(step / math.hypot(radius, radius * math.sin(angle) / a_turn), 0.4 * a_turn)
        for angle in angles if number % 2 == 0 else reversed(angles):
            turn = 2 * math.pi * radius * angle / pitch
            axis = (math.sin(angle) * math.cos(turn), math.sin(angle) * math.sin(turn), math.cos(angle))
            yield tuple(radius * a for a in axis), axis


def slot_frame(number):
    """A point of a slot's bottom line, outwards, and along the line."""
    angle = 2 * math.pi * number / SLOTS
    out = (math.cos(angle), math.sin(angle), 0.0)
    along = (-math.sin(angle) * math.sin(LEAN), math.cos(angle) * math.sin(LEAN), math.cos(LEAN))
    return tuple(SLOT_RADIUS * o for o in out), out, along


def slot_passes(number, step):
    """Passes of the small cutter along a slot; its axis leans to and fro in the slot's plane."""
    bottom, out, along = slot_frame(number)
    for i, depth in enumerate(DEPTHS):
        count = int(38 / step)
        places = [-16 + 38 * k / count for k in range(count + 1)]
        for s in places if i % 2 == 0 else reversed(places):
            lean = 0.3 + 0.25 * math.sin(s / 5)
            axis = tuple(math.cos(lean) * o + math.sin(lean) * a for o, a in zip(out, along))
            yield tuple(b + s * a + depth * o for b, a, o in zip(bottom, along, out)), axis


class Writer:
    """Axis values of a trunnion table: A tilts about x and carries C; x, y and z follow the turned part."""

    def __init__(self):
        self.lines, self.turn, self.moves = ["%", "(a ball with leaning slots)", "G17 G21 G40 G54 G80 G90 G94"], 0.0, 0

    def tool(self, number):
        self.lines += [f"T{number} M6", f"G43 H{number}", "S12000 M3"]

    def to(self, tip, axis, rapid=False):
        tilt = math.atan2(math.hypot(axis[0], axis[1]), axis[2])
        turn = math.pi / 2 - math.atan2(axis[1], axis[0]) if tilt > 1e-9 else self.turn
        self.turn = turn = turn + 2 * math.pi * round((self.turn - turn) / (2 * math.pi))
        x, y = (math.cos(turn) * tip[0] - math.sin(turn) * tip[1], math.sin(turn) * tip[0] + math.cos(turn) * tip[1])
        y, z = (math.cos(tilt) * y - math.sin(tilt) * tip[2], math.sin(tilt) * y + math.cos(tilt) * tip[2])
        feed = "" if rapid or self.lines[-1].startswith("G1") else " F1500"
        self.lines.append(f"{'G0' if rapid else 'G1'} X{x:.4f} Y{y:.4f} Z{z:.4f} A{math.degrees(tilt):.4f} "
                          f"C{math.degrees(turn):.4f}{feed}")
        self.moves += 1

    def along(self, places, radius):
        """Down from far out to the first place, along all of them, and out again."""
        places = [(tuple(p - radius * a for p, a in zip(place, axis)), axis) for place, axis in places]
        far = lambda tip, axis: tuple(t + 40 * a for t, a in zip(tip, axis))
        self.to(far(*places[0]), places[0][1], rapid=True)
        for tip, axis in places:
            self.to(tip, axis)
        self.to(far(*places[-1]), places[-1][1], rapid=True)


def program(moves):
    # How long all ways are, to know how long a step is.
    spiral = sum(2 * math.pi * radius * radius * (1 - math.cos(REACH)) / pitch for radius, pitch in SPIRALS)
    step = (spiral + SLOTS * len(DEPTHS) * 38) / moves
    writer = Writer()
    writer.tool(1)
    writer.along(list(spirals(step)), BIG)
    writer.tool(2)
    for number in range(SLOTS):
        writer.along(list(slot_passes(number, step)), SMALL)
    return writer.lines + ["M2", "%"], writer.moves


def part():
    """max(ball, -slots), each slot all that is within SMALL of a half-plane."""
    slots = []
    for number in range(SLOTS):
        _, out, along = slot_frame(number)
        across = (out[1] * along[2] - out[2] * along[1], out[2] * along[0] - out[0] * along[2],
                  out[0] * along[1] - out[1] * along[0])
        outwards = f"{out[0]:.9f} * x + {out[1]:.9f} * y - {SLOT_RADIUS}"
        aside = f"{across[0]:.9f} * x + {across[1]:.9f} * y + {across[2]:.9f} * z"
        slots.append(f"sqrt(square(min({outwards}, 0)) + square({aside})) - {SMALL}")
    while len(slots) > 1:
        slots = [f"min({a}, {b})" for a, b in zip(slots[::2], slots[1::2])] + slots[len(slots) & ~1:]
    return f"max(sqrt(square(x) + square(y) + square(z)) - {BALL}, -({slots[0]}))\n"


SETUP = f"""name = "slotted_ball"
machine = "five_axis_ac"
cell = 0.1
[stock]
lower = [-30, -30, -20]
upper = [30, 30, 30]
[target]
model = "slotted_ball.frep"
gouge = 0.05
excess = 0.05
floor = -10
[[tool]]
number = 1
shape = "ball"
diameter = {2 * BIG}
flute = 36
length = 60
holder_diameter = 30
holder_length = 40
[[tool]]
number = 2
shape = "ball"
diameter = {2 * SMALL}
flute = 16
length = 50
shank = {2 * SMALL}
holder_diameter = 24
holder_length = 40
"""


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    lines, moves = program(int(sys.argv[2]) if len(sys.argv) == 3 else 100_000)
    (folder / "slotted_ball.ngc").write_text("\n".join(lines) + "\n")
    (folder / "slotted_ball.toml").write_text(SETUP)
    (folder / "slotted_ball.frep").write_text(part())
    print(f"{folder / 'slotted_ball.ngc'}: {moves} moves")


if __name__ == "__main__":
    main()
