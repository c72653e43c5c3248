"""One operation of a machine program as a path of FreeCAD's Path workbench, for its post processors, simulator and
dress-ups."""

import re

import FreeCAD
import numpy as np

from ..words import described, tr
from .document_object import DocumentObject
from .machine_program import machine_file, sections_of


HEIGHTS = (described("StartDepth", "z at which cutting begins"), described("FinalDepth", "Lowest z of the path"),
           described("SafeHeight", "z of rapids"),
           described("ClearanceHeight", "z of rapids"))


class PathOfProgram(DocumentObject):
    """A path that follows the program. Three-axis cuts are in document coordinates, as in FreeCAD's jobs. Cuts with a
    tilted tool are copied from the machine file, since only it contains the rotary axes' words."""

    NAME = "PathOfProgram"

    def add_properties(self, obj):
        self.add(obj, "Link", "Program", "Path", "The machine program that it follows")
        self.add(obj, "Integer", "Section", "Path",
                 "Index of the operation, from 0; -1: all operations, as in the machine file", 0)
        self.add(obj, "Link", "ToolController", "Path", "Tool controller of the Path job")
        self.add(obj, "Bool", "Active", "Path", "Include the operation in the Path job", True)
        for name, words in HEIGHTS:  # FreeCAD's dress-ups read these
            self.add(obj, "Distance", name, "Depth", words, mode=1)
        self.add_choice(obj, "CoolantMode", "Path", "Coolant while cutting", ("None", "Flood", "Mist"))

    def execute(self, obj):
        import Path

        if obj.Program is None or not obj.Program.MadeFrom:
            raise ValueError(tr("{label}: nothing is planned yet").format(label=obj.Label))
        if obj.Section < 0:
            text = words_of_file(machine_file(obj.Program).decode("utf-8", "replace"))
            obj.Placement.Base = obj.Program.Zero
        else:
            sections = sections_of(obj.Program)
            if obj.Section >= len(sections):
                raise ValueError(tr("{label}: the program has no operation {section} any more").format(
                    label=obj.Label, section=obj.Section + 1))
            section, moves = sections[obj.Section]
            if section["tilted"]:
                raise ValueError(tr("{label}: its tool is tilted now: make its path again").format(label=obj.Label))
            text = gcode_of(moves, obj.Program.Zero)
            heights = moves[:, 2] + obj.Program.Zero.z
            cuts = heights[moves[:, 3] > 0]
            obj.StartDepth, obj.FinalDepth, obj.SafeHeight, obj.ClearanceHeight = (
                cuts.max(), cuts.min(), heights.max(), heights.max())
            obj.CoolantMode = section["coolant"].capitalize() or "None"
        obj.Path = Path.Path(text)


def gcode_of(moves, zero=(0, 0, 0)):
    """Returns (n, 8) moves as G-code for Path.Path, with feeds in mm/s. `zero`: position of the program's zero."""
    to, feed, bulge = moves[:, :3] + np.array(tuple(zero)), moves[:, 3] / 60, moves[:, 4]
    begin = np.vstack([to[:1], to[:-1]])
    with np.errstate(divide="ignore", invalid="ignore"):
        across = np.stack([begin[:, 1] - to[:, 1], to[:, 0] - begin[:, 0]], axis=1)
        # From the arc's start to its centre.
        arm = (to - begin)[:, :2] / 2 + ((1 - bulge**2) / (4 * bulge))[:, None] * across
    lines = []
    if len(moves):
        lines.append(f"G0 Z{to[0, 2]:.5f}")  # first up to a safe height
    for (x, y, z), f, b, (i, j) in zip(to.tolist(), feed.tolist(), bulge.tolist(), arm.tolist()):
        if b:
            lines.append(f"G{3 if b > 0 else 2} X{x:.5f} Y{y:.5f} Z{z:.5f} I{i:.5f} J{j:.5f} F{f:.5f}")
        elif f:
            lines.append(f"G1 X{x:.5f} Y{y:.5f} Z{z:.5f} F{f:.5f}")
        else:
            lines.append(f"G0 X{x:.5f} Y{y:.5f} Z{z:.5f}")
    return "\n".join(lines)


_WORDS = re.compile(r"^(?:G0?[0123]\b|(?=[XYZABCF][-.\d]))", re.MULTILINE)


def words_of_file(text):
    """Returns the moves of a machine's G-code for Path.Path: without header, tool changes and comments, with feeds in
    mm/s. Raises ValueError for files other than G-code in millimetres."""
    if not re.search(r"^G0?[01]\b", text, re.MULTILINE) or re.search(r"\bG20\b", text):
        raise ValueError(tr("FreeCAD's Path takes G-code in millimetres: choose such a machine"))
    lines, mode, over = [], "G0", ""
    for line in text.splitlines():
        if line.startswith("G53"):
            over = "G0"  # Path.Path knows no machine coordinates: the rapids over and down become one
        if not _WORDS.match(line):
            continue
        head = re.match(r"G0?([0123])\b", line)
        mode = f"G{head[1]}" if head else mode
        words = re.sub(r"F([\d.]+)", lambda m: f"F{float(m[1]) / 60:.5f}", line[head.end():] if head else line)
        if over and "Z" not in words:
            over += f" {words.strip()}"
            continue
        lines.append(f"{over or mode} {words.strip()}")
        over = ""
    return "\n".join(lines)


def create(program, section=0):
    """Adds the path of an operation to the document; computes nothing yet."""
    obj = program.Document.addObject("Path::FeaturePython", "PathOfProgram")
    PathOfProgram(obj)
    obj.Program, obj.Section = program, section
    told = sections_of(program)
    obj.Label = told[section][0]["name"] if section >= 0 else program.Label
    if FreeCAD.GuiUp:
        obj.ViewObject.Proxy = 0  # FreeCAD's own view of paths
    return obj


def create_all(program):
    """Adds the paths of a program: one for each operation, or a single one if a tool is tilted."""
    sections = sections_of(program)
    if any(section["tilted"] for section, moves in sections):
        return [create(program, -1)]
    return [create(program, number) for number in range(len(sections))]
