"""Every library function with a solid argument, applied to a formula, a scan, a mesh and a design: meshes are valid by
CGAL.

Every function is tested with two of the four leaves, in rotation. FIELDFAB_FINE=1 tests all of them, with four times as
many cells along each axis, and searches for thinner features."""

import os

import numpy as np
import pytest
from volume_test import nrrd

import fieldfab as ff

FINER = 4 if os.environ.get("FIELDFAB_FINE") else 1
SHAPES = {"shape", "a", "b", "formula"}
TAKING_SOLIDS = {f["name"]
                 for f in ff.library() if f["group"] != "numbers" and SHAPES & {p["name"] for p in f["parameters"]}}

# S is a leaf, about 4 mm long; unbounded results are cut off.
CALLS = {
    "extrude": "extrude(S, 2, -1)", "revolve": "revolve(move(S, 4))", "loft": "loft(S, circle(1.5), 2)",
    "union": "union(S, sphere(1.6))", "intersection": "intersection(S, sphere(1.6))",
    "difference": "difference(S, cylinder(0.6, 9))",
    "solid": "solid(value(S) - 0.1)", "offset": "offset(S, 0.2)", "shell": "shell(S, 0.5)",
    "clearance": "clearance(box(6, 6, 2), S, 0.2)",
    "blend": "blend(S, move(sphere(1), 2), 0.5)", "smooth_union": "smooth_union(S, move(box(2, 2, 1), 2), 0.4)",
    "smooth_intersection": "smooth_intersection(S, sphere(1.7), 0.4)",
    "smooth_difference": "smooth_difference(S, cylinder(0.6, 9), 0.3)",
    "chamfer_union": "chamfer_union(S, move(box(2, 2, 1), 2), 0.4)",
    "chamfer_intersection": "chamfer_intersection(S, sphere(1.7), 0.4)",
    "chamfer_difference": "chamfer_difference(S, cylinder(0.6, 9), 0.3)", "morph": "morph(S, sphere(1.8), 0.4)",
    "move": "move(S, 1, 2, 3)", "rotate_x": "rotate_x(S, 30)", "rotate_y": "rotate_y(S, 30)",
    "rotate_z": "rotate_z(S, 30)", "scale": "scale(S, 1.7)",
    "scale_xyz": "scale_xyz(S, 1 + 0.2 * cos(z), 1, 0.8)", "mirror_x": "mirror_x(S)", "mirror_y": "mirror_y(S)",
    "mirror_z": "mirror_z(S)",
    "symmetric_x": "symmetric_x(move(S, 0.7))", "symmetric_y": "symmetric_y(move(S, 0, 0.7))",
    "symmetric_z": "symmetric_z(move(S, 0, 0, 0.7))",
    "shear_x_y": "shear_x_y(S, 0.5)", "shear_x_z": "shear_x_z(S, 0.5)", "twist": "twist(S, 15)",
    "taper": "taper(S, 5, 0.5)", "bend": "bend(S, 5)",
    "attract": "attract(S, 0, 0, 3, 1)", "repel": "repel(S, 0, 0, 3, 1)",
    "repeat_x": "repeat_x(S, 5) & box(12, 5, 5)", "repeat_y": "repeat_y(S, 5) & box(5, 12, 5)",
    "repeat_z": "repeat_z(S, 5) & box(5, 5, 12)",
    "array_x": "array_x(S, 3, 2.9)", "array_xy": "array_xy(S, 2, 2, 3.3, 3.3)",
    "array_polar": "array_polar(move(S, 3), 5)",
    "map": "map(S, x + 0.2 * sin(y), y, z)",
}
# A taper moves points at its tip to infinity, where only intervals of formulas prove emptiness. Hence the given bounds.
UNBOUNDED = {"taper": (-2.5, -2.5, -2.5, 2.5, 2.5, 2.5)}
FORMULA = "move(rounded_box(3.6, 3, 2.4, 0.4) - cylinder(0.4, 9), 0.2, 0.1, 0)"


@pytest.fixture(scope="module")
def leaves(tmp_path_factory):
    """Returns {kind: text of a leaf} and the folder of their files."""
    folder = tmp_path_factory.mktemp("leaves")
    (folder / "part.csg").write_text("difference() { cube(size = [3.6, 3, 2.4], center = true); cylinder($fn = 12, "
                                     "$fa = 12, $fs = 2, h = 9, r1 = 0.5, r2 = 0.3, center = true); }")
    ff.mesh(ff.parse('rotate_x(open("part.csg"), 20)', folder=folder)).save(folder / "part.stl")  # 120 triangles
    z, y, x = (np.meshgrid(*[np.arange(20) * 0.25 - 2.375] * 3, indexing="ij"))
    densities = np.clip(128 + 90 * (1 - np.sqrt((x / 1.9) ** 2 + (y / 1.5) ** 2 + (z / 1.3) ** 2)) * 1.5, 0,
                        255).astype(np.uint8)
    axes = "(0.25,0,0) (0,0.25,0) (0,0,0.25)"
    (folder / "scan.nrrd").write_bytes(nrrd(body=densities.tobytes(), sizes="20 20 20",
                                            **{"space directions": axes, "space origin": "(-2.375,-2.375,-2.375)"}))
    return folder, {"formula": FORMULA, "scan": 'open("scan.nrrd", threshold = 128)', "mesh": 'open("part.stl")',
                    "design": 'open("part.csg")'}


def test_every_function_has_a_call():
    assert set(CALLS) == TAKING_SOLIDS


@pytest.mark.parametrize("kind", ["formula", "scan", "mesh", "design"])
def test_functions_of_a_leaf_make_valid_meshes(leaves, kind):
    folder, texts = leaves
    wrong = []
    for number, (name, call) in enumerate(CALLS.items()):
        if FINER == 1 and (number + list(texts).index(kind)) % 2:
            continue
        solid = ff.parse(call.replace("S", texts[kind]), folder=folder)
        bounds = solid.bounds()
        if name in UNBOUNDED and kind != "formula":
            with pytest.raises(ff.Error, match="unbounded along x, y"):
                ff.mesh(solid)
            bounds = UNBOUNDED[name]
        mesh = ff.mesh(solid, voxel=max(b - a for a, b in zip(bounds[:3], bounds[3:])) / (12 * FINER), bounds=bounds,
                       depth=6 if FINER > 1 else 1)
        found = ff.inspect(mesh)
        if not found.valid or mesh.volume < 0.5:
            wrong.append((name, mesh.volume, found.manifold, found.closed, found.outward, found.self_intersections,
                          found.degenerate))
    assert not wrong
