"""Motions of a program from Fieldfab's reader and from LinuxCNC's rs274, in common terms: the tip in machine
coordinates, mm and degrees."""

import math
import os
import re
import subprocess
import tempfile
from dataclasses import dataclass

from programs import need

REPOSITORY = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
READER = os.path.join(REPOSITORY, "build/release/bin/gcode_moves")
TIMEOUT = 100  # seconds for rs274
TOOLS = ((1, 10.0, 6.0), (2, 25.4, 2.54), (3, 50.0, 12.0))  # number, length, diameter


@dataclass
class Move:
    kind: str
    end: tuple = (0.0,) * 6
    centre: tuple = (0.0, 0.0)
    turns: int = 0
    plane: int = 0
    feed: float = 0.0
    seconds: float = 0.0
    tool: int = 0
    spindle: float = 0.0
    unit: float = 1.0
    offset: tuple = (0.0, 0.0, 0.0)
    line: str = ""


def ours(program, tools=TOOLS):
    """Returns (moves, error or "", notes) of our reader. Raises AssertionError if it neither succeeds nor reports an
    error."""
    with tempfile.NamedTemporaryFile("w") as table:
        table.write("".join(f"{n} {length} {diameter}\n" for n, length, diameter in tools))
        table.flush()
        done = subprocess.run([READER, str(program), table.name], capture_output=True, text=True, errors="replace",
                              timeout=300)
    assert done.returncode in (0, 2), f"{program}: {done.returncode} {done.stderr}"
    moves = []
    for line in done.stdout.splitlines():
        kind, number, plane, _, *n = line.split()
        n = [float(x) for x in n]
        moves.append(Move(kind, tuple(n[:6]), (n[9], n[10]), int(n[11]), int(plane), n[12], n[13], int(n[14]), n[15],
                          1.0, tuple(n[16:19]), "line " + number))
    notes = [x for x in done.stderr.splitlines() if x.startswith("note ")]
    error = "\n".join(x for x in done.stderr.splitlines() if not x.startswith("note "))
    if done.returncode == 2:
        assert re.search(r":\d+: ", error), f"{program}: an error without its line: {error}"
    return moves, error, notes


def rs274(program, tools=TOOLS):
    """Returns (moves, error or "") of LinuxCNC's interpreter, with work offsets, G92 and rotation applied."""
    need("rs274")
    with tempfile.TemporaryDirectory() as folder:
        table, variables, out = folder + "/tool.tbl", folder + "/v.var", folder + "/out.txt"
        with open(table, "w") as f:
            for number, length, diameter in tools:
                f.write(f"T{number} P{number} Z{length / 25.4:.10f} D{diameter / 25.4:.10f}\n")
        open(variables, "w").close()
        done = subprocess.run(["rs274", "-g", "-n", "2", "-t", table, "-v", variables, str(program), out],
                              capture_output=True, text=True, errors="replace",
                              # It writes a parameter file there.
                              timeout=TIMEOUT, cwd=os.path.dirname(os.path.abspath(str(program))),
                              env={**os.environ, "HOME": folder})
        with open(out, errors="replace") as f:
            moves = canonical_moves(f)
    return (moves, "" if done.returncode == 0 else (done.stderr + done.stdout).replace("executing", "").strip()
            or f"exit {done.returncode}")


def turned(x, y, angle):
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    return c * x - s * y, s * x + c * y


