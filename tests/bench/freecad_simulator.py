"""Compares FreeCAD's simulator (PathSimulator, a height field) with ours on the same jobs in one process.

Level and waves: 10,100 moves of 1 mm of a 6 mm cutter over a block of 100 x 100 mm at 0.1 mm, each row at one height,
or up and down: seconds to cut, and to make the mesh. (FreeCAD merges coplanar level triangles.) Groove: a 6 mm ball
goes along a sloping line and back, 101 times in 100 moves each, at 0.1 mm: moves per second, and the distance of the
groove's triangle centres from the true groove, mm.

Figures of one thread: `taskset -c 0 /usr/bin/python3 tests/bench/freecad_simulator.py`."""

import sys
import time

import numpy as np

import fieldfab as ff

sys.path.append("/usr/lib/freecad-python3/lib")
import FreeCAD
import Part
import Path
import PathSimulator

CELL, RADIUS, REPEATS = 0.1, 3.0, 3


def timed(work):
    start = time.perf_counter()
    result = work()
    return time.perf_counter() - start, result


def freecad(box, ball, way):
    """Returns seconds to cut, seconds to mesh, and corners of the triangles."""
    low, size = FreeCAD.Vector(*box[:3]), [float(b - a) for a, b in zip(box[:3], box[3:])]
    # Half of its section, revolved about the axis.
    v = FreeCAD.Vector
    if ball:
        lower = Part.Arc(v(0, 0, 0), v(RADIUS * np.sqrt(0.5), 0, RADIUS * (1 - np.sqrt(0.5))),
                         v(RADIUS, 0, RADIUS)).toShape()
        rest = Part.makePolygon([v(RADIUS, 0, RADIUS), v(RADIUS, 0, 30), v(0, 0, 30), v(0, 0, 0)])
        outline = Part.Wire([lower, *rest.Edges])
        tool = Part.Face(outline).revolve(v(0, 0, 0), v(0, 0, 1), 360)
    else:
        tool = Part.makeCylinder(RADIUS, 30)
    simulator = PathSimulator.PathSim()
    simulator.BeginSimulation(Part.makeBox(*size, low), CELL)
    simulator.SetToolShape(tool, 0.05 * CELL)
    commands = [Path.Command("G1", {"X": x, "Y": y, "Z": z}) for x, y, z in way.tolist()]

    def cut():
        place = FreeCAD.Placement(v(*way[0].tolist()), FreeCAD.Rotation())
        for command in commands[1:]:
            place = simulator.ApplyCommand(place, command)

    cutting, _ = timed(cut)
    meshing, meshes = timed(simulator.GetResultMesh)
    corners = np.concatenate([np.array([f.Points for f in mesh.Facets]).reshape(-1, 3, 3)
                              for mesh in meshes if mesh.CountFacets])
    return cutting, meshing, corners


def ours(box, ball, way):
    stock = ff.stock.Stock(box, cell=CELL)
    cutting, _ = timed(lambda: stock.cut({"shape": "ball" if ball else "flat", "diameter": 2 * RADIUS, "flute": 30},
                                         way))
    meshing, mesh = timed(stock.mesh)
    return cutting, meshing, np.asarray(mesh.vertices)[np.asarray(mesh.triangles)]


def best(simulate, *job):
    """Returns the run with the least total time."""
    return min((simulate(*job) for _ in range(REPEATS)), key=lambda run: run[0] + run[1])


def raster(name, height):
    box, rows = [0, 0, -10, 100, 100, 0], []
    for row in range(101):
        x = np.linspace(0, 100, 101)[:: 1 if row % 2 == 0 else -1]
        rows.append(np.column_stack([x, np.full(101, float(row)), height(x, row)]))
    way = np.concatenate(rows)
    theirs, mine = best(freecad, box, False, way), best(ours, box, False, way)
    print(f"{name}, {len(way) - 1} moves (of which 100 go from row to row): cut s, mesh s, sum s")
    for who, (cutting, meshing, corners) in (("FreeCAD", theirs), ("ours", mine)):
        print(f"  {who:8}{cutting:8.3f}{meshing:8.3f}{cutting + meshing:8.3f}   {len(corners)} triangles")
    print(f"  FreeCAD / ours: cut {theirs[0] / mine[0]:.2f}, mesh {theirs[1] / mine[1]:.2f}, "
          f"sum {(theirs[0] + theirs[1]) / (mine[0] + mine[1]):.2f}")


def groove():
    box, start, end = [0, 0, 0, 20, 20, 5], np.array([3.3, 2.1, 2.2]), np.array([16.4, 17.9, 3.1])
    there = start + np.linspace(0, 1, 101)[:, None] * (end - start)
    way = np.concatenate([there] + [there[::-1][1:], there[1:]] * 50)
    print(f"groove, {len(way) - 1} moves: moves a second, mean error mm, worst error mm")
    for name, simulate in (("FreeCAD", freecad), ("ours", ours)):
        cutting, _, corners = best(simulate, box, True, way)
        # Triangles with all corners inside the block: without those of its faces and of the groove's rim.
        inside = ((corners > np.array(box[:3]) + 1e-3) & (corners < np.array(box[3:]) - 1e-3)).all(axis=(1, 2))
        middles = corners.mean(axis=1)
        centre, along = start + [0, 0, RADIUS], end - start
        t = (middles - centre) @ along / (along @ along)
        apart = np.linalg.norm(middles - centre - t[:, None] * along, axis=1)
        chosen = inside & (t >= 0) & (t <= 1) & (apart < RADIUS + 5 * CELL)
        error = np.abs(apart[chosen] - RADIUS)
        print(f"  {name:8}{(len(way) - 1) / cutting:10.0f}{error.mean():9.4f}{error.max():9.4f}   of "
              f"{chosen.sum()} triangles")


raster("level", lambda x, row: np.full(101, -2 + np.sin(row / 7)))
raster("waves", lambda x, row: -3 + 2 * np.sin(x / 10) * np.cos(row / 15))
groove()
