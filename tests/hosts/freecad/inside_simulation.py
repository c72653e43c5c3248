"""Runs inside freecadcmd: simulations as document objects."""

import json
import os

import FreeCAD
import pytest

from fieldfab_workbench import path_shim, work
from fieldfab_workbench.objects import combine, frep_solid, programs, set_ups, simulation
from fieldfab_workbench.objects import solid as solids

# A slot of 6 x 40 mm and 2 mm deep; then a rapid through the remaining stock and beyond the machine's limit.
SLOT = """G21 G90 G17
T1 M6
S5000 M3
G0 X-25 Y0 Z5
G1 Z-2 F300
G1 X25
G0 Z5
"""
CRASH = "G0 X-10 Y15\nG0 Z-3\nG0 Z20\nM2\n"
BLOCK = 40 * 30 * 10
TOOL = {"number": 1, "shape": "flat", "diameter": 6, "flute": 12, "length": 30, "shank": 6, "holder_diameter": 20,
        "holder_length": 20}


@pytest.fixture
def slot(tmp_path):
    path = tmp_path / "slot.ngc"
    path.write_text(SLOT + "M2\n")
    return str(path)


def simulated(document, program, recompute=True, **values):
    obj = solids.create(simulation.Simulation, document)
    obj.ProgramFile, obj.Tools, obj.Cell = program, [set_ups.tool_to_line(TOOL)], 0.25
    obj.StockLower, obj.StockUpper = FreeCAD.Vector(-20, -10, -10), FreeCAD.Vector(20, 20, 0)
    for name, value in values.items():
        setattr(obj, name, value)
    if recompute:
        document.recompute()
    return obj


def test_a_slot_is_cut_and_told(document, slot):
    obj = simulated(document, slot)
    assert obj.isValid(), obj.getStatusString()
    assert obj.Verdict == "good" and not obj.Events
    assert obj.Removed.Value == pytest.approx(480, rel=0.05)  # by number of samples
    assert obj.Volume.Value == pytest.approx(BLOCK - 480, rel=1e-4)
    assert obj.Mesh.isSolid() and obj.Mesh.CountFacets == obj.Triangles
    assert obj.Seconds > obj.RapidSeconds > 0 and obj.AirShare == round(100 * 7 / 57)
    assert {obj.Mesh.BoundBox.ZMin, obj.Mesh.BoundBox.ZMax} == {-10, 0}


def test_events_are_saved_worst_first_and_opening_computes_nothing(document, slot, tmp_path, monkeypatch):
    with open(slot, "w") as file:
        file.write(SLOT + CRASH)
    target = solids.create(frep_solid.FrepSolid, document)
    target.Expression, target.VoxelSize = "move(box(40, 30, 10), 0, 5, -5)", 1
    document.recompute()
    obj = simulated(document, slot, Target=target, MoreOfSetup="[limits]\nx = [-30, 24]")
    assert obj.isValid(), obj.getStatusString()
    events = [json.loads(line) for line in obj.Events]
    assert ([e["kind"] for e in events][:2] == ["rapid contact", "over-travel"] and events[0]["line"] == 9
            and events[1]["line"] == 6)
    assert obj.Contacts == 1 and obj.OverTravels == 2 and obj.Gouges >= 1 and "rapid contact at line 9" in obj.Verdict
    assert obj.DeepestGouge.Value > 1.5 and {"gouge"} == {e["kind"] for e in events[3:]}
    path = str(tmp_path / "saved.FCStd")
    document.saveCopy(path)
    computed = []
    monkeypatch.setattr(simulation.Task, "run", lambda *a: computed.append(1))
    again = FreeCAD.openDocument(path)
    try:
        other = again.getObject(obj.Name)
        assert (not computed and list(other.Events) == list(obj.Events) and other.Mesh.CountFacets == obj.Triangles
                and other.Verdict == obj.Verdict)
        other.touch()
        again.recompute()
        assert not computed and other.isValid(), "nothing has changed"
    finally:
        FreeCAD.closeDocument(again.Name)


def test_what_is_left_is_a_solid_and_the_next_stock(document, slot, tmp_path):
    first = simulated(document, slot, Cell=0.5)
    pin = solids.create(frep_solid.FrepSolid, document)
    pin.Expression, pin.VoxelSize = "box(4, 4, 30)", 0.5
    both = solids.create(combine.Combine, document)
    both.Operation, both.Sources, both.VoxelSize = "Difference", [first, pin], 0.5
    document.recompute()
    assert both.isValid() and both.Volume.Value == pytest.approx(first.Volume.Value - 16 * 8, rel=0.01)
    across = tmp_path / "across.ngc"
    across.write_text(SLOT.replace("X-25 Y0", "X0 Y-15").replace("G1 X25", "G1 Y25") + "M2\n")
    second = simulated(document, str(across), Stock=first, Cell=0.5)
    assert second.isValid(), second.getStatusString()
    # Edges are accurate to a cell.
    assert second.Volume.Value == pytest.approx(first.Volume.Value - (2 * 6 * 30 - 2 * 36), rel=5e-3)


def test_recompute_only_where_the_program_or_its_set_up_changed(document, slot, monkeypatch):
    obj = simulated(document, slot)
    ran, real = [], simulation.Run
    monkeypatch.setattr(simulation, "Run", lambda *a: ran.append(1) or real(*a))
    obj.touch()
    obj.Label = "other"
    document.recompute()
    assert not ran
    with open(slot, "w") as file:
        file.write(SLOT.replace("Z-2", "Z-4") + "M2\n")
    obj.touch()
    document.recompute()
    assert len(ran) == 1 and obj.Volume.Value == pytest.approx(BLOCK - 960, rel=1e-4)
    obj.Cell = 0.5
    document.recompute()
    assert len(ran) == 2


