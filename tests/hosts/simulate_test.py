"""`fieldfab simulate`: programs of our CAM run without events. Every planted fault is found at its line, without false
alarms."""

import json
import math
import os
import pathlib
import random
import re
import struct
import subprocess
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from family import sample_or_all

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMAND = pathlib.Path(os.environ.get("FIELDFAB", ROOT / "build/release/bin/fieldfab"))

DOME = """
plate = max(max(abs(x) - 20, abs(y) - 15), max(z + 4, -(z + 8)))
dome = sqrt(square(x + 8) + square(y) + square(z + 9)) - 9
pocket = max(max(abs(x - 9) - 5, abs(y) - 8), -(z + 6.5))
max(min(plate, max(dome, -(z + 8))), -pocket)
"""
KNOB = ("min(max(sqrt(x*x + y*y + (z+4)*(z+4)) - 9 - 0.4*sin(x)*cos(y), -z - 2), max(max(abs(x) - 13, abs(y) - 13), "
        "abs(z+3) - 3))")
TOOLS = """
[[tool]]
number = 1
diameter = 6
flute = 16
length = 30
shank = 6
holder_diameter = 24
holder_length = 30
[[tool]]
number = 2
shape = "ball"
diameter = 4
flute = 14
length = 30
shank = 4
holder_diameter = 24
holder_length = 30
"""
JOBS = {
    "dome": ("linuxcnc", DOME, '[[operation]]\ntype = "rough"\ntool = 1\nstepdown = 2\nbottom = -8\n'
             '[[operation]]\ntype = "finish"\ntool = 2\nstepover = 0.6\nbottom = -8\n'),
    "knob": ("five_axis_ac", KNOB, '[[operation]]\ntype = "rough"\ntool = 1\nstepdown = 2\nbottom = 0\n'
             '[[operation]]\ntype = "finish"\ntool = 2\nlean = true\npattern = "spiral"\nscallop = 0.02\nbottom = 0\n'),
}


def run(*args, timeout=300):
    return subprocess.run([str(COMMAND), *map(str, args)], capture_output=True, text=True, timeout=timeout)


HOME = 1000.0  # height of the machine's zero over the part's: anything above the stock


def follow(lines):
    """Returns the position after each line of a program, and its tool."""
    places, tools, place, tool = [], [], {}, 0
    for line in lines:
        if found := re.match(r"T(\d+)", line):
            tool = int(found[1])
        if line.startswith("G53"):
            place = {**place, "Z": HOME}
        elif re.match(r"G[0123] ", line):
            place = {**place, **{letter: float(number) for letter, number in re.findall(r"([XYZAC])(-?[\d.]+)", line)}}
        places.append(place)
        tools.append(tool)
    return places, tools


class Program:
    """A program of our CAM, its job, and the end point of each line."""

    def __init__(self, name, folder):
        machine, model, operations = JOBS[name]
        self.folder, self.name = folder, name
        (folder / f"{name}.frep").write_text(model)
        self.job_text = (f'name = "{name}"\nmachine = "{machine}"\n[input]\nmodel = "{name}.frep"\n[stock]\n'
                         f'margin = 2\ntop = 0.5\n{TOOLS}{operations}')
        self.job = folder / f"{name}.toml"
        self.job.write_text(self.job_text)
        path = folder / f"{name}.ngc"
        done = run("cam", self.job, "-o", path)
        assert done.returncode == 0, done.stderr
        self.lines = path.read_text().splitlines()
        self.at, self.tool = follow(self.lines)
        clean = self.simulate(self.lines, self.job)
        assert clean["code"] == 0 and not clean["events"], clean
        self.removed = {record["line"]: record["removed"] for record in clean["lines"]}

    def simulate(self, lines, setup, tag="", cell=0.3):
        program, report = self.folder / f"{self.name}{tag}.nc", self.folder / f"{self.name}{tag}.json"
        program.write_text("\n".join(lines) + "\n")
        done = run("simulate", program, "--setup", setup, "--report", report, "--cell", cell, "--threads", 1)
        assert done.returncode in (0, 1), done.stderr
        result = json.loads(report.read_text())
        result["code"] = done.returncode
        return result

    def feeds(self, tool):
        """Returns indices of straight feeds of a tool that precede another straight feed."""
        return [i for i in range(len(self.lines) - 1)
                if self.tool[i] == tool and self.lines[i].startswith("G1") and self.lines[i + 1].startswith("G1")
                and "X" in self.at[i]]

    def furthest(self, i):
        """Returns the greatest x of a move without its start; for an arc, that of its bulge."""
        start, end = self.at[i - 1], self.at[i]
        most = end.get("X", -9999)
        if self.lines[i][:2] in ("G2", "G3"):
            given = {letter: float(number) for letter, number in re.findall(r"([IJ])(-?[\d.]+)", self.lines[i])}
            x, y = start["X"] + given.get("I", 0), start["Y"] + given.get("J", 0)
            first, last = math.atan2(start["Y"] - y, start["X"] - x), math.atan2(end["Y"] - y, end["X"] - x)
            if self.lines[i][1] == "2":
                first, last = last, first
            if (last - first) % (2 * math.pi) > -first % (2 * math.pi):
                most = max(most, x + math.hypot(start["X"] - x, start["Y"] - y))
        return most

    def with_job(self, tag, change):
        setup = self.folder / f"{self.name}{tag}.toml"
        setup.write_text(change(self.job_text))
        return setup


