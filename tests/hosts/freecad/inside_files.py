"""Runs inside freecadcmd: import and export of files, called as FreeCAD does."""

import importlib
import math
import pathlib

import FreeCAD
import Mesh
import pytest

from fieldfab_workbench import file_types, files, kernel, preferences, work
from fieldfab_workbench.objects import frep_solid, scan
from fieldfab_workbench.objects import solid as solids

DATA = pathlib.Path(__file__).resolve().parents[2] / "data"
SPHERE = 4 / 3 * math.pi * 125


def frep(document, text, voxel=0.25, at=(0, 0, 0)):
    solid = solids.create(frep_solid.FrepSolid, document)
    solid.Expression, solid.VoxelSize = text, voxel
    solid.Placement.Base = FreeCAD.Vector(*at)
    document.recompute()
    return solid


def importer(path):
    """Returns the module that FreeCAD uses for a file."""
    for ending in (".".join(path.name.split(".")[1:]), path.suffix[1:]):
        for module in FreeCAD.getImportType(ending) or []:
            if module == file_types.MODULE:
                return importlib.import_module(module)
    raise AssertionError(f"FreeCAD knows no importer of ours for {path}")


def test_file_types_are_those_of_the_kernel(monkeypatch):
    for row in kernel.load().formats():
        for ending in (extension[1:] for extension in row["extensions"]):
            comes_in = (row["reads"] and row["kind"] not in ("script", "mesh") or row["kind"] == "mesh" and row["reads"]
                        and row["parts"])
            assert (file_types.MODULE in (FreeCAD.getImportType(ending) or [])) == comes_in, (
                f"{ending}: scripts run by command only")
            goes_out = (
                row["writes"] and (row["kind"] in ("distances", "mesh") or ending in ("frep", "math", "vm", "vdb")))
            assert (file_types.MODULE in (FreeCAD.getExportType(ending) or [])) == goes_out, ending
    assert file_types.MODULE in FreeCAD.getImportType("gz"), "of .nii.gz FreeCAD sees the end"
    # FreeCAD's start reads the table from the preferences, without the kernel.
    monkeypatch.setattr(kernel, "load", lambda: pytest.fail("the kernel was loaded"))
    file_types.table.cache_clear()
    assert "glb" in file_types.extensions("mesh", writes=True) and file_types.format_of("a.NII.GZ")["kind"] == "volume"


def test_freecad_starts_without_the_kernel(monkeypatch):
    def missing():
        raise ImportError("not built")

    monkeypatch.setattr(kernel, "load", missing)
    monkeypatch.setattr(kernel, "stamp", lambda: "")
    monkeypatch.setattr(FreeCAD, "addImportType", lambda *given: pytest.fail("a file type without a kernel"))
    file_types.table.cache_clear()
    file_types.register()


def test_volumes_come_in(document, tmp_path):
    path = DATA / "ct" / "CT_pitch.nii.gz"
    obj = importer(path).insert(str(path), document.Name)
    assert isinstance(obj.Proxy, scan.Scan) and obj.isValid() and obj.Triangles > 10000 and obj.Label == "CT_pitch"
    document.undo()
    assert not document.Objects
    one = importer(DATA / "ct" / "cthead" / "001.tif").insert(str(DATA / "ct" / "cthead" / "007.tif"), document.Name)
    assert one.File == str(DATA / "ct" / "cthead"), "a slice stands for its stack"


def test_texts_and_fields_come_in_and_go_out(document, tmp_path):
    solid = frep(document, "radius = 5\nsphere(radius)", at=(10, 0, 0))
    for ending in ("math", "vm", "asdf"):
        path = tmp_path / f"ball.{ending}"
        files.export([solid], str(path))
        made = importer(path).open(str(path))
        assert made.Document.Label == "ball" and made.isValid() and made.Volume.Value == pytest.approx(SPHERE, rel=0.02)
        assert made.Mesh.BoundBox.Center.distanceToPoint(FreeCAD.Vector(10, 0, 0)) < 0.05
    files.export([solid], str(tmp_path / "moved.frep"))
    made = files.insert(str(tmp_path / "moved.frep"), document.Name)
    assert made.Label == "FrepSolid001" and made.Mesh.BoundBox.Center.distanceToPoint(FreeCAD.Vector(10, 0, 0)) < 0.05
    solid.Placement = FreeCAD.Placement()
    solid.radius = 4
    files.export([solid], str(tmp_path / "ball.frep"))
    assert "radius = 4" in (tmp_path / "ball.frep").read_text()
    made = importer(tmp_path / "ball.frep").insert(str(tmp_path / "ball.frep"), document.Name)
    assert made.radius == 4 and made.Volume.Value == pytest.approx(SPHERE * 64 / 125, rel=0.02)


