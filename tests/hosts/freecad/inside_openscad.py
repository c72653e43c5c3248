"""Runs inside freecadcmd: OpenSCAD's designs as trees of objects, compared with OpenSCAD's own meshes and with the
kernel's reading of the same file."""

import importlib
import math
import pathlib
import sys

import FreeCAD
import numpy as np
import pytest

from fieldfab_workbench import file_types, files, kernel, openscad_tree
from fieldfab_workbench.objects import combine, frep_solid, modify, openscad_node
from fieldfab_workbench.objects import solid as solids

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import openscad_designs

EXAMPLES = ("CSG LetterBlock assert example002 example003 example004 example005 example008 example011 example012 "
            "example014 example015 offset hull3-tests".split())


@pytest.fixture
def read(document, tmp_path):
    """Returns a function that reads the text of a .csg design and returns its root."""

    def reading(text, name="design.csg"):
        (tmp_path / name).write_text(text)
        return files.insert(str(tmp_path / name), document.Name)

    return reading


def below(obj):
    return list(getattr(obj, "Sources", [])) or ([obj.Source] if getattr(obj, "Source", None) else [])


def shape(obj):
    """Returns a tree as nested lists: kind, then children."""
    what = obj.Node if hasattr(obj, "Node") else obj.Operation if hasattr(obj, "Operation") else "text"
    return [what, *map(shape, below(obj))]


def named(document, label):
    return document.getObjectsByLabel(label)[0]


def volume_of(text, folder="."):
    """Returns the volume of the whole text by the kernel."""
    design = kernel.load().openscad_design(text, folder)
    return kernel.load().mesh(design.solid, voxel=design.voxel).volume


def test_freecad_offers_both_importers():
    assert {file_types.MODULE, "importCSG"} <= set(FreeCAD.getImportType("csg"))
    assert file_types.MODULE in FreeCAD.getImportType("scad"), (
        "FreeCAD's own only once its preferences say where openscad is")


@pytest.mark.parametrize("name", EXAMPLES)
def test_examples_are_openscads_own_solids(document, tmp_path, name):
    path = next(path for path in openscad_designs.designs() if path.stem == name)
    root = importlib.import_module(file_types.MODULE).insert(str(path), document.Name)
    reference, _, flat = openscad_designs.theirs(path, tmp_path / "theirs.off")
    points, triangles = openscad_designs.read_off(reference)
    wanted = openscad_designs.volume(points, triangles) / (openscad_designs.THICKNESS if flat else 1)
    assert root.isValid() and root.Label == name
    assert root.Volume.Value == pytest.approx(wanted, rel=0.005)
    whole = kernel.load().read_openscad_tree(str(path))[0].text()
    assert root.Volume.Value == pytest.approx(volume_of(whole, path.parent), rel=1e-3)
    if not flat:
        mine = np.array([tuple(point.Vector) for point in root.Mesh.Points], dtype=np.float32)
        voxel = root.Proxy.source(root).field().default_voxel()
        assert np.abs(kernel.load().load(reference).values(mine)).max() < voxel, (
            "no vertex is farther than a voxel from OpenSCAD's surface")
    assert root.Visibility and not any(obj.Visibility for obj in root.OutListRecursive)


CORNER = ("difference() { cube(size = [10, 10, 10]); "
          "multmatrix([[1, 0, 0, 5], [0, 1, 0, 5], [0, 0, 1, 5], [0, 0, 0, 1]]) { cube(size = [10, 10, 10]); } }")


def by_the_command(folder):
    """Returns the command's summary of the mesh of the design that was read last."""
    return openscad_designs.ours(folder / "design.csg", folder / "command.off", False)[0]


def test_the_mesh_has_the_designs_own_faces(document, read, tmp_path):
    root = read(CORNER)
    told = by_the_command(tmp_path)
    assert told["exact"] and root.Triangles == root.Mesh.CountFacets == told["triangles"] == 24
    assert root.Volume.Value == told["volume"] == 875 and root.Area.Value == told["area"] == 600 and root.Mesh.isSolid()
    root.VoxelSize = 3
    document.recompute()
    assert root.Triangles == 24 and root.Volume.Value == 875, "faces have no cells"
    root.Sources[0].Length = 12
    document.recompute()
    assert root.Triangles < 50 and root.Volume.Value == 1200 - 7 * 5 * 5
    root.Sources[1].Placement.Base = FreeCAD.Vector(5, 5, -5)
    document.recompute()
    assert root.Triangles < 50 and root.Volume.Value == 1200 - 7 * 5 * 5 and root.Mesh.isSolid()
    root.Operation = "Union"
    document.recompute()
    assert root.Volume.Value == 1200 + 1000 - 7 * 5 * 5


