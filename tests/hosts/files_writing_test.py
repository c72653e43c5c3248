"""Files written whole or not at all, failing streams, inputs other than files, memory limits and signals."""

import contextlib
import json
import os
import pathlib
import random
import resource
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time

import faults
import numpy as np
import pytest
from conftest import BUILD, COMMAND
from freecad_host import screen
from programs import need

OLD = b"the old file"
JOB = """
machine = "linuxcnc"
[input]
model = "part.frep"
[stock]
lower = [-12, -12, -8]
upper = [12, 12, 0]
[[tool]]
number = 1
diameter = 6
flute = 16
length = 30
[[operation]]
type = "rough"
tool = 1
stepdown = 4
bottom = -8
"""
PROGRAM = "G21 G90\nT1 M6\nS1000 M3\nG0 X0 Y0 Z5\nG1 Z-2 F200\nG1 X8\nG0 Z5\nM30\n"
SETUP = """
[stock]
lower = [-12, -12, -8]
upper = [12, 12, 0]
[[tool]]
number = 1
diameter = 6
flute = 16
length = 30
"""
# Output file, and arguments of a command that writes it; OUT stands for its path.
OUTPUTS = {
    "mesh.stl": "mesh ball.frep -o OUT --voxel 0.5",
    "mesh.ply": "mesh ball.frep -o OUT --voxel 0.5",
    "mesh.off": "mesh ball.frep -o OUT --voxel 0.5",
    "mesh.obj": "mesh ball.frep -o OUT --voxel 0.5",
    "mesh.3mf": "mesh ball.frep -o OUT --voxel 0.5",
    "mesh.glb": "mesh ball.frep -o OUT --voxel 0.5",
    "solid.asdf": "build ball.frep -o OUT --voxel 0.5",
    "scan.asdf": "build scan_20x20x20_uint8.raw -o OUT",
    "levels.vdb": "convert ball.frep -o OUT --voxel 0.5",
    "scan.nrrd": "convert scan_20x20x20_uint8.raw -o OUT",
    "scan.mha": "convert scan_20x20x20_uint8.raw -o OUT",
    "scan.nii": "convert scan_20x20x20_uint8.raw -o OUT",
    "scan.nii.gz": "convert scan_20x20x20_uint8.raw -o OUT",
    "formula.math": "convert ball.frep -o OUT",
    "formula.vm": "convert ball.frep -o OUT",
    "formula.frep": "convert ball.frep -o OUT",
    "formula.dot": "convert ball.frep -o OUT",
    "picture.png": "render ball.frep -o OUT --size 64",
    "histogram.png": "info scan_20x20x20_uint8.raw --histogram OUT",
    "part.nc": "cam job.toml -o OUT",
    "ways.png": "cam job.toml -o made.nc --picture OUT",
    "ways.svg": "cam job.toml -o made.nc --picture OUT",
    "sheet.html": "cam job.toml -o made.nc --sheet OUT",
    "stock.stl": "simulate program.nc --setup setup.toml -o OUT",
    "stock.asdf": "simulate program.nc --setup setup.toml -o OUT",
    "report.json": "simulate program.nc --setup setup.toml --report OUT",
    "report.html": "simulate program.nc --setup setup.toml --report OUT",
    "stock.png": "simulate program.nc --setup setup.toml --picture OUT --size 64",
    "frames/frame_0001.png": "simulate program.nc --setup setup.toml --frames FOLDER --frame-count 1 --size 64",
    "design.stl": "openscad box.scad -o OUT",
}
TEXTS = [name for name in OUTPUTS if name.startswith("formula")]


