"""The Python module: expressions, fields, arrays without copies, progress and errors."""

import math
import re

import numpy as np
import pytest

import fieldfab as ff

BALL = ff.shapes.sphere(1)


def test_expressions():
    x, y = ff.X, ff.Y
    assert ff.parse("x^2 + y") == ff.parse_math("+pXf2Y")
    assert (x * x + y).simplified() == x * x + y
    assert ff.parse(str(BALL)) == BALL and ff.parse_math(BALL.math()) == BALL and ff.parse_vm(BALL.vm()) == BALL
    assert np.allclose((2 * x - y / 4 + abs(-y) ** 2 % 3)(np.array([1.0, 2.0]), 2.0, 0.0), [2 - 0.5 + 1, 4 - 0.5 + 1])
    assert np.allclose(ff.sin(x)(np.linspace(-3, 3, 50), 0, 0), np.sin(np.linspace(-3, 3, 50)), atol=1e-6)
    assert BALL.map(x=ff.Y, y=ff.X) != BALL
    with pytest.raises(ff.Error) as raised:
        ff.parse("spheer(1)")
    assert raised.value.kind == "bad_input" and raised.value.place == "expression:1:1"
    with pytest.raises(ff.Error):
        ff.Solid(math.nan)


def test_fields():
    field = ff.Solid(BALL)
    assert field.value(0, 0, 3) == 2
    values, gradients = field.gradients(np.array([[0, 0, 3], [0, 2, 0]], np.float32))
    assert np.allclose(values, [2, 1]) and np.allclose(gradients, [[0, 0, 1], [0, 1, 0]])
    low, high = field.interval((0, 0, 0, 1, 1, 1))
    assert low <= -1 and high >= math.sqrt(3) - 1 - 1e-6
    moved = field.translate(5, 0, 0).rotate((0, 0, 1), math.pi / 2)
    assert moved.value(0, 5, 0) == pytest.approx(-1, abs=1e-5)
    assert np.allclose(moved.bounds(), (-1, 4, -1, 1, 6, 1), atol=0.05)
    assert (field - field.scale(0.5, 0.5, 0.5)).value(0, 0, 0) > 0
    assert ff.Solid(ff.shapes.gyroid(1)).bounds() is None


def test_mesh_arrays_are_views():
    mesh = ff.mesh(BALL, voxel=0.1)
    vertices, triangles = mesh.vertices, mesh.triangles
    assert vertices.dtype == np.float32 and triangles.dtype == np.uint32
    assert not vertices.flags.owndata and not triangles.flags.owndata
    assert vertices.__array_interface__["data"] == mesh.vertices.__array_interface__["data"]
    volume = mesh.volume
    del mesh
    a, b, c = (vertices[triangles[:, i]].astype(float) for i in range(3))
    assert np.einsum("ij,ij->", a, np.cross(b, c)) / 6 == pytest.approx(volume)


def test_asdf(tmp_path):
    asdf = ff.build(BALL, voxel=0.05)
    counts = asdf.statistics()
    assert counts["bytes"] <= 24 * counts["cells"]
    asdf.save(tmp_path / "b.asdf")
    assert ff.Asdf.load(tmp_path / "b.asdf").value(0.9, 0, 0) == pytest.approx(asdf.value(0.9, 0, 0), abs=0.05 / 1024)
    assert asdf.slice(0.5).lattice[2] == 0
    assert asdf.rescale(2).value(1.9, 0, 0) < 0
    assert asdf.ray((5, 0, 0), (-1, 0, 0)) == pytest.approx(4, abs=0.01)
    assert ff.inspect(ff.mesh(asdf)).valid


def test_render():
    image = ff.render(BALL, mode="height", size=50)
    assert image.pixels.shape == (50, 50) and not image.pixels.flags.owndata
    assert image.pixels.max() > 60000 and image.zmax > 1 > image.zmin
    assert ff.render(BALL, size=40).pixels.shape == (40, 40, 3)


def test_check():
    report = ff.check(BALL, voxel=0.1)
    assert report.passed and "pass" in str(report)


def test_progress_cancels_and_raises():
    seen = []
    ff.mesh(BALL, voxel=0.02, progress=lambda fraction, message: seen.append(fraction))
    assert seen and all(0 <= f <= 1 for f in seen)
    with pytest.raises(ff.Error) as raised:
        ff.mesh(BALL, voxel=0.02, progress=lambda fraction, message: False)
    assert raised.value.kind == "cancelled"

    def fail(fraction, message):
        raise KeyError("mine")

    with pytest.raises(KeyError):
        ff.build(BALL, voxel=0.01, progress=fail)


