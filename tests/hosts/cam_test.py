"""Jobs through the command and through Python, with LinuxCNC's interpreter as the oracle."""

import json
import math
import subprocess

import numpy as np
import pytest
from conftest import COMMAND, DATA

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


def compare(path_to_program, moves):
    """LinuxCNC's canonical moves equal ours to 1e-4 mm, vertex for vertex, arcs with their centres."""
    ours = np.vstack(moves)
    keep = [0]
    for i in range(1, len(ours)):  # moves to where the tool is are not written
        if np.abs(ours[i, :3] - ours[keep[-1], :3]).max() > 6e-6 or abs(ours[i, 4]) > 0:
            keep.append(i)
    theirs, kinds, centres = rs274.moves(path_to_program)
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
        'type = "isolate"\noffsets = 3',
    ],
)
def test_flat_programs_are_what_linuxcnc_reads(tmp_path, operation):
    path = job(tmp_path, FLAT + "[[operation]]\n" + operation, part_frep=PART)
    done = json.loads(run("--json", "cam", path, "-o", tmp_path / "out.ngc").stdout)
    assert done["cut"] > 50 and done["seconds"] > 10
    planned = ff.cam.Job(path)
    planned.run()
    compare(tmp_path / "out.ngc", planned.moves)


@pytest.mark.parametrize(
    "operation",
    [
        'type = "rough"\ntool = 2\nstepdown = 3',
        'type = "finish"\ntool = 1\nstepover = 0.2',
        'type = "finish"\ntool = 1\npattern = "spiral"\nstepover = 0.3',
        'type = "finish"\ntool = 1\npattern = "cross"\nangle = 30\nscallop = 0.1',
        'type = "waterline"\ntool = 1\nstepdown = 1',
    ],
)
def test_solid_programs_are_what_linuxcnc_reads(tmp_path, operation):
    path = job(tmp_path, SOLID + "[[operation]]\n" + operation, part_frep=DOME)
    run("cam", path, "-o", tmp_path / "out.ngc")
    planned = ff.cam.Job(path)
    planned.run()
    rs274_tools = ((1, 0.0, 4.0), (2, 0.0, 6.0))
    moves = planned.moves
    theirs, kinds, _ = rs274.moves(tmp_path / "out.ngc", tools=rs274_tools)
    ours = np.vstack(moves)
    assert len(theirs) <= len(ours)
    assert np.abs(theirs[-1, :3] - ours[-1, :3]).max() <= 1e-4
    assert np.abs(theirs[:, 2].min() - ours[:, 2].min()) <= 1e-4


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
        (FLAT.replace("diameter = 3", "diameter = 3\nflute = 2") + '[[operation]]\ntype = "profile"', None, "flutes of 2 mm"),
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


def test_the_plan_shows_stages_and_where_settings_come_from(tmp_path):
    path = job(tmp_path, FLAT + '[[operation]]\ntype = "pocket"\nstepdown = 2', part_frep=PART)
    plan = run("cam", path, "--plan").stdout
    assert "solid -> [outline] -> outline -> [pocket] -> paths" in plan
    assert "stepdown           2              job" in plan
    assert "stepover           0.4            default" in plan
