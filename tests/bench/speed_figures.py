#!/usr/bin/python3
"""Times what takes longest, on one thread and on two, beside what it took before and beside other programs. Writes the
table of docs/speed.md to stdout.

    PYTHONPATH=build/release/python /usr/bin/python3 tests/bench/speed_figures.py [WORDS]    (only rows with WORDS)

OpenVDB runs here. Times of other programs and those of before were measured on such a machine (two cores, idle).
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/hosts"))
DATA = ROOT.parent / "shared/data"
COMMAND = ROOT / "build/release/bin/fieldfab"
SCAN = (361, 512, 512)  # slices, rows, columns
THRESHOLD = 800


def text():
    """Six lines of 28 letters."""
    signs = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789abcdefghijklmnopqrstuvwxyz" * 3
    lines = [f'move(extrude(text("{signs[28 * i: 28 * i + 28]}", h = 5, weight = 1), 1), 0, {-8 * i})'
             for i in range(6)]
    return ff.parse(f"union({', '.join(lines)})")


def blend():
    """Twenty-nine balls that blend by exponentials."""
    x, y, z = ff.X, ff.Y, ff.Z
    total = ff.exp(-ff.sqrt(x * x + y * y + z * z))
    for ball in range(28):
        turn, height = 2.4 * ball, ball - 14
        cx, cy, cz = 10 * np.cos(turn), 10 * np.sin(turn), height
        total += ff.exp((3.5 - ff.sqrt((x - cx) ** 2 + (y - cy) ** 2 + (z - cz) ** 2)) * 2)
    return -ff.ln(total) / 2


def formula(name):
    return ff.parse_vm((DATA / "frep" / name).read_text())


def tanglecube():
    """The distance field of the tanglecube and its mesh, 256 cells a side."""
    solid, box = formula("tanglecube.vm"), ((-3, -3, -3), (3, 3, 3))
    return lambda: (ff.build(solid, bounds=box, voxel=6 / 256), ff.mesh(solid, bounds=box, voxel=6 / 256))


def tanglecube_heights():
    solid, box = formula("tanglecube.vm"), ((-3, -3, -3), (3, 3, 3))
    return lambda: ff.render(solid, mode="height", size=512, bounds=box)


def mill():
    """The 35 parts of the PCB mill mtm_az (inches): distance fields and meshes, 5 cells a mm."""
    files = sorted((DATA / "frep/kokopelli").rglob("mtm_az_??.math"))
    assert len(files) == 35

    def run():
        for file in files:
            part = ff.load(file)
            ff.build(part, voxel=1 / 127)
            ff.mesh(part, voxel=1 / 127)

    return run


def plate():
    solid = formula("prospero.vm")
    solid = ff.maximum(solid, ff.maximum(ff.Z - 0.04, -ff.Z))
    return lambda: ff.mesh(solid, bounds=((-1.02, -1.02, -0.02), (1.02, 1.02, 0.06)), voxel=0.01)


def knob():
    return lambda: ff.mesh(ff.load(ROOT / "examples/knob.frep"), voxel=0.15)


def letters():
    return lambda: ff.mesh(text(), voxel=0.25)


def letters_flat():
    part = ff.load(DATA / "frep/kokopelli/text/text_00.math")
    return lambda: ff.render(part, mode="bitmap", size=2048, bounds=((0, -5.5, 0), (25, 6.7, 0)))


def prospero():
    solid = formula("prospero.vm")
    return lambda: ff.render(solid, mode="bitmap", size=4096, bounds=((-1, -1, 0), (1, 1, 0)))


def blend_heights():
    solid = blend()
    return lambda: ff.render(solid, mode="height", size=512, bounds=((-20, -20, -20), (20, 20, 20)))


def job(text, model):
    """Planning of a job in memory."""
    folder = pathlib.Path(tempfile.mkdtemp())
    (folder / "job.toml").write_text(text)
    (folder / "part.frep").write_text(model)

    def run():
        planned = ff.cam.Job(folder / "job.toml")
        planned.run()

    return run


def pocket():
    return job(
        'machine = "linuxcnc"\n[input]\nmodel = "part.frep"\n[stock]\nmargin = 0\n[[tool]]\nnumber = 1\ndiameter = 6\n'
        '[[operation]]\ntype = "rough"\npattern = "adaptive"\nstepover = 0.2\nstepdown = 5\n',
        "difference(box(100, 80, 12), move(box(94, 74, 10), dz = 5)) | cylinder(9, 12) | "
        "move(box(15, 30, 12), 27, 10)")


def board():
    folder = ROOT / "examples/cam"

    def run():
        planned = ff.cam.Job(folder / "pcb_gcode.toml")
        planned.run()

    return run


def scan_file():
    """A head of 512 x 512 x 361 samples of 16 bits: the CT scan of SOURCES.txt between its samples, with noise."""
    path = pathlib.Path(tempfile.gettempdir()) / "speed_512x512x361_int16.raw"
    if path.exists():
        return path
    values = ff.Volume.open(DATA / "ct/cthead").densities().astype(np.float32)
    for axis, count in enumerate(SCAN):
        at = np.linspace(0, values.shape[axis] - 1.001, count)
        low = at.astype(int)
        share = (at - low).astype(np.float32).reshape([-1 if a == axis else 1 for a in range(3)])
        values = np.take(values, low, axis) * (1 - share) + np.take(values, low + 1, axis) * share
    values *= 1600 / 60
    values += np.random.default_rng(1).normal(0, 12, SCAN).astype(np.float32)
    path.write_bytes(np.clip(values, -32768, 32767).astype("<i2").tobytes())
    return path


def scan():
    path, out = scan_file(), pathlib.Path(tempfile.mkdtemp()) / "scan.ply"
    return lambda: subprocess.run(
        [COMMAND, "--threads", os.environ["THREADS"], "mesh", path, "-o", out, "--threshold", str(THRESHOLD)],
        check=True, capture_output=True)


def scan_by_openvdb():
    """Reading, copyFromDense, volumeToMesh and writing, by OpenVDB's Python module."""
    from openvdb_module import openvdb

    path, out = scan_file(), pathlib.Path(tempfile.mkdtemp()) / "scan.ply"

    def run():
        samples = THRESHOLD - np.fromfile(path, "<i2").reshape(SCAN).astype(np.float32)
        grid = openvdb.FloatGrid(100000.0)
        grid.copyFromArray(samples)
        points, quads = grid.convertToQuads()
        faces = np.empty((len(quads), 17), np.uint8)
        faces[:, 0] = 4
        faces[:, 1:] = quads.astype("<u4").view(np.uint8)
        with open(out, "wb") as file:
            file.write(b"ply\nformat binary_little_endian 1.0\n"
                       b"element vertex %d\nproperty float x\nproperty float y\nproperty float z\n"
                       b"element face %d\nproperty list uchar uint vertex_indices\nend_header\n" %
                       (len(points), len(quads)))
            file.write(points.tobytes())
            file.write(faces.tobytes())

    return run


