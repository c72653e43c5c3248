"""Constant-engagement clearing against FreeCAD's Adaptive2d: time, length and engagement on a pocket of 100 x 80 mm
with three islands.

    /usr/bin/python3 tests/bench/adaptive_figures.py        (PYTHONPATH=build/release/python)
"""

import math
import pathlib
import sys
import tempfile
import time

import numpy as np

sys.path += ["/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"]

RADIUS, STEPOVER = 3.0, 0.2  # radius of the tool, mm; in diameters
CIRCLE = (30, 30, 9)
SQUARE = (60, 78, 15, 30)
TRIANGLE = [(50, 52), (72, 50), (66, 66)]


def edge(a, b):
    """Returns the formula of the half-plane to the right of the line from a to b."""
    length = math.dist(a, b)
    return f"((x-{a[0]})*{(b[1] - a[1]) / length:.12g} - (y-{a[1]})*{(b[0] - a[0]) / length:.12g})"


def pocket():
    """Returns the pocket's formula: negative in the area to clear."""
    x0, x1, y0, y1 = SQUARE
    sides = [edge(TRIANGLE[i], TRIANGLE[(i + 1) % 3]) for i in range(3)]
    islands = [
        f"{CIRCLE[2]} - sqrt((x-{CIRCLE[0]})*(x-{CIRCLE[0]}) + (y-{CIRCLE[1]})*(y-{CIRCLE[1]}))",
        f"-max(max({x0}-x, x-{x1}), max({y0}-y, y-{y1}))",
        f"-max({sides[0]}, max({sides[1]}, {sides[2]}))",
    ]
    formula = "max(max(-x, x-100), max(-y, y-80))"
    for island in islands:
        formula = f"max({formula}, {island})"
    return formula


def ours():
    import fieldfab as ff

    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "pocket.frep").write_text(pocket())
        (folder / "job.toml").write_text(
            f"""
            machine = "linuxcnc"
            [input]
            model = "pocket.frep"
            [stock]
            lower = [-5, -5, -1]
            upper = [105, 85, 0]
            [[tool]]
            diameter = {2 * RADIUS}
            [[operation]]
            type = "pocket"
            pattern = "adaptive"
            stepover = {STEPOVER}
            tolerance = 0.01
            feed = 1000
            link_feed = 2000
            """
        )
        job = ff.cam.Job(folder / "job.toml")
        start = time.perf_counter()
        job.run()
        seconds = time.perf_counter() - start
    moves = np.vstack(job.moves)
    ways = []
    for a, b in zip(moves, moves[1:]):
        if b[3] == 0 or b[2] > -1 + 1e-9 or a[2] > -1 + 1e-9:
            continue
        ways.append((b[3] == 1000, arc(a[:2], b[:2], b[4])))
    return seconds, ways


def arc(a, b, bulge):
    """Returns points along a straight or circular move."""
    if bulge == 0:
        return np.array([a, b])
    chord = b - a
    centre = (a + b) / 2 + (1 - bulge**2) / (4 * bulge) * np.array([-chord[1], chord[0]])
    turn = np.linspace(0, 4 * math.atan(bulge), 2 + int(abs(4 * math.atan(bulge)) / 0.02))
    c, s = np.cos(turn), np.sin(turn)
    d = a - centre
    return centre + np.stack([c * d[0] - s * d[1], s * d[0] + c * d[1]], axis=1)


def freecad():
    import area

    def closed(points):
        return [list(p) for p in points] + [list(points[0])]

    x0, x1, y0, y1 = SQUARE
    circle = [(CIRCLE[0] + CIRCLE[2] * math.cos(t), CIRCLE[1] + CIRCLE[2] * math.sin(t))
              for t in np.linspace(0, 2 * math.pi, 128)[:-1]]
    outer = closed([(0, 0), (100, 0), (100, 80), (0, 80)])
    islands = [closed(circle), closed([(x0, y0), (x1, y0), (x1, y1), (x0, y1)]), closed(TRIANGLE)]
    tool = area.Adaptive2d()
    tool.tolerance, tool.toolDiameter, tool.stepOverFactor = 0.1, 2 * RADIUS, STEPOVER
    tool.opType, tool.finishingProfile = area.AdaptiveOperationType.ClearingInside, True
    start = time.perf_counter()
    regions = tool.Execute([outer], [outer, *islands], lambda *progress: False)
    seconds = time.perf_counter() - start
    ways = []
    for region in regions:
        centre, first = np.array(region.HelixCenterPoint), np.array(region.StartPoint)
        ways.append((None, arc(first, 2 * centre - first, 1)))
        ways.append((None, arc(2 * centre - first, first, 1)))
        last = first
        for kind, points in region.AdaptivePaths:
            for p in points:
                p = np.array(p)
                ways.append((kind == 0, np.array([last, p])))
                last = p
    return seconds, ways


def engagement(ways, cell=0.05):
    """Returns the width of cut for each millimetre of the feeds (True), from discs stamped on a lattice."""
    left = np.zeros((int(80 / cell), int(100 / cell)), bool)
    y, x = np.mgrid[0 : left.shape[0], 0 : left.shape[1]]
    x, y = (x + 0.5) * cell, (y + 0.5) * cell
    left[:] = True
    left[np.hypot(x - CIRCLE[0], y - CIRCLE[1]) < CIRCLE[2]] = False
    left[(x > SQUARE[0]) & (x < SQUARE[1]) & (y > SQUARE[2]) & (y < SQUARE[3])] = False
    inside = np.ones_like(left)
    for a, b in zip(TRIANGLE, TRIANGLE[1:] + TRIANGLE[:1]):
        inside &= (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) > 0
    left[inside] = False
    reach = int(RADIUS / cell) + 1

    def stamp(p):
        c, r = int(p[0] / cell), int(p[1] / cell)
        rows, columns = slice(max(0, r - reach), r + reach + 1), slice(max(0, c - reach), c + reach + 1)
        disc = (x[rows, columns] - p[0]) ** 2 + (y[rows, columns] - p[1]) ** 2 < RADIUS**2
        cut = np.count_nonzero(left[rows, columns] & disc)
        left[rows, columns] &= ~disc
        return cut * cell * cell

    widths, taken, along, total = [], 0.0, 0.0, 0.0
    for cutting, points in ways:
        for a, b in zip(points, points[1:]):
            steps = max(1, math.ceil(math.dist(a, b) / 0.15))
            for k in range(1, steps + 1):
                cut = stamp(a + (b - a) * k / steps)
                if not cutting:
                    continue
                taken, along, total = taken + cut, along + math.dist(a, b) / steps, total + math.dist(a, b) / steps
                if along >= 1:
                    widths.append(taken / along)
                    taken = along = 0.0
    return total, np.array(widths), left.sum() * cell * cell


def main():
    figures = {}
    for name, plan in (("FreeCAD", freecad), ("Fieldfab", ours)):
        seconds, ways = plan()
        length, widths, left = engagement(ways)
        figures[name] = seconds, length
        print(
            f"{name:9} {seconds:6.2f} s {length:7.0f} mm cut; engaged mm: mean {widths.mean():.2f}, "
            f"99 % {np.quantile(widths, 0.99):.2f}, most {widths.max():.2f}; left {left:.1f} mm^2"
        )
    print(f"ratio     {figures['FreeCAD'][0] / figures['Fieldfab'][0]:6.1f} times as fast, "
          f"{figures['Fieldfab'][1] / figures['FreeCAD'][1]:.3f} of the length")


if __name__ == "__main__":
    main()
