"""Runs inside freecadcmd: documents must not execute code; documents with missing data; large documents."""

import os
import sys
import time
import zipfile

import FreeCAD
import numpy as np
import pytest

from fieldfab_workbench import kernel
from fieldfab_workbench.objects import combine, frep_solid, modify, part_shape, scan, solid_from_object
from fieldfab_workbench.objects import solid as solids

RUNS = ("subprocess.Popen", "os.system", "os.exec", "os.posix_spawn", "os.spawn", "os.fork", "os.startfile")
_seen, _watching = [], []


def _watch(event, arguments):
    installed = ("<frozen", sys.prefix, "/usr/lib")
    if _watching and (event in RUNS or (
            event == "exec" and not getattr(arguments[0], "co_filename", "").startswith(installed))):
        _seen.append((event, str(arguments)))


sys.addaudithook(_watch)


@pytest.fixture
def watched():
    """Records all code and processes that run, by Python's audit events, which no code can bypass."""
    _seen.clear()
    yield _seen
    _watching.clear()


def add(document, kind, **values):
    obj = solids.create(kind, document)
    for name, value in values.items():
        setattr(obj, name, value)
    return obj


def ball(path):
    at = (np.arange(24) - 11.5) * 0.5
    z, y, x = np.meshgrid(at, at, at, indexing="ij")
    kernel.load().Volume(np.clip(128 + 100 * (4 - np.sqrt(x * x + y * y + z * z)), 0, 255).astype("f4"),
                         spacing=(0.5, 0.5, 0.5)).save(path)
    return str(path)


def one_of_each(document, tmp_path):
    frep = add(document, frep_solid.FrepSolid, Expression="r = 5\nsphere(r)", VoxelSize=0.5)
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    found = add(document, scan.Scan, File=ball(tmp_path / "ball.nrrd"))
    copied = add(document, solid_from_object.SolidFromObject, Source=box, VoxelSize=0.5)
    union = add(document, combine.Combine, Sources=[frep, copied], VoxelSize=0.5)
    moved = add(document, modify.Modify, Operation="Transform", Source=found, VoxelSize=0.5)
    shape = part_shape.create(document, copied)
    document.recompute()
    made = [frep, found, copied, union, moved, shape]
    assert all(obj.isValid() for obj in made), [obj.getStatusString() for obj in made]
    return made


def test_opening_runs_nothing(document, tmp_path, watched):
    """Neither scripts named in a document nor texts in the form of programs are executed."""
    ran = tmp_path / "ran"
    evil = f"__import__('pathlib').Path({str(ran)!r}).touch()"
    (tmp_path / "evil.py").write_text(evil)
    made = one_of_each(document, tmp_path)
    for name in ("evil.py", "evil.frep"):
        add(document, scan.Scan, File=str(tmp_path / name))
    add(document, frep_solid.FrepSolid, Expression=evil)
    add(document, frep_solid.FrepSolid, Expression="#!/usr/bin/python3\n" + evil, Label=evil)
    document.recompute()
    document.saveAs(str(tmp_path / "evil.FCStd"))
    FreeCAD.closeDocument(document.Name)
    _watching.append(True)
    again = FreeCAD.openDocument(str(tmp_path / "evil.FCStd"))
    assert not watched, "opening"
    assert sum(obj.isValid() for obj in again.Objects) >= len(made)
    for obj in again.Objects:
        obj.touch()
    again.recompute()
    _watching.clear()
    assert not watched and not ran.exists(), "recomputing"


def test_documents_hold_no_program(document, tmp_path):
    """A document stores only the class name of our objects, and null: there is no state to deserialize."""
    made = one_of_each(document, tmp_path)
    document.saveAs(str(tmp_path / "all.FCStd"))
    text = zipfile.ZipFile(tmp_path / "all.FCStd").read("Document.xml").decode()
    kept = [line for line in text.splitlines() if "<Python " in line]
    assert len(kept) == len(made)
    for line in kept:
        assert ('module="fieldfab_workbench.objects.' in line
                and ('value="bnVsbA=="' in line or 'value="null"' in line)), line


def test_what_fails_keeps_what_it_had_and_so_do_those_made_of_it(document, tmp_path):
    made = one_of_each(document, tmp_path)
    frep, found, copied, union, moved, shape = made
    before = [getattr(obj, "Triangles", getattr(obj, "Faces", 0)) for obj in made]
    os.remove(tmp_path / "ball.nrrd")
    frep.Expression, found.Below = "nothing(", True
    document.recompute()
    assert not frep.isValid() and not found.isValid()
    assert [getattr(obj, "Triangles", getattr(obj, "Faces", 0)) for obj in made] == before
    assert all(obj.Mesh.CountFacets == obj.Triangles for obj in made[:-1]) and shape.Shape.isValid()
    frep.Expression = "r = 5\nsphere(r)"
    found.File = ball(tmp_path / "elsewhere.nrrd")
    document.recompute()
    assert all(obj.isValid() for obj in made), [obj.getStatusString() for obj in made]


def test_fifty_solids(document, tmp_path, monkeypatch):
    spheres = [add(document, frep_solid.FrepSolid, Expression=f"r = 5\nsphere(r) & box(9, 9, {5 + i % 5})",
                   VoxelSize=0.8) for i in range(20)]
    for i, sphere in enumerate(spheres):
        sphere.Placement.Base = FreeCAD.Vector(4 * i, 0, 0)
    boxes = [document.addObject("Part::Box", f"Box{i}") for i in range(5)]
    document.recompute(boxes)
    made = list(spheres)
    made += [add(document, scan.Scan, File=ball(tmp_path / f"ball{i}.nrrd")) for i in range(5)]
    made += [add(document, solid_from_object.SolidFromObject, Source=box, VoxelSize=0.8) for box in boxes]
    made += [add(document, combine.Combine, Operation=("Union", "Difference", "Intersection", "Blend")[i % 4],
                 Sources=spheres[i:i + 2], VoxelSize=0.8) for i in range(12)]
    made += [add(document, modify.Modify, Operation=("Offset", "Shell", "Mirror", "Transform")[i % 4],
                 Source=made[20 + i], VoxelSize=0.8) for i in range(8)]
    assert len(made) == 50
    changed = spheres[3].Name

    def timed(what):
        began = time.monotonic()
        result = what()
        return result, time.monotonic() - began

    times = {"computed": timed(document.recompute)[1]}
    assert all(obj.isValid() for obj in made), [obj.getStatusString() for obj in made if not obj.isValid()]
    times["saved"] = timed(lambda: document.saveAs(str(tmp_path / "fifty.FCStd")))[1]
    triangles = {obj.Name: obj.Triangles for obj in made}
    FreeCAD.closeDocument(document.Name)
    computed = []
    real = solids.meshes.to_freecad
    monkeypatch.setattr(solids.meshes, "to_freecad", lambda mesh: computed.append(1) or real(mesh))
    again, times["opened"] = timed(lambda: FreeCAD.openDocument(str(tmp_path / "fifty.FCStd")))
    assert not computed and all(again.getObject(name).Mesh.CountFacets == count for name, count in triangles.items())
    _, times["looked at anew, unchanged"] = timed(lambda: [obj.touch() for obj in again.Objects] and again.recompute())
    assert not computed
    again.getObject(changed).r = 4.8
    _, times["one changed"] = timed(again.recompute)
    assert len(computed) == 3, "it, and the two made of it"
    print("50 solids: " + ", ".join(f"{name} {seconds:.2f} s" for name, seconds in times.items()))
    assert times["opened"] < 3 and times["looked at anew, unchanged"] < 3
