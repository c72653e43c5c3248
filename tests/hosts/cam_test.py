"""Jobs through the command and through Python, with LinuxCNC's interpreter as the oracle."""

import json
import math
import re
import subprocess

import numpy as np
import pytest
from conftest import COMMAND

import fieldfab as ff
import rs274

PART = "max(max(abs(x)-20, abs(y)-15), 6 - sqrt((x-3)*(x-3)+y*y))"
DOME = "max(sqrt(x*x+y*y+(z+8)*(z+8)) - 14, max(abs(x)-12, max(abs(y)-10, -z-2)))"


def job(folder, text, **files):
    for name, content in files.items():
        (folder / name.replace("_", ".")).write_text(content)
    path = folder / "job.toml"
    path.write_text(text)
    return path


def run(*arguments, check=True):
    done = subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True, timeout=300)
    if check:
        assert done.returncode == 0, done.stderr
    return done


def compare(path_to_program, moves, **keywords):
    """Asserts that LinuxCNC's canonical moves equal ours to 1e-4 mm: end points, and centres of arcs."""
    ours = np.vstack(moves)
    written = [[f"{v:.5f}" for v in move[:3]] for move in ours]  # moves of length 0 are not written
    keep = [i for i in range(len(ours)) if i == 0 or written[i] != written[i - 1] or ours[i, 4] != 0]
    theirs, kinds, centres = rs274.moves_of_program(path_to_program, **keywords)
    ours = ours[keep]
    # rs274 ends at the program's last move; it rounds to four decimals.
    assert len(theirs) == len(ours)
    assert np.abs(theirs[:, :3] - ours[:, :3]).max() <= 1e-4
    assert [k == "STRAIGHT_TRAVERSE" for k in kinds] == [f == 0 for f in ours[:, 3]]
    for i in range(1, len(ours)):
        bulge = ours[i, 4]
        assert (kinds[i] == "ARC_FEED") == (bulge != 0)
        if bulge:
            a, b = ours[i - 1, :2], ours[i, :2]
            across = np.array([-(b - a)[1], (b - a)[0]])
            centre = (a + b) / 2 + (1 - bulge**2) / (4 * bulge) * across
            radius = math.dist(a, centre)
            assert math.dist(centres[i, :2], centre) <= 1e-4 * max(1, radius / 10)
            assert np.sign(centres[i, 2]) == np.sign(bulge)


def moves_of(path, machine):
    """A control that follows the tip goes to the first place in one move: its program begins with a safe transfer."""
    read = rs274.moves if machine == "five_axis_tcp" else rs274.moves_of_program
    return read(path, tools=((1, 0, 4),))


FLAT = """
machine = "linuxcnc"
[input]
model = "part.frep"
[stock]
thickness = 4
[[tool]]
diameter = 3
"""

SOLID = """
machine = "linuxcnc"
[input]
model = "part.frep"
[stock]
margin = 2
[[tool]]
number = 1
shape = "ball"
diameter = 4
[[tool]]
number = 2
diameter = 6
"""


@pytest.mark.parametrize(
    "operation",
    [
        'type = "profile"\ntabs = 3\nstepdown = 1.5',
        'type = "profile"\nside = "inside"\nentry = "ramp"\nclimb = false',
        'type = "pocket"\nstepdown = 2\nentry = "helix"',
        'type = "pocket"\nside = "outside"\ndepth = 1',
        'type = "pocket"\npattern = "adaptive"\nstepover = 0.2\nstepdown = 2\nlink_feed = 2000',
        'type = "isolate"\noffsets = 3',
    ],
)
def test_flat_programs_are_what_linuxcnc_reads(tmp_path, operation):
    path = job(tmp_path, FLAT + "[[operation]]\n" + operation, part_frep=PART)
    done = json.loads(run("--json", "cam", path, "-o", tmp_path / "out.ngc").stdout)
    assert done["cut"] > 50 and done["seconds"] > 5
    planned = ff.cam.Job(path)
    planned.run()
    compare(tmp_path / "out.ngc", planned.moves)


@pytest.mark.parametrize(
    "operation",
    [
        'type = "rough"\ntool = 2\nstepdown = 3',
        'type = "rough"\ntool = 2\nstepdown = 6\npattern = "adaptive"\nstepover = 0.25',
        'type = "finish"\ntool = 1\nstepover = 0.2',
        'type = "finish"\ntool = 1\npattern = "spiral"\nstepover = 0.3',
        'type = "finish"\ntool = 1\npattern = "cross"\nangle = 30\nscallop = 0.1',
        'type = "waterline"\ntool = 1\nstepdown = 1',
        'type = "pencil"\ntool = 1',
    ],
)
def test_solid_programs_are_what_linuxcnc_reads(tmp_path, operation):
    path = job(tmp_path, SOLID + "[[operation]]\n" + operation, part_frep=DOME)
    run("cam", path, "-o", tmp_path / "out.ngc")
    planned = ff.cam.Job(path)
    planned.run()
    compare(tmp_path / "out.ngc", planned.moves, tools=((1, 0.0, 4.0), (2, 0.0, 6.0)))