@pytest.fixture(scope="module", params=sorted(JOBS))
def program(request, tmp_path_factory):
    return Program(request.param, tmp_path_factory.mktemp(request.param))


def each(items, body):
    """Runs body(number, item) for all items on two threads. Returns the failures."""
    with ThreadPoolExecutor(2) as pool:
        return [f for f in pool.map(lambda pair: body(*pair), enumerate(items)) if f]


def where(result, kind):
    return sorted(e["line"] for e in result["events"] if e["kind"] == kind)


def passes(result, kind):
    """Returns the lines of the passes with events of a kind. Each event names its worst line and the first and last
    line of its pass."""
    return {line for e in result["events"] if e["kind"] == kind for line in range(e["first_line"], e["last_line"] + 1)}


def only(result, kind):
    return result["code"] == 1 and {e["kind"] for e in result["events"]} == {kind}


def words(at, **changes):
    return " ".join(f"{letter}{number:.5f}" for letter, number in {**at, **changes}.items())


def dome(x, y, z):
    """The dome's formula."""
    plate = max(abs(x) - 20, abs(y) - 15, z + 4, -(z + 8))
    ball = math.sqrt((x + 8) ** 2 + y ** 2 + (z + 9) ** 2) - 9
    pocket = max(abs(x - 9) - 5, abs(y) - 8, -(z + 6.5))
    return max(min(plate, max(ball, -(z + 8))), -pocket)


def knob(x, y, z):
    """The knob's formula."""
    ball = max(math.sqrt(x * x + y * y + (z + 4) ** 2) - 9 - 0.4 * math.sin(x) * math.cos(y), -z - 2)
    return min(ball, max(abs(x) - 13, abs(y) - 13, abs(z + 3) - 3))


def depth_in_part(name, at):
    """Returns the depth in the part of a 4 mm ball at these axis values, from points on its surface."""
    tip, axis = np.array([at["X"], at["Y"], at["Z"]]), np.array([0.0, 0, 1])
    if name == "knob":  # the table rotates the workpiece by C, then by A
        a, c = math.radians(at.get("A", 0)), math.radians(at.get("C", 0))
        turned = np.array([[1, 0, 0], [0, math.cos(a), -math.sin(a)], [0, math.sin(a), math.cos(a)]]) @ np.array(
            [[math.cos(c), -math.sin(c), 0], [math.sin(c), math.cos(c), 0], [0, 0, 1]])
        tip, axis = turned.T @ tip, turned.T @ axis
    centre, deepest = tip + 2 * axis, 0
    for i in range(400):  # on a spiral around the ball
        z = 1 - 2 * (i + 0.5) / 400
        r, angle = math.sqrt(1 - z * z), 2.399963 * i
        deepest = max(deepest, -(knob if name == "knob" else dome)(
            *(centre + 2 * np.array([r * math.cos(angle), r * math.sin(angle), z]))))
    return deepest


