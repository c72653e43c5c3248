"""Conversion between FreeCAD's Path jobs and Fieldfab: operations into a job, and a job's program and set-up for the
simulator."""

import os
from dataclasses import dataclass, field

import FreeCAD

from . import meshes, path_shim, tool_bits
from .objects import cam_setup, cam_tool, path_of_program
from .objects.cam_job import toml_value
from .words import tr

SHAPE_FILES = {"flat": "endmill", "ball": "ballend", "bull": "bullnose", "v": "v-bit", "tapered": "ballend",
               "drill": "drill"}
MACHINES = {"AC": "five_axis_ac", "BC": "five_axis_bc"}  # default machine for programs with these rotary axes

NOT_THE_OPERATIONS = ("M6", "M06", "M3", "M03", "M4", "M04", "G43", "G54", "G55", "G56", "G57", "G58", "G59")
ARC_CENTRES = {"G17": "IJ", "G18": "IK", "G19": "JK"}


# From Fieldfab to a Path job.


def to_job(program, job=None):
    """Adds the paths of a machine program, with their tools, to a Path job. Without a given job it makes a new one with
    the set-up's stock. Returns (job, paths); the caller recomputes."""
    paths = path_of_program.create_all(program)
    with path_shim.in_one_step():
        job = job or _new_job(program)
        _take_tools(job, program, paths)
    for path in paths:
        job.Proxy.addOperation(path)
    return job, paths


def _take_tools(job, program, paths):
    by_number = {tool.Number: tool for tool in program.Setup.Tools}
    sections = path_of_program.sections_of(program)
    for path in paths:
        section = sections[max(0, path.Section)][0]
        tool = by_number.get(section["tool"])
        if tool is not None:
            path.ToolController = _controller(job, tool, section)


def _new_job(program):
    document, setup = program.Document, program.Setup
    lower, upper = cam_setup.stock_box(setup)
    model = setup.Part
    # A job's model must have a shape; meshes have none.
    if not getattr(getattr(model, "Shape", None), "Solids", None):
        model = document.addObject("Part::Box", "Block")
        model.Label = tr("Block of {job}").format(job=setup.Label)
        model.Length, model.Width, model.Height = (max(size, 0.01) for size in upper - lower)
        model.Placement.Base = lower
        document.recompute([model])
    FreeCAD.setActiveDocument(document.Name)  # FreeCAD creates jobs in the active document
    job = path_shim.jobs().Create("Job", [model])
    path_shim.show_job(job)
    if FreeCAD.GuiUp:
        model.ViewObject.Visibility = model == setup.Part
    before, job.Stock = (job.Stock,
                         path_shim.stocks().CreateBox(job, upper - lower, FreeCAD.Placement(lower, FreeCAD.Rotation())))
    if before is not None:
        document.removeObject(before.Name)
    for controller in list(job.Tools.Group):  # FreeCAD's default tool
        job.Tools.removeObject(controller)
        bit = controller.Tool
        document.removeObject(controller.Name)
        document.removeObject(bit.Name)
    return job


def _controller(job, tool, section):
    """Returns the job's tool controller with the number of a Fieldfab tool, or makes one."""
    for controller in job.Tools.Group:
        if controller.ToolNumber == tool.Number:
            return controller
    told = cam_tool.values_of(tool)
    lengths = {"Diameter": "diameter", "Length": "length", "ShankDiameter": "shank", "CuttingEdgeHeight": "flute"}
    parameter = {name: f"{told[ours]} mm" for name, ours in lengths.items() if ours in told}
    if tool.Shape == "bull":
        name, length = path_shim.corner_of_bull_nose(told["diameter"], told.get("corner_radius", 0))
        parameter[name] = f"{length} mm"
    if "angle" in told:
        parameter["TipAngle" if tool.Shape == "drill" else "CuttingEdgeAngle"] = f"{told['angle']} deg"
    bit = path_shim.make_bit(job.Document, {
        "version": 2, "name": tool.Label, "shape": SHAPE_FILES[tool.Shape] + ".fcstd",
        "parameter": _known(parameter, tool.Shape), "attribute": {}})
    controller = path_shim.controllers().Create(f"TC: {tool.Label}", bit, tool.Number, False)
    controller.SpindleSpeed = section["spindle"]
    # mm/s; used only for the controller, since the path contains its own feeds.
    controller.HorizFeed, controller.VertFeed = tool.Feed.Value or 10, tool.Plunge.Value or 3
    if FreeCAD.GuiUp:
        controller.ViewObject.Proxy = bit.ViewObject.Proxy = 0
        bit.ViewObject.Visibility = False
    job.Proxy.addToolController(controller)
    return controller


def _known(parameter, shape):
    """Returns the parameters that FreeCAD's tool bit of this shape supports."""
    if shape == "drill":
        return {name: value for name, value in parameter.items() if name in ("Diameter", "Length", "TipAngle")}
    return {name: value for name, value in parameter.items() if name != "CuttingEdgeAngle" or shape == "v"}


# From a Path job to Fieldfab's simulator.