@pytest.mark.parametrize(
    "text, line, words",
    [
        ('machine = "linuxcn"', 1, "did you mean 'linuxcnc'"),
        ('machine = "linuxcnc"\nmatter = 1', 2, "matter"),
        ('machine = "linuxcnc"\n[input]\nmodel = "part.frep"\nscales = 2', 4, "did you mean 'scale'"),
        (FLAT + '[[operation]]\ntype = "pokcet"', 10, "did you mean 'pocket'"),
        (FLAT + '[[operation]]\ntype = "pocket"\nstepovr = 0.3', 11, "did you mean 'stepover'"),
        (FLAT + '[[operation]]\ntype = "pocket"\nstepover = 0', 11, "above 0"),
        (FLAT + '[[operation]]\ntype = "pocket"\ntool = 7', 11, "no [[tool]] with number 7"),
        (FLAT + '[[operation]]\ntype = "pocket"\nstepover = "wide"', 11, "must be a number"),
        (FLAT.replace("diameter = 3", "diameter = 60") + '[[operation]]\ntype = "pocket"', 10, "fits into no pocket"),
        (FLAT.replace("diameter = 3", "diameter = 3\nlength = 2") + '[[operation]]\ntype = "profile"', 11,
         "the holder of tool 1 meets material"),
        (FLAT.replace("linuxcnc", "modela") + '[[operation]]\ntype = "profile"', 2, "knows no places below 0"),
        (FLAT.replace("linuxcnc", "othermill").replace('"part.frep"', '"part.frep"\nscale = 4')
         + '[[operation]]\ntype = "profile"', 2, "can move 140 mm along x"),
        (FLAT.replace("diameter = 3", "diameter = -3") + '[[operation]]\ntype = "profile"', 8, "diameter"),
        (FLAT + '[[operation]]\ntype = "finish"', 10, "flat"),
        (FLAT + '[[operation]]\ntype = "v_carve"', 10, "shape v"),
        (FLAT, 1, "operation"),
        ("machine = ", 1, ""),
        (FLAT.replace("part.frep", "nothing.frep") + '[[operation]]\ntype = "profile"', None, "nothing.frep"),
    ],
)
def test_bad_jobs_are_refused_with_their_line(tmp_path, text, line, words):
    path = job(tmp_path, text, part_frep=PART)
    out = tmp_path / "out.ngc"
    out.write_text("old")
    done = run("cam", path, "-o", out, check=False)
    assert done.returncode == 2, done.stderr
    assert len(done.stderr.strip().splitlines()) == 1
    assert words in done.stderr
    if line:
        assert f"job.toml:{line}:" in done.stderr
    assert out.read_text() == "old"


def test_tools_that_are_too_short_back_out_and_say_so(tmp_path):
    short = FLAT.replace("diameter = 3", "diameter = 3\nflute = 2") + '[[operation]]\ntype = "profile"'
    path = job(tmp_path, short, part_frep=PART)
    done = run("cam", path, "-o", tmp_path / "out.ngc", "--sheet", tmp_path / "sheet.html")
    assert "1 profile: tool 1 is too short with flutes of 2 mm" in done.stderr
    assert "is too short with flutes of 2 mm" in (tmp_path / "sheet.html").read_text()
    assert "nothing is wrong" in run("simulate", tmp_path / "out.ngc", "--setup", path).stdout


def test_the_plan_shows_stages_and_where_settings_come_from(tmp_path):
    path = job(tmp_path, FLAT + '[[operation]]\ntype = "pocket"\nstepdown = 2', part_frep=PART)
    plan = run("cam", path, "--plan").stdout
    assert "solid -> [outline] -> outline -> [pocket] -> paths" in plan
    assert "stepdown           2              job" in plan
    assert "stepover           0.4            default" in plan


MACHINES = sorted(ff.cam.machines())
LASERS = {"epilog", "universal", "trotec", "gcc_laser", "oxford", "roland_vinyl", "gcc_vinyl", "hpgl", "dxf", "svg"}


def test_all_machines_of_kokopelli_and_the_fab_modules_are_there():
    for name in ["epilog", "universal", "gcc_laser", "trotec", "modela", "imodela", "mdx40", "roland_vinyl",
                 "gcc_vinyl", "oxford", "othermill"]:
        assert name in MACHINES
    for name in ["shopbot", "shopbot_mm", "shopbot5", "linuxcnc", "grbl", "mach3", "marlin", "hpgl", "dxf", "svg",
                 "png", "stl", "srm20"]:
        assert name in MACHINES
    for name in ["five_axis_ac", "five_axis_bc", "five_axis_tcp", "five_axis_head", "five_axis_mixed"]:
        assert name in MACHINES