def test_quarter_turns_are_exact(document, read):
    """Those of quaternions are not: coplanar faces would separate."""
    root = read(CORNER)
    root.Sources[1].Placement = FreeCAD.Placement(FreeCAD.Vector(5, 15, 5),
                                                  FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 90))
    assert ("multmatrix([[1.0, 0.0, 0.0, 5.0], [0.0, 0.0, -1.0, 15.0], [0.0, 1.0, 0.0, 5.0], [0.0, 0.0, 0.0, 1.0]])"
            in str(root.Proxy.csg(root)))
    document.recompute()
    assert root.Volume.Value == 875 and root.Triangles < 50
    root.Sources[1].Placement.Rotation = FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 1e-9)
    assert "1.745e-11" in str(root.Proxy.csg(root)), "small turns stay"


def test_a_sphere_has_its_facets(read, tmp_path):
    root = read("sphere($fn = 12, r = 10);")
    told = by_the_command(tmp_path)
    assert (root.Triangles == told["triangles"] == 2 * 12 * 5 + 2 * 10
            and root.Volume.Value == pytest.approx(told["volume"], rel=1e-7))
    assert (all(point.Vector.Length == pytest.approx(10, abs=1e-5) for point in root.Mesh.Points)
            and root.Mesh.CountPoints == 6 * 12)


def test_a_part_of_a_design_is_contoured(document, read):
    root = read(CORNER)
    root.AutoBounds, root.Lower, root.Upper, root.VoxelSize = (
        False, FreeCAD.Vector(-1, -1, -1), FreeCAD.Vector(11, 11, 4), 0.25)
    document.recompute()
    assert (root.isValid() and root.Volume.Value == pytest.approx(400, rel=1e-3)
            and root.Mesh.BoundBox.ZMax == pytest.approx(4, abs=1e-3))
    root.AutoBounds = True
    document.recompute()
    assert root.Volume.Value == 875 and root.Triangles == 24


def test_what_is_made_of_other_solids_too_is_contoured(document, read):
    root = read(CORNER)
    offset = solids.create(modify.Modify, document)
    offset.Operation, offset.Source, offset.Distance = "Offset", root, 1
    document.recompute()
    assert (offset.isValid() and offset.Volume.Value > 875 + 0.9 * 600 and offset.Proxy.source(offset).faces() is None
            and root.Triangles == 24)


@pytest.mark.parametrize("seed", [0, 1, 2, 3, 4, 6, 7, 8])
def test_random_trees_are_openscads_own_solids(document, tmp_path, seed):
    path = tmp_path / "random.scad"
    path.write_text(openscad_designs.random_design(seed))
    root = files.insert(str(path), document.Name)
    reference, _, _ = openscad_designs.theirs(path, tmp_path / "theirs.off")
    assert root.Volume.Value == pytest.approx(openscad_designs.volume(*openscad_designs.read_off(reference)), rel=0.005)


TREE = """difference() {
  cube(size = [10, 20, 30], center = true);
  multmatrix([[1, 0, 0, 2], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {
    cylinder($fn = 12, h = 40, r1 = 3, r2 = 3, center = true);
  }
  %multmatrix([[0, -1, 0, 20], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) { cube(size = [1, 2, 3], center = true); }
  *sphere(r = 100);
}
group() { multmatrix([[-2, 0, 0, 20], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) { color([1, 0, 0, 0.5]) {
  linear_extrude(height = 3, center = false, convexity = 1, twist = 40, slices = 8, scale = [1, 1]) {
    difference() { square(size = [4, 4], center = true); group(); #circle($fn = 8, r = 1); }
  }
} } }
"""


