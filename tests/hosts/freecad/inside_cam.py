"""Runs inside freecadcmd: CAM set-ups, operations, tools and programs as document objects."""

import json
import math
import os

import FreeCAD
import numpy as np
import pytest

from fieldfab_workbench import kernel, path_shim, tool_bits, ways, work, workflow
from fieldfab_workbench.objects import cam_job, cam_operation, cam_setup, cam_tool, frep_solid, machine_program
from fieldfab_workbench.objects import solid as solids

BITS = os.path.join(path_shim.folder(), "Tools", "Bit")
DOME = "sphere(r = 12) & box(40, 40, 16)"


def part(document, text=DOME, voxel=0.8, at=(0, 0, 0)):
    solid = solids.create(frep_solid.FrepSolid, document)
    solid.Expression, solid.VoxelSize = text, voxel
    solid.Placement.Base = FreeCAD.Vector(*at)
    document.recompute()
    return solid


def set_up(document, solid=None, operations=("rough",), machine="linuxcnc"):
    setup = cam_setup.create(document, solid or part(document))
    setup.Machine = machine
    cam_tool.add(setup, {"diameter": 4, "length": 40, "name": "4 mm end mill"})
    for kind in operations:
        operation = cam_operation.add(setup, kind)
        cell = next(s for s in workflow.settings_of(kind) if s.name == "cell")
        operation.Proxy.give(operation, cell, 0.4)
    document.recompute()
    return setup


def planned(setup):
    program = next(iter(cam_setup.programs_of(setup)), None) or machine_program.create(setup)
    setup.Document.recompute()
    return program


def setting(operation, name):
    return next(s for s in operation.Proxy.settings(operation) if s.name == name)


def give(operation, name, value):
    operation.Proxy.give(operation, setting(operation, name), value)


def test_a_program_is_that_of_the_same_job_from_the_command_line(document, tmp_path):
    """The same part, tool and settings in a job file, read by the kernel, give the same program."""
    setup = set_up(document)
    give(setup.Operations[0], "stepdown", 3.0)
    program = planned(setup)
    assert program.isValid(), program.getStatusString()
    (tmp_path / "part.frep").write_text(DOME)
    (tmp_path / "job.toml").write_text('name = "CAM job"\nmachine = "linuxcnc"\n[input]\nmodel = "part.frep"\n[stock]\n'
                                       'margin = 2\ntop = 1\n'
                                       '[[tool]]\nname = "4 mm end mill"\ndiameter = 4\nlength = 40\n'
                                       '[[operation]]\nname = "Rough"\ntype = "rough"\ncell = 0.4\nstepdown = 3\n')
    job = kernel.load().cam.Job(str(tmp_path / "job.toml"))
    job.run()
    job.save(str(tmp_path / "by_hand.ngc"))
    machine_program.write_machine_file(program, str(tmp_path / "ours.ngc"))
    assert (tmp_path / "ours.ngc").read_text() == (tmp_path / "by_hand.ngc").read_text()
    [(section, moves)] = machine_program.sections_of(program)
    assert section["name"] == "Rough" and (moves == job.moves[0]).all()
    assert (program.Seconds == pytest.approx(job.reports[0]["seconds"])
            and program.CutLength.Value == pytest.approx(job.reports[0]["cut"]))
    machine_program.write_setup_sheet(program, str(tmp_path / "sheet.html"))
    assert "4 mm end mill" in (tmp_path / "sheet.html").read_text()


def test_feeds_follow_the_cut_where_the_set_up_asks_for_it(document, tmp_path):
    setup = set_up(document)
    program = planned(setup)
    seconds, before = program.Seconds, machine_program.sections_of(program)[0][1]
    assert program.PlannedSeconds == seconds
    setup.AdjustFeeds = True
    document.recompute()
    assert program.isValid(), program.getStatusString()
    after = machine_program.sections_of(program)[0][1]
    assert program.PlannedSeconds == pytest.approx(seconds) and program.Seconds < 0.95 * seconds
    assert {tuple(each) for each in before[:, :3]} <= {tuple(each) for each in after[:, :3]}, "the same way"
    document.saveCopy(str(tmp_path / "feeds.FCStd"))
    again = FreeCAD.openDocument(str(tmp_path / "feeds.FCStd"), True)
    assert again.getObject(setup.Name).AdjustFeeds
    FreeCAD.closeDocument(again.Name)