class Canon:
    """Converts rs274's canonical calls to moves."""

    def __init__(self):
        self.moves = []
        self.unit, self.plane, self.feed, self.feed_degrees, self.per_turn, self.synchronous = (
            1.0, 0, 0.0, 0.0, False, None)
        self.origin, self.axis_offset, self.angle, self.tool_offset = [0.0] * 6, [0.0] * 6, 0.0, (0.0, 0.0, 0.0)
        self.speed, self.direction, self.tool = 0.0, 0, 0
        self.last = (0.0,) * 6  # in program coordinates
        self.at = self.axes(self.last)

    def length(self, values):
        return [v * (self.unit if k < 3 else 1) for k, v in enumerate(values)]

    def tip(self, values):
        p = [a + b for a, b in zip(values, self.axis_offset)]
        p[0], p[1] = turned(p[0], p[1], self.angle)
        return tuple(a + b for a, b in zip(p, self.origin))

    def axes(self, values):
        return tuple(t + o for t, o in zip(self.tip(values), (*self.tool_offset, 0, 0, 0)))

    def add(self, kind, *place, **more):
        self.moves.append(Move(kind, *place, plane=self.plane, tool=self.tool, spindle=self.speed * self.direction,
                               unit=self.unit, line=self.line,
                               offset=self.tool_offset, **more))

    def arrive(self, program):
        self.last, self.at = tuple(program), self.axes(program)

    def call(self, line, name, words):
        """Processes one call; `words` is the text in its parentheses."""
        self.line = line
        n = [float(x) for x in re.findall(r"-?\d+\.?\d*", words)]
        if name in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "STRAIGHT_PROBE"):
            self.straight(self.length(n[:6]), name == "STRAIGHT_TRAVERSE")
        elif name == "RIGID_TAP":
            for where, sign in ((self.length(n[:3]) + list(self.last[3:]), 1), (list(self.last), -1)):
                self.add("feed", self.tip(where), feed=self.synchronous * self.unit * self.speed)
                self.moves[-1].spindle *= sign
        elif name == "ARC_FEED":
            self.arc(n)
        elif name == "NURBS_FEED":
            self.add("spline")
        elif name in ("CHANGE_TOOL", "CHANGE_TOOL_NUMBER"):
            self.tool = int(n[0])
            self.add("tool_change", self.tip(self.last))
        elif name == "DWELL":
            self.add("dwell", self.tip(self.last), seconds=n[0])
        elif name in ("PROGRAM_STOP", "OPTIONAL_PROGRAM_STOP", "PALLET_SHUTTLE_STOP"):
            self.add("stop", self.tip(self.last))
        elif name == "PROGRAM_END":
            self.add("end", self.tip(self.last))
        else:
            self.set_mode(name, n, words)

    def straight(self, program, rapid):
        rate = self.feed
        if self.synchronous is not None:
            rate = self.synchronous * self.unit * self.speed
        elif (all(abs(a - b) < 1e-4 * self.unit for a, b in zip(self.axes(program)[:3], self.at[:3]))
              and program[3:] != list(self.at[3:])):
            rate = self.feed_degrees * math.pi / 180
        if self.per_turn and self.synchronous is None:
            rate *= self.speed
        self.add("rapid" if rapid else "feed", self.tip(program), feed=0 if rapid else rate)
        self.arrive(program)

    def arc(self, n):
        """`n`: end 1, end 2, centre 1, centre 2, turns, axis end, A, B, C."""
        first, second, third = ((0, 1, 2), (2, 0, 1), (1, 2, 0))[self.plane]
        program, centre = [0.0] * 3 + n[6:9], [0.0] * 6
        program[first], program[second], program[third] = n[0] * self.unit, n[1] * self.unit, n[5] * self.unit
        centre[first], centre[second], centre[third] = n[2] * self.unit, n[3] * self.unit, n[5] * self.unit
        middle = self.tip(centre)
        self.add("arc", self.tip(program), centre=(middle[first], middle[second]), turns=int(n[4]),
                 feed=self.feed * (self.speed if self.per_turn else 1))
        self.arrive(program)

    def set_mode(self, name, n, words):
        if name == "USE_LENGTH_UNITS":
            self.unit = 25.4 if "INCHES" in words else 1.0
        elif name == "SELECT_PLANE":
            self.plane = {"CANON_PLANE_XY": 0, "CANON_PLANE_XZ": 1, "CANON_PLANE_YZ": 2}[words]
        elif name == "SET_G5X_OFFSET":
            self.origin = self.length(n[1:7])
        elif name == "SET_G92_OFFSET":
            self.axis_offset = self.length(n[:6])
        elif name == "SET_XY_ROTATION":
            self.angle = n[0]
        elif name == "USE_TOOL_LENGTH_OFFSET":
            self.tool_offset = tuple(self.length(n[:3]))
        elif name == "SET_FEED_RATE":
            self.feed, self.feed_degrees = n[0] * self.unit, n[0]
        elif name == "SET_FEED_MODE":
            self.per_turn = n[1] == 1
        elif name == "START_SPEED_FEED_SYNC":
            self.synchronous = n[0]
        elif name == "STOP_SPEED_FEED_SYNCH":
            self.synchronous = None
        elif name == "SET_SPINDLE_SPEED":
            self.speed = n[1]
        elif name == "START_SPINDLE_CLOCKWISE":
            self.direction = 1
        elif name == "START_SPINDLE_COUNTERCLOCKWISE":
            self.direction = -1
        elif name in ("STOP_SPINDLE_TURNING", "ORIENT_SPINDLE"):
            self.direction = 0


