"""Result of a CAM set-up: the moves, the machine file and the set-up sheet, all stored in the document."""

import base64
import io
import json
import zlib

import FreeCAD
import numpy as np

from .. import kernel, work
from ..words import tr
from . import cam_job
from .document_object import DocumentObject, create_object


class MachineProgram(DocumentObject):
    """A machine program, planned again when its inputs change. If planning fails or is cancelled, it keeps the previous
    result."""

    NAME = "MachineProgram"

    def add_properties(self, obj):
        self.add(obj, "Link", "Setup", "Program", "The CAM job that it follows")
        self.add(obj, "Float", "Seconds", "Program", "Estimated machining time in seconds", mode=1)
        self.add(obj, "Float", "PlannedSeconds", "Program",
                 "Estimated machining time in seconds, without adjusted feeds", mode=1)
        self.add(obj, "Length", "CutLength", "Program", "Length of cuts", mode=1)
        self.add(obj, "Length", "RapidLength", "Program", "Length of rapids", mode=1)
        self.add(obj, "StringList", "Reports", "Program", "Report of each operation", mode=1)
        self.add(obj, "StringList", "Notes", "Program", "Notes on the program", mode=1)
        self.add(obj, "Vector", "Zero", "Program", "The program's zero in the document's coordinates", mode=1)
        self.add(obj, "String", "PackedProgram", "Result", "Machine file, compressed", mode=4)
        self.add(obj, "String", "PackedSheet", "Result", "Set-up sheet as an HTML page, compressed",
                 mode=4)
        self.add(obj, "String", "PackedMoves", "Result", "All moves as a NumPy array, compressed", mode=4)
        self.add(obj, "String", "Sections", "Result", "Tool and settings of each operation, as JSON", mode=4)
        self.add(obj, "String", "Job", "Result", "The job that it was planned from (docs/cam.md)", mode=4)
        self.add(obj, "String", "Extension", "Result", "Extension of the machine file", mode=4)
        self.add(obj, "String", "MadeFrom", "Result",
                 "Digest of the input; the program is planned again when it changes",
                 mode=4)

    @staticmethod
    def program(obj):
        """Returns the machine file as bytes. Raises ValueError if nothing is planned."""
        return machine_file(obj)

    def onDocumentRestored(self, obj):
        """Converts file properties of documents of earlier versions to byte properties. FreeCAD loses such files if the
        object is copied, or deleted and restored by undo."""
        super().onDocumentRestored(obj)
        for before, name in (("MachineFile", "PackedProgram"), ("SetupSheet", "PackedSheet"), ("Moves", "PackedMoves")):
            if before in obj.PropertiesList:
                if path := getattr(obj, before):
                    with open(path, "rb") as file:
                        setattr(obj, name, packed(file.read()))
                obj.removeProperty(before)
        obj.purgeTouched()

    def execute(self, obj):
        if obj.Setup is None:
            raise ValueError(tr("{label}: choose a Setup").format(label=obj.Label))
        job = cam_job.Job(obj.Setup)
        if obj.MadeFrom == job.digest:
            return
        try:
            plan = work.run(job.plan, obj.Label)
        except kernel.load().Error as error:
            raise ValueError(f"{obj.Label}: {error}") from None
        except work.Cancelled:
            raise ValueError(tr("{label}: cancelled; it is unchanged").format(label=obj.Label)) from None
        take(obj, plan)


def take(obj, plan):
    """Stores a cam_job.Plan in the object."""
    moves = io.BytesIO()
    np.save(moves, cam_job.all_moves(plan))
    obj.PackedProgram, obj.PackedSheet, obj.PackedMoves = (
        packed(plan.program), packed(plan.sheet), packed(moves.getvalue()))
    counts = [len(moves) for moves in plan.moves]
    obj.Sections = json.dumps([{**section, "moves": count} for section, count in zip(plan.sections, counts)])
    obj.Seconds, obj.PlannedSeconds = plan.seconds, plan.planned_seconds
    obj.CutLength, obj.RapidLength = (sum(report[name] for report in plan.reports) for name in ("cut", "rapid"))
    obj.Reports = [f"{r['name']}: {r['cut'] / 1000:.2f} m cut, {r['rapid'] / 1000:.2f} m of rapids, "
                   f"{clock(r['seconds'])}" for r in plan.reports]
    obj.Notes = plan.notes
    obj.Zero = FreeCAD.Vector(*plan.zero)
    obj.Job, obj.Extension = plan.text, plan.extension
    obj.MadeFrom = plan.digest  # last: a change of it redraws the view


def packed(data):
    """Returns bytes as the value of a property."""
    return base64.b64encode(zlib.compress(data, 6)).decode()


def unpacked(text):
    return zlib.decompress(base64.b64decode(text))


def machine_file(obj):
    """Returns the machine file as bytes. Raises ValueError if nothing is planned."""
    return _held(obj, "PackedProgram")


def setup_sheet(obj):
    """Returns the set-up sheet for the machine operator, HTML as bytes. Raises ValueError if nothing is planned."""
    return _held(obj, "PackedSheet")


def _held(obj, name):
    if not getattr(obj, name) or not obj.MadeFrom:
        raise ValueError(tr("{label}: nothing is planned yet").format(label=obj.Label))
    return unpacked(getattr(obj, name))


def sections_of(obj):
    """Returns the moves as [(section, moves)], one for each operation. `moves` is an (n, 8) array of x, y, z (mm, in
    the program's coordinates), feed (mm/min, 0 for rapids), bulge and the tool's axis."""
    if not obj.PackedMoves:
        return []
    told, moves = json.loads(obj.Sections), np.load(io.BytesIO(unpacked(obj.PackedMoves)))
    ends = np.cumsum([section["moves"] for section in told])
    return list(zip(told, np.split(moves, ends[:-1]) if told else []))


def clock(seconds):
    """Formats seconds as "1:02:03 h" or "2:03 min"."""
    minutes, seconds = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02d}:{seconds:02d} h" if hours else f"{minutes}:{seconds:02d} min"


def write_machine_file(obj, path):
    """Writes the machine file, whole or not at all. Raises OSError, and ValueError if nothing is planned."""
    kernel.write_file(path, machine_file(obj))


def write_setup_sheet(obj, path):
    kernel.write_file(path, setup_sheet(obj))


def create(setup):
    """Adds the machine program of a set-up to the document; does not plan it yet."""
    program = create_object(MachineProgram, setup.Document, tr("Program of {job}").format(job=setup.Label))
    program.Setup = setup
    return program
