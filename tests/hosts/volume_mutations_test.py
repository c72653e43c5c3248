"""Damaged volumes in formats of libraries that the fuzzers cannot include (ITK, OpenVDB), and PNG slices: each gives an
Error or a readable volume, never a crash or an endless loop. Assertions of Debian's GDCM, the reader of DICOM, abort
its process."""

import os
import subprocess

import pytest

from conftest import BUILD, COMMAND
from volume_test import FORMATS, files

# FIELDFAB_MUTATIONS: number of files per format; FIELDFAB_MUTATION_SECONDS: time limit. `./dev fuzz` sets both.
COUNT = int(os.environ.get("FIELDFAB_MUTATIONS", "80"))
SECONDS = float(os.environ.get("FIELDFAB_MUTATION_SECONDS", "inf"))
SEEDS = ("mha", "mha, compressed", "mhd", "nrrd", "nrrd, gzip", "nhdr", "nifti", "nifti, gzip", "nifti, big-endian",
         "png stack, 16 bit", "dicom", "dicom, scaled")

# Runs in a separate process; after a crash the file that caused it remains.
LOOP = """
import pathlib, random, resource, sys, time
import fieldfab as ff
resource.setrlimit(resource.RLIMIT_AS, (1 << 30, 1 << 30))  # OpenVDB and GDCM take memory for what a file only says
path, opened, seed, count = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3], int(sys.argv[4])
end = time.monotonic() + float(sys.argv[5])
whole = path.read_bytes()
random, read, refused = random.Random(seed), 0, 0
NUMBERS = [b"0", b"-1", b"1", b"9999999999", b"1e39", b"nan",
           b"\\xff\\xff\\xff\\xff", b"\\0\\0\\0\\0", b"\\x7f\\xff", b"\\x80"]
for tried in range(count):
    if time.monotonic() > end:
        break
    data = bytearray(whole)
    for _ in range(random.choice((1, 1, 2, 4, 8))):
        # Half of the damage is to the header.
        at = random.randrange(min(len(data), 600) if random.random() < 0.5 else len(data)) if data else 0
        kind = random.randrange(5)
        if kind == 0 and data:
            data[at] ^= 1 << random.randrange(8)
        elif kind == 1:
            number = random.choice(NUMBERS)
            data[at:at + len(number)] = number
        elif kind == 2:
            del data[at:at + random.choice((1, 2, 8, 64, len(data)))]
        elif kind == 3:
            data[at:at] = data[at:at + random.choice((1, 4, 64))]
        elif data:
            data[at] = random.randrange(256)
    path.write_bytes(data)
    try:
        volume = ff.Volume.open(opened)
        if volume.size[0] * volume.size[1] * volume.size[2] < 1e7:
            volume.densities()
        read += 1
    except ff.Error as error:
        assert error.kind != "internal" and "\\n" not in str(error), error
        refused += 1
print(read, refused)
"""


def mutate(path, opened, seed, count=COUNT):
    python = ["/usr/bin/python3", "-c", LOOP, str(path), str(opened), seed, str(count), str(SECONDS)]
    environment = {**os.environ, "PYTHONPATH": str(BUILD / "python")}
    done = subprocess.run(python, env=environment, capture_output=True, text=True, timeout=60 + min(2 * count, SECONDS))
    assert done.returncode == 0, f"{done.returncode} at {path}\n{done.stderr[-2000:]}"
    read, refused = map(int, done.stdout.splitlines()[-1].split())  # a warning of OpenVDB may precede
    assert refused > 0 and (read + refused == count or SECONDS < float("inf"))
    assert done.stderr == ""


@pytest.mark.parametrize("name", SEEDS)
def test_damaged_volumes(tmp_path, name):
    contents, _, _ = FORMATS[name]
    first = files(tmp_path, contents)
    mutate(first, first.parent if first.parent != tmp_path else first, name)


def test_damaged_level_sets(tmp_path):
    (tmp_path / "ball.frep").write_text("sphere(2)")
    command = [COMMAND, "convert", tmp_path / "ball.frep", "-o", tmp_path / "ball.vdb", "--voxel", "0.25"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    mutate(tmp_path / "ball.vdb", tmp_path / "ball.vdb", "vdb", max(1, COUNT // 5))


@pytest.mark.parametrize("name, old, new, words", [
    ("mhd", b"NDims = 3", b"NDims = -1", "-1 dimensions"), ("mha", b"NDims = 3", b"NDims = 1e39", "1e+39 dimensions"),
    ("nifti", None, b"\0\0\0\x7f", "not possible")])
def test_headers_that_itk_reads_for_ever(tmp_path, name, old, new, words):
    contents, _, _ = FORMATS[name]
    path = files(tmp_path, contents)
    data = path.read_bytes()
    if old:
        assert old in data
        data = data.replace(old, new)
    else:  # an element of the matrix whose square is no float
        data = data[:254] + b"\1\0" + data[256:288] + new + data[292:]
    path.write_bytes(data)
    done = subprocess.run([COMMAND, "info", path], capture_output=True, text=True, timeout=20)
    assert done.returncode == 2 and words in done.stderr, done.stderr
