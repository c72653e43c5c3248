"""Every file format: a round trip of our own, our files read by Debian's other programs, and theirs read by us, with
units. Statements of docs/formats.md."""

import itertools
import json
import os
import re
import subprocess
import xml.etree.ElementTree
import zipfile
import zlib

import nibabel
import numpy as np
import pytest

from conftest import BUILD, COMMAND, ROOT
from meshlab_host import MESHLABSERVER
from openvdb_module import openvdb
from programs import need

MESHES = ("stl", "ply", "off", "obj", "3mf")
VOLUMES = ("nrrd", "mha", "nii", "nii.gz")
SOLIDS = ("vdb", "asdf")
TEXTS = ("frep", "math", "vm")
ROUND_TRIPS = (*MESHES, *VOLUMES, *SOLIDS, *TEXTS)
SOLID = "difference(box(10, 8, 6), move(sphere(3), 1, 2, 3))"  # without any symmetry
BOUNDS = [[-5, 5], [-4, 4], [-3, 3]]


def run(*arguments, **more):
    done = subprocess.run(list(map(str, arguments)), capture_output=True, text=True, timeout=300, **more)
    assert done.returncode == 0, (arguments, done.stdout[-2000:], done.stderr[-2000:])
    return done.stdout


def summary(*arguments):
    return json.loads(run(COMMAND, "--json", *arguments))


