"""Runs inside freecadcmd: functions of the editor, the gallery and the live view that need no window."""

import os
import pathlib
import shutil
import subprocess
import sys

import FreeCAD
import numpy as np
import pytest

from fieldfab_workbench import frep_language as language
from fieldfab_workbench import kernel, openscad, shapes, work
from fieldfab_workbench.objects import frep_solid
from fieldfab_workbench.objects import solid as solids
from fieldfab_workbench.views import inventor, refinement

WORKBENCH = pathlib.Path(shapes.__file__).resolve().parents[1]


def go_on(fraction, message):
    return True


# The language.
def test_places_are_counted_as_qt_does():
    text = "a = 1  # ½ 😀\nb = 2; sphere(ä, q) \"😀\"\nspheer(3)"
    units = [text.encode("utf-16-le")[2 * start:2 * end].decode("utf-16-le")
             for kind, start, end, token in language.tokens(text)]
    assert (units == [token for kind, start, end, token in language.tokens(text)]
            and units[3:7] == ["# ½ 😀", "b", "=", "2"])
    shown = [(text.encode("utf-16-le")[2 * m.start:2 * m.end].decode("utf-16-le"), m.line)
             for m in language.mistakes(text)]
    assert shown == [("ä", 1), ("spheer", 2)]
    places = language.Places(text)
    for i in range(len(text) + 1):
        unit, byte = len(text[:i].encode("utf-16-le")) // 2, len(text[:i].encode())
        assert places.unit(byte) == unit and places.byte(unit) == byte
    at = len(text[:text.index("spheer") + 2].encode("utf-16-le")) // 2
    start, fitting = language.completions(text, at)
    assert start == at - 2 and "sphere()" in [entry.insert for entry in fitting]
    assert language.word_at(text + " | sphere(2)", at + 13).signature == "sphere(r = 1)"
    assert language.with_values(text, {"a": 3.5, "b": -1, "c": 2}) == text.replace("a = 1", "a = 3.5").replace(
        "b = 2", "b = -1")


def test_half_a_character_is_a_mistake_only():
    assert [m.start for m in language.mistakes("a = 1\n\ud83d\nsphere(a)")] == [6]


def test_properties_follow_texts_in_order_only():
    document = FreeCAD.newDocument()
    solid = solids.create(frep_solid.FrepSolid, document)
    solid.Expression = "size = 4  # 1 to 9, side\nhole = 1\nbox(size, size, size) - sphere(hole)"
    assert (solid.getDocumentationOfProperty("size") == "side"
            and solid.getDocumentationOfProperty("hole") == "hole of the text")
    solid.size = 5
    solid.Expression = solid.Expression.replace("hole = 1", "hole = (1")
    assert solid.hole == 1 and solid.size == 5, "a text with a mistake keeps them"
    solid.Expression = "size = 4\nbox(size, size, size)"
    assert solid.size == 5 and "hole" not in solid.PropertiesList
    FreeCAD.closeDocument(document.Name)


# The gallery.
def test_every_shape_has_a_picture_and_a_text():
    fieldfab, every = kernel.load(), shapes.shapes()
    assert len(every) > 90 and {s.group for s in every} >= {"Solids", "Flat shapes", "Lattices", "Sets", shapes.DESIGNS}
    for shape in every:
        assert shape.picture and os.path.exists(shape.picture), shape.name
        made = fieldfab.parse(shape.solid(shape.values))
        assert shape.group not in ("Solids", "Flat shapes") or fieldfab.Solid(made).bounds(), (
            f"{shape.name} makes no solid")
        if not shape.text:
            fieldfab.parse(shape.before + shape.call(shape.values) + shape.after)


def numbers(text):
    return {name: each.value for name, each in language.parameters(text).items()}


