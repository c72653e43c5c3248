"""`fieldfab simulate` on the programs of the jobs in examples/cam: they run without events, and planted faults are
found."""

import json
import random
import re

import numpy as np
import pytest
import rs274
from family import sample_or_all
from simulate_test import ROOT, each, follow, only, run, where

import fieldfab as ff

EXAMPLES = ROOT / "examples" / "cam"
SIMULATED = ["pcb_gcode", "text_vcarve", "bearing", "knob_five_axis"]
AFTER = 200  # lines of a program after a planted fault; the rest is cut off, since programs are long


def faults(name):
    """Returns how many faults of a kind are planted in a program; the text's takes long to simulate."""
    return sample_or_all(1 if name == "text_vcarve" else 2, 3 if name == "text_vcarve" else 8)


class Example:
    """A job of examples/cam in a separate folder, and its program."""

    def __init__(self, name, folder):
        self.folder, self.name = folder, name
        # Models are named relative to the job.
        self.job_text = re.sub(r'model = "([^"]+)"', lambda m: f'model = "{(EXAMPLES / m[1]).resolve()}"',
                               (EXAMPLES / f"{name}.toml").read_text())
        self.job = self.job_with()
        path = folder / ("program.rml" if "modela" in name else "program.ngc")
        done = run("cam", self.job, "-o", path)
        assert done.returncode == 0, done.stderr
        if 'machine = "linuxcnc"' in self.job_text:
            at, _, _ = rs274.moves_of_program(path, tools=((1, 0, 1), (2, 0, 1)))
            assert len(at) > 1000
        self.suffix, self.lines = path.suffix, path.read_text().split("\n")
        self.at, self.tool = follow(self.lines)
        clean = self.simulate(self.lines)
        assert clean["code"] == 0 and not clean["events"], clean["events"][:5]
        assert clean["deviation"]["deepest_gouge"] < 0.03
        self.removed = {record["line"]: record["removed"] for record in clean["lines"]}

    def job_with(self, tag="", **of_first_tool):
        """Writes the job with other sizes of its first tool."""
        head, tool, rest = (self.job_text.split("[[tool]]", 2) if self.job_text.count("[[tool]]") > 1
                            else (*self.job_text.split("[[tool]]"), None))
        body, *operations = tool.split("[[operation]]")
        body = "\n".join(line for line in body.splitlines() if line.split(" = ")[0] not in of_first_tool)
        body += "".join(f"\n{key} = {value}" for key, value in of_first_tool.items()) + "\n\n"
        text = "[[tool]]".join([head, "[[operation]]".join([body, *operations]), *([rest] if rest else [])])
        path = self.folder / f"job{tag}.toml"
        path.write_text(text)
        return path

    def simulate(self, lines, tag="", job=None):
        program, report = self.folder / f"program{tag}{self.suffix}", self.folder / f"report{tag}.json"
        program.write_text("\n".join(lines))
        done = run("simulate", program, "--setup", job or self.job, "--report", report, "--threads", 1)
        assert done.returncode in (0, 1), done.stderr
        return {**json.loads(report.read_text()), "code": done.returncode}

    def cuts(self, least):
        """Returns indices of straight feeds that remove more than `least` mm3 and precede a straight feed. They end at
        the first stop, where the part is turned over."""
        end = next((i for i, line in enumerate(self.lines) if line.startswith("M0")), len(self.lines) - 1)
        return [i for i in range(end) if self.removed.get(i + 1, 0) > least and self.lines[i].startswith("G1 ")
                and self.lines[i + 1].startswith("G1 ")]


@pytest.fixture(scope="module", params=SIMULATED)
def example(request, tmp_path_factory):
    return Example(request.param, tmp_path_factory.mktemp(request.param))


def ball_in_part(at, radius, model=[]):
    """Returns the depth in the bearing of a ball with its tip at `at`. The bearing's top is the program's zero."""
    if not model:
        model.append(ff.load(ROOT / "examples" / "bearing.frep"))
    i = np.arange(2000)
    z = 1 - 2 * (i + 0.5) / 2000
    r, angle = np.sqrt(1 - z * z), 2.399963 * i
    ball = np.stack([r * np.cos(angle), r * np.sin(angle), z + 1], 1) * radius
    return -float(np.min(model[0].values(np.array([at["X"], at["Y"], at["Z"] + 4.5]) + ball)))


def test_gouges(example):
    rng = random.Random(1)
    deeper = 0.4
    cuts = example.cuts(0.002)
    if example.name == "knob_five_axis":
        # No cuts, unlike the same test in simulate_test.py: the part under an inclined tool has no closed form.
        cuts = []
    if example.name == "bearing":
        cuts = [i for i in rng.sample(cuts, 300) if example.tool[i] == 2
                and ball_in_part({**example.at[i], "Z": example.at[i]["Z"] - deeper}, 1) > 0.25]

    def plant(number, i):
        lines = list(example.lines)
        lines[i] = re.sub(r" (Z|F)-?[\d.]+", "", lines[i]) + f" Z{example.at[i]['Z'] - deeper:.5f}"
        lines[i + 1] = re.sub(r" (Z|F)-?[\d.]+", "", lines[i + 1]) + f" Z{example.at[i + 1]['Z']:.5f}"
        result = example.simulate(lines[:i + AFTER], f"_g{number}")
        ok = only(result, "gouge") and set(where(result, "gouge")) <= {i + 1, i + 2}
        return None if ok else f"line {i + 1} {lines[i]}: {result['events']}"

    failed = each(rng.sample(cuts, min(faults(example.name), len(cuts))), plant)
    assert not failed, failed


