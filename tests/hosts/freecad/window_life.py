"""Runs inside FreeCAD's window: every kind of object through save, close, open, undo, redo, copy and deletion.
FreeCAD's report view stays empty."""

import pathlib

import FreeCAD
import FreeCADGui
import numpy as np
import pytest
from window import live, wait

from fieldfab_workbench import kernel, scripts
from fieldfab_workbench.objects import (cam_operation, cam_setup, cam_tool, combine, document_object, file_part,
                                        frep_solid, machine_program, modify, openscad_node,
                                        part_shape, path_of_program, scan, script_solid, simulation, solid_from_object)
from fieldfab_workbench.objects import solid as solids
from fieldfab_workbench.shim import QtWidgets

PROGRAM = "G21 G90 G17\nT1 M6\nS5000 M3\nG0 X-12 Y-12 Z5\nG1 Z-2 F300\nG1 X12 F900\nG0 Z5\nM2\n"


def add(document, kind, **values):
    obj = solids.create(kind, document)
    for name, value in values.items():
        setattr(obj, name, value)
    return obj


def frep(document, text="r_side = 12\nbox(r_side, r_side, 6)"):
    return add(document, frep_solid.FrepSolid, Expression=text, VoxelSize=1)


def set_up(document):
    part = frep(document)
    document.recompute()
    setup = cam_setup.create(document, part)
    cam_tool.add(setup, {"diameter": 4, "length": 40})
    operation = cam_operation.add(setup, "rough")
    operation.Cell = 0.5
    return setup


def planned(document):
    setup = set_up(document)
    program = machine_program.create(setup)
    document.recompute()
    return program


def a_scan(document, folder):
    at = (np.arange(24) - 11.5) * 0.5
    z, y, x = np.meshgrid(at, at, at, indexing="ij")
    path = folder / "ball.nrrd"
    kernel.load().Volume(np.clip(128 + 100 * (4 - np.sqrt(x * x + y * y + z * z)), 0, 255).astype("f4"),
                         spacing=(0.5, 0.5, 0.5)).save(path)
    return add(document, scan.Scan, File=str(path))


def a_part_of_a_file(document, folder):
    (folder / "two.frep").write_text('part(box(4, 4, 4), "a")\npart(sphere(r = 3), "b")')
    return add(document, file_part.FilePart, File=str(folder / "two.frep"), Part="a", VoxelSize=0.5)


def simulated_file(document, folder):
    (folder / "part.ngc").write_text(PROGRAM)
    return add(document, simulation.Simulation, ProgramFile=str(folder / "part.ngc"),
               StockLower=FreeCAD.Vector(-15, -15, -5), StockUpper=FreeCAD.Vector(15, 15, 0),
               Cell=0.5)


def simulated_plan(document, folder):
    return add(document, simulation.Simulation, Program=planned(document), Cell=0.5)


def of_source(kind, **values):
    return lambda document, folder: add(document, kind, Source=frep(document), VoxelSize=1, **values)


def by_script(document, folder):
    scripts.agree(document)
    return add(document, script_solid.ScriptSolid, Script="from fieldfab.shapes import *\nr = 4\nsolid = sphere(r)\n",
               VoxelSize=1)


KINDS = {
    "FrepSolid": lambda document, folder: frep(document),
    "ScriptSolid": by_script,
    "Scan": a_scan,
    "SolidFromObject": of_source(solid_from_object.SolidFromObject),
    "Combine": lambda document, folder: add(document, combine.Combine, Operation="Difference",
                                            Sources=[frep(document), frep(document, "sphere(r = 4)")], VoxelSize=1),
    "Modify": of_source(modify.Modify, Operation="Offset", Distance=1),
    "PartShape": lambda document, folder: part_shape.create(document, frep(document)),
    "FilePart": a_part_of_a_file,
    "OpenScadNode": lambda document, folder: add(document, openscad_node.OpenScadNode, Node="cube"),
    "OpenScadText": lambda document, folder: add(document, openscad_node.OpenScadText,
                                                 Text="cube(size = [3, 4, 5], center = false);"),
    "Simulation": simulated_file,
    "Simulation of a plan": simulated_plan,
    "CamSetup": lambda document, folder: set_up(document),
    "CamTool": lambda document, folder: set_up(document).Tools[0],
    "CamOperation": lambda document, folder: set_up(document).Operations[0],
    "MachineProgram": lambda document, folder: planned(document),
    "PathOfProgram": lambda document, folder: path_of_program.create_all(planned(document))[0],
}


