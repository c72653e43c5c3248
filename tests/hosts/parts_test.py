"""Models of several parts through the command: error messages, names and colours in files, and verbs for single
parts."""

import json
import math
import re
import resource
import struct
import zipfile

import pytest
from cli_test import refused, run, summary

MODEL = """part(sphere(3), "ball", "tomato")
part(move(box(4, 4, 4), 6), "cube", "#204060")
part(move(sphere(2), 9), "plain")
part(intersection(sphere(1), move(sphere(1), 9)), "none", "red")
"""
COLOURS = {"ball": (255, 99, 71), "cube": (32, 64, 96)}
VOLUMES = {"ball": 36 * math.pi, "cube": 64, "plain": 32 / 3 * math.pi}


@pytest.fixture
def model(tmp_path):
    path = tmp_path / "model.frep"
    path.write_text(MODEL)
    return path


@pytest.mark.parametrize("text, words", [
    ("union(sphere(1),\n  open('missing.stl'))".replace("'", '"'), "bad.frep:2:3: "),
    ('r = 2\n  open("circle.frep") | sphere(r)', "bad.frep:2:3: CIRCLE"),
    ('part(sphere(1), "lid")\n  part(sphere(2), "lid")', "bad.frep:2:3: two parts are called 'lid'"),
    ('part(sphere(1),\n  "lid", "rde")', "bad.frep:2:10: unknown colour 'rde'"),
    ('part(sphere(1), "lid")\nsphere(2)', "bad.frep:2:1: the text has parts, and this is none"),
    ("sphere(2)\nsphere(1)", "bad.frep:1:1: this value is not used"),
    ('open("model.frep", part = "cub")', "did you mean 'cube'?"),
    ('part(sphere(1), "")', "bad.frep:1:1: 'part' lacks its shape or its name"),
], ids=["missing file", "circle", "names", "colour", "no part", "two solids", "part of a file", "empty name"])
def test_bad_models_are_refused_with_file_line_and_column(tmp_path, model, text, words):
    (tmp_path / "circle.frep").write_text('open("bad.frep")')
    (tmp_path / "bad.frep").write_text(text)
    for verb in ("info", "mesh"):
        said = refused(verb, tmp_path / "bad.frep", *(["-o", tmp_path / "out.3mf"] if verb == "mesh" else []))
        assert words.removesuffix("CIRCLE") in said
        assert ("bad.frep: opens itself: bad.frep opens circle.frep opens bad.frep" in said) == words.endswith("CIRCLE")
    assert not (tmp_path / "out.3mf").exists()


def test_an_empty_part_is_told_and_the_others_are_kept(tmp_path, model):
    done = run("--json", "mesh", model, "-o", tmp_path / "out.3mf", "--voxel", 0.3)
    assert done.returncode == 0 and f"{model}:4:1: part 'none': the solid is empty" in done.stderr
    parts = {part["name"]: part for part in json.loads(done.stdout)["parts"]}
    assert {name: part["volume"] for name, part in parts.items()} == pytest.approx(VOLUMES, rel=0.01)
    assert {name: part["colour"] for name, part in parts.items()} == {
        "ball": "#ff6347", "cube": "#204060", "plain": None}
    (tmp_path / "none.frep").write_text("".join(f'part(intersection(sphere(1), move(sphere(1), 9)), "{name}")\n'
                                                for name in "ab"))
    done = run("mesh", tmp_path / "none.frep", "-o", tmp_path / "none.3mf")
    assert done.returncode == 2 and "all parts are empty" in done.stderr and not (tmp_path / "none.3mf").exists()


