"""Failing calls in verbs with several outputs and in verbs that only read, and names that are not UTF-8. The tests of
verbs with one output are in files_faults_test.py and files_writing_test.py."""

import gzip
import json
import os
import random
import re
import shutil
import signal
import subprocess
import time

import faults
import pytest
from conftest import COMMAND
from files_faults_test import KILLS
from files_writing_test import OLD, inputs, interrupted
from programs import lacks, need

# Arguments of a command, and its output files.
WRITES = {
    "height map": ("render ball.frep -o made.png --mode height --size 60", ["made.png"]),
    "histogram": ("info scan_20x20x20_uint8.raw --histogram made.png", ["made.png"]),
    "openscad": ("openscad box.scad -o made.stl", ["made.stl"]),
    "cached openscad": ("openscad smooth.scad -o made.stl", ["made.stl"]),
    "materials": ("mesh two_parts.frep -o made.obj --voxel 0.5", ["made.mtl", "made.obj"]),
    "sheet": ("cam job.toml -o made.nc --picture made.svg --sheet made.html", ["made.nc", "made.svg", "made.html"]),
    "report": ("simulate program.nc --setup setup.toml -o made.fieldstock --report made.json --picture made.png"
               " --size 64", ["made.fieldstock", "made.json", "made.png"]),
}
SMOOTH = "use <fieldfab.scad>\nsmooth_union(2) { cube(10); translate([5, 5, 5]) cube(8); }\n"
READS = {
    "check": "check ball.frep --voxel 0.5",
    "info": "info ball.frep",
    "info of a volume": "info scan_20x20x20_uint8.raw",
    "info of a design": "info plate.csg",
    "info of a mesh": "info part.3mf",
    "info of a level set": "info part.vdb",
    "plan": "cam job.toml --plan",
    "simulate": "simulate program.nc --setup setup.toml",
}


@pytest.fixture
def folder(tmp_path):
    folder = inputs(tmp_path / "work")
    for name in ("part.3mf", "part.vdb"):
        words = [COMMAND, "convert", "ball.frep", "-o", name, "--voxel", "0.5"]
        subprocess.run(words, cwd=folder, check=True, capture_output=True)
    (folder / "smooth.scad").write_text(SMOOTH)
    return folder


def once(words, outputs, folder, **injected):
    """Runs a command over old files, and checks the guarantees for any outcome. Returns the replaced files."""
    shutil.rmtree(folder / "fieldfab-cache", ignore_errors=True)
    if words.startswith("openscad"):
        need("openscad")
    for name in outputs:
        (folder / name).write_bytes(OLD)
    before = faults.files_of(folder)
    done = faults.run(words.split(), folder, **injected)
    after = faults.files_of(folder)
    assert done.returncode not in faults.CRASHES, (injected, done.stderr)
    assert done.left == [], (injected, "temporary files are left")
    made = {name for name in after.keys() ^ before.keys() if not name.startswith("fieldfab")}  # OpenSCAD's
    assert made == set(), injected
    done.replaced = [name for name in before if after.get(name) != before[name] and not name.startswith("fieldfab")]
    assert set(done.replaced) <= set(outputs), injected
    done.lines = [line for line in done.stderr.splitlines() if not line.startswith("fieldfab: note: ")]
    return done


def refused(done, codes):
    assert done.returncode in codes, (done.returncode, done.stderr)
    assert len(done.lines) == 1 and done.lines[0].startswith("fieldfab: "), done.stderr


@pytest.mark.parametrize("call", ["write", "fsync", "rename"])
@pytest.mark.parametrize("name", WRITES)
def test_a_failing_call_leaves_old_files_or_new_ones(name, call, folder):
    words, outputs = WRITES[name]
    for number in range(1, 200):
        done = once(words, outputs, folder, call=call, at=number)
        if done.returncode == 0:
            assert done.replaced == sorted(outputs)
            break
        refused(done, {2})
        if name == "materials":  # useless without their triangles
            assert done.replaced in ([], sorted(outputs)) and (not done.replaced or call == "fsync")
    else:
        pytest.fail("it never succeeds")
    assert number > (0 if name == "openscad" else len(outputs))  # OpenSCAD writes the mesh