def test_numbers_become_parameters():
    every = {s.name: s for s in shapes.shapes()}
    box = every["rounded_box"]
    text = box.solid({**box.values, "dx": "12", "r": "1.5"})
    assert numbers(text) == {"dx": 12, "dy": 6, "dz": 4, "r": 1.5}
    assert box.call(box.values) == "rounded_box(dx = 8, dy = 6, dz = 4, r = 1)"
    # A reserved name is replaced.
    assert numbers(every["plane"].solid(every["plane"].values)) == {"nx": 1, "ny": 1, "nz": 1, "offset_": 2}
    assert numbers(every["text"].solid({**every["text"].values, "words": '"Hi"'})) == {"h": 5, "weight": 0.9}
    assert every["difference"].call(every["difference"].values) == "difference(box(6, 6, 4), cylinder(2, 6))"


def test_pictures_are_found_beside_an_installed_workbench(tmp_path, monkeypatch):
    (tmp_path / "figures" / "shapes").mkdir(parents=True)
    shutil.copy(shapes.found("figures", "shapes", "box.png"), tmp_path / "figures" / "shapes")
    monkeypatch.setattr(shapes, "WORKBENCH", str(tmp_path))
    assert shapes.found("figures", "shapes", "box.png") == str(tmp_path / "figures" / "shapes" / "box.png")
    assert shapes.found("figures", "shapes", "sphere.png") is None


# The live view.
def pieces(picture):
    """Returns the triangles of a picture as points of shape (n, 3, 3)."""
    corners = []
    for data in (each for piece in picture.values() for each in piece):
        node = inventor.read(data)
        points = np.array([p.getValue() for p in node.getChild(1).point.getValues()])
        index = np.array(node.getChild(2).coordIndex.getValues()).reshape(-1, 4)
        assert (index[:, 3] == -1).all() and len(points) == node.getChild(0).vector.getNum()
        corners.append(points[index[:, :3]])
    return np.concatenate(corners)


def area(corners):
    return np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() / 2


def test_coin_nodes_hold_the_mesh():
    fieldfab = kernel.load()
    mesh = fieldfab.mesh(fieldfab.parse("box(4, 4, 4)"), voxel=0.5)
    _, slopes = fieldfab.Solid(fieldfab.parse("box(4, 4, 4)")).gradients(mesh.vertices)
    vertices, normals, triangles = inventor.corner_normals(mesh.vertices, mesh.triangles, slopes)
    assert area(pieces({0: [inventor.written(vertices, normals, triangles)]})) == pytest.approx(6 * 16, rel=1e-5)
    # Normals are not averaged across sharp edges.
    facets = np.cross(vertices[triangles[:, 1]] - vertices[triangles[:, 0]],
                      vertices[triangles[:, 2]] - vertices[triangles[:, 0]])
    facets /= np.linalg.norm(facets, axis=1)[:, None]
    assert np.einsum("tcx,tx->tc", normals[triangles], facets).min() > inventor.CREASE - 1e-3


def test_flat_faces_are_drawn_with_creases():
    """A post of 24 sides: smooth around, sharp at its ends."""
    mesh = kernel.load().openscad_design(
        "cylinder($fn = 24, h = 10, r1 = 5, r2 = 5); multmatrix([[1, 0, 0, 20], [0, 1, 0, 0], [0, 0, 1, 0], "
        "[0, 0, 0, 1]]) { cube(size = [1, 2, 3]); }").solid.faces()
    vertices, normals, triangles = inventor.creased(mesh.vertices, mesh.triangles)
    assert area(pieces({0: [inventor.written(vertices, normals, triangles)]})) == pytest.approx(mesh.area, rel=1e-5)
    level, post = np.abs(normals[:, 2]) > 0.5, vertices[:, 0] < 10
    assert (np.allclose(normals[level], [0, 0, 1] * np.sign(normals[level]))
            and np.allclose(normals[~level, 2], 0, atol=1e-6))
    outward = vertices[post & ~level, :2] / 5
    assert np.einsum("ix,ix->i", normals[post & ~level, :2], outward).min() > np.cos(np.radians(8)), (
        "of the sides on both hands")
    assert np.allclose(np.abs(normals[~post]).max(axis=1), 1), "a block's corners belong to one side each"


