"""Fieldfab's filters and files in the real meshlabserver, against closed forms and CGAL."""

import math
import os
import pathlib

import numpy as np
import pytest
from conftest import BUILD
from family import sample_or_all
from meshlab_host import (BOOLEAN, DEVIATION, FREP, LATTICE, OFFSET, PARAMETERS, REFUSED, REMESH, REMOVES_NAN, REPORT,
                          SERVER, SHELL, VOLUME, cube, figure_eight, joined, serve, sphere, verdict, with_holes,
                          write_ply)

import fieldfab


def test_the_plugin_was_built():
    assert SERVER.exists(), "MeshLab's plugin was not built: ./dev setup fetches its headers"
    assert {"libfieldfab_filters.so", "libfieldfab_files.so"} <= set(os.listdir(BUILD / "meshlab" / "plugins"))


def ball_volume(radius):
    return 4 / 3 * math.pi * radius**3


def result_of(tmp_path, mesh, *steps, more=(), close=True):
    """Returns the last layer after the steps; asserts that CGAL finds it valid."""
    inputs = ([write_ply(tmp_path / f"in{n}.ply", *each) for n, each in enumerate([mesh, *more])]
              if mesh is not None else [])
    said = serve(tmp_path, inputs, steps, tmp_path / "out.ply")
    assert (tmp_path / "out.ply").exists(), said.text
    found, result = verdict(tmp_path / "out.ply")
    if close:
        assert found.valid, (found.manifold, found.closed, found.outward, found.self_intersections, found.degenerate)
    return result, found, said


def test_every_filter_runs_from_a_script(tmp_path):
    filters = [(name, {"Strut": 4} if name == LATTICE else {})
               for name in PARAMETERS if name.startswith("Fieldfab") and name != VOLUME]
    inputs = [write_ply(tmp_path / "a.ply", *sphere(24)), write_ply(tmp_path / "b.ply", *sphere(24, at=(25, 0, 0)))]
    for name in filters:
        said = serve(tmp_path, inputs, [name], tmp_path / "out.ply")
        assert said.code == 0 and (tmp_path / "out.ply").exists(), said.text
        assert "LOG: 1" not in said, said.text  # a warning
        (tmp_path / "out.ply").unlink()


@pytest.mark.parametrize("kind", ["closed", "holes", "inverted", "overlapping", "split"])
def test_remesh_makes_a_valid_solid_of_any_soup(tmp_path, kind):
    vertices, triangles = ball = sphere(48)
    soup, expected = {
        "closed": (ball, ball_volume(20)),
        "holes": (with_holes(ball), ball_volume(20)),
        "inverted": ((vertices, triangles[:, ::-1]), ball_volume(20)),
        # Two balls, 20 apart, the second inverted: their intersection has winding number 1 - 1 = 0.
        "overlapping": (joined(ball, sphere(48, at=(20, 0, 0))),
                        2 * ball_volume(20) - math.pi / 12 * (4 * 20 + 20) * (2 * 20 - 20) ** 2),
        # No shared vertices.
        "split": ((vertices[triangles].reshape(-1, 3), np.arange(3 * len(triangles)).reshape(-1, 3)), ball_volume(20)),
    }[kind]
    result, _, said = result_of(tmp_path, soup, (REMESH, {"Voxel": 0.5}))
    assert result.volume == pytest.approx(expected, rel=0.015), said.text
    assert ("closed by lids" in said) == (kind == "holes")


def test_remesh_of_a_figure_eight(tmp_path):
    before, _ = verdict(write_ply(tmp_path / "eight.ply", *figure_eight()))
    assert before.self_intersections > 0
    result_of(tmp_path, figure_eight(), (REMESH, {"Voxel": 0.6}))


def test_remesh_keeps_the_edges_of_a_cube_exactly(tmp_path):
    result, _, _ = result_of(tmp_path, cube(20), (REMESH, {"Voxel": 0.7}))
    assert result.volume == pytest.approx(8000, rel=1e-5) and result.area == pytest.approx(2400, rel=1e-5)


