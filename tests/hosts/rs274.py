"""LinuxCNC's interpreter as an oracle: the canonical moves of a program, in mm (notes: ../shared/data/SOURCES.txt)."""

import os
import re
import subprocess
import tempfile

import numpy as np
from programs import need


def canonical(program, tools=((1, 0.0, 0.1),), above=0.0):
    """Returns rs274's canonical calls (name, [numbers]) for a G-code file. The machine's zero is `above` mm over the
    program's. Raises AssertionError with its message if it refuses the file."""
    need("rs274")
    with tempfile.TemporaryDirectory() as folder:
        table, variables, out = folder + "/tool.tbl", folder + "/v.var", folder + "/out.txt"
        with open(table, "w") as f:
            for number, length, diameter in tools:
                f.write(f"T{number} P{number} Z{length / 25.4:.8f} D{diameter / 25.4:.8f}\n")
        with open(variables, "w") as f:
            f.write(f"5223\t{-above / 25.4:.8f}\n")
        # Interpreters of one home share their tool table in memory, and end each other by SIGBUS.
        done = subprocess.run(["rs274", "-g", "-n", "2", "-t", table, "-v", variables, str(program), out],
                              capture_output=True, text=True, timeout=300, env={**os.environ, "HOME": folder})
        assert done.returncode == 0, f"exit {done.returncode}: {done.stderr}{done.stdout}"
        calls = []
        for line in open(out):
            found = re.match(r"\s*\d+\s+N\S*\s+(\w+)\((.*)\)\s*$", line)
            if found and found[1] != "COMMENT":
                numbers = [float(x) for x in re.findall(r"-?\d+\.?\d*", found[2])]
                calls.append((found[1], numbers))
        return calls


def moves(program, **keywords):
    """Returns an (n, 6) array of x, y, z, A, B, C after each move, the kinds of moves, and centres (NaN for lines)."""
    at, kinds, centres = [], [], []
    for name, n in canonical(program, **keywords):
        if name in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED"):
            at.append(n[:6])
            centres.append((np.nan, np.nan, 0))
        elif name == "ARC_FEED":  # end1, end2, centre1, centre2, turns, axis end, A, B, C
            at.append([n[0], n[1], n[5], *n[6:9]])
            centres.append((n[2], n[3], n[4]))
        else:
            continue
        kinds.append(name)
    return np.array(at), kinds, np.array(centres)


def moves_of_program(program, **keywords):
    """Returns moves() of a program of `fieldfab cam`, without those at the machine's zero: after each tool change the
    tool goes up to it and over. Raises AssertionError if there are none, and if they are not rapids."""
    above = 1000.0
    at, kinds, centres = moves(program, above=above, **keywords)
    up = at[:, 2] > above / 2  # the tip is lower than the axis, by the tool's length
    assert up[:2].all() and all(kinds[i] == "STRAIGHT_TRAVERSE" for i in np.flatnonzero(up))
    return at[~up], [kind for kind, away in zip(kinds, up) if not away], centres[~up]