@pytest.mark.parametrize("machine", [m for m in MACHINES if m not in ("png", "stl")])
def test_every_machine_writes_the_same_part(tmp_path, machine):
    """Every file has the same number of moves, and the size of the part in the machine's units."""

    flat = machine in LASERS
    text = FLAT.replace("linuxcnc", machine).replace('"part.frep"', '"part.frep"\nzero = "corner"')
    if flat:
        text = text.replace("[[tool]]\ndiameter = 3\n", "")
    path = job(tmp_path, text + '[[operation]]\ntype = "profile"\nside = "on"\n', part_frep=PART)
    run("cam", path, "-o", tmp_path / "out")
    data = (tmp_path / "out").read_bytes().decode("latin-1")
    unit = {"epilog": 25.4 / 600, "universal": 0.0254, "trotec": 0.005, "gcc_laser": 0.1, "shopbot": 25.4,
            "shopbot5": 25.4, "gcode_inch": 25.4,
            "modela": 0.025, "imodela": 0.01, "mdx40": 0.01, "srm20": 0.01, "roland_vinyl": 0.025, "gcc_vinyl": 0.025,
            "hpgl": 0.025}.get(machine, 1)
    if machine == "dxf":
        points = re.findall(r"VERTEX\n8\n0\n10\n(\S+)\n20\n(\S+)", data)
    elif machine == "svg":
        points = re.findall(r"[ML](\S+?) (\S+?)(?=[MLAZ\"])", data)
    elif (".ngc" in machine or machine.startswith("five")
          or "X" in data and machine in ("linuxcnc", "grbl", "mach3", "marlin", "gcode_inch", "othermill", "oxford")):
        xs, ys = re.findall(r"X(-?[\d.]+)", data), re.findall(r"Y(-?[\d.]+)", data)
        points = [(x, ys[0]) for x in xs] + [(xs[0], y) for y in ys if machine != "oxford" or y != "0"]
    else:
        points = re.findall(r"(?:P[UDA]|Z|[JM][35],)(-?[\d.]+),(-?[\d.]+)", data)
        points = [p for p in points if p != ("0", "0") or machine not in LASERS]
    x = np.array([float(a) for a, _ in points]) * unit
    y = np.array([float(b) for _, b in points]) * unit
    assert abs(np.ptp(x) - 40) < 2 * unit * 0.02 + 0.1, (np.ptp(x), data[:300])
    assert abs(np.ptp(y) - 30) < 2 * unit * 0.02 + 0.1


def test_zero_is_a_point_of_the_model(tmp_path):
    """A point given for the zero gives the same program as a corner that lies there; the model may be turned."""
    texts = []
    for zero in ('"corner"', "[-15, -20, 5]"):
        job_text = FLAT.replace('"part.frep"', f'"part.frep"\nrotate = [0, 0, 90]\nzero = {zero}')
        path = job(tmp_path, job_text + '[[operation]]\ntype = "profile"\n', part_frep="box(40, 30, 10)")
        run("cam", path, "-o", tmp_path / "out.ngc")
        texts.append(numbers_of((tmp_path / "out.ngc").read_text()))
    assert len(texts[0]) > 10 and texts[0] == pytest.approx(texts[1], abs=0.01)
    path = job(tmp_path, FLAT.replace('"part.frep"', '"part.frep"\nzero = [1, 2]'), part_frep=PART)
    assert "zero has too few numbers" in run("cam", path, "-o", tmp_path / "never", check=False).stderr


def numbers_of(program):
    """Returns the coordinates of a G-code program in order."""
    return [float(n) for n in re.findall(r"[XYZ](-?[\d.]+)", program)]


def test_a_machine_is_one_file(tmp_path):
    """docs/machines.md promises a machine in ten minutes. This is a complete one, with a unit, a template and a
    material."""
    (tmp_path / "mine.toml").write_text(
        'name = "My foam cutter"\nextension = ".foam"\ntick = 0.1\ntakes = "flat paths"\n'
        'default_operation = "profile"\nnegative = false\n'
        '[setting]\nheat = { default = 10, min = 0, max = 20, unit = "W", help = "of the wire" }\n'
        'kerf = { default = 1, min = 0, unit = "mm" }\n'
        "[material.foam]\nheat = 12\n"
        '[text]\nheader = "HEAT {heat}\\n"\nrapid = "GO {x} {y}\\n"\nline = "CUT {x} {y}\\n"\nfooter = "OFF\\n"\n'
    )
    path = job(tmp_path, 'machine = "mine.toml"\nmaterial = "foam"\n[input]\nmodel = "part.frep"\nmove = [25, 20, 0]\n'
               '[stock]\nthickness = 9\n', part_frep=PART)
    run("cam", path, "-o", tmp_path / "out.foam")
    lines = (tmp_path / "out.foam").read_text().splitlines()
    assert lines[0] == "HEAT 12" and lines[-1] == "OFF"
    x = [int(line.split()[1]) for line in lines[1:-1]]
    assert max(x) - min(x) == 410  # 40 mm and the kerf, in tenths of a millimetre
    path.write_text(path.read_text() + "[setting]\nheat = 21\n")
    assert "at most 20 W" in run("cam", path, "-o", tmp_path / "out.foam", check=False).stderr
    path.write_text(path.read_text().replace("heat = 21", "heet = 1"))
    assert "did you mean 'heat'" in run("cam", path, "-o", tmp_path / "out.foam", check=False).stderr