def canonical_moves(lines):
    canon = Canon()
    for line in lines:
        found = re.match(r"\s*\d+\s+N\S*\s+(\w+)\((.*)\)\s*$", line)
        if found and found[1] not in ("COMMENT", "MESSAGE"):
            canon.call(line.strip(), found[1], found[2])
    return canon.moves


def difference(a, b):
    """Returns a description of the difference between our move and rs274's; "" if they are equal."""
    if a.kind != b.kind:
        return "kind"
    within = 2e-4 * b.unit + 3e-6 * max(map(abs, b.end))
    if a.kind in ("rapid", "feed", "arc"):
        if any(abs(x - y) > within for x, y in zip(a.end, b.end)):
            return "end"
        if a.kind != "rapid" and abs(a.feed - b.feed) > 2e-4 * b.unit + 1e-5 * abs(b.feed):
            return "feed"
        if abs(a.spindle - b.spindle) > 1e-3:
            return "spindle"
        if any(abs(x - y) > within for x, y in zip(a.offset, b.offset)):
            return "tool offset"
    if a.kind == "arc":
        far = max(abs(x) for x in b.centre) * 1e-5
        if a.turns != b.turns or a.plane != b.plane:
            return "turns"
        if any(abs(x - y) > within + far for x, y in zip(a.centre, b.centre)):
            return "centre"
    if a.tool != b.tool:
        return "tool"
    if a.kind == "dwell" and abs(a.seconds - b.seconds) > 1e-4:
        return "seconds"
    return ""


def still(move, before):
    """Whether a move has length 0 to four decimals."""
    axes = lambda m: tuple(e + o for e, o in zip(m.end, (*m.offset, 0, 0, 0)))
    return (move.kind in ("rapid", "feed")
            and all(abs(a - b) < 2.5e-4 * max(move.unit, before.unit) for a, b in zip(axes(move), axes(before))))


def compare(mine, theirs):
    """Returns "" if the moves are equal, else the first difference. Moves of length 0 may be absent from either list; a
    spline of rs274 corresponds to all of our feeds of that line."""
    real = lambda m: m.kind != "end" and not (m.kind == "dwell" and m.seconds == 0)
    mine, theirs = [m for m in mine if real(m)], [m for m in theirs if real(m)]
    last_mine = last_theirs = Move("rapid")
    i = k = 0
    while i < len(mine) or k < len(theirs):
        a, b = mine[i] if i < len(mine) else None, theirs[k] if k < len(theirs) else None
        if a and b:
            a.unit = b.unit
            if b.kind == "spline":
                while i < len(mine) and mine[i].line == a.line:
                    i += 1
                last_mine = last_theirs = mine[i - 1]
                k += 1
                continue
        what = difference(a, b) if a and b else "missing"
        if not what:
            last_mine, last_theirs = a, b
            i, k = i + 1, k + 1
        elif a and still(a, last_mine):
            i += 1
        elif b and still(b, last_theirs):
            k += 1
        else:
            return f"move {k}: {what}\n  ours:  {a}\n  rs274: {b}"
    return ""
