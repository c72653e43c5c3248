"""Programs as they are written for LinuxCNC, Fanuc, GRBL and Mach3 controls: verdicts are those of docs/simulation.md,
and volumes are known in closed form."""

import json
import math
import re

import pytest
from conftest import ROOT
from simulate_test import run

FOLDER = ROOT / "examples" / "dialects"
ROWS = re.findall(r"^\| (\w+\.(?:nc|tap|ngc)) \| [^|]+ \| ([^|]+) \|", (ROOT / "docs/simulation.md").read_text(), re.M)


def drilled(depth, radius=2.5, point=118):
    """Returns the volume of a hole in the plate of 10 mm, by a drill whose tip goes to `depth`."""
    cone = radius / math.tan(math.radians(point / 2))
    return math.pi * radius**2 * (depth - cone + cone / 3)


REMOVED = {  # mm3
    "fanuc_holes.nc": 6 * math.pi * 2.5**2 * 10,
    "fanuc_steps.nc": (40 * 20 - (4 - math.pi) * 9) * 6,
    "grbl_router.nc": (2 * 40 + 2 * math.pi * 15) * 6 * 3,
    "grbl_inches.nc": 2 * (2 * 25.4 * 6 + 9 * math.pi) * 0.08 * 25.4,
    "mach3_holes.tap": 4 * drilled(6),
    "mach3_spiral.tap": math.pi * 12**2 * 6,
    "linuxcnc_circle.ngc": 13 * drilled(4),
}


@pytest.mark.parametrize("name, verdict", ROWS)
def test_programs_of_shops(name, verdict, tmp_path):
    report = tmp_path / "report.json"
    done = run("simulate", FOLDER / name, "--setup", FOLDER / "plate.toml", "--dialect", name.split("_")[0],
               "--cell", 0.1, "--report", report)
    told = json.loads(report.read_text())
    events = [f"line {event['line']}: {event['kind']}" for event in told["events"]]
    assert (events or ["nothing is wrong"]) == [verdict], done.stderr
    assert done.returncode == (1 if events else 0)
    if name in REMOVED:
        assert told["removed"] == pytest.approx(REMOVED[name], rel=0.01)
    if name.startswith("fanuc"):  # their headers are errors of LinuxCNC's interpreter
        assert run("simulate", FOLDER / name, "--setup", FOLDER / "plate.toml").returncode == 2


def test_all_of_them_are_in_the_documents():
    assert sorted(name for name, _ in ROWS) == sorted(path.name for path in FOLDER.iterdir() if path.suffix != ".toml")


def test_projects_of_camotics():
    folder = ROOT.parent / "shared" / "data" / "gcode"
    for project, program, things in (("flower_mold", None, 0), ("text", "text.ngc", 0), ("wave", "wave.gcode", 0),
                                     ("vcarve", None, 27)):
        done = run("simulate", *([folder / program] if program else []), "--setup", folder / f"{project}.camotics")
        assert done.returncode == (1 if things else 0), done.stderr
        assert done.stderr.count("rapid contact") == things and ("nothing is wrong" in done.stdout) == (things == 0)
        assert ("switched on by hand" in done.stderr) == (project in ("wave", "vcarve"))
        if program:
            refused = run("simulate", "--setup", folder / f"{project}.camotics")
            assert refused.returncode == 2 and "JavaScript" in refused.stderr