@pytest.mark.parametrize("words, keeps", [
    ("mesh model.frep -o out.stl", False), ("mesh model.frep -o out.ply", False), ("mesh model.frep -o out.glb", True),
    ("convert model.frep -o out.3mf", True), ("convert model.frep -o out.off", False),
    ("convert model.frep -o out.vdb", False),
    ("convert model.frep -o out.asdf", False), ("convert model.frep -o out.vm", False),
    ("build model.frep -o out.asdf", False),
    ("render model.frep -o out.png --size 32", True),
])
def test_each_verb_tells_what_is_left_out_of_parts(tmp_path, model, words, keeps):
    """Reports empty parts with file, line and column, and the union of several parts."""
    voxel = [] if words.startswith("render") else ["--voxel", 0.5]
    done = run(*words.split(), *voxel, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    notes = [line.removeprefix("fieldfab: note: ") for line in done.stderr.splitlines()]
    out = words.split()[3]
    lost = f"{out}: 4 parts are one there, without their names" + ("" if out.endswith("ply") else " and colours")
    assert notes == ["model.frep:4:1: part 'none': the solid is empty"] + ([] if keeps else [lost])


NAMES = ['6" pipe', "back\\slash\\", "two\nlines", "it's \\n", "\\\""]


def test_names_of_parts_may_have_quotes_backslashes_and_line_ends(tmp_path):
    """In texts, in files that they open, and in scripts."""
    (tmp_path / "model.py").write_text(
        f"import fieldfab as ff\nfor i, name in enumerate({NAMES!r}): ff.part(ff.shapes.sphere(i + 1), name)\n")
    for there, back in (("model.py", "model.frep"), ("model.frep", "again.frep")):
        run("convert", tmp_path / there, "-o", tmp_path / back, check=True)
        assert [part["name"] for part in summary("info", tmp_path / back)["parts"]] == NAMES
    assert "  two lines: x" in run("info", tmp_path / "model.frep").stdout
    assert (tmp_path / "model.frep").read_text() == (tmp_path / "again.frep").read_text()
    assert (tmp_path / "model.frep").read_text().startswith(
        "part(sqrt((square(x) + square(y)) + square(z)) - 1, \"6\\\" pipe\")\n")
    summary("mesh", tmp_path / "model.frep", "-o", tmp_path / 'of "all".3mf', "--voxel", 0.5)
    (tmp_path / "one.frep").write_text(r'open("of \"all\".3mf", part = "6\" pipe") | move(sphere(1), 9)')
    run("convert", tmp_path / "one.frep", "-o", tmp_path / "two.frep", check=True)
    for name in ("one", "two"):
        assert summary("info", tmp_path / f"{name}.frep")["bounds"] == [
            pytest.approx(b, abs=0.1) for b in ([-1, 10], [-1, 1], [-1, 1])]
    (tmp_path / "bad.frep").write_text('part(sphere(1), "a\\")')
    assert "bad.frep:1:17: the quotes opened here are not closed on this line" in refused("info", tmp_path / "bad.frep")


def test_names_and_colours_are_in_each_format(tmp_path, model):
    for extension in ("3mf", "obj", "glb", "ply"):
        summary("mesh", model, "-o", tmp_path / f"out.{extension}", "--voxel", 0.3)

    xml = zipfile.ZipFile(tmp_path / "out.3mf").read("3D/3dmodel.model").decode()
    assert re.findall(r'<object [^>]*name="(\w+)"', xml) == ["ball", "cube", "plain"]
    assert {"#FF6347", "#204060"} <= {colour[:7].upper() for colour in re.findall(r'displaycolor="([^"]+)"', xml)}

    materials = dict(re.findall(r"newmtl (\S+)\nKd ([^\n]+)", (tmp_path / "out.mtl").read_text()))
    for name, material in re.findall(r"^o (\w+)\nusemtl (\S+)$", (tmp_path / "out.obj").read_text(), re.M):
        assert name == "plain" or [round(255 * float(c)) for c in materials[material].split()] == list(COLOURS[name])

    body = (tmp_path / "out.glb").read_bytes()
    scene = json.loads(body[20:20 + struct.unpack("<I", body[12:16])[0]])
    assert [node["name"] for node in scene["nodes"] if "mesh" in node] == ["ball", "cube", "plain"]

    head, body = (tmp_path / "out.ply").read_bytes().split(b"end_header\n", 1)
    count = int(re.search(rb"element vertex (\d+)", head)[1])
    rows = list(struct.iter_unpack("<3f3B", body[:15 * count]))
    assert {row[3:] for row in rows if row[0] < 2.9} == {COLOURS["ball"]}
    assert {row[3:] for row in rows if 4.5 < row[0] < 6.5} == {COLOURS["cube"]}


def test_an_obj_file_and_its_materials_are_both_kept_when_one_cannot_be_written(tmp_path, model):
    for name in ("out.obj", "out.mtl"):
        (tmp_path / name).write_text(f"old {name}")
    small = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))  # enough for the materials only
    done = run("mesh", model, "-o", tmp_path / "out.obj", "--voxel", 2, preexec_fn=small)
    assert done.returncode == 2 and "out.obj: cannot write: File too large" in done.stderr
    assert [(tmp_path / name).read_text() for name in ("out.obj", "out.mtl")] == ["old out.obj", "old out.mtl"]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["model.frep", "out.mtl", "out.obj"]


