"""Each call fails in turn, and power is lost at any moment: the old file remains, or the new file is complete.

FIELDFAB_KILLS: number of losses of power per command (default 6); twice as many failed allocations are tried."""

import os
import random
import shutil

import faults
import pytest
from conftest import BUILD
from files_writing_test import OLD, inputs
from programs import need

KILLS = int(os.environ.get("FIELDFAB_KILLS", "6"))
COMMANDS = {
    "mesh": ("mesh ball.frep -o OUT --voxel 0.5", "made.stl"),
    "build": ("build ball.frep -o OUT --voxel 0.5", "made.asdf"),
    "import": ("build scan_20x20x20_uint8.raw -o OUT", "made.asdf"),
    "convert": ("convert ball.frep -o OUT --voxel 0.5", "made.vdb"),
    "volume": ("convert scan_20x20x20_uint8.raw -o OUT", "made.nii.gz"),
    "parts": ("mesh two_parts.frep -o OUT --voxel 0.5", "made.3mf"),
    "openscad": ("mesh plate.csg -o OUT", "made.ply"),
    "render": ("render ball.frep -o OUT --mode shaded --size 60", "made.png"),
    "cam": ("cam job.toml -o OUT", "made.nc"),
    "simulate": ("simulate program.nc --setup setup.toml -o OUT", "made.stl"),
}


@pytest.fixture
def folder(tmp_path):
    return inputs(tmp_path / "work")


def once(name, folder, old=OLD, **injected):
    """Runs a command over an old file, and checks the guarantees for any outcome."""
    words, out = COMMANDS[name]
    if old is not None:
        (folder / out).write_bytes(old)
    before = faults.files_of(folder)
    done = faults.run(words.replace("OUT", out).split(), folder, **injected)
    after = faults.files_of(folder)
    assert done.returncode not in faults.CRASHES, (injected, done.stderr)
    assert done.left == [], (injected, "temporary files are left")
    assert ({path: data for path, data in after.items() if path != out}
            == {path: data for path, data in before.items() if path != out}), injected
    done.replaced = after.get(out) != before.get(out)
    return done


@pytest.mark.parametrize("call", ["write", "pwrite", "fsync", "rename"])
@pytest.mark.parametrize("name", COMMANDS)
def test_a_failing_call_leaves_the_old_file(name, call, folder):
    tried = 0
    for number in range(1, 200):
        done = once(name, folder, call=call, at=number)
        if done.returncode == 0:
            assert done.replaced
            break
        tried += 1
        assert done.returncode == 2 and done.stderr.startswith("fieldfab: "), (number, done.returncode, done.stderr)
        assert len([line for line in done.stderr.splitlines() if not line.startswith("fieldfab: note: ")]) == 1
        # The folder is synced after the new file was renamed.
        assert not done.replaced or (call == "fsync" and tried > 1), number
    else:
        pytest.fail("it never succeeds")
    assert tried >= {"write": 1, "pwrite": 0, "fsync": 2, "rename": 1}[call]


@pytest.mark.parametrize("lasting", [False, True])
@pytest.mark.parametrize("name", COMMANDS)
def test_a_thread_that_cannot_be_started(name, lasting, folder):
    """The command may hang while log4cplus, a dependency of OpenVDB, is loaded and cannot start one of its threads. The
    command first tries to start as many threads; later failures are not tested."""
    for number in range(1, 2 + max(2, len(os.sched_getaffinity(0))) if name == "convert" else 20):
        done = once(name, folder, call="pthread_create", at=number, threads=4, **({"lasting": 1} if lasting else {}))
        if done.returncode == 0:
            assert done.replaced
            break
        assert done.returncode == 3 and not done.replaced, (number, done.returncode, done.stderr)
        assert done.stderr.startswith("fieldfab: ") and len(done.stderr.splitlines()) == 1


@pytest.mark.parametrize("lasting", [False, True])
@pytest.mark.parametrize("name", COMMANDS)
def test_memory_that_is_refused(name, lasting, folder, tmp_path):
    """Tries some of up to millions of allocations; one fails alone, or with all later ones."""
    assert once(name, folder, call="malloc", count=tmp_path / "count").returncode == 0
    new, total = (folder / COMMANDS[name][1]).read_bytes(), int((tmp_path / "count").read_text())
    chance = random.Random(name)
    numbers = {int(total ** chance.random()) for _ in range(KILLS)} | {chance.randrange(1, total) for _ in range(KILLS)}
    codes = []
    for number in sorted(numbers):
        done = once(name, folder, call="malloc", at=number, **({"lasting": 1} if lasting else {}))
        codes.append(done.returncode)
        if done.returncode == 0:  # libraries tolerate some failures
            assert done.replaced
            continue
        # A library may report a lack of memory as a damaged file. The summary also needs memory, after the file is
        # written.
        assert done.returncode in (2, 3), (number, done.returncode, done.stderr)
        assert not done.replaced or good(name, (folder / COMMANDS[name][1]).read_bytes(), new), number
        assert len([line for line in done.stderr.splitlines() if line.startswith("fieldfab: ")]) == 1, (
            number, done.stderr)
    assert 3 in codes