def test_gouges_are_found_at_their_line(program):
    """A position of the finish is 0.4 mm too deep along the tool, wherever that reaches the part."""
    rng = random.Random(1)
    candidates = [i for i in program.feeds(2) if program.removed.get(i + 1, 0) > 0.02]
    candidates = [i for i in rng.sample(candidates, min(200, len(candidates)))
                  if depth_in_part(program.name, {**program.at[i], "Z": program.at[i]["Z"] - 0.4}) > 0.2]
    assert len(candidates) > 60

    def plant(number, i):
        lines = list(program.lines)
        lines[i] = f"G1 {words(program.at[i], Z=program.at[i]['Z'] - 0.4)}"
        lines[i + 1] = f"G1 {words(program.at[i + 1])}"
        result = program.simulate(lines, program.job, f"_g{number}")
        found = where(result, "gouge")
        # The tool leaves the gouge on the next line.
        if not only(result, "gouge") or not set(found) <= {i + 1, i + 2}:
            return f"line {i + 1} {lines[i]}: {result['events']}"
        return None

    failed = each(candidates[:sample_or_all(9, 36)], plant)
    assert not failed, f"{len(failed)}: {failed[:3]}"


def test_rapids_through_stock_are_found_at_their_line(program):
    rng = random.Random(2)
    # Without ridges thinner than a cell, which may lie between its points, and chips thinner than `touch`. Finer cells
    # show both by their volume.
    fine = {record["line"]: record["removed"]
            for record in program.simulate(program.lines, program.job, "_fine", cell=0.15)["lines"]}
    candidates = [i for i in program.feeds(1) + program.feeds(2)
                  if program.removed.get(i + 1, 0) > 1.5 and fine[i + 1] > 0.75 * program.removed[i + 1]]
    assert len(candidates) > 60

    def plant(number, i):
        lines = list(program.lines)
        lines[i] = "G0" + lines[i][2:]
        result = program.simulate(lines, program.job, f"_r{number}")
        return (None if only(result, "rapid contact") and where(result, "rapid contact") == [i + 1]
                else f"line {i + 1}: {result['events']}")

    failed = each(rng.sample(candidates, sample_or_all(9, 36)), plant)
    assert not failed, f"{len(failed)}: {failed[:3]}"


@pytest.mark.parametrize("program", ["dome"], indirect=True)
def test_missing_retracts_are_found(program):
    """Without a retract the next rapid crosses material. (With rotary axes, machine z is not a height.)"""
    candidates = [i for i in range(len(program.lines) - 1)
                  if re.fullmatch(r"G0 Z[\d.]+", program.lines[i]) and program.tool[i] == 1
                  and re.match(r"G0 X", program.lines[i + 1]) and program.at[i - 1].get("Z", 9) < -3]

    def plant(number, i):
        lines = list(program.lines)
        lines[i] = ""
        result = program.simulate(lines, program.job, f"_l{number}")
        if result["code"] == 0:  # the path was free by chance
            way = abs(program.at[i + 1]["X"] - program.at[i]["X"]) + abs(program.at[i + 1]["Y"] - program.at[i]["Y"])
            return None if way < 8 else f"line {i + 1}: nothing found"
        wrong = {e["kind"] for e in result["events"]} - {"rapid contact", "gouge"}
        return f"line {i + 1}: {result['events']}" if wrong or set(where(result, "rapid contact")) - {i + 2} else None

    failed = each(candidates[:12], plant)
    assert not failed, f"{len(failed)}: {failed[:3]}"


def test_short_flutes_are_found(program):
    """Flutes are shorter than the depth of cut: the shank meets material at every cut, and nowhere else."""
    flutes = [0.4 + 0.1 * k for k in range(12)]
    # Coarse cells miss chips at corners, of which a contact in part of a column may tell.
    fine = program.simulate(program.lines, program.job, "_fine", cell=0.1)
    removed = {record["line"]: record["removed"] for record in fine["lines"]}

    def plant(number, flute):
        setup = program.with_job(f"_s{number}", lambda text: text.replace("flute = 16", f"flute = {flute:.2f}"))
        result = program.simulate(program.lines, setup, f"_s{number}")
        lines = where(result, "shank contact")
        ok = (only(result, "shank contact")
              and all(program.tool[line - 1] == 1 and removed[line] > 0 for line in lines))
        return (None if ok
                else f"flute {flute}: {[e for e in result['events'] if e['kind'] != 'shank contact'][:3]} {len(lines)}")

    failed = each(flutes, plant)
    assert not failed, f"{len(failed)}: {failed[:3]}"