@dataclass
class Setup:
    """Inputs of the simulator besides the program (docs/simulation.md), in document coordinates."""

    machine: str | None  # a Fieldfab machine id; None: three axes
    lower: tuple  # corners of the stock's box, mm
    upper: tuple
    tools: list  # {name: value} as in set-up files
    mesh: object = None  # the stock as a fieldfab.Mesh, if it is not a box
    notes: list = field(default_factory=list)

    def write(self, folder, name="setup.toml"):
        """Writes the set-up file, and the stock's mesh (if any) into the same folder. Returns the file's path."""
        lines = [f"machine = {toml_value(self.machine)}"] if self.machine else []
        lines += ["", "[stock]"]
        if self.mesh is not None:
            self.mesh.save(os.path.join(folder, "stock.stl"))
            lines.append('model = "stock.stl"')
        else:
            lines += [f"lower = {toml_value(self.lower)}", f"upper = {toml_value(self.upper)}"]
        for tool in self.tools:
            lines += ["", "[[tool]]", *(f"{key} = {toml_value(value)}" for key, value in tool.items())]
        path = os.path.join(folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(lines) + "\n")
        return path


def program_of_job(job, machine=None):
    """Returns a Path job as (G-code text, Setup): its active operations in order, each with its tool, in mm, mm/min and
    document coordinates. `machine`: a Fieldfab machine id for jobs with rotary axes; the default is chosen by the axes'
    letters. Raises ValueError."""
    utilities = path_shim.utilities()
    lines, tools, notes, current, letters = ["G21 G17 G90 G94 G40 G49 G80"], {}, [], None, set()
    for operation in job.Operations.Group:
        if (not utilities.opProperty(operation, "Active") or not getattr(operation, "Path", None)
                or not operation.Path.Size):
            continue
        controller = utilities.toolControllerForOp(operation)
        if controller is None:
            raise ValueError(tr("{label}: it has no tool controller").format(label=operation.Label))
        number = controller.ToolNumber
        if number not in tools:
            tools[number] = {**tool_bits.of_object(controller.Tool), "number": number}
        if current != controller:
            lines += [f"M6 T{number}", f"G43 H{number}",
                      f"S{controller.SpindleSpeed or 1000:g} M{4 if controller.SpindleDir == 'Reverse' else 3}"]
            if not controller.SpindleSpeed:
                notes.append(f"{controller.Label}: it has no spindle speed; 1000 is taken")
            current = controller
        lines.append(f"({_comment(operation.Label)})")
        plane = "IJ"
        feed = controller.HorizFeed.Value * 60
        if not feed:
            notes.append(f"{controller.Label}: it has no feed; 600 mm/min is taken where a move has none")
        lines.append(f"F{feed or 600:.4g}")
        for command in _placed(operation).Commands:
            plane = ARC_CENTRES.get(command.Name, plane)
            line = _line(command, plane)
            letters |= set(command.Parameters) & set("ABC")
            if line:
                lines.append(line)
        lines.append("G80")
    if not tools:
        raise ValueError(tr("{label}: no active operation has a path").format(label=job.Label))
    if letters and machine is None:
        machine = MACHINES.get("".join(sorted(letters)) if len(letters) > 1
                               else next((axes for axes in MACHINES if letters <= set(axes)), ""))
        if machine is None:
            words = tr("{label}: no known machine has the rotary axes {letters}: choose the machine")
            raise ValueError(words.format(label=job.Label, letters=f" {tr('and')} ".join(sorted(letters))))
    lower, upper, mesh = _stock(job)
    return "\n".join([*lines, "M5", "M2"]) + "\n", Setup(machine, lower, upper, list(tools.values()), mesh, notes)


def _placed(operation):
    """Returns an operation's path, translated by its placement. Raises ValueError for a rotation."""
    if operation.Placement.isIdentity():
        return operation.Path
    path, way = type(operation.Path)(), operation.Placement
    if way.Rotation.Angle:
        raise ValueError(tr("{label}: its Placement turns the path, which a program cannot express").format(
            label=operation.Label))
    for command in operation.Path.Commands:
        moved = {name: value + way.Base["XYZ".index(name)] if name in "XYZ" else value
                 for name, value in command.Parameters.items()}
        path.addCommands(type(command)(command.Name, moved))
    return path


def _line(command, plane):
    """Returns a command as a line in mm and mm/min. Returns "" for commands without effect and for those that the
    program sets itself (tools, spindle, fixtures)."""
    name, parameters = command.Name, command.Parameters
    if name.startswith("("):
        return f"({_comment(name)})"
    if not name or name in NOT_THE_OPERATIONS:
        return ""
    words = [name]
    for letter, value in parameters.items():
        if letter == "F":
            if value > 0 and name not in ("G0", "G00"):
                words.append(f"F{value * 60:.4f}")
        elif letter in "IJK" and letter not in plane:
            continue  # FreeCAD writes K0 in level arcs, which controls reject
        elif letter in ("D", "H", "L", "N", "O", "S", "T"):
            words.append(f"{letter}{value:g}")
        else:
            words.append(f"{letter}{value:.5f}")
    return " ".join(words)


def _comment(text):
    return text.replace("(", " ").replace(")", " ").strip()


def _stock(job):
    """Returns the stock's lower and upper corner, and its mesh, or None if the stock is an axis-aligned box."""
    shape = getattr(job.Stock, "Shape", None)
    if shape is None or shape.isNull():
        raise ValueError(tr("{label}: it has no stock").format(label=job.Label))
    box = shape.BoundBox
    lower, upper = (box.XMin, box.YMin, box.ZMin), (box.XMax, box.YMax, box.ZMax)
    if abs(shape.Volume - box.XLength * box.YLength * box.ZLength) <= 1e-6 * shape.Volume:
        return lower, upper, None
    import MeshPart

    mesh = MeshPart.meshFromShape(Shape=shape, LinearDeflection=box.DiagonalLength / 2000, AngularDeflection=0.2)
    return lower, upper, meshes.from_bms(meshes.bms_of(mesh))