@pytest.fixture
def report():
    """Returns a function that returns new messages of FreeCAD's report view since its last call."""
    FreeCADGui.activateWorkbench("FieldfabWorkbench")
    dock = FreeCADGui.getMainWindow().findChild(QtWidgets.QDockWidget, "Report view")
    text = dock.findChild(QtWidgets.QTextEdit)

    def told():
        live(0.1)
        words = text.toPlainText().strip()
        text.clear()
        return words

    told()
    yield told
    for name in FreeCAD.listDocuments():
        FreeCAD.closeDocument(name)


def test_every_kind_is_here():
    def names(kind):
        return {name for each in kind.__subclasses__()
                for name in names(each) | ({each.NAME} if "NAME" in vars(each) else set())}

    abstract = {"Solid"}
    assert names(document_object.DocumentObject) - abstract <= set(KINDS)


def figures(document):
    """Returns figures for the comparison of a document's objects."""
    def plain(obj, name):
        value = getattr(obj, name)
        if hasattr(value, "CountFacets"):
            return value.CountFacets
        if hasattr(value, "Faces"):
            return len(value.Faces)
        if hasattr(value, "toGCode"):
            return value.toGCode()
        if isinstance(value, list):
            return [getattr(each, "Name", each) for each in value]
        return f"{value:.9g}" if isinstance(value, float) else getattr(value, "Name", str(value))

    return {obj.Name: {name: plain(obj, name) for name in obj.PropertiesList
                       if name not in ("Proxy", "ExpressionEngine") and not name.startswith("_")}  # FreeCAD's own
            for obj in document.Objects}


def same(document, first):
    """Whether all objects are unchanged; prints differences."""
    now = figures(document)
    different = [(obj, name, now[obj].get(name), value) for obj in now if obj in first
                 for name, value in first[obj].items() if now[obj].get(name) != value]
    print(different, set(now) ^ set(first))
    return not different and set(now) == set(first)


@pytest.mark.parametrize("kind", KINDS)
def test_a_life_without_a_line_in_the_report_view(kind, report, tmp_path):
    document = FreeCAD.newDocument()
    document.UndoMode = 1
    document.openTransaction("Make")
    obj = KINDS[kind](document, tmp_path)
    document.recompute()
    document.commitTransaction()
    name = obj.Name
    assert all(each.isValid() for each in document.Objects), [each.getStatusString() for each in document.Objects]
    assert report() == "", "making"
    path = str(pathlib.Path(tmp_path) / "life.FCStd")
    document.saveAs(path)
    first = figures(document)
    assert report() == "", "saving"
    document.undo()
    assert not document.Objects and report() == "", "undo of all"
    document.redo()
    document.recompute()
    assert same(document, first) and report() == "", "redo of all"
    FreeCAD.closeDocument(document.Name)
    assert report() == "", "closing"

    document = FreeCAD.openDocument(path)
    document.UndoMode = 1
    live(0.2)
    assert report() == "", "opening"
    assert same(document, first)
    document.recompute()
    assert same(document, first) and report() == "", "a recompute of what has not changed"

    obj = document.getObject(name)
    document.openTransaction("Name")
    obj.Label = "Another name"
    document.recompute()
    document.commitTransaction()
    document.undo()
    document.recompute()
    assert same(document, first) and report() == "", "undo"
    document.redo()
    document.undo()
    assert report() == "", "redo"

    document.openTransaction("Copy")
    copied = document.copyObject(obj, True)
    copied = copied if hasattr(copied, "Name") else copied[-1]
    document.recompute()
    document.commitTransaction()
    assert report() == "", "copying"
    assert (copied.isValid() and type(copied.Proxy) is type(obj.Proxy)
            and type(copied.ViewObject.Proxy) is type(obj.ViewObject.Proxy))
    document.undo()
    document.recompute()
    assert set(figures(document)) == set(first) and report() == "", "undo of a copy"

    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(document.getObject(name))
    users = [each for each in document.getObject(name).InList]
    if not users:  # for others FreeCAD asks
        FreeCADGui.runCommand("Std_Delete")
        wait(lambda: document.getObject(name) is None, what="it to go")
        document.recompute()
        assert report() == "", "deleting"
        document.undo()
        document.recompute()
        assert same(document, first) and report() == "", "undo of deleting"
    document.openTransaction("Remove")
    document.removeObject(name)
    document.commitTransaction()
    assert report() == "", "removing"
    document.undo()
    assert set(figures(document)) == set(first) and report() == "", "undo of removing"
    FreeCAD.closeDocument(document.Name)
    assert report() == "", "closing again"