def told(path):
    return summary("info", path)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A mesh and a volume in every format."""
    folder = tmp_path_factory.mktemp("formats")
    (folder / "part.frep").write_text(SOLID)
    summary("mesh", folder / "part.frep", "-o", folder / "part.stl", "--voxel", 0.5)
    for extension in MESHES[1:]:
        summary("convert", folder / "part.stl", "-o", folder / f"part.{extension}")
    (folder / "scan.nrrd").write_bytes(nrrd())
    for extension in VOLUMES[1:]:
        summary("convert", folder / "scan.nrrd", "-o", folder / f"scan.{extension}")
    return folder


def same_mesh(path, like, triangles=True, rel=1e-12, within=0.0):
    a, b = told(path), told(like)
    if triangles:
        assert a["triangles"] == b["triangles"]
    assert a["volume"] == pytest.approx(b["volume"], rel=rel)
    assert np.allclose(a["bounds"], b["bounds"], rtol=0, atol=within)


# Meshes.


@pytest.mark.parametrize("first, second", itertools.product(MESHES, MESHES))
def test_meshes_go_from_any_form_to_any_other_and_back(folder, tmp_path, first, second):
    there, back = tmp_path / f"there.{second}", tmp_path / f"back.{first}"
    summary("convert", folder / f"part.{first}", "-o", there)
    summary("convert", there, "-o", back)
    same_mesh(there, folder / "part.stl")
    assert back.read_bytes() == (folder / f"part.{first}").read_bytes()
    assert np.allclose(told(there)["bounds"], BOUNDS, rtol=0, atol=1e-6)


def openscad(source, target):
    need("openscad")
    scad = target.parent / "import.scad"
    scad.write_text(f'import("{source}");')
    run("openscad", "-o", target, scad)


def freecad(source, target):
    script = target.parent / "convert.py"
    lines = ["import Mesh", f"mesh = Mesh.Mesh({str(source)!r})", f"mesh.write({str(target)!r})", "print('wrote')"]
    script.write_text("\n".join(lines) + "\n")
    assert "wrote" in run("freecadcmd", script)


def assimp(source, target):
    run("assimp", "export", source, target)


def meshlab(source, target):
    environment = {**os.environ, "XDG_RUNTIME_DIR": str(target.parent)}
    run("xvfb-run", "-a", MESHLABSERVER, "-i", source, "-o", target, env=environment)


# Each program with the common formats that it reads and writes. OpenSCAD 2021 reads no .ply and no .obj, FreeCAD 0.20
# no .3mf; Debian's MeshLab fails an assertion on any .obj file (FreeCAD's and assimp's, too), and lacks .3mf; assimp
# has no writer for .off. assimp writes six digits in text.
PROGRAMS = {
    openscad: (("stl", "off", "3mf"), ("stl", "off", "3mf")),
    freecad: (("stl", "ply", "off", "obj"), ("stl", "ast", "ply", "off", "obj", "3mf")),
    assimp: (MESHES, ("stl", "ply", "obj", "3mf")),
    meshlab: (("stl", "ply", "off"), ("stl", "ply", "off", "obj")),
}


def each(which):
    pairs = [(program, extension) for program, forms in PROGRAMS.items() for extension in forms[which]]
    return pytest.mark.parametrize("program, extension", pairs, ids=lambda value: getattr(value, "__name__", value))


@each(0)
def test_our_meshes_are_read_by_other_programs(folder, tmp_path, program, extension):
    """They convert our file to STL, which other tests cover, with all triangles and in mm."""
    program(folder / f"part.{extension}", tmp_path / "theirs.stl")
    same_mesh(tmp_path / "theirs.stl", folder / "part.stl", rel=1e-5, within=1e-4)


@each(1)
def test_meshes_of_other_programs_are_read(folder, tmp_path, program, extension):
    theirs = tmp_path / f"theirs.{extension}"
    program(folder / "part.stl", theirs)
    if extension == "ast":  # FreeCAD's name for STL as text
        theirs = theirs.rename(tmp_path / "text.stl")
        assert theirs.read_bytes().startswith(b"solid")
    same_mesh(theirs, folder / "part.stl", rel=1e-5, within=1e-4)


def test_stl_as_text_is_what_openscad_writes(tmp_path):
    need("openscad")
    (tmp_path / "cube.scad").write_text("translate([1, 2, 3]) cube([3, 4, 5]);")
    run("openscad", "-o", tmp_path / "cube.stl", tmp_path / "cube.scad")
    assert (tmp_path / "cube.stl").read_bytes().startswith(b"solid")
    cube = told(tmp_path / "cube.stl")
    assert (cube["triangles"], cube["volume"], cube["bounds"]) == (12, pytest.approx(60), [[1, 4], [2, 6], [3, 8]])


def model_part(path):
    with zipfile.ZipFile(path) as package:
        assert package.testzip() is None
        assert [(part.filename, part.date_time[:3]) for part in package.infolist()] == [
            (name, (1980, 1, 1)) for name in ("[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model")]
        return package.read("3D/3dmodel.model").decode()


def test_3mf_is_in_millimetres_and_the_same_each_time(folder, tmp_path):
    text = model_part(folder / "part.3mf")
    assert '<model unit="millimeter"' in text
    vertices = re.findall(r'<vertex x="([^"]+)" y="([^"]+)" z="([^"]+)"/>', text)
    numbers = np.array([[float(x) for x in vertex] for vertex in vertices])
    assert len(numbers) == told(folder / "part.stl")["vertices"]
    assert np.array_equal(numbers, numbers.astype(np.float32)), "digits that are another number as double than as float"
    summary("convert", folder / "part.stl", "-o", tmp_path / "again.3mf")
    assert (tmp_path / "again.3mf").read_bytes() == (folder / "part.3mf").read_bytes()


UNITS = {"micron": 0.001, "millimeter": 1, "centimeter": 10, "inch": 25.4, "foot": 304.8, "meter": 1000}


@pytest.mark.parametrize("unit, mm", UNITS.items())
def test_3mf_units_builds_and_components(folder, tmp_path, unit, mm):
    """A part twice, once as a mirrored and moved component, in other units; and one that is not in the build."""
    text = model_part(folder / "part.3mf").replace('unit="millimeter"', f'unit="{unit}"')
    component = '<component objectid="1" transform="-1 0 0 0 1 0 0 0 1 100 0 0"/>'
    text = text.replace("</resources>", f'<object id="2"><components>{component}</components></object></resources>')
    text = text.replace("</build>", '<item objectid="2" transform="1 0 0 0 1 0 0 0 1 0 50 0"/></build>')
    path = tmp_path / "two.3mf"
    with zipfile.ZipFile(folder / "part.3mf") as package, zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as changed:
        for part in package.namelist():
            changed.writestr(part, text if part.endswith(".model") else package.read(part))
    one, two = told(folder / "part.stl"), told(path)
    assert two["triangles"] == 2 * one["triangles"] and two["notes"] == []
    assert two["volume"] == pytest.approx(2 * one["volume"] * mm**3, rel=1e-5)
    assert np.allclose(two["bounds"], [[-5 * mm, 105 * mm], [-4 * mm, 54 * mm], [-3 * mm, 3 * mm]], rtol=1e-6)


def test_a_3mf_through_a_pipe(folder, tmp_path):
    """The writer never seeks, so that a pipe suffices."""
    os.mkfifo(tmp_path / "pipe.3mf")
    with subprocess.Popen(["cat", tmp_path / "pipe.3mf"], stdout=subprocess.PIPE) as reader:
        summary("convert", folder / "part.stl", "-o", tmp_path / "pipe.3mf")
        assert reader.communicate(timeout=60)[0] == (folder / "part.3mf").read_bytes()


LOST = "colours and materials other than one opaque base material an object"


def test_what_is_left_out_is_told(folder, tmp_path):
    """The command reports it on stderr and in its summary, too."""
    assimp(folder / "part.stl", tmp_path / "a.3mf")
    done = subprocess.run([COMMAND, "--json", "info", tmp_path / "a.3mf"], capture_output=True, text=True)
    assert done.stderr == "fieldfab: note: a.3mf: left out: " + LOST + "\n"
    assert json.loads(done.stdout)["notes"] == ["a.3mf: left out: " + LOST]
    for verb in (("convert",), ("mesh", "--voxel", "1")):
        arguments = [COMMAND, *verb, tmp_path / "a.3mf", "-o", tmp_path / "a.ply"]
        done = subprocess.run(arguments, capture_output=True, text=True)
        assert done.returncode == 0 and f"note: a.3mf: left out: {LOST}\n" in done.stderr


# Parts: names, colours and places, as assimp sees them. Our own reader's are in tests/unit/mesh_parts_test.cpp.

TOMATO, GREY, AZURE = (255, 99, 71), (204, 204, 204), (1, 128, 255)
NAMES = ("Fuß <unten> & 'so'", "middle", "top")


@pytest.fixture(scope="module")
def parts(tmp_path_factory):
    """Files of write_parts.cpp: boxes of 30 by 20 by 10 mm at z = 0, 15 and 30, the middle one without a colour."""
    folder = tmp_path_factory.mktemp("parts of it")
    run(BUILD / "bin" / "write_parts",
        *(folder / f"my parts.{form}" for form in ("glb", "obj", "ply", "3mf", "stl", "off")))
    return folder


def numbers(element):
    return np.array(element.text.split(), float)


class Seen:
    """A scene read by assimp: names, colours, and vertices of its nodes in the root's coordinates."""

    def __init__(self, path, folder):
        run("assimp", "dump", path, folder / "dump.xml")
        scene = xml.etree.ElementTree.parse(folder / "dump.xml").getroot().find("Scene")
        self.materials = [material.find("MatPropertyList") for material in scene.iterfind("MaterialList/Material")]
        self.meshes = list(scene.iterfind("MeshList/Mesh"))
        self.parts = []
        self._add(scene.find("Node"), np.eye(4))

    def _add(self, node, above):
        frame = above @ numbers(node.find("Matrix4")).reshape(4, 4)
        for number in map(int, (node.findtext("MeshRefs") or "").split()):
            mesh = self.meshes[number]
            places = numbers(mesh.find("Positions")).reshape(-1, 3) @ frame[:3, :3].T + frame[:3, 3]
            self.parts.append((node.get("name"), self._colour(mesh), places))
        for child in node.iterfind("NodeList/Node"):
            self._add(child, frame)

    def _colour(self, mesh):
        properties = {entry.get("key"): entry for entry in self.materials[int(mesh.get("material_index"))]}
        return tuple(numbers(properties["$clr.diffuse"])[:3])