def test_remesh_closes_gaps_up_to_their_width(tmp_path):
    two = joined(cube(20), cube(20, at=(20.8, 0, 0)))
    voxel = sample_or_all(0.8, 0.3)
    _, apart, _ = result_of(tmp_path, two, (REMESH, {"Voxel": voxel, "GapWidth": 0.4}))
    assert apart.components == 2
    result, together, _ = result_of(tmp_path, two, (REMESH, {"Voxel": voxel, "GapWidth": 1.5}))
    assert together.components == 1
    assert result.volume == pytest.approx(40.8 * 400, rel=0.01)


@pytest.mark.parametrize("distance", [2.0, -3.0])
@pytest.mark.parametrize("edges", [0, 2])
def test_offset_of_a_ball(tmp_path, distance, edges):
    result, _, _ = result_of(tmp_path, sphere(64), (OFFSET, {"Distance": distance, "Voxel": 0.6, "Edges": edges}))
    assert result.volume == pytest.approx(ball_volume(20 + distance), rel=0.01)


def test_offset_of_a_cube_is_rounded(tmp_path):
    result, _, _ = result_of(tmp_path, cube(20), (OFFSET, {"Distance": 2, "Voxel": 0.5}))
    assert result.volume == pytest.approx(20**3 + 6 * 400 * 2 + 12 * 20 * math.pi * 4 / 4 + ball_volume(2), rel=2e-3)


def test_a_cube_out_by_1_and_in_by_1_is_a_cube_within_a_voxel(tmp_path):
    voxel = 0.5
    result, _, _ = result_of(tmp_path, cube(20), (OFFSET, {"Distance": 1, "Voxel": voxel}),
                             (OFFSET, {"Distance": -1, "Voxel": voxel}))
    box = fieldfab.Mesh(np.float32(cube(20)[0]), np.uint32(cube(20)[1])).solid()
    away = np.abs(box.surface_distances(result.vertices))
    corners = [np.linalg.norm(result.vertices - corner, axis=1).min() for corner in cube(20)[0]]
    assert away.max() < voxel and max(corners) < voxel, (away.max(), corners)
    assert result.volume == pytest.approx(8000, rel=0.01)


def test_shell_of_a_ball(tmp_path):
    result, found, _ = result_of(tmp_path, sphere(64), (SHELL, {"Wall": 3, "Voxel": 0.6}))
    assert found.components == 2
    assert result.volume == pytest.approx(ball_volume(20) - ball_volume(17), rel=0.01)


def euler(mesh):
    triangles = np.asarray(mesh.triangles)
    edges = {tuple(sorted(e)) for t in triangles for e in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0]))}
    return len(mesh.vertices) - len(edges) + len(triangles)


def test_drain_holes_make_one_surface_with_handles(tmp_path):
    """One hole: a sphere (Euler characteristic 2). Two: a torus (0). Three: a double torus (-2)."""
    closed, _, _ = result_of(tmp_path, sphere(48), (SHELL, {"Wall": 2, "Voxel": 0.7}))
    for count in (1, 2, 3):
        result, found, said = result_of(tmp_path, sphere(48),
                                        (SHELL, {"Wall": 2, "DrainHoles": count, "HoleDiameter": 4, "Voxel": 0.7}))
        assert found.components == 1 and euler(result) == 4 - 2 * count, said.text
        # Volume of a rod between two concentric spheres.
        rod = 2 * math.pi / 3 * ((20**3 - (20**2 - 2**2) ** 1.5) - (18**3 - (18**2 - 2**2) ** 1.5))
        if count < 3:  # the third meets the wall obliquely
            assert closed.volume - result.volume == pytest.approx(count * rod, rel=0.2)


def test_an_open_sheet_gets_a_thickness(tmp_path):
    vertices, triangles = cube(20)
    sheet = (vertices, triangles[:2])
    result, _, _ = result_of(tmp_path, sheet, (SHELL, {"Wall": 2, "Side": 2, "Voxel": 0.5}))
    assert result.volume == pytest.approx(400 * 2 + 4 * 20 * math.pi / 2 + ball_volume(1), rel=0.01)