def test_the_tree_is_that_of_the_design(document, read):
    root = read(TREE)
    assert shape(root) == ["Union", ["Difference", ["cube"], ["cylinder"]],
                           ["Transform", ["linear_extrude", ["Difference", ["square"], ["circle"]]]]]
    assert root.Volume.Value == pytest.approx(volume_of(TREE), rel=1e-3)
    assert named(document, "cylinder").Placement.Base == FreeCAD.Vector(2, 0, 0)
    scaled = root.Sources[1]
    assert (tuple(scaled.Factors) == (-2, 1, 1) and scaled.Placement.Base == FreeCAD.Vector(20, 0, 0)
            and scaled.Placement.Rotation.Angle == 0)
    assert named(document, "linear_extrude").Twist.Value == 40 and named(document, "circle").Fn == 8
    shown = [obj for obj in document.Objects if obj.Visibility and obj != root]
    assert [shape(obj) for obj in shown] == [["cube"]] and shown[0].Volume.Value == pytest.approx(6, rel=1e-3)
    box = shown[0].Mesh.BoundBox
    assert box.Center.distanceToPoint(FreeCAD.Vector(20, 0, 0)) < 1e-4 and box.XLength == pytest.approx(2, abs=1e-3), (
        "turned by a quarter")


def test_what_is_only_shown_may_be_wrong(document, read):
    root = read('cube(size = [2, 2, 2]); %import(file = "gone.stl"); %cube(size = [0, 1, 1]); '
                '%union() { sphere(r = 1); cube(size = [3, 3, 3]); }')
    assert root.Volume.Value == pytest.approx(8, rel=1e-3)
    assert [shape(obj) for obj in document.Objects if obj.Visibility] == [["cube"], ["Union", ["sphere"], ["cube"]]]
    assert len(document.Objects) == 4


@pytest.mark.parametrize("turn", ["[[1, 0, 0, 3], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]",
                                  "[[0.612372, -0.353553, 0.707107, 3], [0.5, 0.866025, 0, 0], "
                                  "[-0.612372, 0.353553, 0.707107, 0], [0, 0, 0, 1]]"])
def test_faces_that_meet_leave_no_skin(read, turn):
    """Holes flush with a face leave a single closed piece."""
    holes = ("cube(size = [5, 10, 10]); "
             "multmatrix([[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 5], [0, 0, 0, 1]]) { cube(size = [5, 5, 5]); }")
    root = read(
        f"difference() {{ multmatrix({turn}) {{ cube(size = [10, 10, 10]); }} multmatrix({turn}) {{ {holes} }} }}")
    found = kernel.load().inspect(root.Proxy.source(root).mesh(voxel=0.3))
    assert (found.closed and found.manifold and found.components == 1
            and root.Volume.Value == pytest.approx(375, rel=1e-3))


def test_a_marked_root_is_the_design(document, read):
    root = read("cube(size = [1, 1, 1]); union() { !cube(size = [2, 2, 2]); sphere(r = 9); }")
    assert shape(root) == ["cube"] and root.Volume.Value == pytest.approx(8, rel=1e-3)


NODES = {
    "cylinder": "cylinder($fn = 0, $fa = 12, $fs = 2, h = 3, r1 = 1, r2 = 2, center = false);",
    "sphere": "sphere($fn = 12, r = 2);",
    "polyhedron": "polyhedron(points = [[0, 0, 0], [3, 0, 0], [0, 3, 0], [0, 0, 3]], faces = [[0, 1, 2], [0, 3, 1], "
    "[1, 3, 2], [0, 2, 3]], convexity = 1);",
    "polygon": "linear_extrude(height = 2) { polygon(points = [[0, 0], [4, 0], [0, 4], [1, 1], [2, 1], [1, 2]], "
    "paths = [[0, 1, 2], [3, 4, 5]], convexity = 1); }",
    "text": 'linear_extrude(height = 2) { text(text = "A "b"", size = 10, spacing = 1, font = "", halign = "left", '
    'valign = "baseline", $fn = 0); }',
    "rotate_extrude": "rotate_extrude(angle = 90, $fn = 24) { multmatrix([[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0], "
    "[0, 0, 0, 1]]) { circle($fn = 9, r = 1); } }",
    "hull": "hull() { cube(size = [4, 4, 4]); "
    "multmatrix([[1, 0, 0, 9], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) { sphere($fn = 8, r = 2); } }",
    "minkowski": "minkowski(convexity = 0) { cube(size = [4, 4, 4]); sphere($fn = 8, r = 1); }",
    "projection": "linear_extrude(height = 2) { projection(cut = true, convexity = 0) { cube(size = [4, 4, 4], "
    "center = true); } }",
    "round offset": "linear_extrude(height = 2) { offset(r = 1, $fn = 16) { square(size = [4, 4]); } }",
    "offset": "linear_extrude(height = 2) { offset(delta = 1, chamfer = true) { square(size = [4, 4]); } }",
    "resize": "resize(newsize = [8, 0, 2], auto = [0, 1, 0], convexity = 0) { cube(size = [4, 4, 4]); }",
    "multmatrix": "multmatrix([[1, 0.5, 0, 0], [0, 1, 0, 0], [0, 0, 1, 7], [0, 0, 0, 1]]) { cube(size = [4, 4, 4]); }",
    "intersection": "intersection() { cube(size = [4, 4, 4]); sphere(r = 4, $fn = 20); }",
    "flat, turned out of its plane": "linear_extrude(height = 2) { multmatrix([[1, 0, 0, 0], [0, 0.5, -0.866025, 0], "
    "[0, 0.866025, 0.5, 0], [0, 0, 0, 1]]) { square(size = [4, 4]); } }",
}


