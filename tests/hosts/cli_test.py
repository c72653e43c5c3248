"""The command: its verbs, one-line messages, exit codes, and effects on files."""

import json
import math
import os
import re
import signal
import subprocess
import time

import pytest

from conftest import COMMAND, DATA


def run(*arguments, **more):
    return subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True, timeout=120, **more)


def summary(*arguments):
    done = run("--json", *arguments)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def refused(*arguments, code=2):
    done = run(*arguments)
    assert done.returncode == code, (done.returncode, done.stderr)
    lines = [line for line in done.stderr.splitlines() if line.strip()]
    assert len(lines) == 1 and lines[0].startswith("fieldfab: "), done.stderr
    assert done.stdout == ""
    return lines[0]


@pytest.fixture
def ball(tmp_path):
    path = tmp_path / "ball.frep"
    path.write_text("sphere(r = 5)")
    return path


@pytest.mark.parametrize("extension", ["stl", "ply", "off", "obj", "3mf"])
def test_mesh_and_info(ball, tmp_path, extension):
    made = summary("mesh", ball, "-o", tmp_path / f"ball.{extension}", "--voxel", 0.2)
    assert made["volume"] == pytest.approx(4 / 3 * math.pi * 125, rel=0.005)
    told = summary("info", tmp_path / f"ball.{extension}")
    assert told["triangles"] == made["triangles"]
    assert told["volume"] == pytest.approx(made["volume"], rel=1e-5)


def test_build_mesh_of_asdf_and_convert(ball, tmp_path):
    built = summary("build", ball, "-o", tmp_path / "ball.asdf", "--resolution", 5)
    assert built["bytes"] <= 24 * built["cells"]
    assert summary("info", tmp_path / "ball.asdf")["cells"] == built["cells"]
    assert summary("mesh", tmp_path / "ball.asdf", "-o", tmp_path / "a.stl")["volume"] == pytest.approx(
        4 / 3 * math.pi * 125, rel=0.01)
    for extension in ("math", "vm", "frep"):
        summary("convert", ball, "-o", tmp_path / f"again.{extension}")
        assert summary("info", tmp_path / f"again.{extension}")["nodes"] == summary("info", ball)["nodes"]
    summary("convert", tmp_path / "a.stl", "-o", tmp_path / "a.obj")
    assert summary("info", tmp_path / "a.obj")["triangles"] == summary("info", tmp_path / "a.stl")["triangles"]


def test_certainty_of_a_distance_field(ball, tmp_path):
    assert summary("build", ball, "-o", tmp_path / "ball.asdf", "--certain")["certain"]
    (tmp_path / "plate.frep").write_text("box(100, 80, 0.5)")  # default cells are refined for it, to a quarter
    assert summary("build", tmp_path / "plate.frep", "-o", tmp_path / "plate.asdf", "--certain")["certain"]
    made = summary("mesh", tmp_path / "plate.asdf", "-o", tmp_path / "plate.stl", "--voxel", 0.1)
    assert made["volume"] == pytest.approx(4000, rel=0.01)
    assert summary("convert", tmp_path / "plate.frep", "-o", tmp_path / "plate.vdb")["certain"]
    (tmp_path / "plate.frep").write_text("box(100, 80, 0.1)")
    done = run("--json", "build", tmp_path / "plate.frep", "-o", tmp_path / "plate.asdf", "--certain")
    assert done.returncode == 1, done.stderr
    told = json.loads(done.stdout)
    assert not told["certain"] and told["uncertain"]["count"] == 1
    lower, upper = told["uncertain"]["places"][0]["bounds"][:3], told["uncertain"]["places"][0]["bounds"][3:]
    assert all(a < -s and b > s for a, b, s in zip(lower, upper, (49, 39, 0.04), strict=True))
    line = run("build", tmp_path / "plate.frep", "-o", tmp_path / "plate.asdf", "--voxel", 0.04).stdout
    assert "certain" in line and "not certain" not in line


def test_scans_are_certain_in_their_own_cells(tmp_path):
    scan = DATA / "ct/engine.nii.gz"
    made = summary("mesh", scan, "-o", tmp_path / "engine.ply", "--certain", "--threshold", 80)
    assert made["certain"] and made["voxel"] == pytest.approx(1)
    assert summary("build", scan, "-o", tmp_path / "engine.asdf", "--certain", "--threshold", 80)["certain"]
    coarse = run("mesh", scan, "-o", tmp_path / "coarse.ply", "--certain", "--threshold", 80, "--voxel", 3)
    assert coarse.returncode == 1 and "it was not looked" in coarse.stdout