def test_freecad_itself_takes_them(document, tmp_path):
    """FreeCAD's Open chooses the importer by the file's name."""
    (tmp_path / "ball.frep").write_text("sphere(r = 5)")
    FreeCAD.loadFile(str(tmp_path / "ball.frep"))
    made = FreeCAD.ActiveDocument.Objects[0]
    assert (FreeCAD.ActiveDocument.Label == "ball" and made.isValid()
            and made.Volume.Value == pytest.approx(SPHERE, rel=0.02))


@pytest.mark.parametrize("ending", file_types.extensions("mesh", reads=True, writes=True))
def test_solids_go_out_as_meshes(document, tmp_path, ending):
    a, b = frep(document, "sphere(r = 5)"), frep(document, "sphere(r = 5)", at=(20, 0, 0))
    path = tmp_path / f"both.{ending}"
    files.export([a, b], str(path))
    assert kernel.load().Mesh.load(path).volume == pytest.approx(2 * SPHERE, rel=0.02)


def test_other_objects_go_out_as_fields(document, tmp_path):
    box = document.addObject("Part::Box", "Box")
    mesh = document.addObject("Mesh::Feature", "Ball")
    mesh.Mesh = Mesh.createSphere(5, 50)
    mesh.Placement.Base = FreeCAD.Vector(-20, 0, 0)
    document.recompute()
    files.export([box, mesh], str(tmp_path / "both.asdf"))
    made = files.insert(str(tmp_path / "both.asdf"), document.Name)
    assert made.Volume.Value == pytest.approx(1000 + mesh.Mesh.Volume, rel=0.02)
    files.export([box, mesh], str(tmp_path / "both.vdb"))
    made = files.insert(str(tmp_path / "both.vdb"), document.Name)
    assert made.Volume.Value == pytest.approx(1000 + mesh.Mesh.Volume, rel=0.02)
    with pytest.raises(ValueError, match="has no formula"):
        files.export([box], str(tmp_path / "box.frep"))
    assert not (tmp_path / "box.frep").exists()


def test_what_cannot_be_read_adds_nothing(document, tmp_path):
    (tmp_path / "bad.frep").write_text("spheer(r = 3)")
    (tmp_path / "nonsense.vm").write_bytes(b"\xff\xfe\x00")
    (tmp_path / "script.py").write_text("raise SystemExit('it ran')")
    for name in ("bad.frep", "nonsense.vm", "nothing.math", "script.py"):
        with pytest.raises(ValueError) as told:
            files.insert(str(tmp_path / name), document.Name)
        assert name in str(told.value) and "\n" not in str(told.value)
    assert not document.Objects


@pytest.fixture
def coarse():
    """Uses large cells, for speed."""
    FreeCAD.ParamGet(preferences.PATH).SetInt("Cells", 16)
    yield
    FreeCAD.ParamGet(preferences.PATH).RemInt("Cells")


def ball_and_box(folder, radius=5):
    """Returns a model of two parts; the second opens a file."""
    path, opened = folder / "model.frep", folder / "lid.frep"
    opened.write_text("move(box(4, 4, 4), 20, 0, 0)")
    path.write_text(f'part(sphere(r = {radius}), "ball", "red")\npart(open("lid.frep"), "lid")\n')
    return path, opened


def test_parts_come_in_as_objects_of_a_group(document, tmp_path):
    path, opened = ball_and_box(tmp_path)
    group = importer(path).insert(str(path), document.Name)
    ball, lid = group.Group
    assert (group.Label == "model" and [part.Label for part in group.Group] == ["ball", "lid"] and ball.isValid()
            and lid.isValid())
    assert ball.Volume.Value == pytest.approx(SPHERE, rel=0.02) and lid.Volume.Value == pytest.approx(64, rel=1e-4)
    assert ball.Proxy.source(ball).colour() == "#ff0000" and lid.Proxy.source(lid).colour() is None
    document.undo()
    assert not document.Objects
    document.redo()
    lid = document.getObject(lid.Name)
    made = lid.MadeFrom
    opened.write_text("move(box(4, 4, 8), 20, 0, 0)")
    document.recompute()
    assert lid.Volume.Value == pytest.approx(128, rel=1e-4) and lid.MadeFrom != made
    ball_and_box(tmp_path)
    path.write_text('part(sphere(r = 4), "ball")\npart(sphere(r = 1), "bell")\n')
    document.recompute()
    ball = document.getObject(ball.Name)
    assert ball.Volume.Value == pytest.approx(SPHERE * 64 / 125, rel=0.02) and ball.Opened == []
    assert (not lid.isValid() and "no part 'lid'" in lid.getStatusString()
            and lid.Volume.Value == pytest.approx(128, rel=1e-4)), "it keeps its mesh"


