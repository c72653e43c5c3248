"""Runs inside freecadcmd: scans as document objects."""

import math
import os
import pathlib
import shutil

import FreeCAD
import numpy as np
import pytest

from fieldfab_workbench import kernel, meshes
from fieldfab_workbench.objects import combine, frep_solid, scan
from fieldfab_workbench.objects import solid as solids

CT = pathlib.Path(__file__).resolve().parents[2] / "data" / "ct"
BALL = 4 / 3 * math.pi * 6**3


def balls(path, radius=6.0, spot=False):
    """Writes a volume of spacing 0.5 mm with a ball in its centre. `spot`: adds a small component in a corner."""
    at = (np.arange(40) - 19.5) * 0.5
    z, y, x = np.meshgrid(at, at, at, indexing="ij")
    densities = np.clip(128 + 100 * (radius - np.sqrt(x * x + y * y + z * z)), 0, 255)
    if spot:
        densities[2:4, 2:4, 2:4] = 255
    volume = kernel.load().Volume(densities.astype("f4"), spacing=(0.5, 0.5, 0.5), origin=(-9.75, -9.75, -9.75))
    volume.save(path)
    return str(path)


def scanned(document, path, **values):
    obj = solids.create(scan.Scan, document)
    obj.File = str(path)
    for name, value in values.items():
        setattr(obj, name, value)
    document.recompute()
    return obj


def sane(obj):
    assert obj.isValid(), obj.getStatusString()
    assert obj.Mesh.isSolid() and obj.Triangles == obj.Mesh.CountFacets > 11
    assert kernel.load().inspect(meshes.from_bms(meshes.bms_of(obj.Mesh))).valid
    return obj.Volume.Value


def test_a_ball_is_found_at_its_samples_resolution(document, tmp_path):
    obj = scanned(document, balls(tmp_path / "ball.nrrd"))
    assert sane(obj) == pytest.approx(BALL, rel=0.02) and obj.FileState == scan.AS_READ
    assert obj.Mesh.BoundBox.Center.Length < 0.05
    fine = obj.Triangles
    obj.VoxelSize = 2
    document.recompute()
    assert sane(obj) == pytest.approx(BALL, rel=0.1) and obj.Triangles < fine / 2


def test_threshold_spacing_crop_and_below(document, tmp_path):
    obj = scanned(document, balls(tmp_path / "ball.nrrd"))
    obj.AutoThreshold, obj.Threshold = False, 28.0  # 1 mm outside
    document.recompute()
    assert sane(obj) == pytest.approx(4 / 3 * math.pi * 343, rel=0.02)
    obj.Spacing = FreeCAD.Vector(1, 0.5, 0.5)
    document.recompute()
    assert sane(obj) == pytest.approx(2 * 4 / 3 * math.pi * 343, rel=0.02)
    obj.Spacing, obj.Threshold, obj.Crop = FreeCAD.Vector(), 128.0, [0, 0, 0, 39, 39, 19]
    document.recompute()
    assert sane(obj) == pytest.approx(BALL / 2 - math.pi * 36 * 0.25, rel=0.02)
    obj.Crop, obj.Below = [], True
    document.recompute()
    assert sane(obj) == pytest.approx(19.5**3 - BALL, rel=0.002), "closed at the border's samples"
    obj.Crop = [3, 3, 3]
    document.recompute()
    assert not obj.isValid() and "Crop" in obj.getStatusString()
    obj.Crop = [0, 0, 0, 99, 9, 9]
    document.recompute()
    assert not obj.isValid() and obj.getStatusString().count("\n") == 0 and obj.Mesh.CountFacets == obj.Triangles


def test_clean_up(document, tmp_path):
    obj = scanned(document, balls(tmp_path / "ball.nrrd", spot=True))
    crumb = sane(obj)
    assert crumb > BALL * 0.98 and obj.Mesh.countComponents() == 2
    obj.KeepLargest = True
    document.recompute()
    assert sane(obj) < crumb and obj.Mesh.countComponents() == 1
    obj.KeepLargest, obj.SmallestIsland = False, 10
    document.recompute()
    assert sane(obj) < crumb and obj.Mesh.countComponents() == 1
    obj.SmallestIsland, obj.Denoise = 0, "median"
    document.recompute()
    assert sane(obj) == pytest.approx(BALL, rel=0.03)


@pytest.mark.parametrize("name", ["cthead", "CT_pitch.nii.gz", "engine.nii.gz"])
def test_real_scans(document, name):
    obj = scanned(document, CT / name, VoxelSize=4.0)
    assert sane(obj) > 100000
    if name == "CT_pitch.nii.gz":  # an oblique scan, placed by the file's transform
        assert obj.Mesh.BoundBox.XMin < -60 and obj.Mesh.BoundBox.YMin < -50