@pytest.mark.parametrize("kind", workflow.operation_names())
def test_operations_have_the_properties_of_their_stages(document, kind):
    setup = cam_setup.create(document)
    operation = cam_operation.add(setup, kind)
    told = {s.name: s for s in workflow.settings_of(kind)}
    assert {"feed", "clearance", "plane"} <= set(told)
    assert ("cell" in told) == (kind != "face")  # which needs no samples of the part
    for s in told.values():
        assert operation.getTypeIdOfProperty(s.property) == s.property_type
        assert s.help.lower() in operation.getDocumentationOfProperty(s.property).lower()
        if s.choices:
            assert operation.getEnumerationsOfProperty(s.property) == s.choices
        if s.default is not None:
            assert (s.read(operation) == pytest.approx(s.default) if s.kind == "number"
                    else s.read(operation) == s.default)
    assert operation.Given == [] and operation.Proxy.given(operation) == {}


def test_only_what_matters_is_shown(document):
    operation = cam_operation.add(cam_setup.create(document), "finish")

    def shown(name):
        return "Hidden" not in operation.getEditorMode(name)

    assert shown("Stepover") and not shown("Lead") and not shown("RestLeast") and not shown("Alpha") and shown("Angle")
    operation.Lean, operation.Plane, operation.Pattern = True, "view", "spiral"
    assert shown("Lead") and shown("Alpha") and not shown("Steps") and not shown("Angle")
    operation.Type = "profile"
    assert not shown("Lead") and not shown("TabWidth") and not shown("Lean")
    operation.Tabs = 2
    assert shown("TabWidth")


def test_what_is_changed_is_given_and_the_rest_follows(document):
    setup = set_up(document)
    operation = setup.Operations[0]
    operation.Feed = "900 mm/min"
    operation.Stepover = 0.25
    assert operation.Proxy.given(operation) == {"cell": 0.4, "feed": pytest.approx(900), "stepover": 0.25}
    give(operation, "feed", None)
    assert "feed" not in operation.Proxy.given(operation) and operation.Feed.getValueAs("mm/min") == pytest.approx(600)
    setup.Tools[0].Feed = "750 mm/min"
    document.recompute()
    assert operation.Feed.getValueAs("mm/min") == pytest.approx(750), "the tool says so now"
    operation.setExpression("Stepdown", "Stepover * 10 mm")
    document.recompute()
    assert operation.Proxy.given(operation)["stepdown"] == pytest.approx(2.5)
    document.openTransaction("change")
    operation.Allowance = 1
    document.commitTransaction()
    document.undo()
    assert "allowance" not in operation.Proxy.given(operation)


def test_another_type_of_operation_is_undone_whole(document):
    operation = cam_operation.add(cam_setup.create(document), "finish")
    give(operation, "stepover", 0.3)
    operation.Lean, operation.Feed = True, "700 mm/min"
    before = operation.Proxy.given(operation)
    document.openTransaction("another type")
    operation.Type = "v_carve"
    document.commitTransaction()
    assert operation.Proxy.given(operation) == {"feed": pytest.approx(700)}, "a stepover in mm is another thing"
    document.undo()
    assert operation.Type == "finish" and operation.Lean and operation.Proxy.given(operation) == pytest.approx(before)
    for kind in ("rough", "finish"):
        operation.Type = kind
    assert operation.Proxy.given(operation) == pytest.approx(before), "what was given is there again"
    document.undo()
    document.redo()
    operation.Type = "v_carve"
    assert operation.Proxy.given(operation) == {"feed": pytest.approx(700)}


def test_values_that_cannot_be_are_told_with_the_setting(document):
    setup = set_up(document)
    operation = setup.Operations[0]
    operation.Stepdown = -1
    document.recompute()
    assert not operation.isValid() and "stepdown must be above 0" in operation.getStatusString()
    with pytest.raises(cam_job.JobError) as raised:
        cam_job.Job(setup)
    assert raised.value.object == operation.Name and raised.value.setting == "stepdown"
    operation.Stepdown = 2
    operation.Plane, operation.Beta = "view", 30
    with pytest.raises(cam_job.JobError) as raised:
        cam_job.Job(setup).plan()
    assert (raised.value.object == operation.Name and raised.value.setting == "plane"
            and "cannot tilt" in str(raised.value))


