"""Runs inside freecadcmd: files that come into FreeCAD and go out of it, as FreeCAD itself calls it."""

import importlib
import math
import pathlib

import FreeCAD
import Mesh
import pytest

from fieldfab_workbench import file_types, files, kernel
from fieldfab_workbench.objects import frep_solid, scan
from fieldfab_workbench.objects import solid as solids

DATA = pathlib.Path(__file__).resolve().parents[2] / "data"
SPHERE = 4 / 3 * math.pi * 125


@pytest.fixture
def document():
    made = FreeCAD.newDocument()
    made.UndoMode = 1
    yield made
    for name in FreeCAD.listDocuments():
        FreeCAD.closeDocument(name)


def frep(document, text, voxel=0.25, at=(0, 0, 0)):
    solid = solids.create(frep_solid.FrepSolid, document)
    solid.Expression, solid.VoxelSize = text, voxel
    solid.Placement.Base = FreeCAD.Vector(*at)
    document.recompute()
    return solid


def importer(path):
    """The module that FreeCAD takes for a file."""
    for ending in (".".join(path.name.split(".")[1:]), path.suffix[1:]):
        for module in FreeCAD.getImportType(ending) or []:
            if module == file_types.MODULE:
                return importlib.import_module(module)
    raise AssertionError(f"FreeCAD knows no importer of ours for {path}")


def test_every_volume_is_a_file_type():
    for ending in (*file_types.VOLUMES, *file_types.TEXTS, "asdf"):
        assert file_types.MODULE in FreeCAD.getImportType(ending), ending
    for ending in ("asdf", "vdb", "frep", "math", "vm", *file_types.MESHES):
        assert file_types.MODULE in FreeCAD.getExportType(ending), ending
    assert file_types.MODULE not in (FreeCAD.getImportType("py") or []), "scripts run by command only"


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
    with pytest.raises(ValueError, match="not moved"):
        files.export([solid], str(tmp_path / "ball.frep"))
    solid.Placement = FreeCAD.Placement()
    solid.radius = 4
    files.export([solid], str(tmp_path / "ball.frep"))
    assert "radius = 4" in (tmp_path / "ball.frep").read_text()
    made = importer(tmp_path / "ball.frep").insert(str(tmp_path / "ball.frep"), document.Name)
    assert made.radius == 4 and made.Volume.Value == pytest.approx(SPHERE * 64 / 125, rel=0.02)


def test_freecad_itself_takes_them(document, tmp_path):
    """As its Open does it, by the file's name alone."""
    (tmp_path / "ball.frep").write_text("sphere(r = 5)")
    FreeCAD.loadFile(str(tmp_path / "ball.frep"))
    made = FreeCAD.ActiveDocument.Objects[0]
    assert FreeCAD.ActiveDocument.Label == "ball" and made.isValid() and made.Volume.Value == pytest.approx(SPHERE, rel=0.02)


@pytest.mark.parametrize("ending", file_types.MESHES)
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