def test_rapids_through_stock(example):
    def plant(number, i):
        lines = list(example.lines)
        lines[i] = "G0" + lines[i][2:]
        result = example.simulate(lines[:i + AFTER], f"_r{number}")
        ok = only(result, "rapid contact") and where(result, "rapid contact") == [i + 1]
        return None if ok else f"line {i + 1} {lines[i]}: {result['events']}"

    # Where the bearing's roughing begins, the tool's side only grazes the stock.
    cuts = example.cuts({"pcb_gcode": 0.01, "text_vcarve": 0.01, "bearing": 6}.get(example.name, 0.5))
    failed = each(random.Random(2).sample(cuts, faults(example.name)), plant)
    assert not failed, failed


def test_short_bits_and_long_holders(example):
    """The first tool's flutes end 0.05 mm above its tip; in a second run its holder begins there."""
    thick = {"pcb_gcode": 0.397, "text_vcarve": 6, "bearing": 3, "knob_five_axis": 8}[example.name]
    for tag, kind, sizes in (("_s", "shank contact", {"flute": 0.05, "length": 20, "shank": thick}),
                             ("_h", "holder contact",
                              {"flute": 0.05, "length": 0.05, "holder_diameter": 40, "holder_length": 30})):
        result = example.simulate(example.lines[:2000], tag, example.job_with(tag, **sizes))
        assert result["code"] == 1 and kind in {e["kind"] for e in result["events"]}, (tag, result["events"][:3])
        assert all(example.tool[e["line"] - 1] == 1 for e in result["events"] if e["kind"] == kind)


def test_the_modela_program(tmp_path):
    """RML has no explicit rapids; excessive depth is found."""
    example = Example("pcb_modela", tmp_path)
    i = next(i for i, line in enumerate(example.lines)
             if example.removed.get(i + 1, 0) > 0.01 and line.endswith(",-4;"))
    lines = list(example.lines)
    lines[i] = lines[i].replace(",-4;", ",-12;")
    result = example.simulate(lines, "_g")
    assert only(result, "gouge") and set(where(result, "gouge")) <= {i + 1, i + 2}, result["events"]


class Sheet:
    """The laser's job, or some of its parts on a smaller sheet, and its program."""

    def __init__(self, folder, parts=slice(None), size="[600, 900]"):
        self.folder = folder
        text = (EXAMPLES / "mtm_az_laser.toml").read_text()
        models = [str((EXAMPLES / name).resolve()) for name in re.findall(r'"(\.\./[^"]+)"', text)][parts]
        self.job_text = re.sub(r"models = \[.*?\]", f"models = {models}", text, flags=re.S).replace("[600, 900]", size)
        self.job = folder / "job.toml"
        self.job.write_text(self.job_text)
        done = run("cam", self.job, "-o", folder / "program.epi")
        assert done.returncode == 0, done.stderr
        self.lines = (folder / "program.epi").read_text(encoding="latin-1").split("\n")
        self.outlines = [i for i, line in enumerate(self.lines) if line.startswith("PU") and "PD" in line]

    def simulate(self, lines, tag="", job=None):
        program, report = self.folder / f"program{tag}.epi", self.folder / f"report{tag}.json"
        program.write_text("\n".join(lines), encoding="latin-1")
        done = run("simulate", program, "--setup", job or self.job, "--report", report)
        assert done.returncode in (0, 1), done.stderr
        return {**json.loads(report.read_text()), "code": done.returncode}


def test_the_laser_cuts_a_sheet(tmp_path):
    """Plates in cells of 0.1 mm, since the beam is 0.2 mm wide."""
    sheet = Sheet(tmp_path, slice(4, sample_or_all(8, 16)), sample_or_all("[300, 350]", "[400, 500]"))
    found = sheet.simulate(sheet.lines)
    assert found["code"] == 0 and not found["events"], found["events"][:5]
    assert found["deviation"]["deepest_gouge"] < 0.05 and 0.95 < found["removed"] / (0.2 * found["cut"]) < 1.01


def test_faults_of_the_laser(tmp_path):
    """Six plates: cuts in all directions from a corner of an outline, and a beam that is wider than planned."""
    sheet = Sheet(tmp_path, slice(-6, None), "[150, 135]")
    clean = sheet.simulate(sheet.lines)
    assert clean["code"] == 0 and not clean["events"], clean["events"][:5]
    rng = random.Random(3)

    def plant(number, i):
        lines, steps = list(sheet.lines), sheet.lines[i].split(";")
        at = rng.randrange(2, len(steps) - 2)
        x, y = map(int, re.findall(r"\d+", steps[at]))
        ways = [f"PD{x + dx},{y + dy};PD{x},{y}" for dx in (-12, 0, 12) for dy in (-12, 0, 12)]  # half a millimetre
        lines[i] = ";".join([*steps[:at + 1], *ways, *steps[at + 1:]])
        result = sheet.simulate(lines, f"_g{number}")
        ok = only(result, "gouge") and where(result, "gouge") == [i + 1] and 0.25 < result["events"][0]["amount"] < 0.52
        return None if ok else f"line {i + 1} {steps[at]}: {result['events']}"

    assert len(sheet.outlines) > 6
    failed = each(rng.sample(sheet.outlines, sample_or_all(2, 6)), plant)
    assert not failed, failed
    wide = tmp_path / "wide.toml"
    wide.write_text(sheet.job_text.replace("[setting]", "[setting]\nkerf = 0.8"))
    result = sheet.simulate(sheet.lines, "_w", wide)
    told = {line for e in result["events"] for line in range(e["first_line"], e["last_line"] + 1)}
    assert only(result, "gouge") and told >= {i + 1 for i in sheet.outlines}
    assert all(0.25 < e["amount"] < 0.35 for e in result["events"])