def test_stubs_name_what_there_is():
    import ast
    import pathlib

    package = pathlib.Path(ff.__file__).parent
    for module, stub in [(ff._core, "_core.pyi"), (ff.shapes, "shapes.pyi"), (ff.language, "language.pyi"),
                         (ff.cam, "cam.pyi"), (ff.stock, "stock.pyi")]:
        tree = ast.parse((package / stub).read_text())
        described = {node.name: node for node in tree.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
        for name, thing in vars(module).items():
            if name.startswith("_") or name in ("X", "Y", "Z", "default_cells", "shapes", "language", "cam", "stock"):
                continue
            assert name in described, f"{stub} lacks {name}"
            signature = (thing.__doc__ or "").splitlines()[:1]
            if isinstance(described[name], ast.FunctionDef) and signature and "(" in signature[0]:
                found = [part.split(":")[0].strip() for part in signature[0].split("(", 1)[1].split(", ")
                         if ":" in part]
                assert module is ff.shapes or [a.arg for a in described[name].args.args] == found, name
            if isinstance(described[name], ast.ClassDef) and thing is not ff.Error:
                members = {node.name for node in described[name].body if isinstance(node, ast.FunctionDef)}
                own = {n for n in vars(thing) if not n.startswith("_")}
                assert own <= members, f"{stub}: {name} lacks {own - members}"
                assert {n for n in members if not n.startswith("_")} <= own, name
        assert {n for n in described} <= set(vars(module)), stub


def test_what_is_made_from_the_library_is_up_to_date():
    import subprocess
    import sys

    from conftest import ROOT

    done = subprocess.run([sys.executable, ROOT / "packaging" / "make_docs.py", "--check"], capture_output=True,
                          text=True)
    assert done.returncode == 0, done.stderr


def test_detail_meshes():
    mesh = ff.DetailMesh(BALL, cells=16, angle=0.01, deepest=5)
    eye = (0.0, 0.0, 1.2)
    assert mesh.parts(eye) == [] and mesh.refine(eye) and len(mesh.parts(eye)) == 1
    while mesh.refine(eye):
        pass
    levels = [level for _, level, _ in mesh.parts(eye)]
    assert max(levels) == 5 and min(levels) < 5
    assert all(np.abs(np.linalg.norm(part.vertices, axis=1) - 1).max() < 0.02 for _, _, part in mesh.parts(eye))


def test_graphs(tmp_path):
    (ff.X + ff.Y * 2).save_dot(tmp_path / "g.dot")
    text = (tmp_path / "g.dot").read_text()
    assert text.startswith("digraph") and text.count("[label=") == 5 and text.count("->") == 4


def test_evaluators_can_be_forced():
    try:
        for name in ("reference", "portable", "jit"):
            ff.set_evaluator(name)
            assert BALL(0, 0, 3) == 2
        with pytest.raises(ff.Error):
            ff.set_evaluator("abacus")
    finally:
        ff.set_evaluator("automatic")


def test_small_things():
    assert ff.Error("x").kind == "bad_input"
    assert not str(BALL).endswith("\n")
    assert ff.X(1, 2, 3) == 1 and isinstance(ff.X(1, 2, 3), float)
    grid = BALL(np.linspace(-1, 1, 4)[:, None], np.zeros(3)[None, :], 0)
    assert grid.shape == (4, 3) and grid.dtype == np.float32 and grid[0, 0] == pytest.approx(0, abs=1e-6)
    with pytest.raises(ValueError):
        ff.X(np.zeros(3), np.zeros(4), 0)
    from fieldfab.shapes import sphere

    assert sphere(1) == BALL


def test_meshes_of_arrays_are_solids():
    cube = ff.mesh(ff.parse("max(abs(x) - 1, max(abs(y) - 2, abs(z) - 3))"), voxel=0.25)
    again = ff.Mesh(cube.vertices, cube.triangles)
    assert again.volume == cube.volume == pytest.approx(48, rel=1e-3)
    field = again.solid()
    assert field.value(0, 0, 0) == pytest.approx(-1, abs=1e-3) and field.value(3, 0, 0) == pytest.approx(2, abs=1e-3)
    for vertices, triangles in (([[0, 0]], [[0, 0, 0]]), ([[0, 0, 0]], [[0, 0, 1]]),
                                ([[0, 0, float("nan")]], [[0, 0, 0]]), ([[0, 0, 0]], [[0, 0, 7]])):
        with pytest.raises(ff.Error):
            ff.Mesh(vertices, triangles)


def test_freecads_mesh_bytes_name_all_neighbours():
    mesh = ff.mesh(ff.parse("sphere(r = 5)"), voxel=0.7)
    data, n, m = mesh.bms(), len(mesh.vertices), len(mesh.triangles)
    head = np.frombuffer(data[:8], "<u4")
    assert list(head) == [0xA0B0C0D0, 0x010000] and list(np.frombuffer(data[264:272], "<u4")) == [n, m]
    assert len(data) == 272 + 12 * n + 24 * m + 24
    assert data[272:272 + 12 * n] == mesh.vertices.tobytes()
    rows = np.frombuffer(data[272 + 12 * n:-24], "<u4").reshape(m, 6)
    assert (rows[:, :3] == mesh.triangles).all()
    for t, row in enumerate(rows.tolist()):
        for i in range(3):
            other = rows[row[3 + i], :3].tolist()
            assert row[3 + i] != t and row[i] in other and row[(i + 1) % 3] in other


DESIGN = """%sphere(r = 9);
difference() {
  cube(size = [10, 20, 30], center = true);
  #multmatrix([[1, 0, 0, 2], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {
    cylinder($fn = 4, h = 40, r1 = 3, r2 = 3, center = true);
  }
  *cube(size = [1, 1, 1]);
  text(text = "a \\"b\\"", size = 5);
}
"""


def test_an_openscad_design_is_a_tree(tmp_path):
    (tmp_path / "design.csg").write_text(DESIGN)
    tree = ff.read_openscad_tree(tmp_path / "design.csg")
    nodes = [tree[i] for i in range(len(tree))]
    assert [node.name for node in nodes] == ["group", "sphere", "difference", "cube", "multmatrix", "cylinder", "cube",
                                             "text"]
    assert ([node.dimensions for node in nodes] == [3, 3, 3, 3, 3, 3, 3, 2] and nodes[2].children == [3, 4, 6, 7]
            and nodes[2].line == 2)
    assert ([i for i, node in enumerate(nodes) if node.background] == [1]
            and [i for i, node in enumerate(nodes) if node.disabled] == [6])
    assert [i for i, node in enumerate(nodes) if node.highlight] == [4] and not any(node.root for node in nodes)
    assert nodes[3].arguments == {"size": [10, 20, 30], "center": True} and nodes[4].arguments[""][0] == [1, 0, 0, 2]
    assert nodes[7].arguments == {"text": 'a "b"', "size": 5}
    with pytest.raises(IndexError):
        tree[len(tree)]
    (tmp_path / "again.csg").write_text(nodes[0].text())
    again = ff.read_openscad_tree(tmp_path / "again.csg")
    assert again[0].children == [1] and again[1].text() == nodes[0].text(), "modifiers and all"
    alone = ff.openscad_design(nodes[4].text())
    assert ff.mesh(alone.solid, voxel=0.5).volume == pytest.approx(2 * 3 * 3 * 40, rel=1e-3)


def test_openscad_text_is_a_solid(tmp_path):
    design = ff.openscad_design("cube(size = [1, 2, 3]); square(size = [1, 1]);", name="part")
    assert ff.mesh(design.solid, voxel=design.voxel).volume == pytest.approx(6, rel=1e-3) and not design.flat
    assert design.notes == ["part:1: square is 2D among 3D shapes, and left out as OpenSCAD does"]
    plate = ff.openscad_design("square(size = [4, 5]);", thickness=2)
    assert (plate.flat and plate.solid.bounds()[5] == pytest.approx(2, abs=0.05)
            and ff.mesh(plate.solid, voxel=0.1).volume == pytest.approx(40, rel=1e-3))
    assert ff.openscad_design("group();").solid is None
    assert ff.openscad_design("sphere(r = 10, $fn = 6);", smooth=True).solid.value(
        0, 0, 9.99) < 0 < ff.openscad_design("sphere(r = 10, $fn = 6);").solid.value(0, 0, 9.99)
    ff.mesh(BALL, voxel=0.1).save(tmp_path / "ball.stl")
    assert ff.openscad_design('import(file = "ball.stl");', tmp_path).solid.value(0, 0, 0) < 0
    for text, said in (("cube(", "part:1:6"), ("teapot();", "part:1: 'teapot' is not known"),
                       ('import(file = "gone.stl");', "gone.stl")):
        with pytest.raises(ff.Error, match=re.escape(said)):
            ff.openscad_design(text, name="part")
    with pytest.raises(ff.Error) as told:
        ff.openscad_design("minkowski() { cube(size = [1, 1, 1]); sphere(r = 3, $fn = 50); }",
                           progress=lambda fraction, message: False)
    assert told.value.kind == "cancelled"


CORNER = ("difference() { cube(size = [10, 10, 10]); "
          "multmatrix([[1, 0, 0, 5], [0, 1, 0, 5], [0, 0, 1, 5], [0, 0, 0, 1]]) { cube(size = [10, 10, 10]); } }")


def test_an_openscad_design_has_its_own_faces():
    field = ff.openscad_design(CORNER).solid
    for mesh in (ff.mesh(field), field.faces(), ff.mesh(field, voxel=3), ff.mesh(field, resolution=0.1, max_error=1)):
        assert len(mesh.triangles) == 24 and len(mesh.vertices) == 14 and mesh.volume == 875 and ff.inspect(mesh).valid
        assert {*mesh.vertices.ravel()} == {0, 5, 10}
    assert (ff.mesh(field, voxel=0.5, exact=False).volume == pytest.approx(875, rel=1e-3)
            and len(ff.mesh(field, voxel=0.5, exact=False, max_error=0).triangles) > 1000)
    part = ff.mesh(field, bounds=(-1, -1, -1, 11, 11, 4), voxel=0.5)
    assert part.volume == pytest.approx(400, rel=1e-3), "a part of it is a contour"
    whole = ff.mesh(field, bounds=(-1, -1, -1, 11, 11, 11), voxel=0.5, max_error=0)
    assert whole.volume == pytest.approx(875, rel=1e-3) and len(whole.triangles) > 1000
    with pytest.raises(ValueError, match="not both"):
        ff.mesh(field, voxel=1, resolution=1)
    with pytest.raises(ff.Error, match="voxel: must be a positive"):
        ff.mesh(field, voxel=-1)


def test_what_is_made_of_a_design_has_its_faces_where_they_stay_true():
    """A moved or rotated design keeps its exact faces; offsets, unions and round solids have none."""
    field = ff.openscad_design(CORNER).solid
    moved = field.translate(1, 0, 0).rotate((0, 0, 1), 0.5).faces()
    assert (moved.volume == pytest.approx(field.faces().volume, rel=1e-5)
            and len(moved.triangles) == len(field.faces().triangles))
    for other in (field | ff.Solid(BALL), field.offset(1), ff.Solid(BALL),
                  ff.openscad_design(CORNER, smooth=True).solid):
        assert other.faces() is None
    assert ff.mesh(field.translate(1, 0, 0), voxel=0.5).volume == pytest.approx(875, rel=1e-3)
    points = np.random.default_rng(1).uniform(-2, 12, (1000, 3)).astype(np.float32)
    with_faces, without = field.values(points), field.translate(0, 0, 0).values(points)
    assert np.array_equal(with_faces, without) and field.bounds() == pytest.approx((0, 0, 0, 10, 10, 10), abs=1e-3)


def test_a_flat_design_has_the_faces_of_its_plate():
    plate = ff.openscad_design("square(size = [4, 5]);", thickness=2).solid
    assert len(plate.faces().triangles) == 12 and plate.faces().volume == 40
    assert (plate.faces().vertices.min(axis=0).tolist() == [0, 0, 0]
            and plate.faces().vertices.max(axis=0).tolist() == [4, 5, 2])


def test_making_faces_can_be_cancelled():
    field = ff.openscad_design("".join(f"sphere(r = {10 + i}, $fn = 40);" for i in range(20))).solid
    for make in (field.faces, lambda progress: ff.mesh(field, progress=progress)):
        with pytest.raises(ff.Error) as told:
            make(progress=lambda fraction, message: False)
        assert told.value.kind == "cancelled"


def test_the_table_of_formats():
    table = {extension: row for row in ff.formats() for extension in row["extensions"]}
    assert (set(table[".stl"]) == {"extensions", "kind", "reads", "writes", "parts", "help"}
            and len(ff.formats()) < len(table))
    assert {row["kind"] for row in ff.formats()} == {"formula", "script", "design", "distances", "mesh", "volume"}
    assert (table[".glb"]["writes"] and table[".glb"]["parts"] and not table[".glb"]["reads"]
            and table[".csg"]["kind"] == "design")


def test_a_model_tells_its_parts_notes_and_files(tmp_path):
    ball, lid = tmp_path / "ball.frep", tmp_path / "lid.frep"
    ball.write_text('part(sphere(2), "ball", "red")\npart(open("lid.frep"), "lid")')
    lid.write_text('open("open.stl")')
    whole = ff.mesh(ff.shapes.box(1, 1, 1), voxel=0.5)
    ff.Mesh(whole.vertices, whole.triangles[1:]).save(tmp_path / "open.stl")
    model = ff.open_model(ball)
    assert [(name, colour) for _, name, colour in model.parts] == [("ball", "#ff0000"), ("lid", None)]
    assert ([path.name for path in model.files] == ["ball.frep", "lid.frep", "open.stl"]
            and "closed by lids" in model.notes[0])
    assert model.part("lid").value(0, 0, 0) == pytest.approx(-0.5) and model.united().value(0, 0, 0) == -2
    with pytest.raises(ff.Error, match="ball.frep: there is no part 'bal'; did you mean 'ball'"):
        model.part("bal")
    with pytest.raises(ff.Error, match="scripts are run"):
        (tmp_path / "part.py").write_text("")
        ff.open_model(tmp_path / "part.py")


def test_parts_are_written_with_names_and_colours(tmp_path):
    a, b = ff.mesh(ff.shapes.box(2, 2, 2)), ff.mesh(ff.shapes.move(ff.shapes.box(2, 2, 2), 1, 0, 0))
    ff.save_parts([(a, "a", "red"), (b, None, [0, 128, 255])], tmp_path / "parts.3mf")
    (first, name, colour), (second, _, other) = ff.load_parts(tmp_path / "parts.3mf")
    assert (name, colour, other) == ("a", "#ff0000", "#0080ff") and first.bounds()[0] < second.bounds()[0]
    parts = [(ff.shapes.box(2, 2, 2), None, "red"), (ff.shapes.move(ff.shapes.box(2, 2, 2), 1, 0, 0), None, None)]
    ff.mesh(parts[0][0] | parts[1][0]).save(tmp_path / "both.ply", parts)
    assert b"property uchar red" in (tmp_path / "both.ply").read_bytes()
    for parts, path, error in (([(a, "a", "reddish")], "parts.3mf", "reddish"), ([], "parts.3mf", "no part"),
                               ([(a, "a", None)], "parts.xyz", "xyz")):
        with pytest.raises(ff.Error, match=error):
            ff.save_parts(parts, tmp_path / path)


def test_default_cells():
    assert ff.Solid(ff.shapes.box(128, 2, 2)).default_voxel(bounds=(0, 0, 0, 64, 1, 1)) == 64 / ff.default_cells
    assert ff.shapes.box(128, 2, 2).default_voxel(cells=64) == pytest.approx(2, rel=0.05)
    scan = ff.Volume(np.arange(27.0).reshape(3, 3, 3), spacing=(1, 2, 3)).solid(0.5)
    assert scan.default_voxel() == 1
    with pytest.raises(ff.Error, match="cells"):
        scan.default_voxel(cells=0)


def test_certainty_and_measures():
    plate = ff.Solid(ff.shapes.box(100, 80, 0.3))
    told = ff.certainty(plate, voxel=1)
    assert not told.certain and told.count == 1 and told.thickness > 0.9
    assert ff.certainty(plate, voxel=0.1).certain
    assert ff.certainty(ff.mesh(plate).solid(), voxel=1).certain  # by the normals of its triangles
    assert not ff.certainty(ff.mesh(plate).solid().offset(0.1), voxel=1).certain
    measures = ff.measure(plate)
    assert measures.volume[0] <= 2400 <= measures.volume[1] < 2405
    assert measures.area[0] <= 16108 <= measures.area[1]
    half = ff.measure(plate, bounds=(0, -50, -1, 60, 50, 1))
    assert half.volume[0] <= 1200 <= half.volume[1] < 1205
    assert "mm3" in str(measures)
    with pytest.raises(ff.Error):
        ff.measure(ff.X)