def test_failures_keep_the_last_result(document, slot, monkeypatch):
    obj = simulated(document, slot)
    volume, triangles = obj.Volume.Value, obj.Triangles
    with open(slot, "w") as file:
        file.write(SLOT + "G1 X(5\n")
    obj.touch()
    document.recompute()
    assert (not obj.isValid() and "slot.ngc:8" in obj.getStatusString() and obj.Mesh.CountFacets == triangles
            and obj.Volume.Value == volume)
    os.remove(slot)
    obj.touch()
    document.recompute()
    assert not obj.isValid() and "cannot be read" in obj.getStatusString() and obj.Mesh.CountFacets == triangles
    with open(slot, "w") as file:
        file.write(SLOT.replace("Z-2", "Z-3") + "M2\n")

    def cancelled(function, title):
        raise work.Cancelled()

    monkeypatch.setattr(simulation.work, "run", cancelled)
    obj.touch()
    document.recompute()
    assert not obj.isValid() and "cancelled" in obj.getStatusString() and obj.Mesh.CountFacets == triangles
    monkeypatch.undo()
    obj.touch()
    document.recompute()
    assert obj.isValid() and obj.Volume.Value == pytest.approx(BLOCK - 720, rel=1e-4)
    for values, words in (({"Tools": ["flat 6"]}, "a tool has the form"), ({"Tools": ['{"size": 3}']}, "no 'size'"),
                          ({"Tools": [], "StockUpper": obj.StockLower}, "no size"),
                          ({"ProgramFile": ""}, "choose a program")):
        for name, value in values.items():
            setattr(obj, name, value)
        document.recompute()
        assert not obj.isValid() and words in obj.getStatusString()


def test_set_up_files_count_before_properties(document, slot, tmp_path):
    path = tmp_path / "set_up.toml"
    path.write_text(set_ups.text([{**TOOL, "diameter": 10}], (-20, -10, -10), (20, 20, 0)))
    obj = simulated(document, slot, SetupFile=str(path))
    assert obj.isValid(), obj.getStatusString()
    assert obj.Volume.Value == pytest.approx(BLOCK - 800, rel=1e-4) and "Hidden" in obj.getEditorMode("Tools")


def test_programs_of_other_objects(document, slot):
    import Path

    # Stands for a machine program of the CAM set-up, with files.
    other = document.addObject("App::FeaturePython", "MachineProgram")
    other.addProperty("App::PropertyFile", "ProgramFile")
    other.ProgramFile = slot
    assert programs.offers_program(other)
    obj = simulated(document, "", Program=other)
    assert obj.isValid(), obj.getStatusString()
    assert obj.Volume.Value == pytest.approx(BLOCK - 480, rel=1e-4)
    # FreeCAD's own paths: feeds in mm/s.
    path = document.addObject("Path::Feature", "Slot")
    path.Path = Path.Path([Path.Command(c)
                           for c in ("M6 T1", "M3 S5000", "G0 X-25 Y0 Z5", "G1 Z-2 F5", "G1 X25 F5", "G0 Z5")])
    text = programs.program_of(path).text.decode()
    assert "F300" in text and programs.extent(programs.program_of(path)) == ((-25, 0, -2), (25, 0, 5))
    obj.Program = path
    document.recompute()
    assert obj.isValid(), obj.getStatusString()
    assert (obj.Volume.Value == pytest.approx(BLOCK - 480, rel=1e-4)
            and obj.Seconds == pytest.approx((50 + 7) / 5, rel=0.3))


def test_freecads_own_jobs(document):
    part = document.addObject("Part::Box", "Part")
    part.Length, part.Width, part.Height = 40, 30, 10
    document.recompute()
    job = path_shim.jobs().Create("Job", [part], None)
    tool = job.Tools.Group[0]
    tool.Tool.Diameter, tool.HorizFeed, tool.VertFeed = 6, 10, 5
    slot = path_shim.operation("Custom").Create("Custom")
    slot.ToolController = tool
    slot.Gcode = ["G0 X-5 Y15 Z20", "G1 Z8 F5", "G1 X45 F10", "G0 Z20"]
    document.recompute()
    assert programs.is_job(job) and programs.offers_program(job) and programs.offers_program(slot)
    text = programs.program_of(job).text.decode()
    assert "M6 T1" in text and "F600" in text and text.index("M6") < text.index("X-5")
    tools = programs.tools_of(job)
    assert tools[0]["diameter"] == 6 and tools[0]["shape"] == "flat" and tools == programs.tools_of(slot)
    box = simulation.bounds_of(job.Stock)
    obj = simulated(document, "", Program=job, Tools=[set_ups.tool_to_line(t) for t in tools],
                    StockLower=FreeCAD.Vector(box.XMin, box.YMin, box.ZMin),
                    StockUpper=FreeCAD.Vector(box.XMax, box.YMax, box.ZMax), Target=part, Gouge=0.1)
    assert obj.isValid(), obj.getStatusString()
    cut = box.XLength * 6 * (box.ZMax - 8)
    assert box.XLength * box.YLength * box.ZLength - obj.Volume.Value == pytest.approx(cut, rel=0.02)
    assert (obj.Gouges == 1 and obj.DeepestGouge.Value == pytest.approx(2, abs=0.05)
            and json.loads(obj.Events[-1])["kind"] == "gouge")