def test_holders_that_reach_the_stock_are_found(program):
    """The tool sticks out of its holder by less than the depth of the cuts."""
    lengths = [2.5 + 0.25 * k for k in range(12)]
    lowest = min(at["Z"] for at, tool in zip(program.at, program.tool) if tool == 1 and "Z" in at)
    top = {"dome": 0.5, "knob": 5.9}[program.name]  # of the stock, since the part's computed bounds have a margin

    def plant(number, length):
        setup = program.with_job(f"_h{number}", lambda text: text.replace(
            "flute = 16\nlength = 30", f"flute = {length}\nlength = {length}"))
        result = program.simulate(program.lines, setup, f"_h{number}")
        lines = where(result, "holder contact")
        if lowest + length > top + 0.2:
            return None if not result["events"] else f"length {length}: false alarm {result['events'][:2]}"
        ok = only(result, "holder contact") and all(program.tool[line - 1] == 1 for line in lines)
        low = all(min(program.at[line - 1]["Z"], program.at[line - 2].get("Z", 99)) + length < top + 0.2
                  for line in lines)
        return None if ok and low else f"length {length}: {result['events'][:3]}"

    failed = each(lengths, plant)
    assert not failed, f"{len(failed)}: {failed[:3]}"


def setup_of(program, extra):
    """Returns the job as a hand-written set-up, with additional tables."""
    low, high = ((-22, -17, -8), (22, 17, 0.5)) if program.name == "dome" else ((-15, -15, -6), (15, 15, 6))
    machine = JOBS[program.name][0]
    return f'cell = 0.25\nmachine = "{machine}"\n[stock]\nlower = {list(low)}\nupper = {list(high)}\n{TOOLS}{extra}'


def test_over_travel_is_found_at_its_lines(program):
    rng = random.Random(4)

    def plant(number, limit):
        setup = program.folder / f"{program.name}_o{number}.toml"
        setup.write_text(setup_of(program, f"[limits]\nx = [-1000, {limit}]\n"))
        result = program.simulate(program.lines, setup, f"_o{number}")
        moves = [i for i in range(1, len(program.at)) if re.match(r"(G53 )?G[0123] ", program.lines[i])]
        surely = {i + 1 for i in moves if program.furthest(i) > limit + 0.01}  # arcs are checked as chords
        maybe = {i + 1 for i in moves if program.furthest(i) > limit + 1e-6}
        found = passes(result, "over-travel")
        ends = {e[key] for e in result["events"] if e["kind"] == "over-travel"
                for key in ("line", "first_line", "last_line")}
        return (None if surely <= found and ends <= maybe and only(result, "over-travel")
                else f"{limit}: {surely - found} {ends - maybe}")

    reach = max(at.get("X", -99) for at in program.at)
    failed = each([round(reach - rng.uniform(0.1, 8), 2) for _ in range(8)], plant)
    assert not failed, f"{len(failed)}: {failed[:3]}"


@pytest.mark.parametrize("program", ["dome"], indirect=True)
def test_fixtures_in_the_way_are_found(program):
    """A clamp on the stock's edge: lines whose tool comes near it are reported, and no others. The same clamp outside
    the work area is no fault. Lines are chosen by x, which rotates in the other program."""

    def plant(number, inner):
        setup = program.folder / f"{program.name}_c{number}.toml"
        setup.write_text(setup_of(program, f"[fixture]\nlower = [{inner}, -5, -8]\nupper = [{inner + 10}, 5, 3]\n"))
        result = program.simulate(program.lines, setup, f"_c{number}")
        reach = max(at["X"] for i, at in enumerate(program.at)
                    if "X" in at and "Y" in at and abs(at["Y"]) < 8 and at.get("Z", 9) < 3)
        if inner > reach + 3.5:
            return None if not result["events"] else f"{inner}: false alarm {result['events'][:2]}"
        near = all(max(program.at[line - 1]["X"], program.at[line - 2].get("X", -99)) + 12.1 > inner
                   for line in where(result, "fixture contact"))
        return None if only(result, "fixture contact") and near else f"{inner}: {result['events'][:3]}"

    failed = each([16, 17, 18, 19, 20, 21, 30, 40], plant)
    assert not failed, f"{len(failed)}: {failed[:3]}"


