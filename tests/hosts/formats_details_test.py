"""Statements of docs/formats.md about mesh files and pictures other than round trips: text and binary forms, polygons,
data lost on reading, damaged faces and numbers."""

import json
import struct
import subprocess
import zlib
from collections.abc import Callable

import pytest
from conftest import COMMAND

CORNERS = [(x, y, z) for z in (0, 1) for y in (0, 2) for x in (0, 3)]  # of a box of 6 cubic mm
QUADS = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
TRIANGLES = [fan for a, b, c, d in QUADS for fan in ((a, b, c), (a, c, d))]


def joined(rows):
    return "".join(" ".join(map(str, row)) + "\n" for row in rows)


def stl_text(corners=CORNERS):
    facets = [f"facet normal 0 0 0\nouter loop\n{joined(('vertex', *corners[i]) for i in t)}endloop\nendfacet\n"
              for t in TRIANGLES]
    return f"solid box\n{''.join(facets)}endsolid box\n".encode()


def stl_binary():
    facets = [struct.pack("<12fH", 0, 0, 0, *(x for i in t for x in CORNERS[i]), 0) for t in TRIANGLES]
    return bytes(80) + struct.pack("<I", len(facets)) + b"".join(facets)


def ply_text(corners=CORNERS, quads=QUADS, form="ascii"):
    head = f"ply\nformat {form} 1.0\nelement vertex 8\n" + joined(("property", "float", axis) for axis in "xyz")
    head += joined(("property", "uchar", c) for c in ("red", "green", "blue"))
    head += f"element face {len(quads)}\nproperty list uchar int vertex_indices\nend_header\n"
    return (head + joined((*c, 255, 0, 0) for c in corners) + joined((len(q), *q) for q in quads)).encode()


def ply_binary(order):
    form = "binary_little_endian" if order == "<" else "binary_big_endian"
    head = ply_text(form=form).partition(b"end_header\n")
    rows = [struct.pack(f"{order}3f3B", *c, 255, 0, 0) for c in CORNERS]
    rows += [struct.pack(f"{order}B4i", 4, *q) for q in QUADS]
    return head[0] + head[1] + b"".join(rows)


def off_text(corners=CORNERS, quads=QUADS, normals=False):
    rows = [(*c, *((0, 0, 1) if normals else ())) for c in corners]
    word = "NOFF" if normals else "OFF"
    return f"{word}\n8 {len(quads)} 0\n{joined(rows)}{joined((len(q), *q) for q in quads)}".encode()


def obj_text(corners=CORNERS, quads=QUADS, index=lambda i: i + 1):
    faces = joined(("f", *(index(i) for i in q)) for q in quads)
    return f"{joined(('v', *c) for c in corners)}vt 0 0\nvn 0 0 1\ng one two\nusemtl red\n{faces}".encode()


GOOD = {
    "text.stl": stl_text(), "binary.stl": stl_binary(),
    "quads.ply": ply_text(), "triangles.ply": ply_text(quads=TRIANGLES), "binary.ply": ply_binary("<"),
    "quads.off": off_text(), "normals.off": off_text(normals=True), "quads.obj": obj_text(),
    "negative.obj": obj_text(index=lambda i: i - 8), "slashes.obj": obj_text(index=lambda i: f"{i + 1}/1/1"),
    "normals.obj": obj_text(index=lambda i: f"{i + 1}//1"),
}
FAR = [*QUADS[:-1], (1, 3, 7, 8)]  # vertex 8 does not exist
TEXTS: dict[str, Callable[..., bytes]] = {"stl": stl_text, "ply": ply_text, "off": off_text, "obj": obj_text}
BAD = {f"{word}.{extension}": text([(word, 0, 0), *CORNERS[1:]])
       for extension, text in TEXTS.items() for word in ("what", "nan", "inf", "1e39")}
BAD |= {f"far.{extension}": text(quads=FAR) for extension, text in TEXTS.items() if extension != "stl"}
BAD |= {"before.obj": obj_text(index=lambda i: i - 9), "zero.obj": obj_text(index=lambda i: i),
        "nan.binary.stl": stl_binary().replace(struct.pack("<f", 3), struct.pack("<f", float("nan")))}


def run(*words):
    return subprocess.run([COMMAND, "--json", *map(str, words)], capture_output=True, text=True, timeout=60)


@pytest.mark.parametrize("name", GOOD)
def test_forms_of_meshes_that_are_read(name, tmp_path):
    """Polygons become triangles, coincident vertices are merged, and properties other than positions are lost."""
    (tmp_path / name).write_bytes(GOOD[name])
    done = run("info", tmp_path / name)
    assert done.returncode == 0, done.stderr
    told = json.loads(done.stdout)
    assert (told["vertices"], told["triangles"]) == (8, 12)
    assert told["volume"] == pytest.approx(6) and told["bounds"] == [[0, 3], [0, 2], [0, 1]]
    done = run("convert", tmp_path / name, "-o", tmp_path / "made.ply")
    assert done.returncode == 0, done.stderr
    head = (tmp_path / "made.ply").read_bytes().partition(b"end_header")[0]
    assert b"format binary_little_endian 1.0" in head and b"red" not in head and b"nx" not in head


def test_stl_is_written_binary(tmp_path):
    (tmp_path / "a.stl").write_bytes(stl_text())
    assert run("convert", tmp_path / "a.stl", "-o", tmp_path / "b.stl").returncode == 0
    made = (tmp_path / "b.stl").read_bytes()
    assert struct.unpack("<I", made[80:84]) == (12,) and len(made) == 84 + 12 * 50


@pytest.mark.parametrize("name", BAD)
def test_damaged_faces_and_numbers_are_errors_with_the_file_s_name(name, tmp_path):
    (tmp_path / name).write_bytes(BAD[name])
    done = run("info", tmp_path / name)
    assert done.returncode == 2 and done.stdout == ""
    assert done.stderr.startswith(f"fieldfab: {tmp_path / name}:") and done.stderr.count("\n") == 1, done.stderr


def test_a_big_endian_ply_is_refused(tmp_path):
    (tmp_path / "a.ply").write_bytes(ply_binary(">"))
    done = run("info", tmp_path / "a.ply")
    assert done.returncode == 2 and "a.ply: " in done.stderr and "endian" in done.stderr, done.stderr


def chunks(png):
    at, found = 8, {}
    while at < len(png):
        (size,), kind = struct.unpack(">I", png[at:at + 4]), png[at + 4:at + 8]
        body = png[at + 8:at + 8 + size]
        assert struct.unpack(">I", png[at + 8 + size:at + 12 + size]) == (zlib.crc32(kind + body),)
        found[kind] = body
        at += 12 + size
    return found


def test_pictures_have_pixels_a_metre_and_heights(tmp_path):
    (tmp_path / "part.frep").write_text("box(10, 10, 4)")
    done = run("render", tmp_path / "part.frep", "-o", tmp_path / "a.png", "--mode", "height", "--size", 60)
    assert done.returncode == 0, done.stderr
    per_mm = json.loads(done.stdout)["pixels_per_mm"]
    across, down, unit = struct.unpack(">IIB", chunks((tmp_path / "a.png").read_bytes())[b"pHYs"])
    assert across == down == pytest.approx(1000 * per_mm, rel=1e-3) and unit == 1  # per metre
    told = json.loads(run("info", tmp_path / "a.png").stdout)
    assert told["pixels_per_mm"] == pytest.approx(per_mm, rel=1e-3)
    assert told["heights"] == pytest.approx([-2, 2], abs=0.2)  # with the margin of the picture
