"""Runs inside freecadcmd: machine programs as paths of FreeCAD's own Path workbench, and its jobs for our simulator."""

import math
import re

import FreeCAD
import numpy as np
import Part
import Path
import pytest

from fieldfab_workbench import kernel, path_jobs, path_shim, tool_bits
from fieldfab_workbench.objects import (
    cam_operation, cam_setup, cam_tool, frep_solid, machine_program, path_of_program, programs,
)
from fieldfab_workbench.objects import solid as solids


def programmed(document, text, operations, machine="linuxcnc", tool=None, at=(0, 0, 0), zero="corner", **given):
    solid = solids.create(frep_solid.FrepSolid, document)
    solid.Expression, solid.VoxelSize = text, 0.8
    solid.Placement.Base = FreeCAD.Vector(*at)
    document.recompute()
    setup = cam_setup.create(document, solid)
    setup.Machine, setup.Zero = machine, zero
    cam_tool.add(setup, tool or {"diameter": 4, "length": 40, "flute": 20, "name": "4 mm end mill"})
    for kind in operations:
        operation = cam_operation.add(setup, kind)
        operation.Cell = 0.4
        for name, value in given.items():
            setattr(operation, name, value)
    program = machine_program.create(setup)
    document.recompute()
    assert program.isValid(), program.getStatusString()
    return program


def positions(text):
    """Returns X, Y, Z after each move of a G-code text in millimetres."""
    now, found = {"X": math.nan, "Y": math.nan, "Z": math.nan}, []
    for line in text.splitlines():
        if re.match(r"(?:N\d+ )?G0?[0123] ", line):
            now.update({axis: float(value) for axis, value in re.findall(r"([XYZ])([-\d.]+)", line)})
            found.append(tuple(now.values()))
    return np.array(found)


def exported(job, folder):
    """Returns the output of FreeCAD's LinuxCNC post-processor for a job."""
    path = str(folder / "posted.ngc")
    listed = []
    for operation in job.Operations.Group:
        if operation.ToolController not in listed:
            listed.append(operation.ToolController)
        listed.append(operation)
    text = path_shim.post("linuxcnc").export(listed, path, "--no-show-editor --precision=5 --no-header")
    return text or open(path).read()


