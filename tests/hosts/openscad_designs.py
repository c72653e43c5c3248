"""Designs read by Fieldfab and by OpenSCAD: volumes agree within 0.5 %, and the Hausdorff distance is at most a voxel.

    openscad_designs.py            the table of docs/openscad.md: all examples, ../shared/data/scad, 200 random trees
    openscad_designs.py NAME ...   some of them
    openscad_designs.py 0 50       random trees 0 to 49 only
"""

import json
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import time

import numpy as np
from programs import need

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("FIELDFAB_BUILD", ROOT / "build" / "release"))
COMMAND = BUILD / "bin" / "fieldfab"
EXAMPLES = pathlib.Path("/usr/share/openscad/examples")
SHARED = ROOT.parent / "shared" / "data" / "scad"
THICKNESS = 10  # mm, of flat designs

sys.path.insert(0, str(BUILD / "python"))


def read_off(path):
    lines = [line for line in pathlib.Path(path).read_text().splitlines() if line.strip()]
    words = lines[0].split()
    counts, rest = (words[1:3], lines[1:]) if len(words) > 1 else (lines[1].split()[:2], lines[2:])
    vertices, faces = map(int, counts)
    points = np.array([[float(w) for w in line.split()[:3]] for line in rest[:vertices]])
    triangles = []
    for line in rest[vertices : vertices + faces]:
        count, *corners = map(int, line.split()[: 1 + int(line.split()[0])])
        triangles += [(corners[0], corners[i - 1], corners[i]) for i in range(2, count)]
    return points, np.array(triangles)


def volume(points, triangles):
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def places_on(points, triangles, count, seed):
    """Returns random points on a surface, uniform by area."""
    source = np.random.default_rng(seed)
    a, b, c = (points[triangles[:, i]] for i in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    pick = source.choice(len(triangles), count, p=area / area.sum())
    u, v = np.sqrt(source.random(count))[:, None], source.random(count)[:, None]
    return (a[pick] * (1 - u) + b[pick] * (u * (1 - v)) + c[pick] * (u * v)).astype(np.float32)


def theirs(design, output):
    """Returns OpenSCAD's mesh and its seconds; a flat design is extruded by THICKNESS. The mesh is None for an empty
    design."""

    need("openscad")

    def run(path):
        started = time.monotonic()
        done = subprocess.run(["openscad", "-o", str(output), str(path)], capture_output=True, text=True, timeout=600)
        return done, time.monotonic() - started

    done, seconds = run(design)
    if "not a 3D object" not in done.stderr:
        empty = done.returncode != 0 or len(read_off(output)[1]) == 0  # OpenSCAD may write an empty file
        return None if empty else output, seconds, False
    csg = output.with_suffix(".csg")
    subprocess.run(["openscad", "-o", str(csg), str(design)], capture_output=True, check=True, timeout=600)
    text = re.sub(r'file = "', f'file = "{design.parent}/', csg.read_text())
    plate = output.with_suffix(".plate.scad")
    plate.write_text(f"linear_extrude({THICKNESS}) {{\n{text}\n}}\n")
    done, seconds = run(plate)
    assert done.returncode == 0, done.stderr
    return output, seconds, True


def ours(design, output, flat, *options):
    command = [COMMAND, "--json", "mesh", design, "-o", output, *options, *(["--thickness", THICKNESS] if flat else [])]
    started = time.monotonic()
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, timeout=150)
    seconds = time.monotonic() - started
    assert done.returncode == 0, f"{design}: {done.stderr}"
    return json.loads(done.stdout), seconds


def contoured(design, folder):
    """Returns options that force a contour of a design with exact faces: slightly larger bounds."""
    done = subprocess.run([str(c) for c in (COMMAND, "--json", "mesh", design, "-o", folder / "faces.off")],
                          capture_output=True, text=True, timeout=150)
    assert done.returncode == 0, f"{design}: {done.stderr}"
    *lower, x, y, z = json.loads(done.stdout)["bounds"]
    return ["--bounds=" + ",".join(str(v) for v in (*(v - 1 for v in lower), x + 1, y + 1, z + 1))]