def test_a_failed_or_cancelled_plan_keeps_the_last_good_one(document, monkeypatch):
    setup = set_up(document)
    program = planned(setup)
    seconds, made = program.Seconds, program.MadeFrom
    assert seconds > 0
    give(setup.Operations[0], "bottom", 100.0)
    document.recompute()
    assert not program.isValid() and program.Seconds == seconds and len(machine_program.sections_of(program)) == 1

    def cancelled(function, title):
        raise work.Cancelled()

    give(setup.Operations[0], "bottom", None)
    give(setup.Operations[0], "stepdown", 3.0)
    monkeypatch.setattr(machine_program.work, "run", cancelled)
    document.recompute()
    assert not program.isValid() and "cancelled" in program.getStatusString() and program.MadeFrom == made
    monkeypatch.undo()
    setup.touch()
    document.recompute()
    assert program.isValid() and program.MadeFrom != made


def test_only_what_changed_is_planned(document, monkeypatch):
    setup = set_up(document)
    program = planned(setup)
    plans = []
    real = cam_job.Job.plan
    monkeypatch.setattr(cam_job.Job, "plan", lambda job, progress=None: plans.append(1) or real(job, progress))
    for touched in (setup, setup.Part, setup.Tools[0], program):
        touched.touch()
        document.recompute()
    assert not plans
    setup.Part.Placement.Base = FreeCAD.Vector(5, 0, 0)
    document.recompute()
    assert len(plans) == 1
    setup.Tools[0].Diameter = 5
    document.recompute()
    assert len(plans) == 2 and program.isValid()


def test_stock_and_zero_are_where_the_document_has_them(document):
    setup = set_up(document, part(document, at=(100, 50, 0)))
    box = document.addObject("Part::Box", "Block")
    box.Length, box.Width, box.Height = 40, 36, 20
    box.Placement.Base = FreeCAD.Vector(80, 34, -9)
    setup.Zero = "corner"
    for source in ("Object", "Box"):
        setup.StockFrom, setup.StockObject = source, box
        setup.StockLower, setup.StockUpper = FreeCAD.Vector(80, 34, -9), FreeCAD.Vector(120, 70, 11)
        document.recompute()
        plan = cam_job.Job(setup).plan()
        lower, upper = np.reshape(plan.stock, (2, 3)) + plan.zero
        assert np.allclose(lower, (80, 34, -9), atol=0.05) and np.allclose(upper, (120, 70, 11), atol=0.05)
        assert np.allclose(plan.zero, (88, 38, 8), atol=0.3), "the corner of the part's top"
        moves = plan.moves[0]
        cuts = moves[moves[:, 3] > 0, :3] + plan.zero
        assert cuts[:, 0].min() > 77 and cuts[:, 0].max() < 123
    low, high = cam_setup.stock_box(setup)
    assert tuple(low) == (80, 34, -9) and tuple(high) == (120, 70, 11)


def test_every_machine_can_be_chosen(document):
    setup = cam_setup.create(document, part(document))
    operation = cam_operation.add(setup, "profile")
    operation.Cell = 0.5
    for identifier in workflow.machines():
        setup.Machine = identifier
        for material in setup.getEnumerationsOfProperty("Material"):
            setup.Material = material
        told = workflow.machine(identifier)
        for s in told["settings"]:
            assert setup.getTypeIdOfProperty(s.property) == s.property_type
        fastest = told["max_feed"]
        assert not fastest or operation.Proxy.effective(operation)["feed"] <= fastest
    setup.Machine, setup.Zero = "epilog", "corner"
    setup.Material = "acrylic"
    assert setup.Power == 90
    setup.Power = 50
    with pytest.raises(cam_job.JobError, match="knows no places below 0"):
        cam_job.Job(setup).plan()
    setup.Xmin = setup.Ymin = 5
    plan = cam_job.Job(setup).plan()
    assert b"YP50;" in plan.program