def lens(radius, apart):
    return math.pi / 12 * (4 * radius + apart) * (2 * radius - apart) ** 2


@pytest.mark.parametrize("operation", [0, 1, 2])
def test_boolean_of_two_balls(tmp_path, operation):
    expected = [2 * ball_volume(20) - lens(20, 25), lens(20, 25), ball_volume(20) - lens(20, 25)][operation]
    result, _, _ = result_of(tmp_path, sphere(64), (BOOLEAN, {"Operation": operation, "Voxel": 0.6}),
                             more=[sphere(64, at=(25, 0, 0))])
    assert result.volume == pytest.approx(expected, rel=0.015)


@pytest.mark.parametrize("operation, expected", [(0, 2 * 8000 - 4000), (1, 4000), (2, 4000)])
def test_boolean_of_cubes_that_share_planes(tmp_path, operation, expected):
    result, _, _ = result_of(tmp_path, cube(20), (BOOLEAN, {"Operation": operation, "Voxel": 0.6}),
                             more=[cube(20, at=(10, 0, 0))])
    assert result.volume == pytest.approx(expected, rel=1e-3)


def test_a_smooth_union_is_larger_and_a_smooth_intersection_smaller(tmp_path):
    volumes = {}
    for radius in (0, 4):
        for operation in (0, 1, 2):
            result, found, _ = result_of(tmp_path, sphere(48), (
                BOOLEAN, {"Operation": operation, "Radius": radius, "Voxel": 0.8}), more=[sphere(48, at=(25, 0, 0))])
            volumes[operation, radius] = result.volume
            assert found.components == 1
    assert volumes[0, 4] > 1.002 * volumes[0, 0]
    assert volumes[1, 4] < 0.998 * volumes[1, 0]
    assert volumes[2, 4] < 0.998 * volumes[2, 0]


@pytest.mark.parametrize("lattice", [0, 1, 2, 5, 8])  # in FreeCAD all kinds are tested
def test_lattice_infill(tmp_path, lattice):
    """The infill's volume lies between that of the wall and of the cube; without a wall it is the lattice's share of
    the cube."""
    result, _, _ = result_of(tmp_path, cube(20),
                             (LATTICE, {"Lattice": lattice, "Period": 8, "Strut": 1, "Wall": 1.5, "Voxel": 0.5}))
    assert 20**3 - 17**3 < result.volume < 20**3 - 0.5 * 17**3
    bare, _, _ = result_of(tmp_path, cube(20),
                           (LATTICE, {"Lattice": lattice, "Period": 8, "Strut": 1, "Wall": 0, "Voxel": 0.5}))
    assert bare.volume == pytest.approx((result.volume - (20**3 - 17**3)) * (20 / 17) ** 3, rel=0.15)


def test_a_solid_from_a_formula(tmp_path):
    result, _, _ = result_of(tmp_path, None,
                             (FREP, {"Formula": "difference(sphere(10), cylinder(4, 40))", "Voxel": 0.3}))
    # A ball with a bore has the volume of a ball whose diameter is the bore's length (napkin ring).
    assert result.volume == pytest.approx(math.pi / 6 * (2 * math.sqrt(100 - 16)) ** 3, rel=0.003)
    result, _, _ = result_of(tmp_path, None,
                             (FREP, {"Formula": "abs(x) - 3", "Bounds": "-5,-5,-5,5,5,5", "Voxel": 0.5}))
    assert result.volume == pytest.approx(600, rel=1e-4)


PARTS = """part(move(sphere(4), dx = -6), "left", "tomato")
part(move(box(6, 6, 6), dx = 6), "right", "#204060")
part(sphere(1), "plain")
part(intersection(sphere(1), move(sphere(1), dx = 9)), "none")
"""
PART_COLOURS = {"left": (255, 99, 71), "right": (32, 64, 96)}


