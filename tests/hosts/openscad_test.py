"""OpenSCAD's designs: every verb reads them, and solids equal OpenSCAD's. Also fieldfab.scad in OpenSCAD. Full table:
openscad_designs.py."""

import json
import signal
import subprocess
import time

import openscad_designs
import pytest
from conftest import COMMAND, DATA
from family import sample_or_all
from programs import need

import fieldfab as ff

QUICK = ("CSG LetterBlock example002 example003 example004 example007 example008 example009 example011 example012 "
         "example013 example014 example015 example016 offset sign echo list_comprehensions hull3-tests "
         "minkowski3-difference-test".split())


def run(*arguments, cwd=None, **more):
    return subprocess.run([str(a) for a in (COMMAND, *arguments)], capture_output=True, text=True, timeout=300, cwd=cwd,
                          **more)


def example(name):
    found = [path for path in openscad_designs.designs() if path.stem == name]
    if not found:
        pytest.skip("../shared is not here")
    return found[0]


@pytest.mark.parametrize("name", QUICK)
def test_examples_are_the_same_solids(name, tmp_path):
    row = openscad_designs.compare(example(name), tmp_path, refine=1)
    assert row["right"] and (row.get("exact", True) or name == "minkowski3-difference-test"), row


@pytest.mark.parametrize("name", "CSG LetterBlock example002 example008 example013".split() + sample_or_all(
    [], "example004 example007 example009 example012 hull3-tests".split()))
def test_contours_of_examples_are_the_same_solids(name, tmp_path):
    row = openscad_designs.compare(example(name), tmp_path, refine=1, contour=True)
    assert row["right"] and not row["exact"], row


@pytest.mark.parametrize("name", "CSG example001 example008 example013".split())
def test_python_has_the_commands_faces(name, tmp_path):
    done = run("--json", "mesh", example(name), "-o", tmp_path / "faces.ply")
    assert done.returncode == 0, done.stderr
    told, field = json.loads(done.stdout), ff.load(example(name))
    for mine in (ff.mesh(field), field.faces()):
        assert (told["exact"] and mine.volume == pytest.approx(told["volume"], rel=1e-7)
                and mine.area == pytest.approx(told["area"], rel=1e-7))
        # Diagonals and vertices of corefinement within a plane differ from run to run.
        assert len(mine.triangles) == pytest.approx(told["triangles"], rel=0.1) and ff.inspect(mine).valid


def random_design(seed, folder):
    design = folder / "random.scad"
    design.write_text(openscad_designs.random_design(seed))
    return design


@pytest.mark.parametrize("seed", range(sample_or_all(10, 40)))
def test_random_trees_are_the_same_solids(seed, tmp_path):
    design = random_design(seed, tmp_path)
    row = openscad_designs.compare(design, tmp_path, refine=2)
    assert row["right"], (row, design.read_text())


@pytest.mark.parametrize("name", sorted(path.stem for path in (DATA / "openscad").glob("*.scad")))
def test_parts_that_touch_and_are_turned_are_the_same_solids(name, tmp_path):
    row = openscad_designs.compare(DATA / "openscad" / f"{name}.scad", tmp_path)
    assert row["right"] and row["exact"] and abs(row["error"]) < 1e-4, row


@pytest.mark.parametrize("seed", range(sample_or_all(5, 16)))
def test_extrusions_have_the_same_facets(seed, tmp_path):
    design = tmp_path / "extrusion.scad"
    design.write_text(openscad_designs.random_extrusion(seed))
    row = openscad_designs.compare(design, tmp_path)
    assert row["exact"] and abs(row["error"]) < 1e-5, (row, design.read_text())


# Seed 5 has slivers thinner than a cell, where the contour is wrong (docs/limits.md); 9 and 11 take minutes.
@pytest.mark.parametrize("seed", [seed for seed in range(sample_or_all(4, 12)) if seed not in (5, 9, 11)])
def test_contours_of_random_trees_are_the_same_solids(seed, tmp_path):
    design = random_design(seed, tmp_path)
    row = openscad_designs.compare(design, tmp_path, refine=2, contour=True)
    assert row["right"], (row, design.read_text())