def test_height_maps_and_meshes_are_machines_too(tmp_path):
    for machine, start in [("png", b"\x89PNG"), ("stl", b"")]:
        path = job(tmp_path, f'machine = "{machine}"\n[input]\nmodel = "part.frep"\n', part_frep=DOME)
        out = tmp_path / ("out." + machine)
        run("cam", path, "-o", out)
        assert out.read_bytes().startswith(start) and out.stat().st_size > 1000
    assert ff.Mesh.load(tmp_path / "out.stl").volume == pytest.approx(
        ff.mesh(ff.parse(DOME), voxel=0.1).volume, rel=0.01)


def test_pictures_and_set_up_sheets(tmp_path):
    path = job(tmp_path, FLAT + '[[operation]]\ntype = "pocket"\nname = "clear <all>"\n', part_frep=PART)
    run("cam", path, "-o", tmp_path / "o.ngc", "--picture", tmp_path / "a.png", "--picture", tmp_path / "a.svg",
        "--sheet", tmp_path / "s.html")
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")
    svg = (tmp_path / "a.svg").read_text()
    assert svg.count("#e12828") >= 1 and svg.count("<path") > 10
    sheet = (tmp_path / "s.html").read_text()
    assert "clear &lt;all&gt;" in sheet and "3 mm flat" in sheet and "<svg" in sheet
    assert run("cam", path, "-o", tmp_path / "o.ngc", "--picture", tmp_path / "a.bmp", check=False).returncode == 2


def test_images_are_machined(tmp_path):
    """A bitmap with a physical size: a board of 20 x 10 mm; its isolation is the offset rectangle."""
    pixels = np.zeros((150, 250), np.uint8)
    pixels[25:125, 25:225] = 255
    import struct
    import zlib

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    raw = b"".join(b"\0" + row.tobytes() for row in pixels)
    (tmp_path / "board.png").write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 250, 150, 8, 0, 0, 0, 0))
        + chunk(b"pHYs", struct.pack(">IIB", 10000, 10000, 1))
        + chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b"")
    )
    path = tmp_path / "job.toml"
    path.write_text('machine = "linuxcnc"\n[input]\nimage = "board.png"\n[[tool]]\ndiameter = 0.4\n[[operation]]\n'
                    'type = "isolate"\noffsets = 1\ndepth = 0.1\n')
    run("cam", path, "-o", tmp_path / "o.ngc")
    at, kinds, _ = rs274.moves_of_program(tmp_path / "o.ngc", tools=((1, 0, 0.4),))
    cut = at[at[:, 2] < 0]
    assert np.ptp(cut[:, 0]) == pytest.approx(20.4, abs=0.02) and np.ptp(cut[:, 1]) == pytest.approx(10.4, abs=0.02)


BLOCK = "max(max(max(abs(x)-9,max(abs(y)-7,abs(z)-6)), 3-sqrt(x*x+z*z)), 2-sqrt((y-7)*(y-7)+(z-6)*(z-6)))"
FIVE = """
machine = "MACHINE"
[input]
model = "part.frep"
[stock]
margin = 1
top = 1
[[tool]]
shape = "ball"
diameter = 4
length = 40
[[operation]]
type = "finish"
plane = "PLANE"
stepover = 0.5
"""


def turn(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return {"x": np.array([[1, 0, 0], [0, c, -s], [0, s, c]]), "y": np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]),
            "z": np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])}[axis]


def tip_and_axis(machine, x, y, z, a, b, c, length):
    """Returns the tip in workpiece coordinates and the tool's direction, from axis values. Derived from the axes'
    geometry, independently of the library."""
    p, up = np.array([x, y, z]), np.array([0.0, 0, 1])
    if machine == "five_axis_ac":  # A tilts the trunnion about x; C turns the plate on it
        work = turn("x", a) @ turn("z", c)
        return work.T @ p, work.T @ up
    if machine == "five_axis_bc":
        work = turn("y", b) @ turn("z", c)
        return work.T @ p, work.T @ up
    if machine == "five_axis_tcp":
        work = turn("x", a) @ turn("z", c)
        return p, work.T @ up
    if machine == "five_axis_head":  # C carries B; x, y, z move the pivot; zero is the tip of a vertical tool
        axis = turn("z", c) @ turn("y", b) @ up
        return p + (150 + length) * (up - axis), axis
    if machine == "five_axis_mixed":
        head, plate = turn("y", b) @ up, turn("z", c)
        return plate.T @ (p + (150 + length) * (up - head)), plate.T @ head
    raise KeyError(machine)