def compare(design, folder, refine=0, contour=False):
    """Returns one row: name, volumes, distances in voxels, times. Uses the exact faces if available, unless a contour
    is requested. If the default cells of a contour are too coarse, they are halved up to `refine` times."""
    import fieldfab

    folder = pathlib.Path(folder)
    reference, their_seconds, flat = theirs(design, folder / "theirs.off")
    row = {"name": design.stem, "theirs": their_seconds}
    if reference is None:
        row.update(empty=True, right=subprocess.run([COMMAND, "mesh", design, "-o", folder / "ours.off"],
                                                    capture_output=True).returncode == 2)
        return row
    wanted, a, voxel = fieldfab.load(reference), read_off(reference), None
    options = contoured(design, folder) if contour else []
    for attempt in range(refine + 1):
        summary, seconds = ours(design, folder / "ours.off", flat, *options, *(["--voxel", voxel] if voxel else []))
        made, b = fieldfab.load(folder / "ours.off"), read_off(folder / "ours.off")
        voxel = summary["voxel"]
        error = volume(*b) / volume(*a) - 1
        distance = max(np.abs(made.values(places_on(*a, 3000, 1))).max(),
                       np.abs(wanted.values(places_on(*b, 3000, 2))).max())
        row.update(ours=seconds, voxel=voxel, error=error, distance=float(distance) / voxel,
                   triangles=summary["triangles"], halvings=attempt, exact=summary["exact"])
        row["right"] = abs(error) < 0.005 and row["distance"] < 1
        if row["right"]:
            break
        voxel /= 2
    return row


def random_design(seed):
    """Returns OpenSCAD text of a random tree of solids."""
    chance = random.Random(seed)

    def number(low, high):
        return round(chance.uniform(low, high), 2)

    def flat():
        kind = chance.randrange(4)
        if kind == 0:
            return f"square([{number(3, 12)}, {number(3, 12)}], center={chance.choice(['true', 'false'])});"
        if kind == 1:
            return f"circle(r={number(2, 7)}, $fn={chance.randrange(3, 24)});"
        if kind == 2:
            return f"offset(r={number(0.5, 2)}) square({number(3, 8)});"
        return f"difference() {{ circle(r={number(5, 8)}); translate([{number(-2, 2)}, 0]) square({number(2, 4)}); }}"

    def leaf():
        kind = chance.randrange(6)
        if kind == 0:
            return (f"cube([{number(3, 14)}, {number(3, 14)}, {number(3, 14)}], "
                    f"center={chance.choice(['true', 'false'])});")
        if kind == 1:
            return f"sphere(r={number(3, 8)}, $fn={chance.randrange(4, 20)});"
        if kind == 2:
            return f"cylinder(h={number(4, 14)}, r1={number(2, 7)}, r2={number(0, 7)}, $fn={chance.randrange(3, 20)});"
        if kind == 3:
            return f"linear_extrude(height={number(3, 10)}) {flat()}"
        if kind == 4:
            return f"linear_extrude(height={number(4, 10)}, twist={number(-60, 60)}, scale={number(0.5, 1.5)}) {flat()}"
        return (f"rotate_extrude(angle={chance.choice([360, 90, 200, -120])}, "
                f"$fn={chance.randrange(5, 30)}) translate([{number(8, 11)}, 0]) {flat()}")

    def placed(inner):
        kind = chance.randrange(4)
        if kind == 0:
            return f"translate([{number(-8, 8)}, {number(-8, 8)}, {number(-8, 8)}]) {inner}"
        if kind == 1:
            return f"rotate([{number(0, 180)}, {number(0, 180)}, {number(0, 180)}]) {inner}"
        if kind == 2:
            return f"{chance.choice(['mirror([1, 0.5, 0])', 'scale([1.2, 0.8, 1])', 'rotate([90, 0, 90])'])} {inner}"
        return inner

    def tree(depth):
        if depth == 0:
            return placed(leaf())
        if chance.random() < 0.12:
            return placed("hull() { " + " ".join(placed(leaf()) for _ in range(2)) + " }")
        kind = chance.choice(["union", "union", "difference", "intersection"])
        count = 2 if kind == "intersection" else chance.randrange(2, 4)
        return placed(f"{kind}() {{ " + " ".join(tree(depth - 1) for _ in range(count)) + " }")

    return tree(chance.choice([1, 2, 2, 3])) + "\n"


