"""Solids as OpenSCAD text, and the Source that evaluates it. Nothing here accesses a document.

Each object made from a design stores only its own arguments. An object and its descendants are combined into one .csg
text, which the kernel evaluates as a whole. So coincident faces meet exactly, as if a whole file were read, and a hull
has its children's corners."""

import os
import re

from . import kernel
from .sources import Source, kept
from .words import tr

PLATE = 1.0  # mm; thickness of a flat shape as a solid, as in OpenSCAD's preview
_PLACE = re.compile(r"^design:(\d+)(?::\d+)?: ?")
_FILE = re.compile(r'(\b(?:import|surface)\s*\([^()"]*?\bfile\s*=\s*)"((?:[^"\\]|\\["\\])*)"')


def literal(value):
    """Returns a value as an OpenSCAD literal."""
    if value is None:
        return "undef"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(literal, value)) + "]"
    return repr(float(value))


def matrix_of(placement):
    """Returns the 16 numbers of a FreeCAD placement, for Text.placed(). Corrects the rounding of its quaternion, so
    that faces stay coplanar after quarter turns."""
    return [round(number, 14) + 0.0 for number in placement.toMatrix().A]


class Text:
    """Lines of .csg text, each with the label of its object, and the paths of the files that the text names."""

    def __init__(self, lines, files=()):
        self.lines, self.files = tuple(lines), tuple(files)

    def __str__(self):
        return "\n".join(line for line, _ in self.lines)

    def within(self, head, label):
        """Returns the text as the only child of a node."""
        return node(head, label, [self])

    def placed(self, matrix, label):
        """Returns the text within a transform by a matrix of 16 numbers, row by row."""
        return self.within(f"multmatrix({literal([matrix[i:i + 4] for i in (0, 4, 8, 12)])})", label)


def node(head, label, children=(), files=()):
    """Returns the Text of a node with children. `head` is its name with its arguments in parentheses."""
    if "\n" in head:  # strings may span lines, and each line needs a label
        first = [(line, label) for line in head.split("\n")]
    else:
        first = [(head, label)]
    if not children:
        return Text([*first[:-1], (first[-1][0] + ";", label)], files)
    lines = [*first[:-1], (first[-1][0] + " {", label)]
    for child in children:
        lines += child.lines
    return Text([*lines, ("}", label)], [*files, *(path for child in children for path in child.files)])


def whole(text, folder, label):
    """Returns the Text of a file's contents. Relative file names in it refer to `folder`."""
    found = []

    def absolute(match):
        path = os.path.join(folder, re.sub(r"\\([\"\\])", r"\1", match[2]))
        found.append(path)
        return match[1] + literal(path)

    return Text([(line, label) for line in _FILE.sub(absolute, text).split("\n")], found).within("group()", label)


def stamp(path, label):
    """Returns a file's size and modification time, which identify its content. Raises ValueError if it does not
    exist."""
    try:
        seen = os.stat(path)
    except OSError:
        raise ValueError(tr("{label}: the file {path} is not there").format(label=label, path=path)) from None
    return f"{seen.st_size} {seen.st_mtime_ns}"


class OpenScadSource(Source):
    """The solid of a Text. Raises ValueError if a file is missing."""

    def __init__(self, text, label):
        self.text, self.label = text, label
        stamps = [(path, stamp(path, label)) for path in dict.fromkeys(text.files)]
        super().__init__(("openscad", str(text), stamps), None)

    def design(self, progress=None):
        """Returns the fieldfab.OpenScadDesign. Raises fieldfab.Error, with object labels instead of line numbers."""
        return kept(("design", self.digest), lambda: self._designed(progress))

    def _designed(self, progress):
        fieldfab = kernel.load()
        try:
            design = fieldfab.openscad_design(str(self.text), thickness=PLATE, progress=progress)
        except fieldfab.Error as error:
            if error.kind == "cancelled":
                raise
            raise fieldfab.Error(self._said(str(error))) from None
        if design.solid is None:
            raise fieldfab.Error(tr("draws nothing"))
        return design

    def _said(self, message):
        """Returns a message with the label of its object instead of the line number."""
        match = _PLACE.match(message)
        line = int(match[1]) if match else 0
        return (f"{self.text.lines[line - 1][1]}: {message[match.end():]}" if 0 < line <= len(self.text.lines)
                else message)

    def field(self, progress=None):
        return self.design(progress).solid

    def solid(self, progress=None):
        """Returns its Text; for a flat design, the Text of the plate. Raises fieldfab.Error."""
        return (self.text.within(f"linear_extrude(height = {literal(PLATE)})", self.label) if self.design(progress).flat
                else self.text)

    def notes(self):
        """Returns notes about omitted or repaired parts, one line each."""
        return [self._said(note) for note in self.design().notes]


def faces_together(parts, progress=None):
    """Returns the mesh of the union of solids, [(OpenScadSource, FreeCAD placement)], from their exact faces. None if
    the faces are not available. Raises fieldfab.Error."""
    (first, placement), label = parts[0], parts[0][0].label
    if len(parts) == 1 and placement.isIdentity():
        return first.faces(progress)
    texts = [source.solid(progress).placed(matrix_of(placement), source.label) for source, placement in parts]
    return OpenScadSource(node("union()", label, texts), label).faces(progress)