def test_info_lists_parts_with_sizes_and_volumes(tmp_path, model):
    summary("mesh", model, "-o", tmp_path / "out.3mf", "--voxel", 0.3)
    for path, loose in ((model, 0.05), (tmp_path / "out.3mf", 0.01)):
        parts = {part["name"]: part for part in summary("info", path)["parts"]}
        for name, volume in VOLUMES.items():
            found = parts[name]["volume"]
            assert (found if isinstance(found, float) else sum(found) / 2) == pytest.approx(volume, rel=0.01)
            assert parts[name]["colour"] == ("#%02x%02x%02x" % COLOURS[name] if name in COLOURS else None)
        (low, high), (front, back), (bottom, top) = parts["cube"]["bounds"]
        assert (low, high, front, back, bottom, top) == pytest.approx((4, 8, -2, 2, -2, 2), abs=loose)
    said = run("info", model).stdout.splitlines()
    assert (said[0].endswith("4 parts") and said[1].startswith("  ball: #ff6347, x -3")
            and said[4] == "  none: #ff0000, empty")


def test_one_part_is_taken_by_its_name(tmp_path, model):
    made = summary("mesh", model, "-o", tmp_path / "ball.stl", "--part", "ball", "--voxel", 0.3)
    assert made["volume"] == pytest.approx(VOLUMES["ball"], rel=0.01)
    assert "did you mean 'ball'?" in refused("mesh", model, "-o", tmp_path / "never.stl", "--part", "bal")
    (tmp_path / "cube.frep").write_text('open("model.frep", part = "cube")')
    assert summary("mesh", tmp_path / "cube.frep", "-o", tmp_path / "cube.stl")["volume"] == pytest.approx(64, rel=1e-5)


def test_check_tells_which_parts_overlap(tmp_path, model):
    model.write_text('part(box(4, 4, 4), "a")\npart(move(box(4, 4, 4), 3), "b")\npart(move(box(4, 4, 4), 9), "c")')
    done = run("--json", "check", model, "--voxel", 1)
    overlaps = json.loads(done.stdout)["overlaps"]
    assert [each["parts"] for each in overlaps] == [["a", "b"]]
    low, high = overlaps[0]["volume"]
    assert 0.9 * 16 < low <= 16 <= high


def test_a_job_cuts_one_part(tmp_path, model):
    job = ('machine = "linuxcnc"\n[input]\nmodel = "model.frep"\npart = "PART"\n[[tool]]\nnumber = 1\ndiameter = 1\n'
           '[[operation]]\ntype = "profile"\ntool = 1\nside = "on"\n')
    (tmp_path / "job.toml").write_text(job.replace("PART", "cube"))
    run("cam", tmp_path / "job.toml", "-o", tmp_path / "part.ngc", check=True)
    cut = [float(x) for x in re.findall(r"X(-?[\d.]+)", (tmp_path / "part.ngc").read_text())]
    assert (min(cut), max(cut)) == pytest.approx((4, 8), abs=0.05)
    (tmp_path / "job.toml").write_text(job.replace("PART", "cub"))
    assert "job.toml:4" in refused("cam", tmp_path / "job.toml", "-o", tmp_path / "never.ngc")