def test_a_stopped_spindle_is_found(program):
    i = next(i for i, line in enumerate(program.lines) if line.startswith("S") and "M3" in line)
    lines = list(program.lines)
    lines[i] = "M5"
    result = program.simulate(lines, program.job, "_m5")
    passes = [(e["first_line"], e["last_line"]) for e in result["events"]]
    assert only(result, "spindle stopped") and sum(last - first + 1 for first, last in passes) > 20


def test_a_wrong_length_offset_is_found(program):
    """G43 with the other tool's longer offset raises the tool; with a shorter one the tool gouges."""
    i = next(i for i, line in enumerate(program.lines) if line == "G43 H2")
    lines = list(program.lines)
    lines[i] = "G43 H1"
    setup = program.with_job("_w", lambda text: text.replace("length = 30\nshank = 6", "length = 29.5\nshank = 6"))
    result = program.simulate(lines, setup, "_w")
    assert result["code"] == 1 and len(passes(result, "gouge")) > 50
    assert all(program.tool[line - 1] == 2 for line in passes(result, "gouge") if line - 1 < len(program.tool))


BOX = "lower = [-60, -30, -40]\nupper = [60, 30, 0]"
# Programs of LinuxCNC's five-axis machines: machine, stock, tools, moves, bounds of the removed mm3, greatest share of
# feed in air.
REAL = {
    "5ax_boat-xyzac": ("five_axis_ac", BOX, ((10, "flat"), (6, "ball")), 1832, (60e3, 70e3), 0.15),
    "5ax_boat-xyzbc": ("five_axis_bc", BOX, ((10, "flat"), (6, "ball")), 1821, (50e3, 60e3), 0.05),
    "5ax_impeller-7bl-xyzac": ("five_axis_ac", "cylinder = [0, 0, 32, 0, 35]", ((4, "ball"),), 4492, (20e3, 112e3),
                               0.6),
}


def open_edges(path):
    """Returns the number of edges of a binary STL that are not shared by two triangles in opposite directions."""
    records = np.fromfile(path, np.dtype([("normal", "<f4", 3), ("corner", "<f4", (3, 3)), ("rest", "<u2")]), offset=84)
    corners = records["corner"].reshape(-1, 3)
    assert len(corners)
    _, number = np.unique(corners, axis=0, return_inverse=True)
    triangles = number.reshape(-1, 3).astype(np.int64)
    starts, ends = triangles.reshape(-1), np.roll(triangles, -1, axis=1).reshape(-1)
    there, back = starts * len(corners) + ends, ends * len(corners) + starts
    return len(there) - len(np.unique(there)) + len(np.setdiff1d(there, back))


@pytest.mark.parametrize("name", sorted(REAL))
def test_linuxcnc_five_axis_programs_leave_closed_meshes(name, tmp_path):
    """Each program on its own kinematics. The stocks are larger than the authors': only rapids through stock are
    allowed."""
    machine, stock, tools, moves, removed, air = REAL[name]
    setup = tmp_path / "setup.toml"
    setup.write_text(f'cell = 0.5\nmachine = "{machine}"\n[stock]\n{stock}\n' + "".join(
        f'[[tool]]\nnumber = {n}\nshape = "{shape}"\ndiameter = {d}\nflute = 40\n'
        for n, (d, shape) in enumerate(tools, 1)))
    program = ROOT.parent / "shared" / "data" / "gcode" / f"{name}.ngc"
    done = run("simulate", program, "--setup", setup, "-o", tmp_path / "left.stl", "--report", tmp_path / "report.json")
    assert done.returncode in (0, 1), done.stderr
    report = json.loads((tmp_path / "report.json").read_text())
    assert {e["kind"] for e in report["events"]} <= {"rapid contact"}
    assert report["moves"] >= moves and removed[0] < report["removed"] < removed[1] and report["air_share"] < air, (
        done.stdout)
    assert open_edges(tmp_path / "left.stl") == 0