def test_speeds_follow_from_the_chip_load_of_the_material(document):
    """Feed = spindle speed x edges x chip load; of the tool in the operation, until either has a value of its own."""
    setup = cam_setup.create(document, part(document))
    tool = cam_tool.add(setup, {"diameter": 6.35, "flutes": 2})
    operation = cam_operation.add(setup, "finish")
    before = operation.Proxy.effective(operation)
    setup.Material = "aluminium"
    values = operation.Proxy.effective(operation)
    assert abs(values["feed"] - values["spindle"] * 2 * 0.127) < 2 and values["feed"] != before["feed"]
    assert 120 <= values["spindle"] * math.pi * 6.35e-3 <= 250
    tool.Flutes = 1
    document.recompute()
    single = operation.Proxy.effective(operation)
    assert abs(single["feed"] - single["spindle"] * 0.127) < 2 and single["spindle"] >= values["spindle"]
    tool.Spindle = 8000
    document.recompute()
    assert operation.Proxy.effective(operation)["feed"] == int(8000 * 0.127)
    operation.Cell = 0.5
    [moves] = cam_job.Job(setup).plan().moves
    assert moves[:, 3].max() == int(8000 * 0.127)


def test_tool_bits_of_freecad(document):
    tools = {name: tool_bits.read_bit(os.path.join(BITS, f"{name}.fctb"))
             for name in ("5mm_Endmill", "6mm_Ball_End", "6mm_Bullnose", "60degree_Vbit", "5mm_Drill",
                          "45degree_chamfer")}
    assert tools["5mm_Endmill"] == {"name": "5mm Endmill", "shape": "flat", "diameter": 5, "length": 50, "shank": 3,
                                    "flute": 30, "flutes": 2}
    assert (tools["6mm_Bullnose"]["corner_radius"] == 1.5 and tools["60degree_Vbit"]["angle"] == 60
            and tools["5mm_Drill"]["angle"] == 119)
    found, notes = tool_bits.read(os.path.join(BITS, "..", "Library", "Default.fctl"))
    assert len(found) >= 6 and [t["number"] for t in found][:3] == [1, 2, 3]
    assert any("probe" in note for note in notes)
    setup = cam_setup.create(document)
    for tool in found:
        made = cam_tool.add(setup, tool)
        told = cam_tool.values_of(made)
        assert ({name: told[name] for name in tool if name in told}
                == {name: value for name, value in tool.items() if name in told})
    assert [t.Number for t in setup.Tools] == [t["number"] for t in found]
    with pytest.raises(ValueError, match="no tool bit"):
        path = os.path.join(os.environ["HOME"], "broken.fctb")
        with open(path, "w") as file:
            json.dump({"version": 2}, file)
        tool_bits.read(path)


def test_a_saved_document_opens_with_its_program(document, tmp_path, monkeypatch):
    setup = set_up(document, operations=("rough", "finish"))
    program = planned(setup)
    kept = [(section, moves.copy()) for section, moves in machine_program.sections_of(program)]
    path = str(tmp_path / "saved.FCStd")
    document.saveCopy(path)
    monkeypatch.setattr(cam_job.Job, "plan", lambda *a: pytest.fail("opening plans nothing"))
    again = FreeCAD.openDocument(path)
    try:
        other = again.getObject(program.Name)
        assert other.Seconds == program.Seconds and other.Setup.Operations[1].Type == "finish"
        for (section, moves), (old_section, old_moves) in zip(machine_program.sections_of(other), kept):
            assert section == old_section and (moves == old_moves).all()
        assert other.Setup.Operations[0].Given == setup.Operations[0].Given
        assert not any("Touched" in obj.State for obj in again.Objects)
        again.recompute()
        assert other.isValid()
    finally:
        FreeCAD.closeDocument(again.Name)


def test_ways_follow_arcs():
    """Two quarter circles about (0, 0), against the closed form; rapids and cuts are separate."""
    k = np.tan(np.pi / 8)
    moves = np.array([[10, 0, 0, 0, 0], [0, 10, 0, 600, k], [-10, 0, 1, 600, k], [-10, 0, 5, 0, 0], [20, 0, 5, 0, 0],
                      [20, 5, 5, 600, 0]], float)
    points, rapid = ways.points_of(moves)
    cuts, counts = ways.runs(points, rapid, False)
    arc = cuts[: counts[0]]
    assert (len(counts) == 2 and counts[1] == 2 and np.allclose(np.hypot(arc[:, 0], arc[:, 1]), 10)
            and arc[:, 1].min() > -1e-6)
    assert np.hypot(*np.diff(arc[:, :2], axis=0).T).max() < 10 * ways.CHORD * 1.01
    jumps, counts = ways.runs(points, rapid, True)
    assert np.allclose(jumps[-3:], [[-10, 0, 1], [-10, 0, 5], [20, 0, 5]]) and counts.sum() == len(jumps)