def test_faces_are_all_of_a_picture():
    source = openscad.OpenScadSource(openscad.Text([("cube(size = [1, 2, 3]);", "block")]), "block")
    for first in (False, True):
        seen = refinement.Refinement(source, {}, guess=(0, 0, 0, 1, 1, 1), cells=12, most=1000, faces_first=first)
        count = len(pieces(seen.coarse(go_on)))
        assert count == 12 if first else count > 100
        assert seen.exact == first and list(seen.finer(go_on)) == []
        last, = seen.final(go_on)
        assert (len(pieces(last)) == 12 and area(pieces(last)) == pytest.approx(22, rel=1e-6)
                and not seen.is_coarse_for((0, 0, 0)))
    few = refinement.Refinement(source, {}, most=11)
    few.coarse(go_on)
    assert not few.exact, "more than can be shown"
    part = refinement.Refinement(source, {"bounds": (-1, -1, -1, 2, 3, 1), "voxel": 0.1}, most=10_000, faces_first=True)
    assert part.coarse(go_on) and not part.exact and list(part.final(go_on)) and not part.exact


def test_pictures_get_finer_and_end_with_the_solids_own_mesh():
    source = frep_solid.source_of_text("sphere(r = 10)")
    seen = refinement.Refinement(source, {"voxel": 0.5}, guess=(-4, -4, -4, 4, 4, 4), cells=12, most=60_000)
    first = area(pieces(seen.coarse(go_on)))
    assert first == pytest.approx(400 * np.pi, rel=0.05), "found in a box that was too small"
    areas = [area(pieces(picture)) for picture in seen.finer(go_on)]
    assert abs(areas[-1] - 400 * np.pi) < abs(first - 400 * np.pi) and seen.voxel == 0.5
    last, = seen.final(go_on)
    assert area(pieces(last)) == pytest.approx(source.mesh(voxel=0.5).area, rel=1e-4)


def test_the_first_picture_is_smooth_if_that_takes_little_time():
    """A cube with edges that the first cells cut off: small cells, and shading as if they were rounded."""
    source = frep_solid.source_of_text("rotate_x(box(10, 10, 10), 20)")
    ragged, smooth = (refinement.Refinement(source, {"voxel": 0.1}, smooth=wanted) for wanted in (False, True))
    few = len(pieces(ragged.coarse(go_on)))
    for _ in range(5):  # other programs share the processor
        many = len(pieces(smooth.coarse(go_on)))
        if many > few:
            break
    assert many > 3 * few and smooth.voxel == pytest.approx(smooth._longest() / refinement.SMOOTH)
    mesh = source.mesh(voxel=0.5, features=False)
    _, slopes = source.field().gradients(mesh.vertices)
    split, left = (len(inventor.corner_normals(mesh.vertices, mesh.triangles, slopes, crease)[0]) - len(mesh.vertices)
                   for crease in (inventor.CREASE, inventor.STEEP_CREASE))
    assert split > 100 and left < split / 3


def test_what_the_guess_missed_is_found_in_the_end():
    source = frep_solid.source_of_text("sphere(r = 5) | move(sphere(r = 5), dx = 100)")
    seen = refinement.Refinement(source, {"voxel": 0.5}, guess=(-5, -5, -5, 5, 5, 5), cells=12, most=1000)
    assert pieces(seen.coarse(go_on)).max() < 6
    assert [p for p in seen.finer(go_on)] == [] or seen.triangles >= 600
    assert max(pieces(picture).max() for picture in seen.final(go_on)) > 100


