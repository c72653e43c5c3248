"""Simulation of a machine program on a stock. The remaining material is a solid; faults are reported as events."""

import functools
import hashlib
import json
import os
import re
import tempfile
from collections import OrderedDict

import FreeCAD

from .. import kernel, meshes, work
from ..geometry import source_of_geometry
from ..words import marked, tr
from . import programs, set_ups
from .solid import Solid, is_solid, source_of

THREE_AXES = marked("three axes")
OF_THE_MACHINE = marked("the machine's")
DIALECTS = (OF_THE_MACHINE, "linuxcnc", "fanuc", "grbl", "mach3")
# Worst first.
KINDS = marked(("fixture contact", "holder contact", "shank contact", "rapid contact", "over-travel", "spindle stopped",
                "gouge", "excess"))
CONTACTS = KINDS[:4]
KEPT_RUNS = 2  # each run stores its stock at up to 64 times


class Run:
    """A finished simulation for playback. `simulation`: fieldfab.stock.Simulation; `report`: its report; `lines`: the
    program's text."""

    def __init__(self, task, progress):
        self.folder = tempfile.TemporaryDirectory(prefix="fieldfab_")
        setup, program = (self._file(*given) for given in (task.setup, task.program))
        target, stock, part = (source and source.field(progress) for source in (task.target, task.stock, task.part))
        self.simulation = kernel.load().stock.Simulation(setup, program, target=target, stock=stock, part=part,
                                                         cell=task.cell or None, remember=True,
                                                         progress=progress, dialect=task.dialect or None)
        self.report = self.simulation.report
        # Written here, since this thread does not block the window.
        self.mesh_file = meshes.write_bms(self.simulation.mesh, os.path.join(self.folder.name, "mesh.bms"))
        self.lines = task.program[0].decode("utf-8", "replace").splitlines()

    def _file(self, text, name, path):
        """Returns the path of a file. Text without a path is written to the run's temporary folder."""
        if path is None:
            path = os.path.join(self.folder.name, name)
            with open(path, "wb") as file:
                file.write(text)
        return path


class Task:
    """All inputs of a simulation, copied from the document, so that it can run on any thread. `program` and `setup`:
    (bytes, name, path or None). `target`, `stock` and `part` (for which a Fieldfab job was planned): Sources or None.
    `cell`: mm, 0 for automatic. `dialect`: the dialect of its G-code, "" for the set-up's."""

    def __init__(self, program, setup, target=None, stock=None, cell=0.0, part=None, dialect=""):
        self.program, self.setup, self.target, self.stock, self.cell, self.part, self.dialect = (
            program, setup, target, stock, cell, part, dialect)
        told = ("simulation", program[0], program[1], setup[0], _models_of(setup),
                *(s and s.digest for s in (target, stock, part)), cell, *([dialect] if dialect else []))
        self.digest = hashlib.sha1(repr(told).encode()).hexdigest()

    def run(self, progress=None):
        """Returns a cached Run, or simulates a new one. Raises fieldfab.Error."""
        if self.digest not in _runs:
            _runs[self.digest] = Run(self, progress)
        _runs.move_to_end(self.digest)
        while len(_runs) > KEPT_RUNS:
            _runs.popitem(last=False)
        return _runs[self.digest]


_runs = OrderedDict()


def _models_of(setup):
    """Returns the sizes and modification times of the files named in a set-up file."""
    text, _, path = setup
    if path is None:
        return ()
    names = re.findall(r'"([^"\n]+\.\w+)"', text.decode("utf-8", "replace"))
    files = [os.path.join(os.path.dirname(path), name) for name in names]
    return tuple((f, os.stat(f).st_size, os.stat(f).st_mtime_ns) for f in files if os.path.isfile(f))


def bounds_of(obj):
    """Returns the bounding box of an object's mesh or shape in document coordinates."""
    box = (obj.Mesh if hasattr(obj, "Mesh") else obj.Shape).BoundBox
    return (box.transformed((obj.getGlobalPlacement() * obj.Placement.inverse()).toMatrix())
            if hasattr(obj, "getGlobalPlacement") else box)


def event_order(event):
    """Key that sorts events, the worst first."""
    return (KINDS.index(event["kind"]) if event["kind"] in KINDS else len(KINDS), -abs(event["amount"]))


def verdict(events, say=str):
    """Returns the outcome in one line. `events`: the worst first. `say` may be tr; documents store the English text."""
    if not events:
        return say(marked("good"))
    worst = events[0]
    return say(marked("{count} events, the worst: {kind} at line {line}")).format(
        count=len(events), kind=say(worst["kind"]), line=worst["line"])


def planned_of(simulation):
    """Returns the machine program whose set-up the simulation uses, or None."""
    program = simulation.Program if simulation.Program is not None else getattr(simulation, "SetupProgram", None)
    return program if programs.is_planned(program) else None


