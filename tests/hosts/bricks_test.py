"""fieldfab.bricks: imports and meshes by several processes, against those of one."""

import gzip
import json
import os
import pathlib
import signal
import struct
import subprocess
import sys
import time

import numpy as np
import pytest

from conftest import BUILD, COMMAND, DATA
from family import sample_or_all
from mesh_files import read_ply
from volume_test import write_lace

COARSER = sample_or_all(2, 1)  # every second voxel of the scan along each axis, and bricks of half as many cells
PYTHON = ["/usr/bin/python3", "-m", "fieldfab.bricks"]
ENVIRONMENT = {**os.environ, "PYTHONPATH": str(BUILD / "python")}


def run(*arguments):
    return subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True, timeout=120, check=True)


def bricks(*arguments, ok=True):
    done = subprocess.run([*PYTHON, *map(str, arguments)], env=ENVIRONMENT, capture_output=True, text=True, timeout=120)
    assert not ok or done.returncode == 0, done.stderr
    return done


@pytest.fixture(scope="module")
def scan(tmp_path_factory):
    """A CT volume of an engine in NIfTI's format: a header of 352 bytes, then the voxels."""
    data = gzip.decompress((DATA / "ct" / "engine.nii.gz").read_bytes())
    size = np.frombuffer(data, "<i2", 3, 42)
    voxels = np.frombuffer(data, np.uint8, offset=352).reshape(size, order="F")[::COARSER, ::COARSER, ::COARSER]
    path = tmp_path_factory.mktemp("scan") / "engine.nii"
    path.write_bytes(data[:42] + np.array(voxels.shape, "<i2").tobytes() + data[48:352] + voxels.tobytes(order="F"))
    return path


@pytest.fixture(scope="module")
def engine(scan, tmp_path_factory):
    """An .asdf file of three levels, and the mesh that the command makes of it."""
    folder = tmp_path_factory.mktemp("engine")
    run("build", scan, "-o", folder / "engine.asdf", "--levels", 3)
    run("mesh", folder / "engine.asdf", "-o", folder / "engine.ply")
    return folder


def mesh_of(path):
    """The vertices, (n, 3), and triangles of a .ply file."""
    vertices, triangles = read_ply(path)
    return np.stack([vertices[axis] for axis in "xyz"], axis=1), triangles


def by_coordinates(vertices, triangles):
    """The coordinates of the triangles' corners, the least corner first, in ascending order."""
    corners = vertices[triangles]
    rank = np.unique(vertices, axis=0, return_inverse=True)[1].ravel()[triangles]
    first = rank.argmin(axis=1)[:, None]
    corners = np.take_along_axis(corners, ((first + [0, 1, 2]) % 3)[:, :, None], axis=1).reshape(-1, 9)
    return corners[np.lexsort(corners.T[::-1])]


def assert_same_mesh(path, expected):
    import fieldfab as ff

    vertices, triangles = mesh_of(path)
    wanted = mesh_of(expected)
    assert len(vertices) == len(wanted[0]) and len(triangles) == len(wanted[1])
    assert np.array_equal(by_coordinates(vertices, triangles), by_coordinates(*wanted))
    assert ff.inspect(ff.Mesh(vertices, triangles)).valid


def test_two_processes_make_the_same_asdf_file(scan, tmp_path):
    run("build", scan, "-o", tmp_path / "one.asdf", "--levels", 2)
    for parts in (2, 3):
        bricks(scan, "-o", tmp_path / "two.asdf", "--workers", 2, "--parts", parts, "--levels", 2)
        assert (tmp_path / "one.asdf").read_bytes() == (tmp_path / "two.asdf").read_bytes()
    assert sorted(p.name for p in tmp_path.iterdir()) == ["one.asdf", "two.asdf"]


def processes_below(parent):
    """The command lines of all processes that a process started, by their numbers."""
    below, lines = {parent}, {}
    for folder in sorted(pathlib.Path("/proc").glob("[0-9]*"), key=lambda path: int(path.name)):
        try:
            started_by = int((folder / "stat").read_text().rsplit(")", 1)[1].split()[1])
            line = (folder / "cmdline").read_text()
        except OSError:
            continue
        if started_by in below:
            below.add(int(folder.name))
            lines[int(folder.name)] = line
    return lines