def start():
    path = pathlib.Path(tempfile.mkdtemp()) / "ball.frep"
    path.write_text("sphere(10)\n")
    return lambda: subprocess.run(
        [COMMAND, "--threads", os.environ["THREADS"], "render", path, "-o", path.with_suffix(".png"), "--size", "64"],
        check=True, capture_output=True)


# what, before (s), asked (s), by other programs, how
ROWS = [
    ("prospero.vm as a plate of 200 x 200 x 4 cells: mesh", "20 to 40", "2", "", plate),
    ("168 letters with strokes of two cells: mesh", "20", "1", "", letters),
    ("mtm_az, 35 parts of 5 cells a mm: distance fields and meshes", "8.2", "1", "kokopelli 12.8", mill),
    ("tanglecube, 256 cells a side: distance field and mesh", "0.6", "0.3", "mesh only: Fidget 2.6, libfive 4.2",
     tanglecube),
    ("examples/knob.frep at 0.15 mm: mesh", "", "", "", knob),
    ("scan of 512 x 512 x 361 samples, .raw to .ply", "2.45", "half of OpenVDB's", "", scan),
    ("the same by OpenVDB", "2.0 to 2.5", "", "", scan_by_openvdb),
    ("height map of 29 exponentials, 512 x 512", "1.6", "0.2", "libfive 0.75", blend_heights),
    ("height map of the tanglecube, 512 x 512", "0.033 to 0.046", "0.009", "", tanglecube_heights),
    ("Keeter's two lines of text, 2048 x 1000", "0.007 to 0.009", "0.005", "", letters_flat),
    ("prospero.vm, 4096 x 4096", "", "", "", prospero),
    ("a small formula's picture, with the command's start", "0.1", "0.03", "", start),
    ("adaptive clearing of a pocket, 100 x 80 x 10 mm", "", "", "", pocket),
    ("contours of a circuit board", "", "", "", board),
]


def least(run):
    """The least time of several runs, seconds."""
    walls = []
    until = time.monotonic() + 15
    while len(walls) < 3 or (time.monotonic() < until and len(walls) < 20):
        began = time.perf_counter()
        run()
        walls.append(time.perf_counter() - began)
    return min(walls)


def main(words, folder):
    """`folder` holds what the rows write."""
    print("| what | before | asked | one thread | two threads | gain | other programs |\n|---|---|---|---|---|---|---|")
    for name, before, asked, others, _ in ROWS:
        if not all(word in name for word in words):
            continue
        walls = []
        for threads in (1, 2):
            # A process of its own, which sees as many cores.
            done = subprocess.run(
                ["taskset", "-c", ",".join(str(core) for core in range(threads)), sys.executable, __file__, "--row",
                 name], check=True, stdout=subprocess.PIPE, text=True,
                env=dict(os.environ, THREADS=str(threads), TMPDIR=folder))
            walls.append(json.loads(done.stdout))
        one, two = walls
        print(f"| {name} | {before} | {asked} | {one:.3g} | {two:.3g} | {one / two:.2f} | {others} |", flush=True)


if __name__ == "__main__":
    import fieldfab as ff

    if sys.argv[1:2] == ["--row"]:
        ff.set_threads(int(os.environ["THREADS"]))
        print(json.dumps(least(next(make for name, *_, make in ROWS if name == sys.argv[2])())))
    else:
        with tempfile.TemporaryDirectory() as place:
            main(sys.argv[1:], place)