@pytest.mark.parametrize("links", [True, False])
@pytest.mark.parametrize("old", [True, False])
def test_an_obj_file_and_its_materials_are_both_old_or_both_new(folder, old, links, tmp_path):
    """A rename fails, with and without old files and hard links; power is lost at any call."""
    words, (materials, triangles) = WRITES["materials"]
    more = {} if links else {"no_link": 1}

    def start():
        for name in (materials, triangles):
            (folder / name).unlink(missing_ok=True)
            if old:
                (folder / name).write_bytes(b"old " + name.encode())
        return faults.files_of(folder)

    before = start()
    failed = 0
    for number in range(1, 9):
        done = faults.run(words.split(), folder, call="rename", at=number, **more)
        if done.returncode == 0:
            break
        failed += 1
        assert done.returncode == 2 and faults.files_of(folder) == before, (number, done.stderr)
    assert failed == (2 if links and old else 3)  # a file without another name is moved aside
    after = faults.files_of(folder)
    assert after.keys() == before.keys() | {materials, triangles}
    assert after[materials] != before.get(materials) and after[triangles] != before.get(triangles)

    before = start()
    done = faults.run(words.split(), folder, call="any", count=tmp_path / "count", **more)
    total, seen = int((tmp_path / "count").read_text()), set()
    for moment in range(1, total + 2):
        before = start()
        (tmp_path / f"journal{moment}").mkdir()
        journal = tmp_path / f"journal{moment}"
        done = faults.run(words.split(), folder, call="any", at=moment, kill=1, journal=journal, **more)
        assert done.returncode == (-9 if moment <= total else 0)
        faults.cut_to_synced(folder, faults.lose_power(journal, folder), before)
        now = faults.files_of(folder)
        new = now.get(materials) != before.get(materials)
        assert new == (now.get(triangles) != before.get(triangles)), moment
        if new:
            assert now[materials] == after[materials] and abs(len(now[triangles]) - len(after[triangles])) < 64
        seen.add(new)
        for path in now.keys() - before.keys():
            (folder / path).unlink()
    assert seen == {True, False}


@pytest.mark.parametrize("name", READS)
def test_verbs_that_read_write_nothing(name, folder, tmp_path):
    done = once(READS[name], [], folder, call="any", at=1, lasting=1, count=tmp_path / "count")
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "count").read_text() == "0"


@pytest.mark.parametrize("lasting", [False, True])
@pytest.mark.parametrize("name", [*WRITES, *READS])
def test_a_thread_that_cannot_be_started(name, lasting, folder):
    words, outputs = WRITES.get(name) or (READS[name], [])
    # Threads that OpenVDB starts while it is loaded are not tested (files_faults_test.py).
    loads_openvdb = name == "info of a level set" or name.startswith("check")
    for number in range(1, 2 + max(2, len(os.sched_getaffinity(0))) if loads_openvdb else 20):
        done = once(words, outputs, folder, call="pthread_create", at=number, threads=4,
                    **({"lasting": 1} if lasting else {}))
        if done.returncode == 0:
            assert done.replaced == sorted(outputs)
            break
        refused(done, {3})