BAD = {
    "syntax": ("G1 X1 Y\n", ":1"),
    "loop": ("o1 while [1]\no1 endwhile\nM2\n", "no end"),
    "tool": ("T9 M6\nG0 X0 Y0 Z0\nM2\n", ":1: tool 9"),
    "axis": ("T1 M6\nG0 B30\nM2\n", ":2: it moves B"),
    "nan": ("T1 M6\nG0 X[0/0]\nM2\n", ":2"),
    "huge": ("T1 M6\nG1 X1e300 F100\nM2\n", ""),
}


@pytest.mark.parametrize("name", sorted(BAD))
def test_bad_programs_end_with_one_clear_line(name, tmp_path):
    text, wanted = BAD[name]
    program = tmp_path / "bad.nc"
    program.write_text(text)
    setup = tmp_path / "setup.toml"
    setup.write_text(f"cell = 0.5\n[stock]\nlower = [0, 0, 0]\nupper = [10, 10, 10]\n{TOOLS}")
    done = run("simulate", program, "--setup", setup, "-o", tmp_path / "out.stl")
    assert done.returncode in ((2,) if wanted else (0, 1, 2)), done
    if wanted:
        assert wanted in done.stderr and len(done.stderr.strip().splitlines()) == 1, done.stderr
        assert not (tmp_path / "out.stl").exists()


@pytest.mark.parametrize("text, wanted", [
    ("", "needs a [stock]"),
    ("[stock]\nlower = [0, 0, 0]\nupper = [0, 1, 1]\n", ":1: the stock has no size"),
    ("cel = 1\n[stock]\nlower = [0, 0, 0]\nupper = [1, 1, 1]\n", "cel"),
    ("cell = -1\n[stock]\nlower = [0, 0, 0]\nupper = [1, 1, 1]\n", ":1: cell must be above 0"),
    ("cell = 1e-9\n[stock]\nlower = [0, 0, 0]\nupper = [1, 1, 1]\n", "cells along an axis"),
    ("rules = \"XYZ\"\n[stock]\nlower = [0, 0, 0]\nupper = [1, 1, 1]\n", "XYZ"),
    ("[stock]\ncylinder = [0, 0, -1, 0, 1]\n", "cylinder"),
    ("[stock]\nmodel = \"none.stl\"\n", "none.stl"),
])
def test_bad_setups_end_with_one_clear_line(text, wanted, tmp_path):
    program = tmp_path / "p.nc"
    program.write_text("G0 X0\nM2\n")
    setup = tmp_path / "setup.toml"
    setup.write_text(text)
    done = run("simulate", program, "--setup", setup)
    assert done.returncode == 2 and wanted in done.stderr and len(done.stderr.strip().splitlines()) == 1, done.stderr


def test_python_cuts_a_stock():
    import fieldfab as ff

    stock = ff.stock.Stock([0, 0, -5, 20, 20, 0], cell=0.25)
    before = stock.copy()
    removed = stock.cut({"shape": "flat", "diameter": 4, "flute": 10},
                        np.array([[-5, 10, -2], [25, 10, -2.0], [25, 10, 5]]))
    assert removed.shape == (2,) and abs(removed[0] - 20 * 4 * 2) < 12 and removed[1] == 0
    assert abs(before.volume - 2000) < 1e-6 and abs(stock.mesh().volume - (2000 - 160)) < 5
    leaning = np.array([[10, 10, -4, 1, 0, 2], [12, 10, -4, 1, 0, 2.0]])
    assert stock.cut({"shape": "ball", "diameter": 6, "flute": 20}, leaning)[0] > 5
    with pytest.raises(ff.Error, match="it has no \"size\""):
        stock.cut({"size": 4}, leaning)