def test_raw_files_and_asdf_files(document, tmp_path):
    volume = kernel.load().Volume.open(balls(tmp_path / "ball.nrrd"))
    (tmp_path / "plain.raw").write_bytes(volume.densities().astype("<u2").tobytes())
    obj = scanned(document, tmp_path / "plain.raw")
    assert not obj.isValid() and "plain.raw" in obj.getStatusString()
    obj.Samples, obj.SampleType, obj.Spacing = [40, 40, 40], "uint16", FreeCAD.Vector(0.5, 0.5, 0.5)
    document.recompute()
    assert sane(obj) == pytest.approx(BALL, rel=0.02)
    volume.save_asdf(tmp_path / "ball.asdf")
    assert sane(scanned(document, tmp_path / "ball.asdf")) == pytest.approx(BALL, rel=0.02)


def test_a_scan_is_a_source_like_any_other(document, tmp_path):
    obj = scanned(document, balls(tmp_path / "ball.nrrd"))
    obj.Placement.Base = FreeCAD.Vector(20, 0, 0)
    box = solids.create(frep_solid.FrepSolid, document)
    box.Expression = "box(20, 20, 20)"
    box.Placement.Base = FreeCAD.Vector(30, 0, 0)
    both = solids.create(combine.Combine, document)
    both.Operation, both.Sources, both.VoxelSize = "Intersection", [obj, box], 0.5
    document.recompute()
    assert sane(both) == pytest.approx(BALL / 2, rel=0.02) and both.Mesh.BoundBox.XMin == pytest.approx(20, abs=0.1)


def test_the_file_is_found_beside_a_document_that_moves(document, tmp_path):
    here, there = tmp_path / "here", tmp_path / "there"
    (here / "scans").mkdir(parents=True)
    obj = scanned(document, balls(here / "scans" / "ball.nrrd"))
    volume = sane(obj)
    document.saveAs(str(here / "part.FCStd"))
    shutil.move(here, there)
    again = FreeCAD.openDocument(str(there / "part.FCStd"))
    moved = again.getObject(obj.Name)
    assert moved.FileState == scan.AS_READ and moved.Proxy.path(moved) == str(there / "scans" / "ball.nrrd")
    moved.AutoThreshold, moved.Threshold = False, 28.0
    again.recompute()
    assert sane(moved) > volume * 1.4


def test_a_missing_scan_is_marked_and_nothing_is_lost(document, tmp_path, capfd):
    path = balls(tmp_path / "ball.nrrd")
    obj = scanned(document, path)
    volume, name = sane(obj), obj.Name
    document.saveAs(str(tmp_path / "part.FCStd"))
    FreeCAD.closeDocument(document.Name)
    os.rename(path, tmp_path / "elsewhere.nrrd")
    again = FreeCAD.openDocument(str(tmp_path / "part.FCStd"))
    obj = again.getObject(name)
    assert obj.FileState == scan.MISSING and obj.Volume.Value == volume and obj.Mesh.CountFacets == obj.Triangles
    assert obj.Proxy.icon_name(obj) == "ScanMissing"
    again.recompute()
    assert obj.isValid(), "nothing has changed"
    obj.AutoThreshold, obj.Threshold = False, 28.0
    again.recompute()
    assert not obj.isValid() and "is not there" in obj.getStatusString() and "\n" not in obj.getStatusString()
    assert obj.Volume.Value == volume and obj.Mesh.CountFacets == obj.Triangles
    obj.File = str(tmp_path / "elsewhere.nrrd")
    again.recompute()
    assert sane(obj) > volume * 1.4 and obj.FileState == scan.AS_READ


def test_a_changed_file_is_noticed_and_read_again(document, tmp_path):
    path = balls(tmp_path / "ball.nrrd")
    obj = scanned(document, path)
    volume, name = sane(obj), obj.Name
    document.saveAs(str(tmp_path / "part.FCStd"))
    balls(path, 8)
    again = FreeCAD.openDocument(str(shutil.copy(tmp_path / "part.FCStd", tmp_path / "copy.FCStd")))
    obj = again.getObject(name)
    assert obj.FileState == scan.CHANGED and obj.Volume.Value == volume, "opening computes nothing"
    again.recompute()
    assert sane(obj) == pytest.approx(volume * 512 / 216, rel=0.02) and obj.FileState == scan.AS_READ


def test_only_what_changed_is_computed(document, tmp_path, monkeypatch):
    obj = scanned(document, balls(tmp_path / "ball.nrrd"))
    made = []
    real = solids.meshes.to_freecad
    monkeypatch.setattr(solids.meshes, "to_freecad", lambda mesh: made.append(1) or real(mesh))
    obj.touch()
    document.recompute()
    assert not made
    obj.Threshold = 3.0  # not used
    document.recompute()
    assert not made
    obj.Below = True
    document.recompute()
    assert made