def above_each_other(parts):
    for i, (_, _, places) in enumerate(parts):
        assert np.allclose([places.min(0), places.max(0)], [[0, 0, 15 * i], [30, 20, 15 * i + 10]], rtol=0, atol=1e-5)


def test_parts_in_glb_are_nodes_in_metres_with_y_up(parts, tmp_path):
    seen = Seen(parts / "my parts.glb", tmp_path).parts
    assert tuple(name for name, _, _ in seen) == NAMES
    tomato, white, azure = (np.array(colour) for _, colour, _ in seen)
    for linear, colour in ((tomato, TOMATO), (azure, AZURE)):  # IEC 61966-2-1, from linear light
        s_rgb = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
        assert np.allclose(255 * s_rgb, colour, rtol=0, atol=0.05)
    assert np.all(white == 1)
    upright = [(name, colour, 1000 * places @ [[1, 0, 0], [0, 0, 1], [0, -1, 0]]) for name, colour, places in seen]
    above_each_other(upright)


def test_parts_in_obj_are_objects_with_materials(parts, tmp_path):
    seen = Seen(parts / "my parts.obj", tmp_path).parts
    assert tuple(name for name, _, _ in seen) == ("Fuß_<unten>_&_'so'", "middle", "top")
    assert np.allclose([colour for _, colour, _ in seen], np.array([TOMATO, GREY, AZURE]) / 255, rtol=0, atol=1e-5)
    above_each_other(seen)