class Simulation(Solid):
    """The stock after a program, in document coordinates, which are also the part's. The document stores the stock's
    mesh, the figures and the events."""

    NAME = "Simulation"

    def add_own_properties(self, obj):
        add = functools.partial(self.add, obj)
        add("File", "ProgramFile", "Program", "Program file of the machine: G-code, .sbp, .rml, .hpgl")
        add("Link", "Program", "Program",
            "Object with a program: a machine program, a Path operation or a Path job. It replaces the file")
        self.add_choice(obj, "Dialect", "Program",
                        "Dialect of the G-code; if none is chosen, that of the set-up's machine", DIALECTS)
        add("File", "SetupFile", "Set-up",
            "Set-up or job file (docs/simulation.md); empty: the properties below")
        if "Machine" not in obj.PropertiesList:
            obj.addProperty("App::PropertyEnumeration", "Machine", "Set-up",
                            "Machine that runs the program").Machine = [
                                THREE_AXES, *sorted(kernel.load().cam.machines())]
        add("StringList", "Tools", "Set-up",
            "One tool per line, as JSON: number, shape, diameter, flute, length, shank, holder_diameter, ...",
            [set_ups.tool_to_line(set_ups.DEFAULT_TOOL)])
        add("Vector", "StockLower", "Set-up", "Lower corner of the stock")
        add("Vector", "StockUpper", "Set-up", "Upper corner of the stock")
        add("Link", "SetupProgram", "Set-up",
            "Machine program of the document whose set-up a program file uses: machine, tools, stock and part")
        add("Link", "Stock", "Set-up",
            "Stock as a solid, such as the result of an earlier simulation. It replaces the corners")
        add("Link", "Target", "Set-up", "Solid that the program should produce")
        add("Length", "Gouge", "Set-up", "Deeper cuts into the target are reported as gouges", 0.05)
        add("Length", "Excess", "Set-up",
            "More material left on the target is reported as excess; 0: excess is not reported", 0)
        add("Length", "Touch", "Set-up", "Contacts of less depth are ignored", 0.02)
        add("String", "MoreOfSetup", "Set-up",
            "Further lines of the set-up: zero, start, [work], [limits], [fixture], ...")
        add("Length", "Cell", "Sampling",
            "Sample spacing; 0: automatic, 1/300 of the stock, at most 0.2 mm", 0)
        add("String", "Verdict", "Result", "Result of the simulation in a few words", mode=1)
        add("StringList", "Events", "Result", "Events, the worst first: one JSON object per line", mode=1)
        add("StringList", "Notes", "Result", "Notes on lines of the program", mode=1)
        add("Volume", "Removed", "Result", "Volume of the removed material", mode=1)
        add("Float", "Seconds", "Result", "Machining time in seconds", mode=1)
        add("Float", "RapidSeconds", "Result", "Time of the rapids in seconds", mode=1)
        add("Percent", "AirShare", "Result", "Percentage of the feed moves that meets no material", mode=1)
        add("Integer", "Contacts", "Result", "Number of lines with a collision", mode=1)
        add("Integer", "Gouges", "Result", "Number of lines that gouge the target", mode=1)
        add("Integer", "OverTravels", "Result", "Number of lines that leave the machine's limits", mode=1)
        add("Length", "DeepestGouge", "Result", "Greatest depth of a gouge", mode=1)
        add("Length", "HighestExcess", "Result", "Greatest height of excess material", mode=1)

    def add_properties(self, obj):
        self.add_own_properties(obj)
        self.add_results(obj)
        self.show_what_matters(obj)

    def onChanged(self, obj, name):
        if name in ("SetupFile", "SetupProgram", "Stock", "Program"):
            self.show_what_matters(obj)

    @staticmethod
    def show_what_matters(obj):
        if not hasattr(obj, "Stock") or not hasattr(obj, "SetupFile") or not hasattr(obj, "Program"):
            return  # during creation of the object
        there = set(obj.PropertiesList)  # while a document is opened, properties are added one by one
        for name in ("Machine", "Tools", "Stock", "StockLower", "StockUpper", "Gouge", "Excess", "Touch",
                     "MoreOfSetup"):
            corner = name in ("StockLower", "StockUpper")
            counts = (not (corner and obj.Stock is not None)
                      and (name == "Stock" or not (obj.SetupFile or planned_of(obj))))
            if name in there:
                obj.setEditorMode(name, 0 if counts else 2)

    def source(self, obj):
        """Returns the remaining stock as a Source. Raises ValueError before the first simulation."""
        if not obj.Mesh.CountFacets:
            raise ValueError(tr("{label} was not simulated yet").format(label=obj.Label))
        return source_of_geometry(obj)

    def task(self, obj):
        """Returns the Task for the object's properties. Raises ValueError with a line for the user."""
        if obj.Program is None and not obj.ProgramFile:
            raise ValueError(tr("{label}: choose a program").format(label=obj.Label))
        program = (programs.program_of(obj.Program) if obj.Program is not None
                   else programs.program_from_file(obj.ProgramFile))
        for link in (obj.Target, obj.Stock):
            if link is not None and not link.isValid():
                raise ValueError(tr("{label}: {other} could not be computed").format(label=obj.Label, other=link.Label))
        target, stock = (link and source_of(link) for link in (obj.Target, obj.Stock))
        planned = planned_of(obj)
        part = (source_of(planned.Setup.Part) if planned and planned.Setup and planned.Setup.Part
                and not obj.SetupFile else None)
        return Task(program, self.setup(obj), target, stock, obj.Cell.Value, part,
                    "" if obj.Dialect == OF_THE_MACHINE else obj.Dialect)

    def setup(self, obj):
        """Returns the set-up as (bytes, name, path or None)."""
        path = obj.SetupFile or getattr(obj.Program, "SetupFile", "")
        if path:
            try:
                with open(path, "rb") as file:
                    return file.read(), os.path.basename(path), path
            except OSError as error:
                words = tr("{label}: the set-up {path} cannot be read: {error}")
                raise ValueError(words.format(label=obj.Label, path=path, error=error.strerror)) from None
        if planned := planned_of(obj):
            return planned.Job.encode(), "job.toml", None
        lower, upper = obj.StockLower, obj.StockUpper
        if obj.Stock is not None:
            box = bounds_of(obj.Stock)
            # A margin separates the solid's faces from those of the stock's box.
            room = FreeCAD.Vector(1, 1, 1) * max(0.01, box.DiagonalLength / 1000)
            lower, upper = (FreeCAD.Vector(box.XMin, box.YMin, box.ZMin) - room,
                            FreeCAD.Vector(box.XMax, box.YMax, box.ZMax) + room)
        if min(upper - lower) <= 0:
            raise ValueError(
                tr("{label}: the stock has no size: give its corners, or a solid as Stock").format(label=obj.Label))
        tools = [set_ups.tool_from_line(line) for line in obj.Tools if line.strip()]
        tolerances = {"gouge": obj.Gouge.Value, "excess": obj.Excess.Value, "touch": obj.Touch.Value}
        machine = "" if obj.Machine == THREE_AXES else obj.Machine
        return set_ups.text(tools, lower, upper, machine, tolerances, obj.MoreOfSetup).encode(), "setup.toml", None

    def ahead(self, obj):
        """Returns None: the panel runs the simulation."""

    edited = False  # whether its panel is open, which hides the object and shows the result

    def waits(self, obj):
        """Returns whether the simulation is postponed until the object is shown: it is hidden and no other object needs
        its mesh."""
        return (bool(obj.MadeFrom) and not self.edited and not obj.Visibility
                and all(is_solid(user) for user in obj.InList))

    def has_its_mesh(self, obj):
        return obj.MadeFrom == self.task(obj).digest

    def kept_run(self, obj):
        """Returns the Run that the object shows if this session made it, otherwise None. Raises as task() does."""
        return _runs.get(obj.MadeFrom) if obj.MadeFrom == self.task(obj).digest else None

    def execute(self, obj):
        """Simulates the program. Raises errors: FreeCAD then marks the object, which keeps its last result."""
        if self.waits(obj):
            return
        fieldfab = kernel.load()
        try:
            task = self.task(obj)
            if obj.MadeFrom == task.digest:
                return
            run = work.run(task.run, obj.Label)
        except fieldfab.Error as error:
            raise ValueError(f"{obj.Label}: {error}") from None
        except work.Cancelled:
            raise ValueError(tr("{label}: cancelled; it is unchanged").format(label=obj.Label)) from None
        self.put_mesh(obj, run.simulation.mesh, meshes.read_bms(run.mesh_file))
        self.put_report(obj, run.report)
        obj.MadeFrom = task.digest

    @staticmethod
    def put_report(obj, report):
        events = sorted(report["events"], key=event_order)
        kinds = [event["kind"] for event in events]
        obj.Verdict = verdict(events)
        obj.Events = [json.dumps(event) for event in events]
        obj.Notes = [f"line {note['line']}: {note['message']}" for note in report["notes"]]
        obj.Removed, obj.Seconds, obj.RapidSeconds, obj.AirShare = (
            report["removed"], report["seconds"], report["rapid_seconds"], round(100 * report["air_share"]))
        obj.Contacts, obj.Gouges, obj.OverTravels = (
            sum(k in CONTACTS for k in kinds), kinds.count("gouge"), kinds.count("over-travel"))
        deviation = report.get("deviation", {})
        obj.DeepestGouge, obj.HighestExcess = deviation.get("deepest_gouge", 0), deviation.get("highest_excess", 0)