def test_what_is_wrong_is_said_in_one_line(tmp_path):
    need("openscad")
    for text, said in {
        "cube(1": "OpenSCAD says: ERROR: Parser error",
        "teapot();": "the design is empty",
        "intersection() { cube(4); translate([4, 0, 0]) cube(4); }": "the design is empty",
        "difference() { cube(4); cube(4); }": "the solid is empty",
        # Intervals cannot exclude a surface anywhere on the sphere.
        "difference() { sphere(3, $fn=10); sphere(3, $fn=10); }": "no surface was found",
        'import("gone.stl");': "no such file",
        "assert(false);": "Assertion",
    }.items():
        design = tmp_path / "a design's \"name\" $(touch x).scad"
        design.write_text(text)
        done = run("mesh", design, "-o", tmp_path / "out.stl", "--voxel", 3)  # coarse, which is quick
        assert done.returncode == 2 and said in done.stderr and done.stderr.count("\n") == 1, done
    assert not (tmp_path / "x").exists() and not (tmp_path / "out.stl").exists()


def test_without_openscad(tmp_path):
    (tmp_path / "a.scad").write_text("cube(1);")
    (tmp_path / "a.csg").write_text("cube(size = [1, 2, 3], center = false);")
    done = run("mesh", tmp_path / "a.scad", "-o", tmp_path / "a.stl", env={"PATH": "/nowhere"})
    assert done.returncode == 2 and "is not installed" in done.stderr
    assert run("mesh", tmp_path / "a.csg", "-o", tmp_path / "a.stl", env={"PATH": "/nowhere"}).returncode == 0


def test_designs_become_formulas(tmp_path):
    need("openscad")
    (tmp_path / "a.scad").write_text(
        "difference() { cube(10, center = true); cylinder(h = 20, r = 3, center = true, $fn = 12); }")
    assert run("convert", tmp_path / "a.scad", "-o", tmp_path / "a.frep").returncode == 0
    summaries = [run("--json", "mesh", tmp_path / f, "-o", tmp_path / "a.stl", "--voxel", 0.2).stdout
                 for f in ("a.scad", "a.frep")]
    volumes = [json.loads(each)["volume"] for each in summaries]
    assert volumes[0] == pytest.approx(volumes[1], rel=1e-4)
    (tmp_path / "b.scad").write_text("rotate_extrude() translate([5, 0]) circle(2);")
    done = run("convert", tmp_path / "b.scad", "-o", tmp_path / "b.frep")
    assert done.returncode == 2 and "formula" in done.stderr


DESIGN = """use <fieldfab.scad>
difference() {
  union() {
    frep("sphere(5) - 0.3 * sin(2 * x)", voxel = 0.7);
    translate([12, 0, 0]) smooth_union(r = 2, voxel = 0.7) { cube(6); sphere(4, $fn = 20); }
  }
  cylinder(h = 30, r = 1, center = true);
}
"""


def test_fieldfab_within_openscad(tmp_path):
    need("openscad")
    design = tmp_path / "it's a \"part\".scad"
    design.write_text(DESIGN)
    done = run("openscad", design, "-o", tmp_path / "part.stl")
    assert done.returncode == 0 and "2 meshes made" in done.stdout, done
    plain = subprocess.run(["openscad", "-o", str(tmp_path / "plain.off"), str(design)], capture_output=True, text=True,
                           timeout=300)
    assert (plain.returncode == 0 and "Simple:        yes" in plain.stderr and "ERROR" not in plain.stderr
            and "WARNING" not in plain.stderr), plain.stderr
    made = json.loads(run("--json", "info", tmp_path / "part.stl").stdout)["volume"]
    design.write_text(DESIGN.replace("smooth_union(r = 2, voxel = 0.7)", "union()"))
    assert run("openscad", design, "-o", tmp_path / "sharp.stl").returncode == 0
    assert made > json.loads(run("--json", "info", tmp_path / "sharp.stl").stdout)["volume"] + 5  # the fillet
    design.write_text(DESIGN)
    assert "0 meshes made, 2 kept" in run("openscad", design).stdout
    design.write_text(DESIGN.replace("sphere(4, $fn = 20)", "sphere(3)"))
    assert "1 mesh made, 1 kept" in run("openscad", design).stdout


def test_watching(tmp_path):
    need("openscad")
    design = tmp_path / "part.scad"
    design.write_text(DESIGN)
    watching = subprocess.Popen([str(COMMAND), "openscad", "--watch", "part.scad"], cwd=tmp_path,
                                stderr=subprocess.PIPE, text=True)
    try:
        assert "watching" in watching.stderr.readline()
        time.sleep(1.1)  # file times may be whole seconds
        design.write_text(DESIGN.replace("sphere(5)", "sphere(6)"))
        assert "1 made, 1 kept" in watching.stderr.readline()
    finally:
        watching.send_signal(signal.SIGINT)
        assert watching.wait(30) == 130
