#!/usr/bin/python3
"""Compares Fieldfab's Remesh with MeshLab's Uniform Mesh Resampling, with equal cells, in the same meshlabserver.
Prints the table of docs/meshlab.md. Run it as PYTHONPATH=build/release/python /usr/bin/python3
tests/hosts/meshlab_bench.py"""

import pathlib
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import numpy as np
from meshlab_host import REMESH, cube, figure_eight, plates, scan, serve, sphere, with_holes, write_ply

import fieldfab

THEIRS = "Uniform Mesh Resampling"


def on_surface(mesh, count=200_000, seed=1):
    """Returns points distributed uniformly over a mesh's triangles, and its vertices."""
    vertices, triangles = np.asarray(mesh.vertices, float), np.asarray(mesh.triangles)
    a, b, c = (vertices[triangles[:, i]] for i in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    random = np.random.default_rng(seed)
    chosen = random.choice(len(triangles), count, p=area / area.sum())
    u, v = random.random((2, count))
    u, v = np.where(u + v > 1, 1 - u, u)[:, None], np.where(u + v > 1, 1 - v, v)[:, None]
    return np.concatenate([a[chosen] + u * (b - a)[chosen] + v * (c - a)[chosen],
                           vertices[np.unique(triangles)]]).astype(np.float32)


def away(places, mesh):
    """Returns mean and maximum distance of the points to the mesh (CGAL)."""
    distances = np.abs(mesh.solid().values(places))
    return f"{distances.mean():.3g} / {distances.max():.3g}"


def seconds(folder, path, steps, tries=3):
    """Returns the shortest time of a script without loading, and the last output."""
    best, idle = float("inf"), float("inf")
    for _ in range(tries):
        began = time.perf_counter()
        serve(folder, [path], [])
        idle = min(idle, time.perf_counter() - began)
        began = time.perf_counter()
        said = serve(folder, [path], steps, timeout=900)
        best = min(best, time.perf_counter() - began)
    return max(best - idle, 0.005), said


def measured(folder, path, step, source):
    took, said = seconds(folder, path, [step])
    out = folder / "out.ply"
    out.unlink(missing_ok=True)
    serve(folder, [path], [step], out)
    if not out.exists():
        reason = next((line.split(": Assertion")[1].split("'")[0].strip(" `") for line in said.text.splitlines()
                       if "Assertion" in line), "no result")
        return None, f"stops: assertion {reason}"
    mesh = fieldfab.Mesh.load(out)
    verdict = fieldfab.inspect(mesh)
    return took, (f"{took:.2f} s", len(mesh.triangles), away(on_surface(source), mesh), away(on_surface(mesh), source),
                  "yes" if verdict.closed and verdict.manifold else "no", verdict.self_intersections)


def main():
    print("| mesh | cell, mm | by | time | triangles | input to result, mm (mean / largest) | result to input, "
          "mm | closed, manifold | self-intersections |")
    print("|---|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        meshes = {"cube": (write_ply(folder / "cube.ply", *cube()), 0.35),
                  "sphere with holes": (write_ply(folder / "holes.ply", *with_holes(sphere(60))), 0.35),
                  "figure eight, crosses itself": (write_ply(folder / "eight.ply", *figure_eight()), 0.35),
                  "thin plates": (write_ply(folder / "plates.ply", *plates()), 0.4),
                  "scan": (scan(folder / "scan.ply"), 2.0)}
        for what, (path, cell) in meshes.items():
            source = fieldfab.Mesh.load(path)
            ours, our_row = measured(folder, path, (REMESH, {"Voxel": cell}), source)
            theirs, their_row = measured(folder, path, (THEIRS, {"CellSize": cell}), source)
            ratio = f" ({theirs / ours:.1f} times faster)" if ours and theirs else ""
            label = f"{what}, {len(source.triangles)} triangles"
            for by, row, more in (("Fieldfab", our_row, ratio), ("MeshLab", their_row, "")):
                cells = [row, *[""] * 5] if isinstance(row, str) else [row[0] + more, *map(str, row[1:])]
                print(f"| {label if by == 'Fieldfab' else ''} | {cell if by == 'Fieldfab' else ''} | {by} | "
                      + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