def inputs(folder):
    """Writes small input files for each verb."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "ball.frep").write_text("sphere(5)")
    (folder / "two_parts.frep").write_text('part(box(3, 3, 3), "a", "red")\npart(move(sphere(1), dx = 4), "b", "blue")')
    (folder / "plate.csg").write_text("difference() { cube(size = [8, 6, 1], center = true); "
                                      "cylinder(h = 3, r1 = 1, r2 = 1, center = true, $fn = 12); }")
    (folder / "part.frep").write_text("max(max(max(abs(x) - 9, abs(y) - 9), max(z, -z - 8)), 4 - sqrt(x*x + y*y))")
    (folder / "job.toml").write_text(JOB)
    (folder / "program.nc").write_text(PROGRAM)
    (folder / "setup.toml").write_text(SETUP)
    (folder / "box.scad").write_text("cube([10, 20, 30]);")
    z, y, x = np.meshgrid(*[np.arange(20) - 9.5] * 3, indexing="ij")
    np.clip(128 + 40 * (6 - np.sqrt(x * x + y * y + z * z)), 0, 255).astype(np.uint8).tofile(
        folder / "scan_20x20x20_uint8.raw")
    return folder


@pytest.fixture
def folder(tmp_path):
    return inputs(tmp_path / "work")


def words_of(name, out):
    words = OUTPUTS[name].split()
    if words[0] == "openscad":
        need("openscad")
    return [str(out) if word == "OUT" else str(out.parent) if word == "FOLDER" else word for word in words]


def run(words, folder, timeout=120, **more):
    temporary = folder.parent / "tmp"
    temporary.mkdir(exist_ok=True)
    done = subprocess.run([COMMAND, *map(str, words)], capture_output=True, timeout=timeout, cwd=folder,
                          env={**os.environ, "TMPDIR": str(temporary)}, **more)
    assert list(temporary.iterdir()) == [], "temporary files are left"
    if done.stderr is not None:
        done.message = done.stderr.decode(errors="replace")
        done.lines = [line for line in done.message.splitlines()
                      if line.strip() and not line.startswith("fieldfab: note: ")]
    return done


def refused(done, code=2):
    assert done.returncode == code, (done.returncode, done.message)
    assert len(done.lines) == 1 and done.lines[0].startswith("fieldfab: "), done.message
    return done.lines[0]


# Writing


@pytest.mark.parametrize("name", OUTPUTS)
def test_a_full_device_is_told(name, folder):
    out = folder / name
    out.parent.mkdir(exist_ok=True)
    words = words_of(name, out)
    out.symlink_to("/dev/full")
    message = refused(run(words, folder))
    assert "No space left on device" in message and out.name in message
    assert out.is_symlink() and pathlib.Path("/dev/full").is_char_device()


@pytest.mark.parametrize("name", OUTPUTS)
def test_a_limit_of_the_size_of_files_is_told(name, folder):
    """SIGXFSZ does not end the command."""
    out = folder / name
    out.parent.mkdir(exist_ok=True)
    words = words_of(name, out)
    limit = 8 if name in TEXTS else 64
    if words[0] == "cam" and name != "part.nc":  # the smaller program is written before its picture
        assert run(words, folder).returncode == 0
        limit = (folder / "made.nc").stat().st_size
        assert limit < out.stat().st_size
    out.write_bytes(OLD)
    before = faults.files_of(folder)
    done = run(words, folder, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
    message = refused(done)
    if words[0] != "openscad":  # it has a message of its own
        assert "File too large" in message and out.name in message
    assert "XXXXXX" not in message and f".{out.stem}." not in message.replace(out.name, "")
    assert faults.files_of(folder) == before


@pytest.fixture(scope="module")
def small_disk(tmp_path_factory):
    """A file system in memory, 256 kB."""
    place = tmp_path_factory.mktemp("disk")
    made = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=256k", "tmpfs", place], capture_output=True, text=True)
    if made.returncode != 0:
        pytest.skip(f"no file system can be mounted here: {made.stderr.strip()}")
    yield place
    subprocess.run(["umount", place], check=True)


@pytest.mark.parametrize("free", [0, 4096])
@pytest.mark.parametrize("name", OUTPUTS)
def test_a_full_disk_leaves_the_old_file(name, free, folder, small_disk):
    if free and name in TEXTS + ["part.nc", "solid.asdf", "ways.svg", "report.json", "histogram.png", "scan.nii.gz",
                                 "design.stl", "stock.png",
                                 "picture.png", "frames/frame_0001.png", "ways.png", "scan.nrrd", "stock.stl",
                                 "scan.asdf"]:
        pytest.skip("fits into 4096 bytes, or nearly")
    for path in small_disk.iterdir():
        shutil.rmtree(path) if path.is_dir() else path.unlink()
    out = small_disk / name
    out.parent.mkdir(exist_ok=True)
    words = words_of(name, out)
    out.write_bytes(OLD)
    filler = os.open(small_disk / "filler", os.O_WRONLY | os.O_CREAT)
    with pytest.raises(OSError):
        while True:
            os.write(filler, bytes(4096))
    os.truncate(filler, os.fstat(filler).st_size // 4096 * 4096 - free)
    os.close(filler)
    before = faults.files_of(small_disk)
    message = refused(run(words, folder))
    if words[0] != "openscad":
        assert "No space left on device" in message and out.name in message
    assert faults.files_of(small_disk) == before


@pytest.mark.parametrize("name", OUTPUTS)
def test_a_file_is_written_through_a_link_and_by_a_long_name(name, folder):
    """Control for the tests above: the same commands succeed."""
    real = folder / ("n" * 200 + pathlib.Path(name).name)
    out = folder / name
    out.parent.mkdir(exist_ok=True)
    words = words_of(name, out)
    real.write_bytes(OLD)
    real.chmod(0o640)
    out.symlink_to(real)
    names = sorted(path.name for path in folder.iterdir())
    done = run(words, folder)
    assert done.returncode == 0, done.message
    assert out.is_symlink() and real.read_bytes() != OLD and real.stat().st_mode & 0o777 == 0o640
    assert [n for n in sorted(path.name for path in folder.iterdir()) if n not in names] in ([], ["made.nc"])


def test_a_pipe_gets_the_finished_file(folder):
    for name in ("mesh.stl", "solid.asdf", "levels.vdb", "scan.nii.gz"):
        out = folder / name
        assert run(words_of(name, out), folder).returncode == 0
        expected = out.stat().st_size
        out.unlink()
        os.mkfifo(out)
        got = []
        reader = threading.Thread(target=lambda: got.append(out.read_bytes()))
        reader.start()
        done = run(words_of(name, out), folder)
        reader.join()
        assert done.returncode == 0, done.message
        assert abs(len(got[0]) - expected) <= 64
        out.unlink()


def test_vdb_and_volumes_are_read_again(folder):
    """Files written through our own stream are accepted by OpenVDB's and ITK's readers."""
    assert run(words_of("levels.vdb", folder / "a.vdb"), folder).returncode == 0
    done = run(["--json", "mesh", "a.vdb", "-o", "a.stl"], folder)
    assert done.returncode == 0, done.message
    assert json.loads(done.stdout)["volume"] == pytest.approx(4 / 3 * np.pi * 125, rel=0.02)


# Messages


def test_messages_of_what_cannot_be_written(folder):
    message = refused(run(["convert", "ball.frep", "-o", "ball.nrrd"], folder))
    assert "known are" not in message and "only a volume" in message
    assert "'.gz'" in refused(run(["convert", "scan_20x20x20_uint8.raw", "-o", "scan.gz"], folder))
    assert "'.gltf'" in refused(run(["mesh", "ball.frep", "-o", "ball.gltf"], folder))
    assert run(["mesh", "ball.frep", "-o", "BALL.STL", "--voxel", 1], folder).returncode == 0


def test_a_mesh_that_takes_long_says_why(folder):
    """A rim that no lid closes: a small file with minutes of winding numbers."""
    chance = random.Random(1)
    count = 300
    rim = [(10 * np.cos(a) + chance.uniform(-2, 2), 10 * np.sin(a) + chance.uniform(-2, 2), chance.uniform(-2, 2))
           for a in np.linspace(0, 2 * np.pi, count, endpoint=False)]
    lines = ["OFF", f"{count + 1} {count} 0", *(" ".join(map(str, p)) for p in [*rim, (0, 0, -10)])]
    lines += [f"3 {i} {(i + 1) % count} {count}" for i in range(count)]
    (folder / "cone.off").write_text("\n".join(lines) + "\n")
    process = subprocess.Popen([COMMAND, "--progress", "mesh", "cone.off", "-o", "made.stl"], cwd=folder,
                               stderr=subprocess.PIPE)
    os.set_blocking(process.stderr.fileno(), False)
    said, deadline = b"", time.monotonic() + 60
    while time.monotonic() < deadline and not (b"winding numbers" in said and b"sampling" in said):
        said += process.stderr.read() or b""
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    started = time.monotonic()
    assert process.wait(timeout=10) == 130 and time.monotonic() - started < 1
    assert b"cone.off is open, and lids cannot close it" in said and b"% sampling" in said


def test_python_names_the_file_that_was_asked_for(folder, monkeypatch):
    import fieldfab as ff

    full = folder / "full"
    mesh = ff.mesh(ff.parse("sphere(5)"), voxel=1)
    volume = ff.Volume.open(folder / "scan_20x20x20_uint8.raw")
    writers = {"stl": mesh.save, "nii.gz": volume.save, "nrrd": volume.save, "asdf": volume.save_asdf,
               "png": ff.render(ff.parse("sphere(5)"), size=64).save,
               "vdb": lambda path: ff.write_vdb(ff.parse("sphere(5)"), path, voxel=1),
               "txt": lambda path: ff.write_file(path, "text")}
    for ending, write in writers.items():
        path = folder / f"full.{ending}"
        path.symlink_to("/dev/full")
        with pytest.raises(ff.Error) as raised:
            write(path)
        assert raised.value.kind == "io" and str(raised.value) == f"{path}: cannot write: No space left on device"
        path = folder / "absent" / f"x.{ending}"
        with pytest.raises(ff.Error) as raised:
            write(path)
        assert str(raised.value) == f"{path}: cannot write: No such file or directory"
    assert not full.exists()
    ff.write_file(folder / "text.txt", "grün")
    ff.write_file(folder / "bytes.bin", b"\0\xff")
    assert ((folder / "text.txt").read_text(encoding="utf-8") == "grün"
            and (folder / "bytes.bin").read_bytes() == b"\0\xff")


# Streams

VERBS = {
    "build": "build ball.frep -o made.asdf --voxel 0.5",
    "mesh": "mesh ball.frep -o made.stl --voxel 0.5",
    "render": "render ball.frep -o made.png --size 64",
    "check": "check ball.frep --voxel 0.5",
    "info": "info ball.frep",
    "convert": "convert ball.frep -o made.vm",
    "cam": "cam job.toml -o made.nc",
    "simulate": "simulate program.nc --setup setup.toml -o made.stl",
    "openscad": "openscad box.scad -o made.stl",
    "help": "--help",
}


def shell(folder, verb, redirections, options=""):
    if verb == "openscad":
        need("openscad")
    command = f"{COMMAND} {options} {VERBS[verb]} {redirections}"
    return subprocess.run(["bash", "-c", command], capture_output=True, text=True, timeout=120, cwd=folder)


def made(folder):
    return [path for path in folder.iterdir() if path.name.startswith("made")]


@pytest.mark.parametrize("verb", VERBS)
def test_streams_that_are_closed_full_or_dead(verb, folder):
    expected = 0 if verb in ("check", "info", "help") else 1
    for redirections in ("<&-", ">&-", "2>&-", ">&- 2>&-", "<&- >&- 2>&-", "2>/dev/full", "--progress 2>/dev/full",
                         "2> >(true)", "--progress 2> >(true)"):
        done = shell(folder, verb, redirections)
        assert done.returncode == 0, (redirections, done.returncode, done.stderr)
        assert len(made(folder)) == expected
        for path in made(folder):
            assert path.stat().st_size > 0 and b"fieldfab: " not in path.read_bytes()
            path.unlink()
    for options in ("", "--json"):
        done = shell(folder, verb, ">/dev/full", options)
        assert (done.returncode == 2
                and done.stderr.endswith("fieldfab: standard output: cannot write: No space left on device\n"))
        assert len(made(folder)) == expected, "the work is done, only its summary is lost"
        done = shell(folder, verb, "| true; exit ${PIPESTATUS[0]}", options)
        lines = ("", "fieldfab: standard output: cannot write: Broken pipe\n")
        assert done.returncode in (0, 2) and done.stderr in lines or "note" in done.stderr


@pytest.mark.parametrize("redirection", ["2>&-", "2>/dev/full", "2> >(true)", ">&- 2>&-", ">/dev/full 2>&1"])
def test_complaints_to_streams_that_fail(redirection, folder):
    assert subprocess.run(["bash", "-c", f"{COMMAND} mesh absent.frep -o made.stl {redirection}"],
                          cwd=folder).returncode == 2
    assert subprocess.run(["bash", "-c", f"{COMMAND} frobnicate {redirection}"], cwd=folder).returncode == 2


def test_json_of_names_that_are_no_utf8(folder):
    name = b"n\xff\xfe.frep"
    (pathlib.Path(os.fsdecode(os.fsencode(folder) + b"/" + name))).write_text("sphere(5)")
    for words in ([b"info", name], [b"mesh", name, b"-o", b"m\xff.stl", b"--voxel", b"1"],
                  [b"convert", name, b"-o", b"m\xff.vm"],
                  [b"render", name, b"-o", b"m\xff.png", b"--size", b"16"], [b"check", name, b"--voxel", b"1"],
                  [b"build", name, b"-o", b"m\xff.asdf", b"--voxel", b"1"]):
        done = subprocess.run([COMMAND, "--json", *words], capture_output=True, cwd=folder)
        assert done.returncode == 0, done.stderr
        json.loads(done.stdout.decode("utf-8"))


# Inputs other than files

INPUTS = {
    "info": "frep math vm py csg scad stl ply off obj 3mf asdf png raw vol vgi tif mha mhd nrrd nhdr nii nii.gz "
    "dcm vdb".split(),
    "mesh": "frep py ko scad stl asdf nrrd vdb tif".split(),
    "simulate": ["nc", "sbp", "rml", "plt"],
    "cam": ["toml"],
    "openscad": ["scad"],
}


@pytest.mark.parametrize("kind", ["pipe", "socket", "device", "folder link"])
@pytest.mark.parametrize("verb, ending", [(verb, ending) for verb, endings in INPUTS.items() for ending in endings])
def test_what_is_no_file_is_refused_at_once(verb, ending, kind, folder):
    path = folder / f"in.{ending}"
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "device":
        path.symlink_to("/dev/zero")
    elif kind == "folder link":
        (folder / "sub").mkdir()
        path.symlink_to(folder / "sub")
    else:
        server = socket.socket(socket.AF_UNIX)
        with contextlib.chdir(folder):  # names of sockets have a length limit
            server.bind(path.name)
    more = {"mesh": ["-o", "made.stl"], "simulate": ["--setup", "setup.toml"], "cam": ["-o", "made.nc"],
            "openscad": ["-o", "made.stl"]}
    started = time.monotonic()
    message = refused(run([verb, path, *more.get(verb, [])], folder, timeout=10))
    assert time.monotonic() - started < 3
    if kind in ("pipe", "socket", "device"):
        assert f"is a {kind}, not a file" in message or "reader" in message
    assert made(folder) == []


def test_files_named_by_files_are_no_pipes(folder):
    """Slices, samples, set-ups and targets."""
    os.mkfifo(folder / "pipe.frep")
    os.mkfifo(folder / "pipe.raw")
    (folder / "a.toml").write_text(SETUP.replace("[stock]", '[target]\nmodel = "pipe.frep"\n[stock]', 1))
    (folder / "b.toml").write_text(JOB.replace("part.frep", "pipe.frep"))
    (folder / "c.mhd").write_text("ObjectType = Image\nNDims = 3\nDimSize = 20 20 20\nElementType = MET_UCHAR\n"
                                  "ElementDataFile = pipe.raw\n")
    (folder / "d.nhdr").write_text("NRRD0004\ntype: uchar\ndimension: 3\nsizes: 20 20 20\nencoding: raw\n"
                                   "data file: pipe.raw\n")
    (folder / "e.vgi").write_text("size = 20 20 20\nbitsperelement = 8\ndatatype = unsigned integer\nname = pipe.raw\n")
    (folder / "e.vol").write_bytes(b"")
    for words in (["simulate", "program.nc", "--setup", "a.toml"], ["cam", "b.toml", "-o", "made.nc"],
                  ["info", "c.mhd"], ["info", "d.nhdr"], ["info", "e.vgi"],
                  ["simulate", "program.nc", "--setup", "setup.toml", "--target", "pipe.frep"],
                  ["simulate", "program.nc", "--setup", "pipe.frep"]):
        started = time.monotonic()
        assert "is a pipe, not a file" in refused(run(words, folder, timeout=10)), words
        assert time.monotonic() - started < 3
    slices = folder / "slices"
    slices.mkdir()
    os.mkfifo(slices / "a.dcm")
    os.mkfifo(slices / "b.tif")
    refused(run(["info", "slices"], folder, timeout=10))


def test_a_substituted_process_is_read(folder):
    """A pipe from the shell, through a link with an extension that tells its format."""
    (folder / "given.frep").symlink_to("/dev/stdin")
    done = subprocess.run(["bash", "-c", f"echo 'sphere(5)' | {COMMAND} info given.frep"], cwd=folder,
                          capture_output=True, text=True, timeout=20)
    assert done.returncode == 0 and "f-rep" in done.stdout, done.stderr


# Memory and threads


def test_too_little_memory_is_one_line(folder):
    """The limit is on address space; the program and its libraries take some 500 MB of it."""
    (folder / "ball.frep").write_text("sphere(6)")
    most = 700 << 20
    done = run(["--threads", 2, "mesh", "ball.frep", "-o", "made.stl", "--voxel", 0.005], folder,
               preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (most, most)))
    # Allocation of machine code may fail first. That gives a note, and formulas are interpreted.
    done.lines = [line for line in done.lines if "formulas are interpreted instead" not in line]
    assert refused(done, 3) == "fieldfab: there is not enough memory for this" or "system refuses" in done.message
    assert made(folder) == []


# Signals


HEAVY = {
    "mesh": ("shell(gyroid(period = 1), 0.1) & sphere(6)", "mesh heavy.frep -o made.stl --voxel 0.02"),
    "build": ("shell(gyroid(period = 1), 0.1) & sphere(6)", "build heavy.frep -o made.asdf --voxel 0.02"),
    "vdb": ("shell(gyroid(period = 1), 0.1) & sphere(6)", "convert heavy.frep -o made.vdb --voxel 0.03"),
    "check": ("shell(gyroid(period = 1), 0.1) & sphere(6)", "check heavy.frep --voxel 0.05"),
    "render": ("shell(gyroid(period = 1), 0.1) & sphere(6)", "render heavy.frep -o made.png --size 8192"),
}


def interrupted(words, folder, seconds, number=signal.SIGINT):
    """Returns the exit of the command after a signal, and the seconds until then."""
    temporary = folder.parent / "tmp"
    temporary.mkdir(exist_ok=True)
    # nohup leaves one of them ignored.
    taken = lambda: [signal.signal(each, signal.SIG_DFL) for each in (signal.SIGINT, signal.SIGHUP)]
    process = subprocess.Popen([COMMAND, *words], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                               preexec_fn=taken,
                               env={**os.environ, "TMPDIR": str(temporary)})
    try:
        time.sleep(seconds)
        process.send_signal(number)
        started = time.monotonic()
        _, message = process.communicate(timeout=60)
    finally:
        process.kill()
    assert list(temporary.iterdir()) == []
    return process.returncode, time.monotonic() - started, message


@pytest.mark.parametrize("name", HEAVY)
def test_an_interrupt_is_answered_in_half_a_second(name, folder):
    text, words = HEAVY[name]
    (folder / "heavy.frep").write_text(text)
    chance = random.Random(name)
    for moment in range(3):
        code, seconds, message = interrupted(words.split(), folder, chance.uniform(0.3, 4),
                                             chance.choice([signal.SIGINT, signal.SIGTERM, signal.SIGHUP]))
        if code == 0:
            for path in made(folder):
                path.unlink()
            continue
        assert code == 130 and message.count("cancelled") == 1, (code, message)
        assert seconds < 0.5 + 0.5 * (os.getloadavg()[0] > os.cpu_count()), f"{seconds:.2f} s"
        assert made(folder) == [] and not [p for p in folder.iterdir() if p.name.startswith(".")]


def test_an_end_while_it_starts(folder):
    """Before the command handles signals they have their default effect."""
    for milliseconds in range(0, 120, 8):
        code, _, message = interrupted(VERBS["mesh"].split(), folder, milliseconds / 1000, signal.SIGTERM)
        assert code in (-signal.SIGTERM, 130, 0), (code, message)
        assert not [p for p in folder.iterdir() if p.name.startswith(".")]
        for path in made(folder):
            path.unlink()


def children_of(process):
    """Returns all descendants of a process."""
    below = []
    for entry in pathlib.Path("/proc").iterdir():
        try:
            if entry.name.isdigit() and int((entry / "stat").read_text().rpartition(")")[2].split()[1]) == process:
                below += [int(entry.name), *children_of(int(entry.name))]
        except OSError:  # it has ended
            pass
    return below


def ends_soon(process, seconds=5):
    deadline = time.monotonic() + seconds
    while time.monotonic() < deadline:
        try:
            if pathlib.Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] == "Z":
                return True
        except OSError:
            return True
        time.sleep(0.05)
    return False


ENDLESS = "import time\nopen('started', 'w').close()\ntime.sleep(60)\n"


@pytest.mark.parametrize("how", ["script", "openscad", "python", "workbench", "kokopelli"])
def test_what_is_started_ends_with_the_one_that_started_it(how, folder):
    """Scripts and OpenSCAD end with their parent (the command, FreeCAD, MeshLab, the edit window), even if that is
    killed."""
    (folder / "endless.py").write_text(ENDLESS)
    (folder / "endless.ko").write_text(ENDLESS)
    (folder / "endless.scad").write_text("function f(n) = n < 1 ? 1 : f(n - 1) + f(n - 1); echo(f(40)); cube(f(40));")
    words = {
        "script": [COMMAND, "info", "endless.py"],
        "openscad": [COMMAND, "info", "endless.scad"],
        "python": [sys.executable, "-c", "import fieldfab as ff; ff.run_model('endless.py')"],
        "kokopelli": [sys.executable, "-c", "import subprocess, sys; "
                      "subprocess.Popen([sys.executable, '-m', 'fieldfab.script', 'endless.ko']).wait()"],
        "workbench": [sys.executable, "-c", "import subprocess, sys; "
                      "subprocess.Popen([sys.executable, '-m', 'fieldfab.script', 'endless.py']).wait()"],
    }[how]
    if how == "openscad":
        need("openscad")
    process = subprocess.Popen(words, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               env={**os.environ, "PYTHONPATH": str(BUILD / "python")})
    deadline = time.monotonic() + 20
    while (time.monotonic() < deadline
           and not ((folder / "started").exists() or (how == "openscad" and children_of(process.pid)))):
        time.sleep(0.05)
    below = children_of(process.pid)
    assert_ends_with_its_children(process, below)


@pytest.mark.parametrize("host", ["meshlab", "edit"])
def test_what_a_window_starts_ends_with_it(host, folder, screen):
    """OpenSCAD, at work for MeshLab or for the edit window, ends with them, even if they are killed."""
    need("openscad")
    (folder / "endless.scad").write_text("function f(n) = n < 1 ? 1 : f(n - 1) + f(n - 1); echo(f(40)); cube(f(40));")
    words = {"meshlab": [BUILD / "meshlab" / "meshlabserver", "-i", "endless.scad"],
             "edit": [COMMAND, "edit", "endless.scad"]}[host]
    process = subprocess.Popen(words, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               env={**os.environ, "DISPLAY": screen, "HOME": str(folder)})
    deadline = time.monotonic() + 30
    while time.monotonic() < deadline and "openscad" not in [name_of(child) for child in children_of(process.pid)]:
        time.sleep(0.05)
    below = children_of(process.pid)
    assert "openscad" in [name_of(child) for child in below]
    assert_ends_with_its_children(process, below)


def name_of(process):
    try:
        return pathlib.Path(f"/proc/{process}/comm").read_text().strip()
    except OSError:
        return ""


def assert_ends_with_its_children(process, below):
    assert below
    process.kill()
    process.wait()
    left = [child for child in below if not ends_soon(child)]
    for child in left:
        os.kill(child, signal.SIGKILL)
    assert left == []