def test_parts_become_layers_with_names_and_colours(tmp_path):
    (tmp_path / "parts.frep").write_text(PARTS)
    files = [tmp_path / f"{name}.ply" for name in ("left", "right", "plain")]
    said = serve(tmp_path, [], [(FREP, {"Formula": tmp_path / "parts.frep", "Voxel": 0.25})], files, mask=("-m", "vc"))
    volumes = {"left": ball_volume(4), "right": 216, "plain": ball_volume(1)}
    for path in files:
        found, mesh = verdict(path)
        assert found.valid and mesh.volume == pytest.approx(volumes[path.stem], rel=0.01), said.text
        if path.stem in PART_COLOURS:
            assert {(int(row["red"]), int(row["green"]), int(row["blue"]))
                    for row in read_quality(path)} == {PART_COLOURS[path.stem]}
        assert f"LOG: 2 {path.stem}: " in said
    assert "LOG: 2 none: is empty" in said


def test_a_file_of_parts_is_one_layer_in_their_colours(tmp_path):
    (tmp_path / "parts.frep").write_text(PARTS)
    said = serve(tmp_path, [tmp_path / "parts.frep"], [], tmp_path / "out.ply", mask=("-m", "vc"))
    found, mesh = verdict(tmp_path / "out.ply")
    assert (found.valid and found.components == 3
            and mesh.volume == pytest.approx(ball_volume(4) + 216 + ball_volume(1), rel=0.01)), said.text
    rows = read_quality(tmp_path / "out.ply")
    for name, side in (("left", rows["x"] < -1.5), ("right", rows["x"] > 1.5)):
        assert {(int(row["red"]), int(row["green"]), int(row["blue"])) for row in rows[side]} == {PART_COLOURS[name]}


def test_the_log_tells_how_certain_a_mesh_is(tmp_path):
    box = result_of(tmp_path, None, (FREP, {"Formula": "box(10, 10, 10)", "Voxel": 0.5}))[2]
    assert "the mesh is certain" in box, box.text
    # No cell size separates touching balls.
    touching = "union(move(sphere(2), dx = -2), move(sphere(2), dx = 2))"
    balls = serve(tmp_path, [], [(FREP, {"Formula": touching, "Voxel": 0.25})], tmp_path / "balls.ply")
    assert "the mesh is not certain at 1 place, the largest " in balls and "the mesh is certain" not in balls, (
        balls.text)
    cut = result_of(tmp_path, sphere(48), (OFFSET, {"Distance": 1, "Voxel": 1}))[2]
    assert cut.text.count("LOG: 2 the mesh is ") == 1, cut.text


def ball_volume_file(folder):
    """Writes a blurred scan of a ball of radius 12 mm in the centre of a cube of 32 mm, as .nrrd."""
    size, spacing = 64, 0.5
    at = (np.arange(size) + 0.5) * spacing - 16
    distance = 12 - np.sqrt(at[:, None, None] ** 2 + at[None, :, None] ** 2 + at[None, None, :] ** 2)
    densities = (1000 / (1 + np.exp(-distance / 0.8))).astype("<f4")
    path = pathlib.Path(folder) / "ball.nrrd"
    path.write_bytes(
        (f"NRRD0004\ntype: float\ndimension: 3\nsizes: {size} {size} {size}\nspacings: {spacing} {spacing} {spacing}\n"
         "endian: little\nencoding: raw\n\n").encode() + densities.tobytes())
    return path


def test_a_volume_by_its_threshold(tmp_path):
    path = ball_volume_file(tmp_path)
    result, _, said = result_of(tmp_path, None, (VOLUME, {"File": path}))
    assert "threshold" in said
    assert result.volume == pytest.approx(ball_volume(12), rel=0.01)
    # The density at 0.6 mm inside the ball.
    inner, _, _ = result_of(tmp_path, None, (VOLUME, {"File": path, "Threshold": 1000 / (1 + math.exp(-0.75))}))
    assert inner.volume == pytest.approx(ball_volume(12 - 0.6), rel=0.01)