def test_parts_in_ply_are_coloured_vertices(parts, tmp_path):
    seen = Seen(parts / "my parts.ply", tmp_path)
    (_, _, places), = seen.parts
    colours = numbers(seen.meshes[0].find("Colors")).reshape(-1, 4)
    assert len(places) == len(colours) == 24
    for i, colour in enumerate((TOMATO, GREY, AZURE)):
        of_part = places[:, 2] // 15 == i
        assert np.allclose(colours[of_part], np.array([*colour, 255]) / 255, rtol=0, atol=1e-5) and of_part.sum() == 8


def test_parts_in_3mf_are_objects_with_colours(parts, tmp_path):
    """assimp 5.2 reads materials, but no names."""
    seen = Seen(parts / "my parts.3mf", tmp_path)
    above_each_other(seen.parts)
    assert np.allclose([seen.parts[i][1] for i in (0, 2)], np.array([TOMATO, AZURE]) / 255, rtol=0, atol=1e-5)
    model = xml.etree.ElementTree.fromstring(model_part(parts / "my parts.3mf"))
    core = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
    assert tuple(each.get("name") for each in model.iter(f"{core}object")) == NAMES
    assert [each.get("objectid") for each in model.iter(f"{core}item")] == ["1", "2", "3"]


@pytest.mark.parametrize("extension", ["obj", "ply", "3mf", "stl", "off"])
def test_parts_are_read_as_one_mesh(parts, extension):
    seen = told(parts / f"my parts.{extension}")
    assert (seen["triangles"], seen["volume"]) == (36, pytest.approx(18000))
    assert seen["bounds"] == [[0, 30], [0, 20], [0, 40]]
    assert seen["notes"] == []
    assert [part["name"] for part in seen.get("parts", [])] == (list(NAMES) if extension == "3mf" else [])


def test_parts_stay_parts(parts, tmp_path):
    """Parts survive conversion between formats, and from a text."""
    told_of = lambda path: [(p["name"], p["colour"], p["bounds"], pytest.approx(p["volume"]))
                            for p in told(path)["parts"]]
    summary("convert", parts / "my parts.3mf", "-o", tmp_path / "again.3mf")
    assert told_of(tmp_path / "again.3mf") == told_of(parts / "my parts.3mf")
    summary("convert", parts / "my parts.3mf", "-o", tmp_path / "one.3mf", "--part", NAMES[1])
    assert told_of(tmp_path / "one.3mf") == told_of(parts / "my parts.3mf")[1:2]
    (tmp_path / "two.frep").write_text('part(box(1, 1, 1), "a", "red")\npart(move(box(1, 1, 2), 3), "b")\n')
    summary("convert", tmp_path / "two.frep", "-o", tmp_path / "two.3mf")
    assert [(p["name"], p["colour"], p["volume"]) for p in told(tmp_path / "two.3mf")["parts"]] == [
        ("a", "#ff0000", pytest.approx(1)), ("b", None, pytest.approx(2))]