def test_paths_are_the_program_where_the_part_is(document):
    program = programmed(document, "sphere(r = 12) & box(40, 40, 16)", ("rough", "profile"), at=(100, 50, 0))
    paths = path_of_program.create_all(program)
    document.recompute()
    assert len(paths) == 2
    for path, (section, moves) in zip(paths, machine_program.sections_of(program)):
        assert path.isValid() and path.Label.startswith(section["name"])
        told = np.array([[c.Parameters[axis] for axis in "XYZ"] for c in path.Path.Commands[1:]])
        assert np.allclose(told, moves[:, :3] + np.array(program.Zero), atol=1e-5)
        assert [c.Name == "G0" for c in path.Path.Commands[1:]] == [feed == 0 for feed in moves[:, 3]]
        feeds = {round(c.Parameters["F"] * 60) for c in path.Path.Commands if "F" in c.Parameters}
        assert feeds == {round(feed) for feed in moves[:, 3] if feed}, "FreeCAD counts mm/s"
        bent = np.flatnonzero(moves[:, 4])
        for i in bent[:: max(1, len(bent) // 50)]:
            command, begin = path.Path.Commands[i + 1], moves[i - 1, :2]
            centre = begin + (command.Parameters["I"], command.Parameters["J"])
            radius = math.dist(begin, centre)
            assert math.dist(moves[i, :2], centre) == pytest.approx(radius, abs=1e-4)
            turn = 4 * math.atan(moves[i, 4])
            assert (command.Name == ("G3" if turn > 0 else "G2")
                    and math.dist(begin, moves[i, :2]) == pytest.approx(2 * radius * abs(math.sin(turn / 2)), abs=1e-4))
    assert any((moves[:, 4] != 0).any() for section, moves in machine_program.sections_of(program)), "there are arcs"


def test_freecads_job_post_and_simulator_take_them(document, tmp_path):
    program = programmed(document, "sphere(r = 12) & box(40, 40, 16)", ("rough",), at=(20, 20, 0))
    job, paths = path_jobs.to_job(program)
    document.recompute()
    assert path_shim.is_job(job) and job.Operations.Group == paths and [t.ToolNumber for t in job.Tools.Group] == [1]
    lower, upper = cam_setup.stock_box(program.Setup)
    box = job.Stock.Shape.BoundBox
    assert np.allclose((box.XMin, box.YMin, box.ZMax), (lower.x, lower.y, upper.z), atol=1e-6)
    controller = paths[0].ToolController
    assert controller.Tool.Diameter.Value == 4 and controller.SpindleSpeed == 10000
    text = exported(job, tmp_path)
    assert "M6 T1" in text.replace("M06", "M6") and re.search(r"^F|F600", text, re.MULTILINE)
    [(section, moves)] = machine_program.sections_of(program)
    ours = moves[:, :3] + np.array(program.Zero)
    posted = positions(text)
    distinct = lambda rows: rows[np.r_[True, (np.abs(np.diff(rows, axis=0)) > 2e-5).any(axis=1)]]
    assert np.allclose(distinct(posted[1:]), distinct(np.round(ours, 5)), atol=2e-5)
    # FreeCAD's simulator leaves the dome with its allowance. The frame of 2 mm around it is removed; material less than
    # a level above the dome remains.
    import PathSimulator

    simulator = PathSimulator.PathSim()
    simulator.BeginSimulation(job.Stock.Shape, 0.5)
    simulator.SetToolShape(controller.Tool.Shape, 0.5)
    place = FreeCAD.Placement(FreeCAD.Vector(ours[0, 0], ours[0, 1], ours[0, 2]), FreeCAD.Rotation())
    for command in paths[0].Path.Commands:
        place = simulator.ApplyCommand(place, command)
    left = simulator.GetResultMesh()[0].BoundBox
    assert left.ZMax == pytest.approx(upper.z, abs=1e-3)
    assert np.allclose((left.XMin, left.XMax, left.YMin, left.YMax), (7.7, 32.3, 7.7, 32.3), atol=0.6)


def test_a_part_of_freecads_is_the_jobs_own_model(document):
    box = document.addObject("Part::Box", "Box")
    setup = cam_setup.create(document, box)
    cam_tool.add(setup, {"shape": "ball", "diameter": 6, "length": 50})
    cam_operation.add(setup, "profile").Cell = 0.5
    program = machine_program.create(setup)
    document.recompute()
    job, paths = path_jobs.to_job(program)
    document.recompute()
    assert not document.findObjects(Label="Block.*") and [clone.Objects for clone in job.Model.Group] == [[box]]
    assert tool_bits.shape_of(paths[0].ToolController.Tool) == "ballend" and paths[0].isValid()
    more = path_jobs.to_job(program, job)[1]
    assert (len(job.Operations.Group) == 2 and len(job.Tools.Group) == 1
            and more[0].ToolController == paths[0].ToolController)


def test_a_bull_nose_keeps_its_corner(document):
    setup = cam_setup.create(document, document.addObject("Part::Box", "Box"))
    cam_tool.add(setup, {"shape": "bull", "diameter": 6, "corner_radius": 1, "length": 50})
    cam_operation.add(setup, "profile").Cell = 0.5
    program = machine_program.create(setup)
    document.recompute()
    job, [path] = path_jobs.to_job(program)
    [tool] = programs.tools_of(job)
    assert (tool["number"], tool["shape"], tool["diameter"]) == (1, "bull", 6)
    assert tool["corner_radius"] == pytest.approx(1)
    assert tool_bits.of_object(path.ToolController.Tool)["corner_radius"] == pytest.approx(1)


def test_freecads_dress_ups_take_them_and_are_simulated(document, tmp_path):
    ramps = path_shim.first("PathScripts.PathDressupRampEntry", "Path.Dressup.Gui.RampEntry")
    program = programmed(document, "sphere(r = 12) & box(40, 40, 6)", ("profile",),
                         tool={"diameter": 4, "length": 40, "feed": 600, "plunge": 200})
    job, [path] = path_jobs.to_job(program)
    document.recompute()
    dressed = document.addObject("Path::FeaturePython", "RampEntryDressup")
    dressed.Proxy = ramps.ObjectDressup(dressed)
    job.Proxy.addOperation(dressed, path, True)
    dressed.Base = path
    dressed.Proxy.setup(dressed)
    document.recompute()

    def plunges(commands):
        """Returns the vertical cuts."""
        return [c for c in commands if c.Name == "G1" and set(c.Parameters) <= {"Z", "F"}]

    told = [c for c in path.Path.Commands if c.Name == "G1"]
    assert (dressed.isValid() and job.Operations.Group == [dressed]
            and len(dressed.Path.Commands) != len(path.Path.Commands) and told)
    text, setup = path_jobs.program_of_job(job)
    assert "(RampEntryDressup)" in text and text.count("M6 T1") == 1 and not plunges(dressed.Path.Commands)
    (tmp_path / "job.ngc").write_text(text)
    simulation = kernel.load().stock.Simulation(setup.write(str(tmp_path)), str(tmp_path / "job.ngc"), cell=0.25)
    lower, upper = cam_setup.stock_box(program.Setup)
    size, height = upper - lower, 7
    removed = size.x * size.y * height - simulation.mesh.volume
    # The part of a disc of 16 mm beyond one side of the stock, which ends at 14.
    beyond = 16**2 * math.acos(14 / 16) - 14 * math.sqrt(16**2 - 14**2)
    ring = (math.pi * (16**2 - 12**2) - 4 * beyond) * height
    assert removed == pytest.approx(ring, rel=0.04), "a ring as wide as the tool, where there is stock"


def test_a_program_with_a_leaning_tool_is_the_machines_own_words(document):
    program = programmed(document, "sphere(r = 12) & box(40, 40, 16)", ("finish",), "five_axis_ac",
                         {"shape": "ball", "diameter": 6, "length": 60, "flute": 30},
                         zero="model", Lean=True, Stepover=0.5, Tolerance=0.1)
    [path] = path_of_program.create_all(program)
    document.recompute()
    assert path.isValid(), path.getStatusString()
    commands = path.Path.Commands
    assert ({"A", "C"} <= set().union(*(c.Parameters for c in commands))
            and all(c.Name in ("G0", "G1", "G2", "G3") for c in commands))
    lines = machine_program.machine_file(program).decode().splitlines()
    written = [line for line in lines if re.match(r"G[0123]\b", line)]
    # Over and down after the tool change are one rapid here.
    assert lines.count("G53 G0 Z0") == 1 and len(commands) == len(written) - 1
    assert commands[0].Name == "G0" and {"X", "Y", "Z", "A", "C"} == set(commands[0].Parameters)


def test_machines_that_speak_no_gcode_are_told(document):
    program = programmed(document, "sphere(r = 12) & box(40, 40, 16)", ("finish",), "shopbot5",
                         {"shape": "ball", "diameter": 6, "length": 60, "flute": 60},
                         zero="model", Plane="front", Stepover=0.5)
    [path] = path_of_program.create_all(program)
    document.recompute()
    assert not path.isValid() and "choose such a machine" in path.getStatusString()


def freecads_job(document):
    """A box of 40 x 30 x 10 with a round hole of 16 mm, milled by FreeCAD's own profile and pocket operations."""
    solid = document.addObject("Part::Feature", "Plate")
    solid.Shape = Part.makeBox(40, 30, 10).cut(Part.makeCylinder(8, 10, FreeCAD.Vector(20, 15, 4)))
    document.recompute()
    job = path_shim.jobs().Create("Job", [solid])
    for axis in "XY":
        setattr(job.Stock, f"Ext{axis}neg", 3)
        setattr(job.Stock, f"Ext{axis}pos", 3)
    job.Stock.ExtZneg = job.Stock.ExtZpos = 0
    controller = job.Tools.Group[0]
    controller.HorizFeed, controller.VertFeed, controller.SpindleSpeed = "600 mm/min", "200 mm/min", 9000
    controller.Tool.Diameter = 4
    document.recompute()
    clone = job.Model.Group[0]
    floor = next(f"Face{i + 1}" for i, face in enumerate(clone.Shape.Faces)
                 if abs(face.CenterOfMass.z - 4) < 1e-6 and abs(face.Area - math.pi * 64) < 1e-3)
    pocket = path_shim.operation("PocketShape").Create("Pocket")
    pocket.Base = [(clone, floor)]
    profile = path_shim.operation("Profile").Create("Profile")
    profile.processHoles = False
    document.recompute()
    return job


def test_a_job_of_freecads_can_be_simulated_by_us(document, tmp_path):
    job = freecads_job(document)
    assert all(op.Path.Size > 10 for op in job.Operations.Group)
    text, setup = path_jobs.program_of_job(job)
    assert text.count("M6 T1") == 1 and setup.machine is None and setup.mesh is None and setup.tools[0]["diameter"] == 4
    assert np.allclose([*setup.lower, *setup.upper], [-3, -3, 0, 43, 33, 10])
    (tmp_path / "job.ngc").write_text(text)
    simulation = kernel.load().stock.Simulation(setup.write(str(tmp_path)), str(tmp_path / "job.ngc"), cell=0.5)
    # FreeCAD's profile cuts the plate out of its frame of 3 mm: it removes the ring of 4 mm around the plate, and so
    # the whole frame.
    assert simulation.mesh.volume == pytest.approx(40 * 30 * 10 - math.pi * 64 * 6, rel=0.02)


def test_jobs_with_rotary_words_stocks_and_what_is_off(document, tmp_path):
    job = freecads_job(document)
    custom = document.addObject("Path::FeaturePython", "Turned")
    for kind, name, value in (("Link", "ToolController", job.Tools.Group[0]), ("Bool", "Active", True)):
        custom.addProperty(f"App::Property{kind}", name)
        setattr(custom, name, value)
    custom.Path = Path.Path([Path.Command("G0", {"X": 0, "Y": 0, "Z": 30, "A": 0, "C": 0}),
                             Path.Command("G1", {"X": 10, "A": 30, "C": 45, "F": 10})])
    job.Proxy.addOperation(custom)
    text, setup = path_jobs.program_of_job(job)
    assert setup.machine == "five_axis_ac" and "G1 A30.00000 C45.00000 F600.0000 X10.00000" in text
    assert path_jobs.program_of_job(job, "five_axis_mixed")[1].machine == "five_axis_mixed"
    custom.Path = Path.Path([Path.Command("G1", {"X": 10, "A": 30, "B": 45, "C": 3, "F": 10})])
    with pytest.raises(ValueError, match="A and B and C"):
        path_jobs.program_of_job(job)
    custom.Active = False
    text, setup = path_jobs.program_of_job(job)
    assert setup.machine is None
    job.Stock = path_shim.stocks().CreateCylinder(job, 30, 10,
                                                  FreeCAD.Placement(FreeCAD.Vector(20, 15, 0), FreeCAD.Rotation()))
    document.recompute()
    text, setup = path_jobs.program_of_job(job)
    assert setup.mesh is not None and setup.mesh.volume == pytest.approx(math.pi * 900 * 10, rel=1e-2)
    (tmp_path / "job.ngc").write_text(text)
    simulation = kernel.load().stock.Simulation(setup.write(str(tmp_path)), str(tmp_path / "job.ngc"), cell=0.5)
    assert 0 < simulation.mesh.volume < setup.mesh.volume