def test_python_simulates(program):
    import fieldfab as ff

    path = program.folder / f"{program.name}.ngc"
    simulation = ff.stock.Simulation(program.job, path, cell=0.4)
    assert simulation.good and simulation.report["events"] == [] and simulation.report["lines"]
    assert len(simulation.deviation) == len(simulation.lines_of_vertices) == len(simulation.mesh.vertices)
    assert -0.05 < simulation.deviation.min() < 0.01
    with pytest.raises(ff.Error):
        ff.stock.Simulation(program.job, path, progress=lambda fraction, message: False)


def test_python_shows_any_moment(program, tmp_path):
    """The stock after half of the lines equals the result of half of the program. Only cut parts of the surface
    change."""
    import fieldfab as ff

    path = program.folder / f"{program.name}.ngc"
    simulation = ff.stock.Simulation(program.job, path, cell=0.4, remember=True)
    playback = simulation.playback
    assert len(playback) == len(playback.lines) == len(playback.seconds) and (np.diff(playback.seconds) >= 0).all()
    half = len(program.lines) // 2
    done = playback.done_after_line(half)
    (tmp_path / "half.ngc").write_text("\n".join(program.lines[:half]) + "\n")
    ended = ff.stock.Simulation(program.job, tmp_path / "half.ngc", cell=0.4)
    assert abs(playback.stock_after(done).volume - ended.stock.volume) < 1e-3
    assert playback.poses(done - 1).shape[1] == 6 and playback.lines[done - 1] <= half
    surface = ff.stock.Surface()
    assert len(surface.update(playback.stock_after(done))) == len(surface)
    changed = surface.update(playback.stock_after(done + 20))
    assert 0 < len(changed) < len(surface) or len(surface) < 8
    mesh, at_once = surface.mesh(), playback.stock_after(done + 20).mesh(sharp=False)
    assert ((np.asarray(mesh.triangles) == np.asarray(at_once.triangles)).all()
            and (np.asarray(mesh.vertices) == np.asarray(at_once.vertices)).all())
    assert len(mesh.triangles) <= sum(len(surface.piece(i).triangles) for i in range(len(surface)))
    assert surface.update(playback.stock_after(done + 20)) == []
    assert ended.playback is None


def test_frames_for_videos(program, tmp_path):
    """Pictures have one size. The first shows a tool and nearly the whole stock, the last one the final stock."""
    import fieldfab as ff

    setup, path = program.job, program.folder / f"{program.name}.ngc"
    done = run("simulate", path, "--setup", setup, "--cell", 0.4, "--frames", tmp_path / "frames", "--frame-count", 3,
               "--size", 160)
    assert done.returncode == 0, done.stderr
    frames = sorted((tmp_path / "frames").iterdir())
    assert [f.name for f in frames] == ["frame_0001.png", "frame_0002.png", "frame_0003.png"]
    sizes = {struct.unpack(">II", f.read_bytes()[16:24]) for f in frames}
    assert len(sizes) == 1 and max(sizes.pop()) == 160
    assert len({f.read_bytes() for f in frames}) == 3
    bad = run("simulate", path, "--setup", setup, "--frames", setup)
    assert bad.returncode != 0 and len(bad.stderr.strip().splitlines()) == 1 and str(setup) in bad.stderr
    with pytest.raises(ff.Error, match="nothing moved"):
        ff.stock.Simulation(setup, path, cell=0.8).frames(tmp_path / "none")


def test_the_slotted_ball_ends_as_it_should(tmp_path):
    """40,000 moves of both rotary axes, overhangs and inclined slots: no contact, and deviations of at most 0.05 mm."""
    made = subprocess.run(["/usr/bin/python3", str(ROOT / "examples/simulation/slotted_ball.py"), str(tmp_path),
                           "40000"], capture_output=True, text=True)
    assert made.returncode == 0, made.stderr
    report = tmp_path / "report.json"
    done = run("simulate", tmp_path / "slotted_ball.ngc", "--setup", tmp_path / "slotted_ball.toml", "--cell", 0.5,
               "--report", report)
    result = json.loads(report.read_text())
    assert done.returncode == 0 and result["moves"] > 40_000 and not result["events"], done.stderr
    assert result["deviation"]["deepest_gouge"] < 0.05 and result["deviation"]["highest_excess"] < 0.05


