"""A program's motions as Fieldfab's reader gives them and as LinuxCNC's rs274 does, in the same terms: tip in machine coordinates, mm and degrees."""

import math
import os
import re
import subprocess
import tempfile
from dataclasses import dataclass

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
    """(moves, error or "", notes) of our reader; an AssertionError where it neither ends well nor says what is wrong."""
    with tempfile.NamedTemporaryFile("w") as table:
        table.write("".join(f"{n} {length} {diameter}\n" for n, length, diameter in tools))
        table.flush()
        done = subprocess.run([READER, str(program), table.name], capture_output=True, text=True, errors="replace", timeout=300)
    assert done.returncode in (0, 2), f"{program}: {done.returncode} {done.stderr}"
    moves = []
    for line in done.stdout.splitlines():
        kind, number, plane, _, *n = line.split()
        n = [float(x) for x in n]
        moves.append(Move(kind, tuple(n[:6]), (n[9], n[10]), int(n[11]), int(plane), n[12], n[13], int(n[14]), n[15], 1.0, tuple(n[16:19]), "line " + number))
    notes = [x for x in done.stderr.splitlines() if x.startswith("note ")]
    error = "\n".join(x for x in done.stderr.splitlines() if not x.startswith("note "))
    if done.returncode == 2:
        assert re.search(r":\d+: ", error), f"{program}: an error without its line: {error}"
    return moves, error, notes


def rs274(program, tools=TOOLS):
    """(moves, error or "") of LinuxCNC's interpreter; its coordinates with work offsets, G92 and rotation applied."""
    with tempfile.TemporaryDirectory() as folder:
        table, variables, out = folder + "/tool.tbl", folder + "/v.var", folder + "/out.txt"
        with open(table, "w") as f:
            for number, length, diameter in tools:
                f.write(f"T{number} P{number} Z{length / 25.4:.10f} D{diameter / 25.4:.10f}\n")
        open(variables, "w").close()
        done = subprocess.run(["rs274", "-g", "-n", "2", "-t", table, "-v", variables, str(program), out], capture_output=True, text=True, errors="replace",
                              timeout=TIMEOUT, cwd=os.path.dirname(os.path.abspath(str(program))), env={**os.environ, "HOME": folder})  # it keeps a file there
        with open(out, errors="replace") as f:
            moves = canonical_moves(f)
    return moves, "" if done.returncode == 0 else (done.stderr + done.stdout).replace("executing", "").strip() or f"exit {done.returncode}"


def turned(x, y, angle):
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    return c * x - s * y, s * x + c * y