def test_glb_is_a_mesh_of_its_own(folder, tmp_path):
    """Any verb writes .glb; none reads it."""
    summary("convert", folder / "part.3mf", "-o", tmp_path / "a.glb")
    summary("mesh", folder / "part.frep", "-o", tmp_path / "b.GLB", "--voxel", 0.5)
    for name in ("a.glb", "b.GLB"):
        (_, _, places), = Seen(tmp_path / name, tmp_path).parts
        assert len(places) == told(folder / "part.stl")["vertices"]
        assert np.allclose(np.array([places.min(0), places.max(0)]).T[[0, 2, 1]] * [[1], [-1], [1]] * 1000,
                           [BOUNDS[0], BOUNDS[1][::-1], BOUNDS[2]], rtol=0, atol=1e-5)
    summary("convert", folder / "part.3mf", "-o", tmp_path / "again.glb")
    assert (tmp_path / "a.glb").read_bytes() == (tmp_path / "again.glb").read_bytes()
    for verb in (["info"], ["convert", "-o", tmp_path / "c.stl"], ["mesh", "-o", tmp_path / "c.stl"]):
        done = subprocess.run([COMMAND, verb[0], tmp_path / "a.glb", *verb[1:]], capture_output=True, text=True)
        assert done.returncode == 2
        assert "a.glb: is written, not read; " in done.stderr


# Volumes: an eccentric ball, with different spacing along each axis.

SIZE, SPACING, ORIGIN, RADIUS = (24, 20, 18), (0.5, 0.75, 1.0), (1.0, 2.0, 3.0), 4.0


def ball():
    z, y, x = np.meshgrid(*(np.arange(n) for n in SIZE[::-1]), indexing="ij")
    away = np.sqrt(sum(((a - (n - 1) / 2) * s) ** 2 for a, n, s in zip((x, y, z), SIZE, SPACING)))
    return np.clip(128 + 20 * (RADIUS - away), 0, 255).astype(np.float32)


BALL = ball()
VOLUME = 4 / 3 * np.pi * RADIUS**3


def nrrd(units=None):
    lines = ["NRRD0005", "type: float", "dimension: 3", "sizes: 24 20 18", "endian: little", "encoding: raw",
             "space: left-posterior-superior", "space directions: (0.5,0,0) (0,0.75,0) (0,0,1)",
             "space origin: (1,2,3)"]
    lines += [f'space units: "{units}" "{units}" "{units}"'] if units else []
    return "\n".join([*lines, "", ""]).encode() + BALL.astype("<f4").tobytes()


def stands(path, mm=1.0):
    """Asserts that a volume has the size, position and solid of the ball."""
    seen = told(path)
    axes, spacing = np.array(seen["axes"]).T, np.array(seen["spacing"])
    indices = itertools.product(*((0, n - 1) for n in seen["samples"]))
    corners = [np.array(seen["origin"]) + axes @ (spacing * np.array(index)) for index in indices]
    far = [o + s * (n - 1) for o, s, n in zip(ORIGIN, SPACING, SIZE)]
    assert seen["samples"] == list(SIZE)
    assert np.allclose(np.min(corners, 0), np.array(ORIGIN) * mm, rtol=1e-5)
    assert np.allclose(np.max(corners, 0), np.array(far) * mm, rtol=1e-5)
    made = summary("mesh", path, "-o", path.parent / "ball_of_it.stl", "--threshold", 128)
    assert made["volume"] == pytest.approx(VOLUME * mm**3, rel=0.05)
    return made["volume"]


@pytest.mark.parametrize("extension", VOLUMES)
def test_volumes_go_there_and_back(folder, tmp_path, extension):
    assert stands(folder / f"scan.{extension}") == pytest.approx(stands(folder / "scan.nrrd"), rel=1e-6)
    summary("convert", folder / f"scan.{extension}", "-o", tmp_path / "back.nrrd")
    a, b = told(folder / "scan.nrrd"), told(tmp_path / "back.nrrd")
    assert (a["samples"], a["least"], a["greatest"]) == (b["samples"], b["least"], b["greatest"])
    assert a["spacing"] == pytest.approx(b["spacing"]) and a["origin"] == pytest.approx(b["origin"])


def test_nrrd_by_teem(folder, tmp_path):
    summary("convert", folder / "scan.nrrd", "-o", tmp_path / "ours.nrrd")
    assert "sizes: 24 20 18" in run("teem-unu", "head", tmp_path / "ours.nrrd")
    run("teem-unu", "save", "-f", "nrrd", "-e", "raw", "-i", tmp_path / "ours.nrrd", "-o", tmp_path / "theirs.nrrd")
    assert (tmp_path / "theirs.nrrd").read_bytes().endswith(BALL.astype("<f4").tobytes())
    stands(tmp_path / "theirs.nrrd")


