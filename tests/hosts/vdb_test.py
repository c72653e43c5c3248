"""Files of OpenVDB with damaged lengths, offsets and counts: refused in one line, without allocation of the claimed
size."""

import pathlib
import random
import re
import subprocess

import fieldfab as ff
import pytest
from conftest import COMMAND
from family import sample_or_all
from openvdb_module import openvdb

LENGTH = b"\xf0\xff\xff\xff"  # nearly 4 GiB
HEADER = 350  # bytes that are damaged in turn


def peak():
    """Returns the peak memory of this process, MB."""
    return int(re.search(r"VmHWM:\s+(\d+)", pathlib.Path("/proc/self/status").read_text())[1]) / 1024


def forget_peak():
    pathlib.Path("/proc/self/clear_refs").write_text("5")
    return peak()


def ball(name):
    grid = openvdb.createLevelSetSphere(radius=4.0, center=(1.0, 2.0, 3.0), voxelSize=0.5)
    grid.name = name
    grid["note"] = "text"
    return grid


def several():
    flags = openvdb.BoolGrid()
    flags.fill((0, 0, 0), (3, 3, 3), True)
    flags.name = "flags"
    return [flags, ball("ball")]


def test_the_first_grid_of_floats_is_read(tmp_path):
    openvdb.write(str(tmp_path / "a.vdb"), grids=several(), metadata={"by": "us"})
    openvdb.write(str(tmp_path / "b.vdb"), grids=[ball("ball")])
    a, b = ff.Volume.open(tmp_path / "a.vdb"), ff.Volume.open(tmp_path / "b.vdb")
    assert a.size == b.size and (a.densities() == b.densities()).all()
    openvdb.write(str(tmp_path / "c.vdb"), grids=several()[:1])
    with pytest.raises(ff.Error, match="holds no grid of 32-bit real numbers"):
        ff.Volume.open(tmp_path / "c.vdb")


def test_a_header_gets_no_more_memory_than_its_file_has(tmp_path):
    path = tmp_path / "a.vdb"
    openvdb.write(str(path), grids=several(), metadata={"by": "us"})
    whole = path.read_bytes()
    start = whole.index(b"Tree_float") - 24  # of the second grid
    places = {*range(0, HEADER), *range(start, start + HEADER)}
    before, refused = forget_peak(), 0
    tried = sorted(places)[::sample_or_all(5, 1)]
    for place in tried:
        damaged = bytearray(whole)
        damaged[place:place + 4] = LENGTH
        path.write_bytes(damaged)
        try:
            ff.Volume.open(path)
        except ff.Error as error:
            assert str(error).startswith(f"{path}: ") and "\n" not in str(error)
            refused += 1
    assert refused > len(tried) / 20
    assert peak() < before + 500


def test_a_small_file_spans_no_large_lattice(tmp_path):
    grid = openvdb.FloatGrid()
    for place in (0, 700):
        grid.fill((place,) * 3, (place + 2,) * 3, 1.0)
    openvdb.write(str(tmp_path / "far.vdb"), grids=[grid])
    done = subprocess.run([COMMAND, "info", tmp_path / "far.vdb"], capture_output=True, text=True, timeout=60)
    assert done.returncode == 2
    told = "its samples span 705 x 705 x 705, too many for a file of its size"
    assert done.stderr == f"fieldfab: {tmp_path}/far.vdb: {told}\n"


def test_a_later_version_is_refused(tmp_path):
    path = tmp_path / "a.vdb"
    openvdb.write(str(path), grids=[ball("ball")])
    damaged = bytearray(path.read_bytes())
    damaged[8:12] = (1000).to_bytes(4, "little")
    path.write_bytes(damaged)
    done = subprocess.run([COMMAND, "info", path], capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == f"fieldfab: {path}: is no .vdb file, or a damaged one, or of a later version\n"


def test_blocks_of_values_that_are_larger_than_their_memory(tmp_path):
    """A negative size marks a block as uncompressed. OpenVDB would read it into a buffer that is too small."""
    path = tmp_path / "a.vdb"
    openvdb.write(str(path), grids=[ball("ball")])
    whole = path.read_bytes()
    number = lambda at: int.from_bytes(whole[at:at + 8], "little", signed=True)
    sizes = [at for at in range(len(whole) - 8) if 16 < number(at) < 20000 and at + 8 + number(at) <= len(whole)]
    codes = set()
    for at in random.Random(1).sample(sizes, 24):
        size = at + 8 - len(whole)  # the rest of the file
        path.write_bytes(whole[:at] + size.to_bytes(8, "little", signed=True) + whole[at + 8:])
        done = subprocess.run([COMMAND, "info", path], capture_output=True, text=True, timeout=60)
        codes.add(done.returncode)
        assert done.returncode in (0, 2), (at, done.returncode, done.stderr)
        assert done.stderr.count("\n") == (done.returncode == 2)
    assert 2 in codes