def test_info_and_check_give_bounds_of_volume_and_area(ball, tmp_path):
    (tmp_path / "plate.frep").write_text("rotate_x(box(100, 80, 0.3), 30)")
    for model, volume, area in ((ball, 500 / 3 * math.pi, 100 * math.pi), (tmp_path / "plate.frep", 2400, 16000 + 108)):
        told = summary("info", model)
        for name, exact in (("volume", volume), ("area", area)):
            least, most = told[name]
            assert least <= exact <= most and most - least < 0.2 * exact, (model, name, told[name])
        assert "volume" in run("info", model).stdout
    report = summary("check", ball, "--voxel", 0.3)
    assert report["measures"]["volume"][0] <= 500 / 3 * math.pi <= report["measures"]["volume"][1]
    assert any(row["name"] == "volume beyond what its Field proves" for row in report["rows"])


def test_info_gives_the_bounds_that_people_expect(tmp_path):
    (tmp_path / "box.frep").write_text("move(box(40, 30, 10), 0, 0, 5)")
    assert "x -20..20 y -15..15 z 0..10," in run("info", tmp_path / "box.frep").stdout
    told = summary("info", tmp_path / "box.frep")["bounds"]
    assert told == [pytest.approx(ends, abs=2e-5) for ends in ([-20, 20], [-15, 15], [0, 10])]


def test_render_modes(ball, tmp_path):
    for mode, channels, depth in (("bitmap", 1, 8), ("height", 1, 16), ("normals", 3, 8), ("shaded", 3, 8)):
        summary("render", ball, "-o", tmp_path / "p.png", "--mode", mode, "--size", 80, "--alpha", 20, "--beta", -30)
        told = summary("info", tmp_path / "p.png")
        assert (told["channels"], told["depth"]) == (channels, depth)


def test_check_passes_and_reports(ball):
    report = summary("check", ball, "--voxel", 0.3)
    assert report["passed"] and len(report["rows"]) > 10
    assert all(row["measured"] <= row["bound"] for row in report["rows"])


def test_two_dimensional_models(tmp_path):
    quarter = DATA / "frep" / "quarter.vm"
    assert "unbounded along z" in refused("mesh", quarter, "-o", tmp_path / "q.stl")
    assert summary("mesh", quarter, "-o", tmp_path / "q.stl", "--thickness", 0.2)["volume"] == pytest.approx(
        math.pi / 4 * 0.5 * 0.2, rel=0.01)
    summary("render", quarter, "-o", tmp_path / "q.png", "--mode", "bitmap")


def test_bad_input_leaves_files_alone(ball, tmp_path):
    kept = tmp_path / "kept.stl"
    kept.write_text("mine")
    broken = tmp_path / "broken.frep"
    for text in ("sphere(", "", "spheer(1)", "x + 1e99", "\0\1\2"):
        broken.write_text(text)
        assert re.search(r"broken\.frep:\d+:\d+: ", refused("mesh", broken, "-o", kept))
    (tmp_path / "garbage.vm").write_bytes(os.urandom(4096))
    for arguments in (
        ("mesh", tmp_path / "absent.math", "-o", kept),
        ("mesh", tmp_path / "garbage.vm", "-o", kept),
        ("mesh", tmp_path / "what.xyz", "-o", kept),
        ("mesh", ball, "-o", kept, "--voxel", 0),
        ("mesh", ball, "-o", kept, "--voxel", "nan"),
        ("mesh", ball, "-o", kept, "--voxel", -1),
        ("mesh", ball, "-o", kept, "--resolution", "inf"),
        ("mesh", ball, "-o", kept, "--resolution", 1e9),
        ("mesh", ball, "-o", kept, "--voxel", 1, "--resolution", 1),
        ("mesh", ball, "-o", kept, "--bounds", "1,2,3"),
        ("mesh", ball, "-o", kept, "--bounds", "0,0,0,0,1,1"),
        ("mesh", ball, "-o", kept, "--bounds", "0,0,0,-1,1,1"),
        ("mesh", ball, "-o", kept, "--bounds", "0,0,0,inf,1,1"),
        ("mesh", ball, "-o", kept, "--bounds", "0,0,0,1,1,x"),
        ("mesh", ball, "-o", kept, "--max-error", -1),
        ("mesh", ball, "-o", tmp_path / "no" / "such" / "folder.stl"),
        ("mesh", ball, "-o", tmp_path),
        ("mesh", ball, "-o", tmp_path / "ball.xyz"),
        ("mesh", ball),
        ("build", ball, "-o", tmp_path / "b.asdf", "--resolution", 1e7),
        ("render", ball, "-o", tmp_path / "p.png", "--size", 0),
        ("render", ball, "-o", tmp_path / "p.png", "--mode", "pretty"),
        ("render", ball, "-o", tmp_path / "p.jpg"),
        ("frobnicate",),
        ("--frob",),
        (),
    ):
        refused(*arguments)
    assert kept.read_text() == "mine"
    assert sorted(p.name for p in tmp_path.iterdir()) == [
        "ball.frep", "broken.frep", "garbage.vm", "kept.stl"], "nothing half made is left"