def good(name, data, expected):
    """Whether a file has the expected content: byte for byte, except meshes, which are made in parallel."""
    return (data == expected or (name in ("mesh", "parts", "openscad", "simulate", "convert")
                                 and abs(len(data) - len(expected)) < 64 and data[:4] == expected[:4]))


@pytest.mark.parametrize("name", COMMANDS)
def test_a_loss_of_power_leaves_the_old_file_or_the_new_one(name, folder, tmp_path):
    """The process ends at one of its calls, and unsynced data is lost."""
    words, out = COMMANDS[name]
    assert once(name, folder, call="any", count=tmp_path / "count").returncode == 0
    new, total = (folder / out).read_bytes(), int((tmp_path / "count").read_text())
    moments = (range(1, total + 2) if total < KILLS else sorted(
        {1, total - 2, total - 1, total, total + 1} | set(random.Random(name).sample(range(1, total), KILLS - 4))))
    seen = set()
    for moment in moments:
        journal = tmp_path / f"journal{moment}"
        journal.mkdir()
        (folder / out).write_bytes(OLD)
        before = faults.files_of(folder)
        done = faults.run(words.replace("OUT", out).split(), folder, call="any", at=moment, kill=1, journal=journal)
        assert done.returncode == (-9 if moment <= total else 0), (moment, done.returncode, done.stderr)
        faults.cut_to_synced(folder, faults.lose_power(journal, folder), before)
        data = (folder / out).read_bytes()
        assert data == OLD or good(name, data, new), (moment, len(data))
        assert moment <= total or data != OLD, "a success is on the disk"
        seen.add(data == OLD)
        for path in faults.files_of(folder):
            if path not in before:
                (folder / path).unlink()
    assert seen == {True, False}


PARTS = """
import os, sys
sys.path.insert(0, sys.argv[1])
import fieldfab as ff
scan = ff.Volume.open("scan_20x20x20_uint8.raw")
for part in range(2):
    scan.save_part(f"{part}.part", part, 2, threshold=50)
scan.merge_parts("made.asdf", ["0.part", "1.part"], threshold=50)
"""


def test_a_loss_of_power_leaves_an_import_in_parts_whole(folder, tmp_path):
    """Tests the worker processes of fieldfab.bricks."""
    (folder / "parts.py").write_text(PARTS)
    (folder / "made.asdf").write_bytes(OLD)
    python = {"program": ["/usr/bin/python3", "-B"], "arguments": ["parts.py", BUILD / "python"], "folder": folder,
              "call": "any"}
    done = faults.run(**python, count=tmp_path / "count")
    assert done.returncode == 0, done.stderr
    new, total = faults.files_of(folder), int((tmp_path / "count").read_text())
    assert new["made.asdf"] != OLD
    for moment in range(1, total + 2):
        journal = tmp_path / f"journal{moment}"
        journal.mkdir()
        for name in ("0.part", "1.part"):
            (folder / name).unlink(missing_ok=True)
        (folder / "made.asdf").write_bytes(OLD)
        before = faults.files_of(folder)
        assert faults.run(**python, at=moment, kill=1, journal=journal).returncode == (-9 if moment <= total else 0)
        faults.cut_to_synced(folder, faults.lose_power(journal, folder), before)
        now = faults.files_of(folder)
        assert now["made.asdf"] in ((OLD, new["made.asdf"]) if moment <= total else (new["made.asdf"],)), moment
        assert all(now[name] == new[name] for name in ("0.part", "1.part") if name in now), moment


SCAD = "use <fieldfab.scad>\nsmooth_union(2) {{ cube(10); translate([5, 5, 5]) cube({size}); }}\n"


def test_a_loss_of_power_leaves_no_mesh_under_another_ones_note(tmp_path):
    """The cache of OpenSCAD's meshes: a design that is changed and reverted gets its own mesh."""
    need("openscad")
    folder = tmp_path / "work"
    folder.mkdir()
    design = folder / "design.scad"

    def refresh(size, **injected):
        design.write_text(SCAD.format(size=size))
        return faults.run(["openscad", "design.scad"], folder, **injected)

    cache = folder / "fieldfab-cache"
    assert refresh(10).returncode == 0
    first = {path: data for path, data in faults.files_of(cache).items()}
    assert len(first) == 2, first.keys()
    done = refresh(12, call="any", count=tmp_path / "count")
    assert done.returncode == 0, done.stderr
    assert faults.files_of(cache) != first
    total = int((tmp_path / "count").read_text())
    for moment in random.Random(1).sample(range(1, total + 1), min(KILLS, total)):
        shutil.rmtree(cache)
        assert refresh(10).returncode == 0
        journal = tmp_path / f"journal{moment}"
        journal.mkdir()
        before = faults.files_of(folder)
        refresh(12, call="any", at=moment, kill=1, journal=journal)
        faults.cut_to_synced(folder, faults.lose_power(journal, folder), before)
        assert refresh(10).returncode == 0
        now = faults.files_of(cache)
        assert {path: len(now[path]) for path in first} == {path: len(data) for path, data in first.items()}, moment