def test_reports_are_the_same_for_any_number_of_threads(program):
    reports = []
    for threads in (1, 2, 2, 3):
        report = program.folder / f"threads{len(reports)}.json"
        lines = list(program.lines)
        i = next(i for i in program.feeds(1) if program.removed.get(i + 1, 0) > 5)
        lines[i] = "G0" + lines[i][2:]
        (program.folder / "threads.nc").write_text("\n".join(lines))
        run("simulate", program.folder / "threads.nc", "--setup", program.job, "--report", report, "--threads", threads)
        reports.append(report.read_text())
    assert len(set(reports)) == 1


HARMLESS = (
    "%\nO1000\nG0 G80 G40 G90 G54\nT1 M6\nS1000 M3 M8\nG187 P2\nG0 X-8 Y5 Z5\nG1 Z-1 F300\nG1 X28\nG0 Z5\nM30\n%\n")
BLOCK = "cell = 0.5\n[stock]\nlower = [0, 0, -5]\nupper = [20, 10, 0]\n[[tool]]\nnumber = 1\ndiameter = 4\nflute = 8\n"


def test_python_takes_dialects_and_several_programs(tmp_path):
    """A Fanuc header is refused in LinuxCNC's dialect. The second of two programs continues with the stock of the
    first."""
    import fieldfab as ff
    setup, first, second = tmp_path / "setup.toml", tmp_path / "first.nc", tmp_path / "second.nc"
    setup.write_text('programs = ["first.nc", "second.nc"]\n' + BLOCK)
    first.write_text(HARMLESS)
    second.write_text(HARMLESS.replace("Z-1", "Z-2"))
    with pytest.raises(ff.Error, match="first.nc:"):
        ff.stock.Simulation(setup, first)
    with pytest.raises(ff.Error, match="dialect is 'fanucc'"):
        ff.stock.Simulation(setup, first, dialect="fanucc")
    one = ff.stock.Simulation(setup, first, dialect="fanuc")
    both = ff.stock.Simulation(setup, [first, second], dialect="fanuc")
    assert both.good and both.report["removed"] == pytest.approx(2 * one.report["removed"], rel=0.02)
    assert [pathlib.Path(p).name for p in both.report["programs"]] == ["first.nc", "second.nc"]
    assert {line["program"] for line in both.report["lines"]} == {0, 1}
    named = ff.stock.Simulation(setup, dialect="fanuc")
    assert named.report["removed"] == both.report["removed"]


def test_the_command_carries_out_what_the_set_up_names(tmp_path):
    (tmp_path / "first.nc").write_text(HARMLESS)
    (tmp_path / "second.nc").write_text(HARMLESS.replace("G1 X28", "G0 X28"))
    (tmp_path / "setup.toml").write_text('dialect = "fanuc"\nprograms = ["first.nc", "second.nc"]\n' + BLOCK)
    (tmp_path / "none.toml").write_text(BLOCK)
    report = tmp_path / "report.json"
    done = subprocess.run([COMMAND, "simulate", "--setup", tmp_path / "setup.toml", "--report", report, "--report",
                           tmp_path / "page.html"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    told = json.loads(report.read_text())
    assert [pathlib.Path(p).name for p in told["programs"]] == ["first.nc", "second.nc"] and told["good"]
    assert "Simulation of first.nc, second.nc" in (tmp_path / "page.html").read_text()
    (tmp_path / "second.nc").write_text(HARMLESS.replace("G1 Z-1 F300\nG1 X28", "G0 Z-2\nG0 X28"))
    done = subprocess.run([COMMAND, "simulate", "--setup", tmp_path / "setup.toml", "--report", report],
                          capture_output=True, text=True)
    assert done.returncode == 1 and "second.nc:9: rapid contact" in done.stderr
    event = json.loads(report.read_text())["events"][0]
    assert event["program"] == 1 and event["first_line"] <= event["line"] <= event["last_line"]
    done = subprocess.run([COMMAND, "simulate", "--setup", tmp_path / "none.toml"], capture_output=True, text=True)
    assert done.returncode == 2 and "names a program" in done.stderr