@pytest.mark.parametrize("name", NODES)
def test_every_node_is_an_object_with_properties(document, read, name):
    root = read(NODES[name])
    assert not [obj for obj in document.Objects if isinstance(obj.Proxy, openscad_node.OpenScadText)]
    if name in openscad_tree.SETS or "," in name or name == "multmatrix":
        assert root.isValid()
    else:
        assert name in [obj.Node for obj in document.Objects if hasattr(obj, "Node")]
    assert root.Volume.Value == pytest.approx(volume_of(NODES[name]), rel=1e-3)


def test_what_no_property_can_hold_stays_text(document, read):
    root = read("union() { cube(size = [4, 4, 4]); cube(size = [inf, 1, 1]); }")
    assert shape(root) == ["Union", ["cube"], ["text"]] and root.Volume.Value == pytest.approx(64, rel=1e-3)


def test_a_flat_design_is_a_plate(read):
    assert read("square(size = [4, 5]);").Volume.Value == pytest.approx(20, rel=1e-3)


def test_changes_arrive_at_the_root(document, read):
    root = read(TREE.replace("%", "*"))
    cube, hole = named(document, "cube"), named(document, "cylinder")
    before = root.Volume.Value
    cube.Height = 60
    document.recompute()
    section = 3 * math.sin(math.pi / 6) * 3 * 6  # of a cylinder of twelve sides
    assert root.isValid() and root.Volume.Value == pytest.approx(before + 6000 - section * 10, rel=2e-3)
    hole.Placement.Base = FreeCAD.Vector(100, 0, 0)
    document.recompute()
    assert root.Volume.Value == pytest.approx(before + section * 30 + 6000, rel=2e-3)
    root.Sources[0].Operation = "Union"
    document.recompute()
    assert root.Volume.Value == pytest.approx(before + section * 30 + 6000 + section * 40, rel=2e-3)
    hole.setExpression("Height", f"{cube.Name}.Length * 2")
    document.recompute()
    assert (hole.Height.Value == 20
            and root.Volume.Value == pytest.approx(before + section * 30 + 6000 + section * 20, rel=2e-3))
    cube.Height = 0
    document.recompute()
    assert root.isValid(), "OpenSCAD draws nothing of a cube without height"


def test_parts_have_meshes_once_they_are_shown(document, read):
    root = read(TREE)
    cube = named(document, "cube")
    assert cube.isValid() and cube.Mesh.CountFacets == 0 and "Up-to-date" in cube.State
    cube.Visibility = True
    cube.touch()
    document.recompute()
    assert cube.Volume.Value == pytest.approx(6000, rel=1e-3)
    cube.Visibility = False
    volume = root.Volume.Value
    cube.Length = 12
    document.recompute()
    assert cube.Volume.Value == pytest.approx(6000, rel=1e-3) and root.Volume.Value > volume + 100