@pytest.mark.parametrize("plane", ["five", "stepped"])
@pytest.mark.parametrize("machine",
                         ["five_axis_ac", "five_axis_bc", "five_axis_tcp", "five_axis_head", "five_axis_mixed"])
def test_five_axis_programs_put_the_tip_where_it_was_planned(tmp_path, machine, plane):
    path = job(tmp_path, FIVE.replace("MACHINE", machine).replace("PLANE", plane), part_frep=BLOCK)
    run("cam", path, "-o", tmp_path / "out.ngc")
    text = "".join(line for line in open(tmp_path / "out.ngc") if not line.startswith("M42"))  # rs274 lacks M428
    (tmp_path / "out.ngc").write_text(text)
    planned = ff.cam.Job(path)
    planned.run()
    ours = np.vstack(planned.moves)
    keep = [0]
    for i in range(1, len(ours)):
        if np.abs(ours[i, [0, 1, 2, 5, 6, 7]] - ours[keep[-1]][[0, 1, 2, 5, 6, 7]]).max() > 1e-5:
            keep.append(i)
    ours = ours[keep]
    theirs, kinds, _ = moves_of(tmp_path / "out.ngc", machine)
    assert len(theirs) == len(ours)
    for row, planned_row in zip(theirs, ours):
        tip, axis = tip_and_axis(machine, *row, length=40)
        assert np.abs(axis - planned_row[5:8]).max() < 2e-5
        # Four decimals of a degree, times the distance from the pivot.
        bound = 6e-4 if machine in ("five_axis_head", "five_axis_mixed") else 3e-4
        assert np.abs(tip - planned_row[:3]).max() < bound
    assert len({tuple(np.round(a, 3)) for a in ours[:, 5:8]}) >= 5


@pytest.mark.parametrize("machine",
                         ["five_axis_ac", "five_axis_bc", "five_axis_tcp", "five_axis_head", "five_axis_mixed"])
def test_a_leaning_tool_stays_on_its_way_between_poses(tmp_path, machine):
    """All axes move linearly from line to line; the resulting tip stays on the planned path."""
    text = FIVE.replace("MACHINE", machine).replace('plane = "PLANE"', "lean = true\nfeed = 500")
    path = job(tmp_path, text.replace("stepover = 0.5", "stepover = 0.4"), part_frep=DOME)
    run("cam", path, "-o", tmp_path / "out.ngc")
    program = "".join(line for line in open(tmp_path / "out.ngc") if not line.startswith("M42"))
    (tmp_path / "out.ngc").write_text(program)
    planned = ff.cam.Job(path)
    planned.run()
    ours = np.vstack(planned.moves)
    theirs, kinds, _ = moves_of(tmp_path / "out.ngc", machine)
    poses = [tip_and_axis(machine, *row, length=40) for row in theirs]
    at, leaning = 0, 0
    for i, (tip, axis) in enumerate(poses):
        # The planned move that contains this one.
        while at + 1 < len(ours) and np.abs(ours[at, :3] - tip).max() + np.abs(ours[at, 5:8] - axis).max() > 2e-3:
            a, b = ours[at - 1, :3], ours[at, :3]
            share = np.clip((tip - a) @ (b - a) / max((b - a) @ (b - a), 1e-12), 0, 1)
            if at > 0 and np.linalg.norm(a + share * (b - a) - tip) < 8e-3 and ours[at, 3] > 0:
                break
            at += 1
        assert at + 1 < len(ours) or np.abs(ours[at, :3] - tip).max() < 2e-3
        if i == 0 or kinds[i] == "STRAIGHT_TRAVERSE":
            continue
        leaning += axis[2] < 0.98
        if machine == "five_axis_tcp":
            continue  # the control keeps the tip on its path
        a, b = poses[i - 1][0], tip
        for share in (0.2, 0.4, 0.6, 0.8):
            between, _ = tip_and_axis(machine, *(theirs[i - 1] + share * (theirs[i] - theirs[i - 1])), length=40)
            along = np.clip((between - a) @ (b - a) / max((b - a) @ (b - a), 1e-12), 0, 1)
            assert np.linalg.norm(a + along * (b - a) - between) < 7e-3
    assert leaning > 500