def canonical_moves(lines):
    moves = []
    unit, plane, feed, feed_degrees, per_turn, synchronous = 1.0, 0, 0.0, 0.0, False, None
    origin, axis_offset, angle, tool_offset = [0.0] * 6, [0.0] * 6, 0.0, (0.0, 0.0, 0.0)
    speed, direction, tool, selected = 0.0, 0, 0, 0
    last = (0.0,) * 6
    length = lambda values: [v * (unit if k < 3 else 1) for k, v in enumerate(values)]

    def tip(values):
        p = [a + b for a, b in zip(values, axis_offset)]
        p[0], p[1] = turned(p[0], p[1], angle)
        return tuple(a + b for a, b in zip(p, origin))

    axes = lambda values: tuple(t + o for t, o in zip(tip(values), (*tool_offset, 0, 0, 0)))
    at = axes(last)

    for line in lines:
        found = re.match(r"\s*\d+\s+N\S*\s+(\w+)\((.*)\)\s*$", line)
        if not found or found[1] in ("COMMENT", "MESSAGE"):
            continue
        name, n = found[1], [float(x) for x in re.findall(r"-?\d+\.?\d*", found[2])]
        common = dict(plane=plane, tool=tool, spindle=speed * direction, unit=unit, line=line.strip(), offset=tool_offset)
        if name in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "STRAIGHT_PROBE"):
            program = length(n[:6])
            rapid = name == "STRAIGHT_TRAVERSE"
            rate = feed
            if not rapid:
                if synchronous is not None:
                    rate = synchronous * unit * speed
                elif all(abs(a - b) < 1e-4 * unit for a, b in zip(axes(program)[:3], at[:3])) and program[3:] != list(at[3:]):
                    rate = feed_degrees * math.pi / 180
                if per_turn and synchronous is None:
                    rate *= speed
            moves.append(Move("rapid" if rapid else "feed", tip(program), feed=0 if rapid else rate, **common))
            last, at = tuple(program), axes(program)
        elif name == "RIGID_TAP":
            for where, sign in ((length(n[:3]) + list(last[3:]), 1), (list(last), -1)):
                moves.append(Move("feed", tip(where), feed=synchronous * unit * speed, **common))
                moves[-1].spindle *= sign
        elif name == "ARC_FEED":  # end1, end2, centre1, centre2, turns, axis end, A, B, C
            first, second, third = ((0, 1, 2), (2, 0, 1), (1, 2, 0))[plane]
            program, centre = [0.0] * 3 + n[6:9], [0.0] * 6
            program[first], program[second], program[third] = n[0] * unit, n[1] * unit, n[5] * unit
            centre[first], centre[second], centre[third] = n[2] * unit, n[3] * unit, n[5] * unit
            at = tip(centre)
            moves.append(Move("arc", tip(program), centre=(at[first], at[second]), turns=int(n[4]), feed=feed * (speed if per_turn else 1), **common))
            last, at = tuple(program), axes(program)
        elif name == "NURBS_FEED":
            moves.append(Move("spline", **common))
        elif name == "USE_LENGTH_UNITS":
            unit = 25.4 if "INCHES" in found[2] else 1.0
        elif name == "SELECT_PLANE":
            plane = {"CANON_PLANE_XY": 0, "CANON_PLANE_XZ": 1, "CANON_PLANE_YZ": 2}[found[2]]
        elif name == "SET_G5X_OFFSET":
            origin = length(n[1:7])
        elif name == "SET_G92_OFFSET":
            axis_offset = length(n[:6])
        elif name == "SET_XY_ROTATION":
            angle = n[0]
        elif name == "USE_TOOL_LENGTH_OFFSET":
            tool_offset = tuple(length(n[:3]))
        elif name == "SET_FEED_RATE":
            feed, feed_degrees = n[0] * unit, n[0]
        elif name == "SET_FEED_MODE":
            per_turn = n[1] == 1
        elif name == "START_SPEED_FEED_SYNC":
            synchronous = n[0]
        elif name == "STOP_SPEED_FEED_SYNCH":
            synchronous = None
        elif name == "SET_SPINDLE_SPEED":
            speed = n[1]
        elif name == "START_SPINDLE_CLOCKWISE":
            direction = 1
        elif name == "START_SPINDLE_COUNTERCLOCKWISE":
            direction = -1
        elif name in ("STOP_SPINDLE_TURNING", "ORIENT_SPINDLE"):
            direction = 0
        elif name in ("CHANGE_TOOL", "CHANGE_TOOL_NUMBER"):
            tool = int(n[0])
            common["tool"] = tool
            moves.append(Move("tool_change", tip(last), **common))
        elif name == "DWELL":
            moves.append(Move("dwell", tip(last), seconds=n[0], **common))
        elif name in ("PROGRAM_STOP", "OPTIONAL_PROGRAM_STOP", "PALLET_SHUTTLE_STOP"):
            moves.append(Move("stop", tip(last), **common))
        elif name == "PROGRAM_END":
            moves.append(Move("end", tip(last), **common))
    return moves


def difference(a, b):
    """What is not the same in two moves, ours and rs274's; "" where nothing is."""
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
    """Whether a move goes nowhere, as far as four decimals tell."""
    axes = lambda m: tuple(e + o for e, o in zip(m.end, (*m.offset, 0, 0, 0)))
    return move.kind in ("rapid", "feed") and all(abs(a - b) < 2.5e-4 * max(move.unit, before.unit) for a, b in zip(axes(move), axes(before)))


def compare(mine, theirs):
    """"" where the moves are the same, else the first that is not. What takes no time or goes nowhere may be missing from either; a
    spline of rs274's is all of our feeds of that line."""
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