@pytest.mark.parametrize("lasting", [False, True])
@pytest.mark.parametrize("name", [*WRITES, *READS])
def test_memory_that_is_refused(name, lasting, folder, tmp_path):
    words, outputs = WRITES.get(name) or (READS[name], [])
    assert once(words, outputs, folder, call="malloc", count=tmp_path / "count").returncode == 0
    total = int((tmp_path / "count").read_text())
    chance = random.Random(name)
    tries = range(max(2, KILLS // 2))
    numbers = {int(total ** chance.random()) for _ in tries} | {chance.randrange(1, total) for _ in tries}
    codes = []
    for number in sorted(numbers):
        done = once(words, outputs, folder, call="malloc", at=number, **({"lasting": 1} if lasting else {}))
        codes.append(done.returncode)
        if done.returncode == 0:
            assert done.replaced == sorted(outputs)
            continue
        assert done.returncode in (2, 3), (number, done.returncode, done.stderr)
        assert len([line for line in done.lines if line.startswith("fieldfab: ")]) == 1, (number, done.stderr)
        assert name != "materials" or done.replaced in ([], sorted(outputs)), number
    assert 3 in codes


def test_memory_that_is_refused_while_machine_code_is_made(folder, tmp_path):
    """An instruction that lacks its memory is not left out of code that runs: the last hundreds of requests, one by
    one, are those of rendering."""
    words, outputs = WRITES["height map"]
    assert once(words, outputs, folder, call="malloc", count=tmp_path / "count").returncode == 0
    total = int((tmp_path / "count").read_text())
    for number in range(total - 300, total):
        assert once(words, outputs, folder, call="malloc", at=number).returncode in (0, 2, 3), number


# Names that are not UTF-8


MODELS = {"py": "from fieldfab.shapes import *\nmodel = sphere(5)\n", "frep": "sphere(5)", "scad": "sphere(5);",
          "csg": "sphere(r = 5);"}
SCRIPT = "import os\nimport fieldfab as ff\nmodel = ff.open(os.fsdecode(b'q\\xff.frep'))\n"


def in_bytes(folder, words):
    done = subprocess.run([COMMAND, "--json", *words], capture_output=True, cwd=folder, timeout=120)
    if done.returncode == 0:
        json.loads(done.stdout.decode("utf-8"))
    done.message = done.stderr.decode("utf-8")
    return done


@pytest.mark.parametrize("kind", MODELS)
def test_models_whose_names_are_no_utf8(kind, folder):
    path = os.path.join(os.fsencode(folder), b"n\xff." + kind.encode())
    if kind == "scad":
        need("openscad")
    with open(path, "w") as file:
        file.write(MODELS[kind])
    done = in_bytes(folder, [b"mesh", path, b"-o", b"made\xff.stl", b"--voxel", b"1"])
    assert done.returncode == 0 and "made\ufffd.stl" in done.stdout.decode(), done.message
    assert os.path.exists(os.path.join(os.fsencode(folder), b"made\xff.stl"))
    with open(path, "w") as file:
        file.write("sphere((")
    done = in_bytes(folder, [b"info", path])
    assert done.returncode == 2 and re.fullmatch(rf"fieldfab: .*n\ufffd\.{kind}:.*\n", done.message), done.message
    os.remove(path)
    done = in_bytes(folder, [b"info", path])
    assert done.returncode == 2 and re.fullmatch(rf"fieldfab: .*n\ufffd\.{kind}: .*\n", done.message), done.message


def test_scripts_and_formulas_open_names_that_are_no_utf8(folder):
    (folder / "ball.frep").rename(os.path.join(str(folder), os.fsdecode(b"q\xff.frep")))
    (folder / "script.py").write_text(SCRIPT)
    (folder / "text.frep").write_bytes(b'open("q\xff.frep")')
    for name in (b"script.py", b"text.frep"):
        done = in_bytes(folder, [b"info", name])
        assert done.returncode == 0 and json.loads(done.stdout)["volume"][0] == pytest.approx(523.6, abs=0.2)
    (folder / "script.py").write_text(SCRIPT.replace("ff.open(", "ff.parse('open(\"' + ").replace("'))", "') + '\")')"))
    done = in_bytes(folder, [b"info", b"script.py"])
    assert done.returncode == 2 and done.message.startswith("fieldfab: script.py:3: ") and done.message.count("\n") == 1


def test_json_of_programs_whose_names_are_no_utf8(folder):
    """As test_json_of_names_that_are_no_utf8 for the other verbs."""
    for name in ("program.nc", "setup.toml", "job.toml", "box.scad"):
        stem, ending = name.split(".")
        (folder / name).rename(os.path.join(str(folder), os.fsdecode(stem.encode() + b"\xff." + ending.encode())))
    commands = [[b"cam", b"job\xff.toml", b"-o", b"a\xff.nc", b"--picture", b"a\xff.svg", b"--sheet", b"a\xff.html"],
                [b"simulate", b"program\xff.nc", b"--setup", b"setup\xff.toml", b"-o", b"b\xff.stl",
                 b"--report", b"b\xff.json", b"--report", b"b\xff.html"]]
    if not lacks("openscad"):
        commands.append([b"openscad", b"box\xff.scad", b"-o", b"c\xff.stl"])
    for words in commands:
        done = in_bytes(folder, words)
        assert done.returncode == 0, done.message
    for name in (b"a\xff.svg", b"a\xff.html", b"b\xff.json", b"b\xff.html"):
        with open(os.path.join(os.fsencode(folder), name), encoding="utf-8") as file:
            text = file.read()
        assert text and (name != b"b\xff.json" or json.loads(text)["good"] is True)


# Signals inside libraries, and during reads of input


def zeros(path, size=400):
    """Writes a volume of 4 * size**3 bytes as a small file; ITK takes a second to inflate it."""
    lines = ["NRRD0005", "type: float", "dimension: 3", f"sizes: {size} {size} {size}", "endian: little",
             "encoding: gzip", "spacings: 1 1 1", "", ""]
    path.write_bytes("\n".join(lines).encode() + gzip.compress(bytes(4 * size**3), compresslevel=1))


def moved(x, body):
    return f"multmatrix([[1, 0, 0, {x}], [0, 1, 0, 1.3], [0, 0, 1, 0.7], [0, 0, 0, 1]]) {{ {body} }}"


CSG = f"difference() {{ sphere(r = 10, $fn = 200); {moved(5, 'sphere(r = 10, $fn = 190);')} }}"
LIBRARIES = {"ITK": "info in.nrrd", "CGAL": "mesh in.csg -o made.stl"}


@pytest.mark.parametrize("name", LIBRARIES)
def test_an_interrupt_inside_a_library_is_answered(name, folder):
    zeros(folder / "in.nrrd")
    (folder / "in.csg").write_text(CSG)
    chance, codes = random.Random(name), []
    for _ in range(5):
        before = sorted(folder.iterdir())
        code, seconds, message = interrupted(LIBRARIES[name].split(), folder, chance.uniform(0.1, 0.8))
        codes.append(code)
        if code == 0:
            continue
        assert code == 130 and message.count("cancelled") == 1, (code, message)
        assert seconds < 0.5 + 0.5 * (os.getloadavg()[0] > os.cpu_count()), f"{seconds:.2f} s"
        assert sorted(folder.iterdir()) == before
    assert 130 in codes


def test_an_interrupt_while_a_pipe_gives_nothing(folder):
    (folder / "given.frep").symlink_to("/dev/stdin")
    words = [COMMAND, "info", "given.frep"]
    process = subprocess.Popen(words, cwd=folder, stdin=subprocess.PIPE, stderr=subprocess.PIPE)
    time.sleep(1)
    assert process.poll() is None
    process.send_signal(signal.SIGINT)
    started = time.monotonic()
    assert process.wait(timeout=10) == 130 and time.monotonic() - started < 1
    process.stdin.close()
    assert b"cancelled" in process.stderr.read()