def random_extrusion(seed):
    """Returns OpenSCAD text of a random extrusion with twist, scale, or both."""
    chance = random.Random(seed)

    def number(low, high):
        return f"{chance.uniform(low, high):.2f}"

    scale = chance.choice(["1", number(0.1, 4), f"[{number(0.1, 4)}, {number(0.1, 4)}]"])
    fineness = chance.choice(["", "", f"$fn = {chance.randrange(1, 50)}, ", f"$fa = {number(1, 30)}, "
                              f"$fs = {number(0.2, 5)}, ", f"slices = {chance.randrange(1, 30)}, "])
    shape = chance.choice([f"square([{number(2, 12)}, {number(2, 12)}], center = true)",
                           f"translate([{number(0, 9)}, 2]) circle({number(1, 5)})",
                           "difference() { square(8, center = true); circle(2.5); }",
                           "polygon([[0, 0], [9, 1], [3, 3], [1, 8]])"])
    return (f"linear_extrude({number(3, 20)}, {fineness}scale = {scale}, "
            f"twist = {chance.choice(['0', number(-400, 400)])}) {shape};\n")


def designs():
    return sorted(EXAMPLES.rglob("*.scad"),
                  key=lambda path: path.stem) + (sorted(SHARED.glob("*.scad")) if SHARED.exists() else [])


def line(row):
    if "why" in row:
        return f"| {row['name']} | {row['why'][:80]} | | | | | | **no** |"
    if row.get("empty"):
        return (f"| {row['name']} | empty, "
                f"as OpenSCAD says | | | | {row['theirs']:.2f} | | {'yes' if row['right'] else '**no**'} |")
    return (
        f"| {row['name']} | {100 * row['error']:+.3f} % | {row['distance']:.2f} | "
        f"{row['voxel']:.3g}{'*' * row['halvings']} | {'faces' if row['exact'] else 'contour'} | {row['theirs']:.2f} | "
        f"{row['ours']:.2f} | {'yes' if row['right'] else '**no**'} |"
    )


def main(names):
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        print("| design | volume off by | farthest, voxels | voxel, mm | made of | OpenSCAD, s | ours, s | right |\n"
              "|---|---|---|---|---|---|---|---|", flush=True)
        for design in designs() if not names or not names[0].isdigit() else []:
            if names and design.stem not in names:
                continue
            try:
                rows.append(compare(design, folder, refine=1))
            except (AssertionError, subprocess.TimeoutExpired) as why:
                rows.append({"name": design.stem, "empty": True, "theirs": 0, "right": False, "why": str(why)})
            print(line(rows[-1]), flush=True)
        if rows:
            ratios = sorted(r["theirs"] / r["ours"] for r in rows if "ours" in r)
            print(f"\n{sum(r['right'] for r in rows)} of {len(rows)} right; "
                  f"ours faster {np.median(ratios):.2g} times on the median.\n", flush=True)
        right, total = 0, 0
        wanted = [int(name) for name in names if name.isdigit()]
        for seed in range(200) if not names else range(*wanted) if wanted else []:
            design = pathlib.Path(folder) / f"random{seed}.scad"
            design.write_text(random_design(seed))
            try:
                row = compare(design, folder, refine=1)
            except (AssertionError, subprocess.TimeoutExpired) as why:
                row = {"name": design.stem, "empty": True, "theirs": 0, "right": False, "why": str(why)}
            total, right = total + 1, right + row["right"]
            if not row["right"]:
                print(f"random tree {seed}: {row}", flush=True)
        if total:
            print(f"{right} of {total} random trees right.")


if __name__ == "__main__":
    main(sys.argv[1:])