@pytest.mark.parametrize("extension", ["nii", "nii.gz"])
def test_nifti_by_nibabel(folder, tmp_path, extension):
    image = nibabel.load(folder / f"scan.{extension}")
    assert image.header.get_xyzt_units()[0] == "mm"
    assert np.array_equal(np.asarray(image.dataobj), BALL.T)
    assert np.allclose(image.affine @ [0, 0, 0, 1], [-1, -2, 3, 1])  # RAS of our LPS
    nibabel.save(nibabel.Nifti1Image(BALL.T.copy(), image.affine), tmp_path / f"theirs.{extension}")
    stands(tmp_path / f"theirs.{extension}")


def test_metaimage_says_what_its_specification_wants(folder):
    """No program of Debian independent of ITK, our writer, reads the format."""
    head, _, samples = (folder / "scan.mha").read_bytes().partition(b"ElementDataFile = LOCAL\n")
    fields = dict(line.split(" = ", 1) for line in head.decode().splitlines())
    wanted = {"DimSize": "24 20 18", "ElementType": "MET_FLOAT", "NDims": "3", "CompressedData": "False"}
    assert {key: fields[key] for key in wanted} == wanted
    assert [float(x) for x in fields["ElementSpacing"].split()] == list(SPACING)
    assert [float(x) for x in fields["Offset"].split()] == list(ORIGIN)
    assert samples == BALL.astype("<f4").tobytes()


@pytest.mark.parametrize("unit, mm", [("um", 1e-3), ("micron", 1e-3), ("mm", 1), ("cm", 10), ("m", 1e3), ("in", 25.4)])
def test_units_of_nrrd(tmp_path, unit, mm):
    (tmp_path / "scan.nrrd").write_bytes(nrrd(unit))
    stands(tmp_path / "scan.nrrd", mm)


@pytest.mark.parametrize("unit, mm", [("um", 1e-3), ("mm", 1), ("cm", 10)])
@pytest.mark.parametrize("compressed", [False, True])
def test_units_of_metaimage(tmp_path, unit, mm, compressed):
    samples = BALL.astype("<f4").tobytes()
    body = zlib.compress(samples) if compressed else samples
    packed = {"CompressedData": "True", "CompressedDataSize": len(body)} if compressed else {}
    fields = {"ObjectType": "Image", "NDims": 3, "DimSize": "24 20 18", "ElementType": "MET_FLOAT", "Offset": "1 2 3",
              "ElementSpacing": "0.5 0.75 1", "DistanceUnits": unit, **packed, "ElementDataFile": "LOCAL"}
    head = "".join(f"{key} = {value}\n" for key, value in fields.items())
    (tmp_path / "scan.mha").write_bytes(head.encode() + body)
    stands(tmp_path / "scan.mha", mm)


@pytest.mark.parametrize("unit, mm", [("micron", 1e-3), ("mm", 1), ("meter", 1e3), ("unknown", 1)])
def test_units_of_nifti(tmp_path, unit, mm):
    affine = np.diag([-0.5, -0.75, 1, 1])
    affine[:3, 3] = -1, -2, 3
    image = nibabel.Nifti1Image(BALL.T.copy(), affine)
    image.header.set_xyzt_units(unit)
    nibabel.save(image, tmp_path / "scan.nii")
    stands(tmp_path / "scan.nii", mm)


def test_nifti_2_is_refused_by_name(tmp_path):
    nibabel.save(nibabel.Nifti2Image(BALL.T.copy(), np.eye(4)), tmp_path / "scan.nii")
    done = subprocess.run([COMMAND, "info", tmp_path / "scan.nii"], capture_output=True, text=True)
    assert done.returncode == 2 and done.stderr.endswith("scan.nii: is a NIfTI-2 file; NIfTI-1 is read\n")


def test_units_that_are_not_known_are_refused(tmp_path):
    (tmp_path / "scan.nrrd").write_bytes(nrrd("furlong"))
    done = subprocess.run([COMMAND, "info", tmp_path / "scan.nrrd"], capture_output=True, text=True)
    assert done.returncode == 2
    assert done.stderr.endswith("scan.nrrd: has the unit 'furlong'; known are mm, um, nm, cm, m and in\n")


