"""Runs inside FreeCAD's window: an error and a cancellation each give the user one line."""

import FreeCAD
import pytest
from panels import frep
from window_life import report

from fieldfab_workbench import work
from fieldfab_workbench.objects import (cam_operation, cam_setup, cam_tool, combine, file_part, frep_solid,
                                        machine_program, modify, openscad_node, part_shape, scan,
                                        simulation, solid_from_object)
from fieldfab_workbench.objects import solid as solids


def add(document, kind, **values):
    obj = solids.create(kind, document)
    for name, value in values.items():
        setattr(obj, name, value)
    return obj


def wrong_operation(document):
    setup = cam_setup.create(document, frep(document, "box(9, 9, 9)", 1))
    cam_tool.add(setup)
    operation = cam_operation.add(setup, "rough")
    operation.Stepdown = -1
    return operation


def wrong_tool(document):
    tool = cam_tool.add(cam_setup.create(document))
    tool.Diameter = 0
    return tool


def no_shape(document):
    shape = part_shape.create(document, frep(document, "box(9, 9, 9)", 1))
    shape.Source = None
    return shape


# FreeCAD 1.x writes the error of an object twice: as the exception, and with the object's name.
LINES = 1 if FreeCAD.Version()[0] == "0" else 2
MISTAKES = {
    "a text that is none": lambda d: add(d, frep_solid.FrepSolid, Expression="sphere(r ="),
    "one source only": lambda d: add(d, combine.Combine),
    "no source": lambda d: add(d, modify.Modify),
    "nothing to copy": lambda d: add(d, solid_from_object.SolidFromObject),
    "no file": lambda d: add(d, scan.Scan, File="/nowhere/at/all.nrrd"),
    "no model": lambda d: add(d, file_part.FilePart, File="/nowhere/at/all.frep"),
    "no shape": no_shape,
    "no node": lambda d: add(d, openscad_node.OpenScadText, Text="cube("),
    "no program": lambda d: add(d, simulation.Simulation),
    "no program there": lambda d: add(d, simulation.Simulation, ProgramFile="/nowhere/at/all.ngc"),
    "nothing to plan": lambda d: machine_program.create(cam_setup.create(d)),
    "a wrong setting": wrong_operation,
    "a tool without a size": wrong_tool,
}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_mistake_is_a_line(mistake, report):
    document = FreeCAD.newDocument()
    obj = MISTAKES[mistake](document)
    document.recompute()
    assert not obj.isValid()
    # without FreeCAD's own line
    said = [line for line in report().splitlines() if "Recompute failed! Please check report view." not in line]
    assert "Fieldfab: " in said[0] and all(obj.getStatusString().splitlines()[0] in line for line in said), said
    assert len(said) == LINES, said


def test_a_cancel_is_a_line(report, monkeypatch):
    document = FreeCAD.newDocument()
    add(document, frep_solid.FrepSolid, Expression="sphere(r = 5)")

    def stopped(*_):
        raise work.Cancelled()

    monkeypatch.setattr(work, "run", stopped)
    document.recompute()
    said = [line for line in report().splitlines() if "Please check" not in line]
    assert len(said) == LINES and all("FrepSolid: cancelled; it is unchanged" in line for line in said), said


def test_a_python_error_of_ours_keeps_its_traceback(report):
    """The traceback is needed to fix it."""
    document = FreeCAD.newDocument()
    obj = add(document, frep_solid.FrepSolid)
    obj.Proxy.mesh_settings = lambda obj: 1 / 0
    document.recompute()
    assert "Traceback" in report()