def test_full_disk(ball):
    assert "No space left" in refused("mesh", ball, "-o", link_to_full(ball))
    assert os.path.exists("/dev/full")


def link_to_full(beside):
    """Returns a link to /dev/full with a mesh's extension."""
    link = beside.parent / "full.stl"
    link.symlink_to("/dev/full")
    return link


def test_large_garbage_is_refused_soon(tmp_path):
    path = tmp_path / "large.math"
    path.write_bytes(b"n" * 100_000_000)
    started = time.monotonic()
    assert "lacks an argument" in refused("info", path)
    path.write_bytes(b"\xff" * 100_000_000)
    refused("info", path)
    assert time.monotonic() - started < 30


def test_deep_expression(tmp_path):
    path = tmp_path / "deep.math"
    path.write_text("s" * 300_000 + "X")  # a function that calls itself so often overflows its 8 MB
    assert summary("info", path)["nodes"] == 300_001


def test_interrupt_leaves_nothing_behind(tmp_path):
    model = tmp_path / "g.frep"
    model.write_text("shell(gyroid(period = 1), 0.1) & sphere(r = 6)")
    process = subprocess.Popen([COMMAND, "mesh", model, "-o", tmp_path / "g.stl", "--voxel", "0.015"],
                               stderr=subprocess.PIPE, text=True)
    time.sleep(1.5)
    process.send_signal(signal.SIGINT)
    started = time.monotonic()
    _, message = process.communicate(timeout=20)
    assert process.returncode == 130 and "cancelled" in message
    assert time.monotonic() - started < 2
    assert [p.name for p in tmp_path.iterdir()] == ["g.frep"]


def test_help():
    assert "render" in run("--help").stdout
    for verb in ("build", "mesh", "render", "check", "info", "convert"):
        assert run(verb, "--help").returncode == 0


def test_meshes_are_models(tmp_path):
    """An inverted cube without one side becomes closed and valid, and so does a mesh with overlapping parts."""
    corners = [(x, y, z) for z in (0, 10) for y in (0, 10) for x in (0, 10)]
    sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]

    def write(name, sides, turned=False, shift=0):
        faces = [(a, b, c) for q in sides for a, b, c in ((q[0], q[1], q[2]), (q[0], q[2], q[3]))]
        lines = ["OFF", f"{len(corners)} {len(faces)} 0"]
        lines += [f"{x + shift} {y + shift} {z + shift}" for x, y, z in corners]
        lines += ["3 " + " ".join(map(str, reversed(f) if turned else f)) for f in faces]
        (tmp_path / name).write_text("\n".join(lines) + "\n")
        return tmp_path / name

    whole = write("whole.off", sides)
    made = summary("mesh", whole, "-o", tmp_path / "a.stl", "--voxel", 0.5)
    # Edges are sharp, sides are flat.
    assert made["volume"] == pytest.approx(1000, rel=1e-6) and made["triangles"] < 100
    turned = summary("mesh", write("turned.off", sides, True), "-o", tmp_path / "a.stl", "--voxel", 0.5)
    assert turned["volume"] == pytest.approx(1000, rel=1e-3)
    holed = write("holed.off", sides[1:])
    closed = summary("mesh", holed, "-o", tmp_path / "b.stl", "--voxel", 0.5)
    assert closed["volume"] == pytest.approx(1000, rel=1e-6) and closed["triangles"] < 100
    assert "holed.off is open: 1 rim is closed by lids of 100 mm2" in run(
        "mesh", holed, "-o", tmp_path / "b.stl", "--voxel", 0.5).stderr
    assert summary("check", holed, "--voxel", 0.5)["passed"]
    built = summary("build", whole, "-o", tmp_path / "c.asdf", "--voxel", 0.5)
    assert built["leafs"] > 0
    assert "no triangles" in refused("build", write("none.off", []), "-o", tmp_path / "d.asdf")


def test_scripts_are_not_confused_by_the_current_folder(tmp_path):
    (tmp_path / "json.py").write_text("raise SystemExit(7)")
    (tmp_path / "models").mkdir()
    (tmp_path / "models" / "ball.py").write_text("import json\nfrom fieldfab.shapes import *\nshape = sphere(5)\n")
    assert "volume 523.6" in run("info", "models/ball.py", cwd=tmp_path).stdout
