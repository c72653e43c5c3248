"""Conversion of a set-up to a job for the kernel (docs/cam.md), and the job's results. Job texts are made on the GUI
thread, plans on any thread."""

import hashlib
import json
import os
import re
import tempfile

import numpy as np

from .. import kernel, workflow
from ..words import tr
from . import cam_tool
from .cam_setup import NO_MATERIAL, box_of
from .solid import source_of


class JobError(ValueError):
    """An error in a job. `object`: name of the document object; `setting`: name of the setting, or "" if unknown."""

    def __init__(self, words, object=None, setting=""):
        super().__init__(words)
        self.object, self.setting = object, setting


class Job:
    """A job for the kernel. `text`: the job file. `places`: {line number: (object name, setting name)}. `source`: the
    part, a sources.Source."""

    def __init__(self, setup):
        """Makes the job of a set-up. Raises JobError."""
        self._lines, self.places, self.label = [], {}, setup.Label
        if setup.Part is None:
            raise JobError(tr("{label}: choose a Part").format(label=setup.Label), setup.Name, "part")
        try:
            self.source = source_of(setup.Part)
        except ValueError as error:
            raise JobError(str(error), setup.Name, "part") from None
        self._write_setup(setup)
        for tool in setup.Tools:
            self._write_tool(tool)
        for operation in setup.Operations:
            if operation.Active:
                self._write_operation(setup, operation)
        self.text = "\n".join(self._lines) + "\n"
        self.extension = workflow.machine(setup.Machine)["extension"]
        self.digest = hashlib.sha1(repr((self.text, self.source.digest)).encode()).hexdigest()

    def _add(self, name, value, obj, setting=None):
        self._lines.append(f"{name} = {toml_value(value)}")
        self.places[len(self._lines)] = (obj.Name, setting or name)

    def _head(self, text, obj, setting=""):
        self._lines += ["", text]
        self.places[len(self._lines)] = (obj.Name, setting)

    def _write_setup(self, setup):
        problem = next(iter(setup.Proxy.problems(setup).items()), None)
        if problem:
            raise JobError(f"{setup.Label}: {problem[0]} {problem[1]}", setup.Name, problem[0])
        self._add("name", setup.Label, setup)
        self._add("machine", setup.Machine, setup)
        if setup.Material != NO_MATERIAL:
            self._add("material", setup.Material, setup)
        self._head("[input]", setup, "part")
        self._add("zero", list(setup.ZeroPoint) if setup.Zero == "point" else setup.Zero, setup)
        self._head("[stock]", setup, "stock")
        if setup.StockFrom == "Margins":
            self._add("margin", setup.Margin.Value, setup)
            self._add("top", setup.Top.Value, setup)
            if setup.Thickness.Value:
                self._add("thickness", setup.Thickness.Value, setup)
        else:
            if setup.StockFrom == "Object" and setup.StockObject is None:
                raise JobError(tr("{label}: choose a StockObject").format(label=setup.Label), setup.Name, "stock")
            box = box_of(setup.StockObject) if setup.StockFrom == "Object" else None
            lower = (box.XMin, box.YMin, box.ZMin) if box else setup.StockLower
            upper = (box.XMax, box.YMax, box.ZMax) if box else setup.StockUpper
            self._add("coordinates", "model", setup, "stock")
            self._add("lower", list(lower), setup, "stock")
            self._add("upper", list(upper), setup, "stock")
        if setup.AdjustFeeds:
            self._head("[feeds]", setup)
        given = setup.Proxy.given(setup)
        if given:
            self._head("[setting]", setup)
        for name, value in given.items():
            self._add(name, value, setup)

    def _write_tool(self, tool):
        self._head("[[tool]]", tool)
        for name, value in cam_tool.values_of(tool).items():
            self._add(name, value, tool)

    def _write_operation(self, setup, operation):
        problem = next(iter(operation.Proxy.problems(operation).items()), None)
        if problem:
            raise JobError(f"{operation.Label}: {problem[0]} {problem[1]}", operation.Name, problem[0])
        if operation.Tool is not None and operation.Tool not in setup.Tools:
            raise JobError(tr("{label}: its tool is not one of the set-up's").format(label=operation.Label),
                           operation.Name, "tool")
        if operation.Tool is None and len(setup.Tools) > 1:
            raise JobError(tr("{label}: choose a tool").format(label=operation.Label), operation.Name, "tool")
        self._head("[[operation]]", operation)
        self._add("name", operation.Label, operation)
        self._add("type", operation.Type, operation)
        if operation.Tool is not None:
            self._add("tool", operation.Tool.Number, operation)
        for name, value in operation.Proxy.given(operation).items():
            self._add(name, value, operation)

    def plan(self, progress=None):
        """Plans all paths and returns a Plan. Raises JobError for an invalid job, and fieldfab.Error if planning fails
        or is cancelled."""
        fieldfab = kernel.load()
        try:
            job = fieldfab.cam.Job.parse(self.text, self.source.field(progress), "job", progress)
            job.run(progress)
            return Plan(self, job)
        except fieldfab.Error as error:
            if error.kind == "cancelled":
                raise
            raise self._told(error) from None

    def _told(self, error):
        """Returns the kernel's error as a JobError, with the object and setting instead of the line number."""
        line = re.match(r"job:(\d+)", error.place or str(error))
        name, setting = self.places.get(int(line[1]), (None, "")) if line else (None, "")
        words = re.sub(r"^(job(:\d+)?: |machine: )+", "", str(error))
        if setting and not words.startswith(setting):
            mentioned = re.match(r"(\w+) (?:is|must|has)\b", words)
            setting = mentioned[1] if mentioned else setting
        return JobError(words, name, setting)


class Plan:
    """Result of a job as plain values and file contents. It keeps no kernel objects."""

    def __init__(self, order, job):
        self.text, self.digest, self.extension = order.text, order.digest, order.extension
        self.moves, self.sections, self.reports, self.notes = (
            list(job.moves), list(job.sections), list(job.reports), list(job.notes))
        self.zero, self.stock = tuple(job.zero), tuple(job.stock)
        with tempfile.TemporaryDirectory() as folder:
            program, sheet = os.path.join(folder, "program"), os.path.join(folder, "sheet.html")
            job.save(program)
            job.sheet(sheet)
            with open(program, "rb") as file:
                self.program = file.read()
            with open(sheet, "rb") as file:
                self.sheet = file.read()

    @property
    def seconds(self):
        return sum(report["seconds"] for report in self.reports)

    @property
    def planned_seconds(self):
        """The time without adjusted feeds."""
        return sum(report["planned_seconds"] for report in self.reports)


def all_moves(plan):
    """Returns the moves of all sections as one (n, 8) array."""
    return np.vstack(plan.moves) if plan.moves else np.zeros((0, 8))


def toml_value(value):
    """Returns a value as TOML text."""
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(toml_value(float(v)) for v in value) + "]"
    return json.dumps(value, ensure_ascii=False)  # JSON and TOML write numbers, strings and booleans alike