def test_nodes_go_together_with_other_solids(document, read):
    root = read("difference() { cube(size = [20, 20, 20], center = true); sphere(r = 5, $fn = 16); }")
    ball = solids.create(frep_solid.FrepSolid, document)
    ball.Expression = "sphere(r = 12)"
    root.Sources = [*root.Sources, ball]
    document.recompute()
    assert (root.isValid() and root.Volume.Value
            == pytest.approx(8000 - 4 / 3 * math.pi * 12**3 + 6 * math.pi * (2 * 12 + 10) * 4 / 3, rel=0.01))
    shell = solids.create(modify.Modify, document)
    shell.Operation, shell.Source, shell.Wall = "Shell", named(document, "cube"), 1
    document.recompute()
    assert shell.Volume.Value == pytest.approx(20**3 - 18**3, rel=0.01), "of a node that has no mesh itself"


def test_a_hull_takes_only_what_openscad_has(document, read):
    root = read("hull() { cube(size = [4, 4, 4]); sphere(r = 4); }")
    ball = solids.create(frep_solid.FrepSolid, document)
    volume = root.Volume.Value
    root.Sources = [*root.Sources, ball]
    document.recompute()
    assert not root.isValid() and root.Volume.Value == volume
    with pytest.raises(ValueError, match="FrepSolid is no shape of OpenSCAD, and hull takes no other"):
        root.Proxy.source(root)


def test_it_is_one_undo_step(document, read):
    frep = solids.create(frep_solid.FrepSolid, document)
    steps = document.UndoCount
    root = read(TREE)
    count, volume, name = len(document.Objects), root.Volume.Value, root.Name
    assert document.UndoCount == steps + 1
    document.undo()
    assert document.Objects == [frep]
    document.redo()
    root = document.getObject(name)
    assert len(document.Objects) == count and root.Volume.Value == volume
    named(document, "cube").Height = 60
    document.recompute()
    assert root.isValid() and root.Volume.Value > volume + 3000


def test_documents_need_no_design(document, read, tmp_path):
    root = read(TREE)
    volume, name = root.Volume.Value, root.Name
    document.saveAs(str(tmp_path / "saved.FCStd"))
    FreeCAD.closeDocument(document.Name)
    (tmp_path / "design.csg").unlink()
    opened = FreeCAD.openDocument(str(tmp_path / "saved.FCStd"))
    root = opened.getObject(name)
    assert root.Volume.Value == volume and "Up-to-date" in root.State
    named(opened, "cylinder").BottomRadius = 1
    opened.recompute()
    assert root.isValid() and root.Volume.Value > volume + 100


def ball(path, radius):
    kernel.load().mesh(kernel.load().shapes.sphere(radius), voxel=0.25).save(str(path))


def test_files_of_a_design_are_found_again(document, tmp_path):
    folder = tmp_path / "one"
    folder.mkdir()
    ball(folder / "it's a ball.stl", 3)
    (folder / "design.scad").write_text('union() { cube(1); translate([9, 0, 0]) import("it\'s a ball.stl"); }')
    root = files.insert(str(folder / "design.scad"), document.Name)
    assert shape(root) == ["Union", ["cube"], ["import"]]
    volume, name = root.Volume.Value, root.Name
    assert volume == pytest.approx(1 + 36 * math.pi, rel=0.01)
    document.saveAs(str(folder / "saved.FCStd"))
    FreeCAD.closeDocument(document.Name)
    folder.rename(tmp_path / "two")
    opened = FreeCAD.openDocument(str(tmp_path / "two" / "saved.FCStd"))
    root = opened.getObject(name)
    ball(tmp_path / "two" / "it's a ball.stl", 4)
    opened.recompute()
    assert root.isValid() and root.Volume.Value == pytest.approx(1 + 4 / 3 * math.pi * 64, rel=0.01), (
        "the file has changed")
    (tmp_path / "two" / "it's a ball.stl").unlink()
    named(opened, "cube").Height = 2
    opened.recompute()
    assert not root.isValid() and root.Volume.Value > 200, "it keeps the mesh it had"
    with pytest.raises(ValueError, match="it's a ball.stl is not there"):
        root.Proxy.source(root)