def test_a_mesh_is_that_of_one_process_though_a_worker_is_killed(engine, tmp_path):
    out = tmp_path / "mesh.ply"
    command = [*PYTHON, engine / "engine.asdf", "-o", out, "--workers", "3", "--cells", str(64 // COARSER)]
    running = subprocess.Popen(command, env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    made = lambda: len(list(tmp_path.glob(".mesh.ply.*/tiles/?-*-?.npz")))
    until = time.monotonic() + 60
    while made() < 3 and running.poll() is None and time.monotonic() < until:
        time.sleep(0.01)
    workers = [number for number, line in processes_below(running.pid).items() if "spawn_main" in line]
    assert len(workers) == 3
    os.kill(workers[1], signal.SIGKILL)
    at = made()
    said, errors = running.communicate(timeout=120)
    assert running.returncode == 0, errors
    assert 3 <= at < int(said.split(" of ")[1].split()[0]) - 5, "there was work left when the worker was killed"
    assert_same_mesh(out, engine / "engine.ply")
    assert [path.name for path in tmp_path.iterdir()] == ["mesh.ply"]


def test_the_file_is_the_same_for_any_number_of_workers(engine, tmp_path):
    for workers in (1, 2):
        bricks(engine / "engine.asdf", "-o", tmp_path / f"{workers}.ply", "--workers", workers,
               "--cells", 128 // COARSER)
    assert (tmp_path / "1.ply").read_bytes() == (tmp_path / "2.ply").read_bytes()


def test_a_volume_is_meshed_at_once(scan, engine, tmp_path):
    said = bricks(scan, "-o", tmp_path / "engine.ply").stdout
    vertices, triangles = mesh_of(tmp_path / "engine.ply")
    assert said == f"{tmp_path / 'engine.ply'}: {len(vertices)} vertices and {len(triangles)} triangles of 1 bricks\n"
    assert_same_mesh(tmp_path / "engine.ply", engine / "engine.ply")
    assert [path.name for path in tmp_path.iterdir()] == ["engine.ply"]


def test_cells_error_and_level_are_those_of_the_command(engine, tmp_path):
    options = ["--voxel", 1.5, "--max-error", 0.3]
    run("mesh", engine / "engine.asdf", "-o", tmp_path / "one.ply", *options)
    bricks(engine / "engine.asdf", "-o", tmp_path / "bricks.ply", *options, "--cells", 64 // COARSER)
    assert_same_mesh(tmp_path / "bricks.ply", tmp_path / "one.ply")
    run("mesh", engine / "engine.asdf", "-o", tmp_path / "coarse.ply", "--level", 2)
    bricks(engine / "engine.asdf", "-o", tmp_path / "bricks.ply", "--level", 2, "--cells", 32)
    assert_same_mesh(tmp_path / "bricks.ply", tmp_path / "coarse.ply")


def read_glb(path):
    """The vertices, mm, and triangles of a .glb file with one mesh."""
    data = path.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    told, buffer = json.loads(data[20:20 + length]), data[28 + length:]
    mesh, = told["meshes"]
    primitive, = mesh["primitives"]
    places, indices = (told["accessors"][i] for i in (primitive["attributes"]["POSITION"], primitive["indices"]))
    views = told["bufferViews"]
    return (np.frombuffer(buffer, "<f4", 3 * places["count"], views[places["bufferView"]]["byteOffset"]).reshape(-1, 3),
            np.frombuffer(buffer, "<u4", indices["count"], views[indices["bufferView"]]["byteOffset"]).reshape(-1, 3))


def test_tiles_show_every_level(engine, tmp_path):
    out = tmp_path / "tiles" / "tileset.json"
    for level in (2, 0):  # new tiles replace those that were there
        bricks(engine / "engine.asdf", "-o", out, "--cells", 64 // COARSER, "--level", level)
    assert sorted(path.name for path in out.parent.iterdir()) == ["tileset", "tileset.json"]
    tileset = json.loads(out.read_text())
    levels, seen = {}, set()

    def walk(tile, above):
        middle, half = np.array(tile["boundingVolume"]["box"][:3]), np.array(tile["boundingVolume"]["box"][3::4])
        low, high = 1000 * (middle - half), 1000 * (middle + half)
        assert (low >= above[0] - 1e-3).all() and (high <= above[1] + 1e-3).all()
        assert tile["refine"] == "REPLACE"
        if "content" in tile:
            uri = tile["content"]["uri"]
            assert uri not in seen and (out.parent / uri).stat().st_mode & 0o777 == out.stat().st_mode & 0o777
            seen.add(uri)
            vertices, triangles = read_glb(out.parent / uri)
            assert (vertices >= low - 1e-3).all() and (vertices <= high + 1e-3).all()
            levels.setdefault(int(pathlib.Path(uri).name[0]), []).append((vertices, triangles))
        for child in tile.get("children", ()):
            assert child["geometricError"] < tile["geometricError"]
            walk(child, (low, high))

    walk(tileset["root"], (np.full(3, -np.inf), np.full(3, np.inf)))
    assert len(seen) == len(list((out.parent / "tileset").iterdir()))
    assert set(levels) == {0, 1, 2}
    for level, tiles in levels.items():
        one = tmp_path / "one.ply"
        run("mesh", engine / "engine.asdf", "-o", one, "--level", level)
        found = [by_coordinates(vertices, triangles) for vertices, triangles in tiles]
        found = np.concatenate(found)
        assert np.array_equal(found[np.lexsort(found.T[::-1])], by_coordinates(*mesh_of(one))), level


def test_errors_are_one_line(engine, tmp_path):
    import fieldfab as ff

    ff.build(ff.value(1.0), bounds=(-1, -1, -1, 1, 1, 1), voxel=0.1).save(tmp_path / "empty.asdf")
    (tmp_path / "text.asdf").write_text("no distances\n")
    (tmp_path / "old" / "tileset").mkdir(parents=True)
    (tmp_path / "old" / "tileset" / "mine.txt").write_text("mine")
    before = sorted(tmp_path.rglob("*"))
    asdf = engine / "engine.asdf"
    for arguments, words in [
            ((tmp_path / "nothing.nrrd", "-o", tmp_path / "x.asdf"), "nothing.nrrd"),
            ((tmp_path / "nothing.asdf", "-o", tmp_path / "x.ply"), "nothing.asdf"),
            ((tmp_path / "text.asdf", "-o", tmp_path / "x.ply"), "text.asdf"),
            ((tmp_path / "empty.asdf", "-o", tmp_path / "x.ply"), "no surface was found"),
            ((tmp_path / "empty.asdf", "-o", tmp_path / "tileset.json"), "no surface was found"),
            ((asdf, "-o", tmp_path / "x.stl"), "write an .asdf, a .ply or a tileset.json"),
            ((asdf, "-o", tmp_path / "x.ply", "--cells", 100), "100 is not a power of two"),
            ((asdf, "-o", tmp_path / "x.ply", "--level", 3), "level"),
            ((asdf, "-o", tmp_path / "x.ply", "--workers", 0), "workers"),
            ((asdf, "-o", tmp_path / "nowhere" / "x.ply"), "nowhere"),
            ((asdf, "-o", tmp_path / "old" / "tileset.json"), "old/tileset is there already"),
            ((DATA / "asdf" / "kokopelli_torus_24.asdf", "-o", tmp_path / "x.ply", "--voxel", -1), "voxel")]:
        done = bricks(*arguments, ok=False)
        lines = done.stderr.splitlines()
        assert done.returncode == 2 and len(lines) == 1 and words in lines[0], (arguments, done.returncode, done.stderr)
        assert sorted(tmp_path.rglob("*")) == before, arguments


@pytest.mark.skipif("FIELDFAB_SLOW" not in os.environ, reason="writes 3.9 GB; FIELDFAB_SLOW=1 runs it")
def test_a_volume_of_3_9_gigabytes(tmp_path):
    """992^3 floats become a mesh in processes of less than 2 GB each."""
    volume = write_lace(tmp_path)
    start, greatest = time.monotonic(), 0
    running = subprocess.Popen([*PYTHON, volume, "-o", tmp_path / "lace.ply", "--threshold", "0.5"], env=ENVIRONMENT,
                               stdout=subprocess.PIPE, text=True)
    while running.poll() is None:
        for number in [running.pid, *processes_below(running.pid)]:
            try:
                status = pathlib.Path(f"/proc/{number}/status").read_text()
            except OSError:
                continue
            if "RssAnon:" in status:
                greatest = max(greatest, int(status.split("RssAnon:")[1].split()[0]))
        time.sleep(0.1)
    print(f"{running.stdout.read().strip()}; {time.monotonic() - start:.0f} s, {greatest / 1e6:.2f} GB a process")
    assert running.returncode == 0 and greatest < 2e6


if __name__ == "__main__":
    sys.exit(pytest.main([__file__]))