def test_the_shopbot_turns_its_head_as_in_the_thesis(tmp_path):
    """Algorithm 6.1 and the pivot of 6.9: tip = pivot - (gauge + bit) * axis. B tilts, A turns by the smaller of two
    angles."""
    path = job(tmp_path, FIVE.replace("MACHINE", "shopbot5").replace("PLANE", "five"), part_frep=BLOCK)
    run("cam", path, "-o", tmp_path / "out.sbp")
    lines = [line.strip().split(",") for line in open(tmp_path / "out.sbp") if line.startswith("M5")]
    arm = 6.787 * 25.4 + 40
    planned = ff.cam.Job(path)
    planned.run()
    ours = np.vstack(planned.moves)
    x = y = z = a = b = 0.0
    tips = []
    for line in lines:
        n = [float(v) if v else None for v in line[1:]]
        x, y, z = [25.4 * v if v is not None else old for v, old in zip(n[:3], (x, y, z))]
        a, b = n[3], n[4]
        assert abs(a) <= 90.001
        axis = turn("z", a) @ turn("y", b) @ np.array([0.0, 0, 1])
        tips.append(np.array([x, y, z]) - arm * (axis - np.array([0, 0, 1])))
    tips = np.array(tips[1:])
    nearest = [np.abs(tips - row[:3]).max(axis=1).min() for row in ours[:: max(1, len(ours) // 300)]]
    assert max(nearest) < 1e-3
    text = open(tmp_path / "out.sbp").read()
    for plane in ("top", "back", "front", "left", "right"):
        assert f"({plane})" in text or f" {plane} " in text
    # Between planes the head is upright.
    assert text.count("M5,,,,0,0") >= 4


def test_a_smaller_tool_finishes_the_rest(tmp_path):
    """Rest machining cuts around the foot of the dome, out of reach of the larger ball. It requires an earlier
    operation."""
    dome = "min(max(sqrt(x*x+y*y+(z+4)*(z+4)) - 10, -z-2), max(abs(x)-15, max(abs(y)-12, abs(z+1)-1)))"
    rest = '[[operation]]\ntype = "finish"\ntool = 2\nrest = true\n'
    text = SOLID.replace("diameter = 4", "diameter = 6").replace(
        "number = 2\ndiameter = 6", 'number = 2\nshape = "ball"\ndiameter = 2')
    path = job(tmp_path, text + '[[operation]]\ntype = "finish"\ntool = 1\n' + rest, part_frep=dome)
    planned = ff.cam.Job(path)
    planned.run()
    whole, moves = planned.moves
    cut = moves[moves[:, 3] > 0]
    # Neither on the dome's top nor far out on the plate.
    away = np.hypot(cut[:, 0], cut[:, 1])
    inside = (np.abs(cut[:, 0]) < 14) & (np.abs(cut[:, 1]) < 11)
    assert ((away[inside] > 7.5) & (away[inside] < 12.5)).mean() > 0.99
    assert len(cut) > 300
    path = job(tmp_path, text + rest, part_frep=dome)
    failed = run("cam", path, "-o", tmp_path / "o", check=False)
    assert failed.returncode == 2 and "no operation before" in failed.stderr


def test_a_second_finish_is_not_a_rest(tmp_path):
    """Without rest = true a finish cuts everything, regardless of earlier operations on the same plane."""
    finish = '[[operation]]\ntype = "finish"\ntool = 1\nstepover = 0.3\n'
    path = job(tmp_path, SOLID + finish + "allowance = 0.3\n" + finish, part_frep=DOME)
    planned = ff.cam.Job(path)
    planned.run()
    lengths = [np.linalg.norm(np.diff(m[:, :3], axis=0), axis=1)[m[1:, 3] > 0].sum() for m in planned.moves]
    assert lengths[1] > 0.9 * lengths[0]


def test_leaning_is_refused_where_it_cannot_be(tmp_path):
    text = FIVE.replace('plane = "PLANE"', "lean = true")
    path = job(tmp_path, text.replace("MACHINE", "linuxcnc"), part_frep=BLOCK)
    failed = run("cam", path, "-o", tmp_path / "o", check=False)
    assert failed.returncode == 2 and "job.toml:14: " in failed.stderr and "cannot tilt" in failed.stderr
    path = job(tmp_path, text.replace("MACHINE", "five_axis_ac").replace("ball", "flat"), part_frep=BLOCK)
    failed = run("cam", path, "-o", tmp_path / "o", check=False)
    assert failed.returncode == 2 and "only a ball" in failed.stderr


def test_letters_beyond_ascii_are_for_strings_and_comments(tmp_path):
    good = 'name = "Büste 1/2"\n# für Wachs\n' + FLAT + '[[operation]]\ntype = "profile"\nname = """Rand\nö"""\n'
    assert "profile" in run("cam", job(tmp_path, good, part_frep=PART), "--plan").stdout
    for bad in ("\u0350 = 1", "größe = 1", "a = ﹿ"):
        failed = run("cam", job(tmp_path, FLAT + bad + "\n", part_frep=PART), "--plan", check=False)
        assert failed.returncode == 2 and "job.toml:9: has a letter" in failed.stderr, failed.stderr


def test_planes_are_refused_where_a_machine_cannot(tmp_path):
    path = job(tmp_path, FIVE.replace("MACHINE", "linuxcnc").replace("PLANE", "stepped"), part_frep=BLOCK)
    assert "cannot tilt" in run("cam", path, "-o", tmp_path / "o", check=False).stderr
    path = job(tmp_path, FIVE.replace("MACHINE", "shopbot5").replace('"PLANE"', '"view"\nbeta = 120'), part_frep=BLOCK)
    assert "overhangs" in run("cam", path, "-o", tmp_path / "o", check=False).stderr
    path = job(tmp_path, FIVE.replace("MACHINE", "shopbot5").replace("PLANE", "front").replace("length = 40", ""),
               part_frep=BLOCK)
    assert "needs a length" in run("cam", path, "-o", tmp_path / "o", check=False).stderr
    path = job(tmp_path, FIVE.replace("MACHINE", "shopbot5").replace("PLANE", "front").replace(
        "length = 40", "length = 2.5"), part_frep=BLOCK)
    done = run("cam", path, "-o", tmp_path / "o", check=False)
    assert done.returncode == 2 and "reaches 2.5 mm" in done.stderr


def test_a_three_axis_machine_stops_for_turning_the_part(tmp_path):
    text = FIVE.replace("MACHINE", "linuxcnc").replace('"part.frep"', '"part.frep"\nzero = "centre"')
    both = text.replace("PLANE", "top") + '[[operation]]\ntype = "finish"\nplane = "bottom"\nstepover = 0.5\n'
    path = job(tmp_path, both, part_frep="max(max(abs(x)-9,max(abs(y)-7,abs(z)-6)), 3-sqrt((x-4)*(x-4)+(z-6)*(z-6)))")
    run("cam", path, "-o", tmp_path / "out.ngc", "--sheet", tmp_path / "s.html")
    names = [name for name, _ in rs274.canonical(tmp_path / "out.ngc", tools=((1, 0, 4),))]
    assert names.count("PROGRAM_STOP") == 1
    assert "turn the stock so that its bottom is up" in (tmp_path / "s.html").read_text()
    planned = ff.cam.Job(path)
    planned.run()
    top, bottom = planned.moves
    # Only the top side has the groove. After the part is turned over, its upper face is flat and at z = 0.
    assert top[top[:, 3] > 0][:, 2].min() < -2.5
    for before, after in zip(bottom[:-1], bottom[1:]):
        if after[3] > 0:
            for t in np.linspace(0, 1, 9):
                x, y, z = before[:3] + t * (after[:3] - before[:3])
                if abs(x) < 8.5 and abs(y) < 6.5:
                    assert z > -0.02


def test_the_examples_run(tmp_path):
    """Runs the jobs of examples/cam that simulate_examples_test.py does not run, each by one command; of the head (two
    minutes of CT) only the plan."""
    from conftest import ROOT
    from simulate_examples_test import SIMULATED

    jobs = {path.stem: path for path in (ROOT / "examples" / "cam").glob("*.toml")}
    assert len(jobs) >= 6 and set(SIMULATED) < set(jobs)
    for name in sorted(set(jobs) - set(SIMULATED)):
        if name == "cthead_shopbot5":
            plan = run("cam", jobs[name], "--plan").stdout
            assert plan.count("[height map]") == 10
            continue
        out = tmp_path / (name + ".out")
        run("cam", jobs[name], "-o", out)
        assert out.stat().st_size > 10_000


def test_a_part_must_lie_in_its_stock(tmp_path):
    path = job(tmp_path, SOLID.replace("margin = 2", "upper = [12, 10, 3]")
               + '[[operation]]\ntype = "finish"\ntool = 1', part_frep=DOME)
    done = run("cam", path, "-o", tmp_path / "o", check=False)
    assert done.returncode == 2 and "sticks out of the stock" in done.stderr and "job.toml:5" in done.stderr


def test_rapids_clear_a_height_map_that_is_higher_than_the_stock(tmp_path):
    (tmp_path / "part.frep").write_text(DOME)
    run("render", tmp_path / "part.frep", "--mode", "height", "--size", "64", "-o", tmp_path / "map.png")
    path = tmp_path / "job.toml"
    path.write_text('machine = "linuxcnc"\n[input]\nimage = "map.png"\n[[tool]]\nshape = "ball"\ndiameter = 3\n'
                    '[[operation]]\ntype = "finish"\nblack = 0\nwhite = 40\nstepover = 0.5\n')
    planned = ff.cam.Job(path)
    planned.run()
    moves = planned.moves[0]
    highest = moves[moves[:, 3] > 0][:, 2].max()  # of the cuts; the picture sets the stock's top, at about 2
    assert highest > 30
    assert moves[0, 2] == pytest.approx(highest + 5)


def test_what_panels_are_made_from():
    """The graph lists all of its settings, and each `needs` names a setting of the same node."""
    stages = {s["name"]: s for s in ff.cam.stages()}
    joining = ff.cam.joining_settings()
    for stage in stages.values():
        beside = {s["name"]: s for s in [*stage["settings"], *joining]}
        for s in [*stage["settings"], *joining]:
            assert s["help"] and s["kind"] in ("flag", "number", "text")
            assert s["default"] is None or s["kind"] != "text" or s["default"] in s["choices"]
            if s["needs"]:
                assert set(s["needs_values"]) <= set(beside[s["needs"]]["choices"])
    assert ff.cam.chain("solid", "finish") == ["height map", "finish"]
    assert ff.cam.chain("image", "pocket") == ["threshold", "distance transform", "pocket"]
    machine = ff.cam.machine("five_axis_ac")
    assert machine["axes"] == ["A", "C"] or set(machine["axes"]) == {"A", "C"}
    with pytest.raises(ff.Error, match="did you mean"):
        ff.cam.machine("linuxnc")


def test_a_job_of_a_part_that_is_given(tmp_path):
    text = ('machine = "linuxcnc"\n[input]\n{model}zero = "corner"\n[stock]\n{stock}\n[[tool]]\ndiameter = 3\n'
            '[[operation]]\ntype = "rough"\ncell = 0.4\n')
    by_file = ff.cam.Job(job(tmp_path, text.format(model='model = "part.frep"\n', stock="margin = 2"), part_frep=DOME))
    given = ff.cam.Job.parse(text.format(model="", stock="margin = 2"), ff.parse(DOME))
    # The same stock in model coordinates.
    lower, upper = (np.reshape(by_file.stock, (2, 3)) + by_file.zero).tolist()
    placed = ff.cam.Job.parse(text.format(model="", stock=f'coordinates = "model"\nlower = {lower}\nupper = {upper}'),
                              ff.parse(DOME))
    for each in (by_file, given, placed):
        each.run()
    assert (given.zero == by_file.zero and (given.moves[0] == by_file.moves[0]).all()
            and np.allclose(placed.stock, by_file.stock))
    assert len(placed.moves[0]) == len(by_file.moves[0]) and np.abs(placed.moves[0] - by_file.moves[0]).max() < 1e-6
    assert given.sections[0]["tool"] == 1 and not given.sections[0]["tilted"]
    with pytest.raises(ff.Error, match="the part is given") as raised:
        ff.cam.Job.parse(text.format(model='model = "part.frep"\n', stock="margin = 2"), ff.parse(DOME), "mine")
    assert raised.value.place.startswith("mine:3")
    with pytest.raises(ff.Error, match="whole number"):
        ff.cam.Job.parse(text.format(model="", stock="margin = 2").replace('"rough"', '"profile"\ntabs = 1.5'),
                         ff.parse(DOME))


RIB = "move(box(40, 30, 4), dz = -2) | move(box(0.0004, 20, 5), dx = 3.1234, dz = 2.5)"


@pytest.mark.parametrize("operation", ['type = "finish"\ntool = 2', 'type = "rough"\ntool = 2'])
def test_a_rib_thinner_than_any_sample_is_not_cut(tmp_path, operation):
    """A wall of 0.4 micrometres lies between the height map's samples; the tool stays above it."""
    path = job(tmp_path, SOLID + "[[operation]]\n" + operation, part_frep=RIB)
    planned = ff.cam.Job(path)
    planned.run()
    for moves in planned.moves:
        at = moves[:, :3]
        along = np.linspace(0, 1, 200)[None, :, None]
        passed = (at[:-1, None] + along * (at[1:] - at[:-1])[:, None]).reshape(-1, 3)
        near = passed[(abs(passed[:, 0] - 3.1234) < 2.95) & (abs(passed[:, 1]) < 9.5)]
        assert near[:, 2].min(initial=99) > 4.9
    assert np.vstack(planned.moves)[:, 2].min() < 0.1, "the plate around it is cut"
    assert any("the tool stays above it" in note for note in planned.notes)


def test_an_outline_tells_of_walls_thinner_than_its_cells(tmp_path):
    """Cells are halved until a wall is resolved; a still thinner wall is reported."""
    slot = '[[operation]]\ntype = "profile"\ncell = 0.2'
    for width, told in ((0.03, False), (0.0001, True)):
        path = job(tmp_path, FLAT + slot, part_frep="rotate_z(max(abs(x) - 15, "
                   f"abs(y - 2) - {width / 2}) | max(abs(x + 10) - 5, abs(y + 5) - 5), 20)")
        done = run("cam", path, "-o", tmp_path / "out.ngc")
        assert ("narrower than" in done.stderr) == told, done.stderr