def test_large_designs_are_one_object(document, read, tmp_path):
    ball(tmp_path / "ball.stl", 3)
    row = "\n".join(f"multmatrix([[1, 0, 0, {2 * i}], [0, 1, 0, 0], [0, 0, 1, 0], "
                    f"[0, 0, 0, 1]]) {{ cube(size = [1, 1, 1]); }}" for i in range(400))
    root = read(row + '\n%cube(size = [9, 9, 9]); '
                'multmatrix([[1, 0, 0, -9], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) { import(file = "ball.stl"); }')
    assert (shape(root) == ["text"] and [obj.Visibility for obj in document.Objects] == [True, True]
            and root.OutList == [])
    assert root.Volume.Value == pytest.approx(400 + 36 * math.pi, rel=0.01)
    root.Text = "cube(size = [1, 2, 3]);"
    document.recompute()
    assert root.Volume.Value == pytest.approx(6, rel=1e-3)


def test_the_trunk_of_a_large_design_is_a_tree(document, read):
    """Each branch that is too large becomes one object in its place, also within moves."""
    row = "\n".join(f"multmatrix([[1, 0, 0, {2 * i}], [0, 1, 0, 0], [0, 0, 1, 0], "
                    f"[0, 0, 0, 1]]) {{ cube(size = [1, 1, 1]); }}" for i in range(400))
    text = ("difference() { multmatrix([[1, 0, 0, 0], [0, 1, 0, 9], [0, 0, 1, 0], [0, 0, 0, 1]]) { %sphere(r = 3); "
            + row + " } cube(size = [199, 99, 2]); }")
    root = read(text)
    assert (shape(root) == ["Difference", ["text"], ["cube"]] and root.Sources[0].Placement.Base.y == 9
            and len(document.Objects) == 4)
    assert (root.Volume.Value == pytest.approx(400 - 100, rel=0.01)
            and root.Volume.Value == pytest.approx(volume_of(text), rel=1e-3))
    named(document, "cube").Length = 399
    document.recompute()
    assert root.Volume.Value == pytest.approx(400 - 200, rel=0.01)


def test_what_is_only_shown_may_be_large(document, read):
    row = "".join(f"multmatrix([[1, 0, 0, {2 * i}], [0, 1, 0, 0], [0, 0, 1, 0], "
                  f"[0, 0, 0, 1]]) {{ cube(size = [1, 1, 1]); }}" for i in range(400))
    root = read(f"cube(size = [2, 2, 2]); %difference() {{ union() {{ {row} }} cube(size = [199, 1, 1]); "
                f"{row.replace('cube(size = [1,', 'cube(size = [0.5,')} }}")
    shown = next(obj for obj in document.Objects if obj.Visibility and obj != root)
    assert (shape(shown) == ["text"] and shown.Volume.Value == pytest.approx(150, rel=0.01)
            and root.Volume.Value == pytest.approx(8, rel=1e-3))


def test_deep_designs(document, read):
    move = "multmatrix([[1, 0, 0, 1], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) { "
    root = read("group() { " * 3000 + move * 3000 + "cube(size = [1, 1, 1]);" + " }" * 6000)
    assert shape(root) == ["cube"] and root.Placement.Base.x == pytest.approx(3000)
    nested = "cube(size = [1, 1, 1]); " + "".join(f"union() {{ cube(size = [{i + 1}, 1, 1]); "
                                                  for i in range(150)) + "}" * 150
    root = read(nested, "nested.csg")
    assert (len(document.Objects) > 150 and isinstance(document.Objects[-1].Proxy, combine.Combine)
            and root.Volume.Value == pytest.approx(150, rel=1e-2))
    assert [obj.Label for obj in document.Objects if isinstance(obj.Proxy, openscad_node.OpenScadText)] == ["union"], (
        "what is deeper is text")


def test_what_cannot_be_read_adds_nothing(document, tmp_path, monkeypatch):
    documents = list(FreeCAD.listDocuments())
    for name, text, said in (("a.csg", "cube(size = [1, 1, 1]", "expected"),
                             ("b.csg", "teapot();", "'teapot' is not known"), ("c.csg", "group();", "empty"),
                             ("d.csg", 'import(file = "gone.stl");', "gone.stl is not there"),
                             ("e.scad", "cube(1", "OpenSCAD says"), ("f.scad", "assert(false);", "Assertion"),
                             ("g.csg", "cube(size = [0, 1, 1]);", "nothing"), ("h.csg", 'cube(size = "x");', "")):
        (tmp_path / name).write_text(text)
        for into in (document.Name, "another"):
            with pytest.raises(ValueError) as told:
                files.insert(str(tmp_path / name), into)
            assert name in str(told.value) and said in str(told.value) and "\n" not in str(told.value), told.value
    (tmp_path / "a b.scad").write_text("cube(1);")
    monkeypatch.setenv("PATH", "/nowhere")
    with pytest.raises(ValueError, match="not installed .Debian's package openscad."):
        files.insert(str(tmp_path / "a b.scad"), document.Name)
    assert (not document.Objects and list(FreeCAD.listDocuments()) == documents and not document.HasPendingTransaction
            and document.UndoCount == 0)