def test_blocks_are_refined_where_the_eye_is():
    source = frep_solid.source_of_text("difference(box(20, 20, 20), sphere(r = 11))")
    seen = refinement.Refinement(source, {"voxel": 0.6}, cells=16, most=20_000)
    seen.coarse(go_on)
    list(seen.finer(go_on)), list(seen.final(go_on))
    whole = source.mesh(voxel=0.6).area
    far, near = (1000, 0, 0), (12, 12, 12)
    assert not seen.is_coarse_for(far) and seen.is_coarse_for(near)
    picture = seen.divided(go_on)
    # Blocks overlap by a cell, and are open inside the solid.
    assert whole < area(pieces(picture)) < 1.25 * whole
    before = sum(map(len, picture[(1, 1, 1)]))
    for part in seen.detail(near, go_on):
        picture.update(part)
    assert (sum(map(len, picture[(1, 1, 1)])) > 4 * before
            and max(level for _, level, _ in seen.details[(1, 1, 1)].parts(near)) >= 2)


def test_blocks_give_way_to_a_whole_of_more_triangles_than_are_shown():
    source = frep_solid.source_of_text("sphere(r = 10)")
    seen = refinement.Refinement(source, {"voxel": 0.5}, cells=12, most=1000)
    assert len(source.mesh(voxel=0.5).triangles) > 1000
    seen.coarse(go_on)
    list(seen.finer(go_on)), list(seen.final(go_on))
    seen.divided(go_on)
    *_, whole = seen.final(go_on)
    assert area(pieces(whole)) == pytest.approx(400 * np.pi, rel=0.02) and not seen.in_blocks
    assert list(seen.final(go_on)) == [], "it is shown already"


def test_work_that_nobody_wants_ends():
    seen = refinement.Refinement(frep_solid.source_of_text(frep_solid.DEFAULT), {}, guess=(-21, -21, -21, 21, 21, 21),
                                 cells=16)
    seen.coarse(go_on)
    with pytest.raises((work.Cancelled, kernel.load().Error)):
        list(seen.finer(lambda fraction, message: False))


def test_solids_without_bounds_are_told():
    seen = refinement.Refinement(frep_solid.source_of_text("plane(0, 0, 1)"), {}, guess=(-1, -1, -1, 1, 1, 1))
    with pytest.raises(kernel.load().Error, match="unbounded"):
        seen.coarse(go_on)


def loaded_by(code):
    """Returns the names of all modules that `code` loads, in a separate Python with FreeCAD and the workbench in its
    path."""
    paths = [str(WORKBENCH), *(p for p in sys.path if "freecad" in p.lower())]
    code = f"import sys; sys.path[:0] = {paths!r}\n{code}\nprint(chr(10).join(['loaded:', *sys.modules]))"
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
    said = subprocess.run(["/usr/bin/python3", "-c", code], capture_output=True, text=True, timeout=60, env=environment)
    assert "loaded:" in said.stdout, said.stdout + said.stderr
    return said.stdout.split("loaded:")[1].split()


def test_the_workbench_loads_without_what_takes_long():
    """The start imports neither numpy nor the kernel: the preferences store the file types."""
    FreeCAD.saveParameter("User parameter")
    loaded = loaded_by("import FreeCAD, FreeCADGui; FreeCADGui.addCommand = lambda *given: None\n"
                       "from fieldfab_workbench import commands; commands.register()")
    assert "fieldfab_workbench.commands.cam" in loaded and not {"numpy", "fieldfab", "pivy"} & set(loaded)


def test_objects_and_files_load_without_the_window():
    """Objects, import and export of files load neither Qt, Coin, views nor panels."""
    package = WORKBENCH / "fieldfab_workbench"
    names = [f"objects.{file.stem}" for file in sorted((package / "objects").glob("*.py")) if file.stem != "__init__"]
    names = [f"fieldfab_workbench.{name}" for name in (*names, "file_types", "files", "openscad_files", "path_jobs")]
    loaded = loaded_by("import FreeCAD\n" + "\n".join(f"import {name}" for name in names))
    assert len(names) > 15 and set(names) <= set(loaded)
    ours = [f"fieldfab_workbench.{name}" for name in ("shim", "views", "panels", "commands")]
    window = ("PySide", "shiboken", "pivy", "FreeCADGui", *ours)
    assert [name for name in loaded if name.startswith(window)] == []
