#!/usr/bin/python3
"""Writes a five-axis program of any length, its set-up and its target: a ball with twelve inclined slots.

    slotted_ball.py FOLDER [MOVES]

A ball of radius 24 mm is cut from a block. Spirals approach it along its normal, and continue below the equator, so
that the part has overhangs. A smaller cutter then cuts each slot with an inclined axis. Both axes of the trunnion table
turn in nearly every move. The target has a closed form: a ball-nose cutter of radius R leaves a surface at distance R
from the path of its centre.

Then: fieldfab simulate FOLDER/slotted_ball.ngc --setup FOLDER/slotted_ball.toml -o part.stl
"""

import math
import pathlib
import sys

BALL, REACH = 24.0, math.radians(118)  # radius, mm; angle from the pole to the spirals' ends
BIG, SMALL = 3.0, 1.5  # radii of the cutters, mm
SLOTS, SLOT_RADIUS, LEAN = 12, 14.0, math.radians(35)  # SLOT_RADIUS: from the centre to a slot's bottom, mm
# Radius of the spiral of the cutter's centre, and distance between turns, mm.
SPIRALS = [(48 - 3 * i, 3.0) for i in range(7)] + [(BALL + BIG, 0.45)]
DEPTHS = [10.0 - i for i in range(11)]  # of the passes above the slot's bottom, mm


def spirals(step):
    """Yields positions of the large cutter's centre with its axis; spirals alternate between down and up."""
    for number, (radius, pitch) in enumerate(SPIRALS):
        angles, angle = [], 0.0
        while angle < REACH:  # even steps along the spiral
            angles.append(angle)
            a_turn = pitch / (2 * math.pi * radius)  # change of the polar angle per radian of turn
            angle += min(step / math.hypot(radius, radius * math.sin(angle) / a_turn), 0.4 * a_turn)
        for angle in angles if number % 2 == 0 else reversed(angles):
            turn = 2 * math.pi * radius * angle / pitch
            axis = (math.sin(angle) * math.cos(turn), math.sin(angle) * math.sin(turn), math.cos(angle))
            yield tuple(radius * a for a in axis), axis


def slot_frame(number):
    """Returns a point of a slot's bottom line, the outward direction, and the direction of the line."""
    angle = 2 * math.pi * number / SLOTS
    out = (math.cos(angle), math.sin(angle), 0.0)
    along = (-math.sin(angle) * math.sin(LEAN), math.cos(angle) * math.sin(LEAN), math.cos(LEAN))
    return tuple(SLOT_RADIUS * o for o in out), out, along


def slot_passes(number, step):
    """Yields passes of the small cutter along a slot; its axis swings in the slot's plane."""
    bottom, out, along = slot_frame(number)
    for i, depth in enumerate(DEPTHS):
        count = int(38 / step)
        places = [-16 + 38 * k / count for k in range(count + 1)]
        for s in places if i % 2 == 0 else reversed(places):
            lean = 0.3 + 0.25 * math.sin(s / 5)
            axis = tuple(math.cos(lean) * o + math.sin(lean) * a for o, a in zip(out, along))
            yield tuple(b + s * a + depth * o for b, a, o in zip(bottom, along, out)), axis


class Writer:
    """Writes a program for a trunnion table: A tilts about x and carries C; x, y and z are machine coordinates."""

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
        """Approaches the first position from outside, follows all positions, and retracts."""
        places = [(tuple(p - radius * a for p, a in zip(place, axis)), axis) for place, axis in places]
        far = lambda tip, axis: tuple(t + 40 * a for t, a in zip(tip, axis))
        self.to(far(*places[0]), places[0][1], rapid=True)
        for tip, axis in places:
            self.to(tip, axis)
        self.to(far(*places[-1]), places[-1][1], rapid=True)


def program(moves):
    # The step follows from the total length of all paths.
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
    """Returns the target's formula, max(ball, -slots). A slot is the set of points within SMALL of a half-plane."""
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