# Solids.


def test_level_sets_by_openvdb(folder, tmp_path):
    summary("convert", folder / "part.frep", "-o", tmp_path / "ours.vdb", "--voxel", 0.25)
    (grid,), _ = openvdb.readAll(str(tmp_path / "ours.vdb"))
    assert grid.gridClass == "level set" and np.allclose(grid.transform.voxelSize(), 0.25)
    ours = summary("mesh", tmp_path / "ours.vdb", "-o", tmp_path / "ours.stl")
    assert ours["volume"] == pytest.approx(told(folder / "part.stl")["volume"], rel=0.02)
    assert np.allclose(told(tmp_path / "ours.stl")["bounds"], BOUNDS, rtol=0, atol=0.1)
    theirs = openvdb.createLevelSetSphere(radius=4.0, center=(1.0, 2.0, 3.0), voxelSize=0.25)
    openvdb.write(str(tmp_path / "theirs.vdb"), theirs)
    ball = summary("mesh", tmp_path / "theirs.vdb", "-o", tmp_path / "theirs.stl")
    assert ball["volume"] == pytest.approx(VOLUME, rel=0.01)
    assert np.allclose(told(tmp_path / "theirs.stl")["bounds"], [[-3, 5], [-2, 6], [-1, 7]], atol=0.05)


@pytest.mark.parametrize("extension", SOLIDS)
def test_solids_go_there_and_back(folder, tmp_path, extension):
    summary("convert", folder / "part.frep", "-o", tmp_path / f"part.{extension}", "--voxel", 0.2)
    made = summary("mesh", tmp_path / f"part.{extension}", "-o", tmp_path / "part.stl")
    assert made["volume"] == pytest.approx(told(folder / "part.stl")["volume"], rel=0.02)
    assert np.allclose(told(tmp_path / "part.stl")["bounds"], BOUNDS, rtol=0, atol=0.1)


@pytest.mark.parametrize("extension", TEXTS)
def test_formulas_go_there_and_back(folder, tmp_path, extension):
    summary("convert", folder / "part.frep", "-o", tmp_path / f"part.{extension}")
    made = summary("mesh", tmp_path / f"part.{extension}", "-o", tmp_path / "part.stl", "--voxel", 0.5)
    same_mesh(tmp_path / "part.stl", folder / "part.stl")
    assert made["triangles"] == told(folder / "part.stl")["triangles"]


# The document.


def rows(heading):
    """Returns rows of the table below a heading of docs/formats.md, by the extensions in their first cells."""
    text = (ROOT / "docs" / "formats.md").read_text().split(f"\n## {heading}\n")[1].split("\n## ")[0]
    table = [line.strip("|").split("|") for line in text.splitlines() if line.startswith("|")]
    lines = [[cell.strip() for cell in line] for line in table]
    assert all(len(cells) == len(lines[0]) and all(cells) for cells in lines)
    return {extension: cells[1:] for cells in lines[2:] for extension in re.findall(r"`\.([\w.]+)`", cells[0])}


def test_the_document_names_the_formats_that_go_both_ways():
    both = {**rows("Meshes"), **rows("Volumes and solids"), **rows("Formulas")}
    assert sorted(both) == sorted(ROUND_TRIPS)
    assert sorted(rows("Parts")) == sorted([*MESHES, "glb"])


def test_the_document_names_every_format_that_the_command_knows(tmp_path):
    said = lambda *arguments: subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True).stderr
    (tmp_path / "a.frep").write_text("sphere(1)")
    (tmp_path / "a.what").write_text("")
    known = lambda text: set(re.findall(r"\.([a-z0-9]+(?:\.gz)?)\b", text.split("known are")[1]))
    written = known(said("convert", tmp_path / "a.frep", "-o", tmp_path / "b.what"))
    read = known(said("info", tmp_path / "a.what"))
    assert len(written) > 10 and len(read) > 20
    both, only_read, only_written = set(ROUND_TRIPS), set(rows("Only read")), set(rows("Only written"))
    assert written - both - only_written == set() and read - both - only_read == set()
    assert only_read - read <= {"ima", "dicom", "tiff"}  # aliases of .dcm and .tif, omitted in messages