def test_what_is_wrong_names_the_object(document, read):
    root = read("union() { cube(size = [1, 1, 1]); rotate_extrude(angle = 360) { square(size = [2, 2]); } }")
    square = named(document, "square")
    square.Centred = True
    document.recompute()
    assert not root.isValid()
    with pytest.raises(kernel.load().Error, match="^rotate_extrude: "):
        root.Proxy.source(root).field()
    square.Centred = False
    document.recompute()
    assert root.isValid()


def test_combine_is_what_it_was(document):
    a, b = (solids.create(frep_solid.FrepSolid, document) for _ in range(2))
    both = solids.create(combine.Combine, document)
    both.Sources = [a, b]
    assert both.Proxy.csg(both) is None


def exported(objects, path):
    files.export(objects, str(path))
    mesh = kernel.load().Mesh.load(path)
    assert kernel.load().inspect(mesh).valid
    return mesh


def test_faces_go_out(document, read, tmp_path):
    root = read(CORNER)
    mesh = exported([root], tmp_path / "out.stl")
    assert len(mesh.triangles) == 24 and mesh.volume == 875
    root.Placement.Base = FreeCAD.Vector(100, 0, 0)
    mesh = exported([root], tmp_path / "out.3mf")
    assert len(mesh.triangles) == 24 and mesh.volume == 875 and mesh.vertices[:, 0].min() == 100
    root.Placement.Rotation = FreeCAD.Rotation(FreeCAD.Vector(1, 2, 3), 40)
    mesh = exported([root], tmp_path / "out.ply")
    assert len(mesh.triangles) == 24 and mesh.volume == pytest.approx(875, rel=1e-6)
    files.export([root], str(tmp_path / "out.asdf"))
    field = kernel.load().load(tmp_path / "out.asdf")
    assert np.abs(field.values(mesh.vertices)).max() < 0.2, "as a Field it is at the same place"


def test_several_designs_go_out_united(document, read, tmp_path):
    root = read(CORNER)
    block = read("cube(size = [10, 10, 4]);", "block.csg")
    block.Placement.Base = FreeCAD.Vector(10, 0, 0)  # one of its sides touches
    mesh = exported([root, block], tmp_path / "out.stl")
    assert len(mesh.triangles) < 50 and mesh.volume == 875 + 400 and kernel.load().inspect(mesh).components == 1
    plate = read("square(size = [4, 5]);", "plate.csg")
    plate.Placement.Base = FreeCAD.Vector(0, 0, 20)
    mesh = exported([root, plate], tmp_path / "out.stl")
    assert mesh.volume == 875 + 20 and mesh.vertices[:, 2].max() == 21, "a flat one as the plate that is seen"
    ball = solids.create(frep_solid.FrepSolid, document)
    ball.Expression, ball.VoxelSize = "sphere(r = 3)", 0.5
    document.recompute()
    mesh = exported([root, ball], tmp_path / "out.stl")
    assert mesh.volume == pytest.approx(875 + 7 / 8 * 36 * math.pi, rel=0.01) and len(mesh.triangles) > 1000


def test_the_root_goes_out_as_a_mesh(document, read, tmp_path):
    root = read("union() { cube(size = [4, 4, 4]); sphere(r = 4, $fn = 20); }")
    root.Placement.Base = FreeCAD.Vector(100, 0, 0)
    files.export([root], str(tmp_path / "out.stl"))
    mesh = kernel.load().Mesh.load(tmp_path / "out.stl")
    assert (mesh.volume == pytest.approx(root.Volume.Value, rel=1e-3)
            and mesh.vertices[:, 0].min() == pytest.approx(96, abs=0.1))