def read_quality(path):
    head, body = pathlib.Path(path).read_bytes().split(b"end_header\n", 1)
    lines = head.decode().splitlines()
    count = int(next(line for line in lines if line.startswith("element vertex")).split()[-1])
    properties = [line.split()[1:]
                  for line in lines[: next(i for i, line in enumerate(lines) if line.startswith("element face"))]
                  if line.startswith("property")]
    kinds = {"float": "<f4", "uchar": "u1", "double": "<f8", "int": "<i4"}
    return np.frombuffer(body, [(name, kinds[kind]) for kind, name in properties], count)


def test_deviation_from_a_formula_and_from_a_layer(tmp_path):
    a, b = (write_ply(tmp_path / "a.ply", *sphere(48, 20)),
            write_ply(tmp_path / "b.ply", *sphere(96, 19.5, at=(0.5, 0, 0))))
    expected = np.linalg.norm(sphere(48, 20)[0] - np.array([0.5, 0, 0]), axis=1) - 19.5
    for given, bound in (({"Reference": 0, "Layer": 1}, 0.02),
                         ({"Reference": 1, "Formula": "move(sphere(19.5), 0.5, 0, 0)"}, 1e-3)):
        said = serve(tmp_path, [b, a] if "Layer" in given else [a],
                     [(DEVIATION, {**given, **({"Layer": 0} if "Layer" in given else {})})], tmp_path / "out.ply",
                     mask=("-m", "vq", "vc"))
        rows = read_quality(tmp_path / "out.ply")
        assert np.abs(rows["quality"] - expected).max() < bound, said.text
        assert np.abs(np.stack([rows["x"], rows["y"], rows["z"]], -1) - sphere(48, 20)[0]).max() < 1e-5  # unmoved
        outside = rows[rows["quality"].argmax()]
        assert int(outside["red"]) > int(outside["blue"]) + 50
        assert "root mean square" in said and "####" in said
        assert f"most {expected.max():.2g}" in said or "most 1" in said


def test_the_report_tells_the_truth(tmp_path):
    cases = {"ball": (sphere(24), "It is a valid solid"), "open": (with_holes(sphere(24)), "BAD  closed: no"),
             "eight": (figure_eight(around=80, across=16), "BAD  self-intersections"),
             "inside out": ((sphere(24)[0], sphere(24)[1][:, ::-1]), "BAD  faces outwards")}
    for mesh, words in cases.values():
        said = serve(tmp_path, [write_ply(tmp_path / "in.ply", *mesh)], [REPORT])
        assert words in said and ("It is a valid solid" in said) == (words == "It is a valid solid"), said.text


# Files


def test_files_become_layers(tmp_path):
    (tmp_path / "ball.frep").write_text("sphere(10)")
    (tmp_path / "ball.math").write_text("-r++qXqYqZf10")
    (tmp_path / "ball.csg").write_text("sphere($fn = 100, $fa = 12, $fs = 2, r = 10);")
    fieldfab.build(fieldfab.shapes.sphere(10), voxel=0.5).save(tmp_path / "ball.asdf")
    fieldfab.write_vdb(fieldfab.shapes.sphere(10), tmp_path / "ball.vdb", voxel=0.5)
    for name in ("ball.frep", "ball.math", "ball.csg", "ball.asdf", "ball.vdb"):
        said = serve(tmp_path, [tmp_path / name], [], tmp_path / "out.ply")
        found, mesh = verdict(tmp_path / "out.ply")
        assert found.valid and mesh.volume == pytest.approx(ball_volume(10), rel=0.01), said.text
        (tmp_path / "out.ply").unlink()
    said = serve(tmp_path, [ball_volume_file(tmp_path)], [], tmp_path / "out.ply")
    assert verdict(tmp_path / "out.ply")[1].volume == pytest.approx(ball_volume(12), rel=0.01), said.text


def test_a_layer_becomes_an_asdf(tmp_path):
    said = serve(tmp_path, [write_ply(tmp_path / "in.ply", *with_holes(sphere(48)))], [], tmp_path / "out.asdf")
    assert (tmp_path / "out.asdf").exists(), said.text
    assert fieldfab.mesh(fieldfab.load(tmp_path / "out.asdf")).volume == pytest.approx(ball_volume(20), rel=0.015)