def test_a_document_with_parts_opens_as_it_was_and_moves_with_its_files(document, tmp_path):
    (tmp_path / "a").mkdir()
    path, _ = ball_and_box(tmp_path / "a")
    group = files.insert(str(path), document.Name)
    document.saveAs(str(tmp_path / "a" / "parts.FCStd"))
    triangles = group.Group[0].Triangles
    (tmp_path / "a").rename(tmp_path / "b")
    again = FreeCAD.openDocument(str(tmp_path / "b" / "parts.FCStd"))
    ball = again.getObject(group.Group[0].Name)
    ball.VoxelSize = 1
    again.recompute()
    assert (ball.isValid() and ball.Proxy.files(ball)[0] == str(tmp_path / "b" / "model.frep")
            and ball.Triangles < triangles)


def test_the_example_of_an_assembly_comes_in(document, coarse):
    """A scan, a mesh and formulas are parts of one text."""
    group = files.insert(str(DATA.parents[1] / "examples" / "assembly" / "display.frep"), document.Name)
    assert ([part.Label for part in group.Group] == ["engine", "stand", "knobs"]
            and all(part.isValid() and part.Triangles > 100 for part in group.Group))
    assert [part.Proxy.source(part).colour() for part in group.Group] == ["#c0c0c0", "#cd853f", "#8b1a1a"]
    assert group.Group[0].Opened == ["../../tests/data/ct/engine.nii.gz", "knob.3mf"]


@pytest.mark.parametrize("ending", file_types.extensions("mesh", writes=True, parts=True))
def test_parts_go_out_with_names_and_colours(document, coarse, tmp_path, ending):
    """Overlapping parts remain separate; one of them is moved, and one is a foreign solid."""
    group = files.insert(str(ball_and_box(tmp_path)[0]), document.Name)
    group.Group[0].Placement.Base = FreeCAD.Vector(18, 0, 0)
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    path = tmp_path / f"out.{ending}"
    files.export([group, box], str(path))
    if ending == "3mf":
        parts = kernel.load().load_parts(path)
        assert [(name, colour) for _, name, colour in parts] == [("ball", "#ff0000"), ("lid", None), ("Box", None)]
        assert [kernel.load().mesh(solid, voxel=1).volume
                for solid, _, _ in parts] == pytest.approx([SPHERE, 64, 1000], rel=0.05)
        assert parts[0][0].bounds()[0] == pytest.approx(13, abs=0.2)
        made = files.insert(str(path), document.Name)
        assert ([part.Label for part in made.Group] == ["ball001", "lid001", "Box001"]
                and made.Group[2].Volume.Value == pytest.approx(1000, rel=0.01))
    else:
        said = path.read_bytes()
        assert (all(name in said for name in (b"ball", b"lid", b"Box"))
                and (ending == "glb" or b"newmtl" in path.with_suffix(".mtl").read_bytes()))


def test_parts_go_out_as_text(document, coarse, tmp_path):
    """A moved formula, and a solid from another file, which the text opens."""
    kernel.load().openscad_design("cube(4);").solid.faces().save(tmp_path / "lid.3mf")
    path = tmp_path / "model.frep"
    path.write_text('part(sphere(5), "ball", "red")\npart(open("lid.3mf"), "lid")')
    group = files.insert(str(path), document.Name)
    group.Group[0].Placement.Base = FreeCAD.Vector(18, 0, 0)
    files.export([group], str(tmp_path / "out.frep"))
    (ball, name, colour), (lid, other, _) = kernel.load().load_parts(tmp_path / "out.frep")
    assert ((name, colour, other) == ("ball", "#ff0000", "lid")
            and 'open("lid.3mf"' in (tmp_path / "out.frep").read_text())
    assert ball.bounds() == pytest.approx((13, -5, -5, 23, 5, 5), abs=0.2) and lid.kind == "mesh"
    with pytest.raises(ValueError, match=".frep text only"):
        files.export([group], str(tmp_path / "out.math"))
    assert not (tmp_path / "out.math").exists()


def test_united_parts_have_their_colours_at_the_vertices(document, tmp_path):
    group = files.insert(str(ball_and_box(tmp_path)[0]), document.Name)
    files.export([group], str(tmp_path / "out.ply"))
    head, rest = (tmp_path / "out.ply").read_bytes().split(b"end_header\n")
    assert b"property uchar red" in head and b"\xff\x00\x00" in rest and b"\xcc\xcc\xcc" in rest
    assert kernel.load().inspect(kernel.load().Mesh.load(tmp_path / "out.ply")).valid


def test_a_cancelled_import_adds_nothing(document, tmp_path, monkeypatch):
    """Cancellation during reading, and during the mesh of the second part."""
    (path, _), run = ball_and_box(tmp_path), work.run
    for stopped in (1, 3):
        for docname in (document.Name, ""):
            titles = []

            def stop(function, title):
                titles.append(title)
                if len(titles) == stopped:
                    raise work.Cancelled()
                return run(function, title)

            monkeypatch.setattr(work, "run", stop)
            with pytest.raises(ValueError, match="model.frep: cancelled; nothing was added"):
                files.insert(str(path), docname)
            assert titles == ["Reading model.frep", "ball", "lid"][:stopped]
            assert not document.Objects and not document.UndoCount and list(FreeCAD.listDocuments()) == [document.Name]