# Invalid input: one clear line, and an unchanged layer


def refused(tmp_path, mesh, step, words, name="in.ply"):
    path = write_ply(tmp_path / name, *mesh) if mesh is not None else None
    before = path.read_bytes() if path else None
    said = serve(tmp_path, [path] if path else [], [step])
    assert words in said, said.text
    assert said.code >= 0 and "Aborted" not in said and "terminate" not in said, said.text
    assert path is None or path.read_bytes() == before


def test_bad_meshes_are_refused_in_one_line(tmp_path):
    for step in ((REMESH, {}), (OFFSET, {}), (SHELL, {}), (LATTICE, {}), (REPORT, {})):
        refused(tmp_path, ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], []), step, "has no triangles")
        refused(tmp_path, ([[0, 0, 0], [0, 0, 0], [0, 0, 0]], [[0, 1, 2]]), step, "none of its 1 triangles has an area")
        refused(tmp_path, ([[math.nan, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]), step,
                "has no triangles" if REMOVES_NAN else "none of its 1 triangles has an area and finite places")
    refused(tmp_path, None, (REMESH, {}), "open a mesh first")


def test_bad_triangles_are_left_out_and_counted(tmp_path):
    vertices, triangles = cube(20)
    vertices = np.concatenate([vertices, [[math.nan, 0, 0]], vertices[:1]])
    triangles = np.concatenate([triangles, [[0, 1, 8], [0, 9, 1]]])
    result, _, said = result_of(tmp_path, (vertices, triangles), (REMESH, {"Voxel": 0.7}))
    assert REMOVES_NAN or "1 triangles have places that are not finite" in said
    assert "1 triangles have no area" in said
    assert result.volume == pytest.approx(8000, rel=1e-5)


def test_too_fine_a_voxel_is_refused_before_it_starts(tmp_path):
    for mesh in (cube(20), sphere(48)):
        refused(tmp_path, mesh, (REMESH, {"Voxel": 0.0002}), "of memory and")
        refused(tmp_path, mesh, (OFFSET, {"Voxel": 0.0002}), "would fit")
    refused(tmp_path, None, (FREP, {"Voxel": 0.0001}), "of memory and")


def test_bad_numbers_and_texts_are_refused(tmp_path):
    ball = sphere(24)
    for value in (0, -1, "nan"):
        refused(tmp_path, ball, (REMESH, {"Voxel": value}), "Voxel: must be above 0")
    refused(tmp_path, ball, (SHELL, {"Wall": 0}), "Wall: must be above 0")
    refused(tmp_path, ball, (SHELL, {"DrainHoles": -1}), "DrainHoles")
    refused(tmp_path, ball, (OFFSET, {"Distance": -30, "Voxel": 1}), "nothing left")
    refused(tmp_path, None, (FREP, {"Formula": "sphere("}), "formula:1:")
    refused(tmp_path, None, (FREP, {"Formula": "abs(x) - 3"}), "unbounded")
    refused(tmp_path, None, (FREP, {"Formula": " "}), "is empty")
    refused(tmp_path, None, (FREP, {"Bounds": "1,2,3"}), "is not x0,y0,z0,x1,y1,z1")
    refused(tmp_path, None, (VOLUME, {"File": tmp_path / "none.nrrd"}), "none.nrrd")
    refused(tmp_path, None, (VOLUME, {"File": ball_volume_file(tmp_path), "Threshold": "much"}), "much")


def test_damaged_files_are_refused(tmp_path):
    for name, text in (("bad.frep", b"sphere("), ("bad.asdf", b"nothing of the kind"), ("bad.vdb", b"\0" * 100),
                       ("bad.nrrd", b"NRRD0004\ntype: float\n\n")):
        (tmp_path / name).write_bytes(text)
        said = serve(tmp_path, [tmp_path / name], [], tmp_path / "out.ply")
        assert REFUSED in said, said.text
        assert "Aborted" not in said and not (tmp_path / "out.ply").exists(), said.text
