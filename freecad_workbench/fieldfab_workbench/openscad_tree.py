"""The parts of an OpenSCAD design's tree, each as an object of a document to be. Groups that join nothing are left out;
colours and moves become those of the parts. Changes no document."""

import dataclasses
import heapq
import itertools
import os

import FreeCAD

from .openscad_nodes import Unfit, key_of, properties_of

# In larger designs whole branches become one object with their text: a larger tree would be slow and no help.
MOST_PARTS = 300
DEEPEST = 100  # parts within parts
MOST_NODES = 20_000  # of the file, groups and moves among them; a larger one is one object
RIGID = 1e-5  # OpenSCAD writes matrices with six digits

SETS = {"group": "Union", "union": "Union", "render": "Union", "color": "Union", "multmatrix": "Union",
        "difference": "Difference", "intersection": "Intersection"}


class TooLarge(Exception):
    """More nodes, or deeper ones, than can be made a tree."""


@dataclasses.dataclass
class Part:
    """An object to be made: its kind (`make`: node, set, scaled or text), properties, children, placement and looks."""

    label: str
    make: str
    values: dict
    children: list = dataclasses.field(default_factory=list)
    placement: FreeCAD.Placement = dataclasses.field(default_factory=FreeCAD.Placement)
    colour: tuple = None  # red, green, blue, and how opaque
    highlight: bool = False
    origin: callable = None  # gives its text, but for where it is

    def walk(self):
        """It and all that is below it."""
        waiting = [self]
        while waiting:
            part = waiting.pop()
            yield part
            waiting += part.children

    def become_text(self, folder):
        """One part in place of a branch."""
        self.make, self.values, self.children = "text", {"Text": self.origin(), "Folder": folder}, []


class Design:
    """The parts of a fieldfab.OpenScadTree that was read from a file in `folder`: `root`, None where the design draws
    nothing, and those that are only shown (%). `branches`: how many branches were too large. Raises TooLarge."""

    def __init__(self, tree, folder):
        self.folder = folder
        if len(tree) > MOST_NODES:
            raise TooLarge(len(tree))
        nodes = [tree[i] for i in range(len(tree))]
        start = next((i for i, node in enumerate(nodes) if node.root), 0)
        made = [None] * len(nodes)  # (the part or None, those that are only shown)
        for i in reversed(range(len(nodes))):  # children come after their parents
            made[i] = self._made(nodes[i], [(nodes[child], *made[child]) for child in nodes[i].children])
        self.root, self.shown = made[start]
        self.branches = self._prune(([self.root] if self.root else []) + self.shown)

    def _prune(self, tops):
        """Leaves MOST_PARTS parts: the largest branches are divided first, and branches that stay undivided become
        text. Returns how many became text."""
        parts = [part for top in tops for part in top.walk()]
        sizes = {}
        for part in reversed(parts):
            sizes[id(part)] = 1 + sum(sizes[id(child)] for child in part.children)
        order, kept, pruned = itertools.count(), len(tops), 0
        waiting = [(-sizes[id(top)], next(order), top, 1) for top in tops]
        heapq.heapify(waiting)
        while waiting:
            _, _, part, depth = heapq.heappop(waiting)
            if (part.children and part.origin
                    and (depth >= DEEPEST or (len(part.children) > 1 and kept + len(part.children) > MOST_PARTS))):
                part.become_text(self.folder)
                pruned += 1
            if depth > 2 * DEEPEST:
                raise TooLarge(depth)
            kept += len(part.children)
            for child in part.children:
                heapq.heappush(waiting, (-sizes[id(child)], next(order), child, depth + 1))
        return pruned

    def _made(self, node, below):
        """A node's part, of its children, each with what was made of it."""
        shown = [part for child, _, others in below if not child.disabled for part in others]
        shown += [part for child, part, _ in below if child.background and not child.disabled and part is not None]
        counted = [part for child, part, _ in below if not child.background and not child.disabled]
        children = [part for part in counted if part is not None]
        if node.dimensions == 0:
            return None, shown
        try:
            if node.name not in SETS:
                part = Part(node.name, "node", {"Node": key_of(node), **self._with_paths(properties_of(node))},
                            children, origin=lambda: _alone(node))
            elif not children or (node.name == "difference" and counted[0] is None):
                raise Unfit(node.name)  # nothing at all; others may mind that
            elif len(children) == 1:
                part = children[0]
            else:
                named = node.name if node.name in ("difference", "intersection") else "union"
                coloured = children[:1] if node.name == "difference" else children
                part = Part(named, "set", {"Operation": SETS[node.name]}, children,
                            colour=_common([child.colour for child in coloured]),
                            origin=lambda: ("".join(child.text() for child, _, _ in below)
                                            if SETS[node.name] == "Union" else _alone(node)))
            if node.name == "multmatrix":
                part, shown = self._moved(part, node), [self._moved(other, node) for other in shown]
            if node.name == "color":
                self._paint(part, node)
        except Unfit:
            part = self.text(node, node.name)
        part.highlight = part.highlight or node.highlight
        return part, shown

    def text(self, node, label):
        """A node and what is below it as one part with its text."""
        return Part(label, "text", {"Text": _alone(node), "Folder": self.folder})

    def _with_paths(self, values):
        return {**values, "File": os.path.join(self.folder, values["File"])} if values.get("File") else values

    @staticmethod
    def _moved(part, node):
        """Where a matrix puts it: by its placement where that can be, else within a part of its own. Raises Unfit."""
        matrix = properties_of(node)["Matrix"]
        columns = [FreeCAD.Vector(matrix.A[i], matrix.A[i + 4], matrix.A[i + 8]) for i in range(3)]
        lengths = [column.Length for column in columns]
        square = all(abs(columns[i] * columns[k]) <= RIGID * lengths[i] * lengths[k]
                     for i, k in ((0, 1), (0, 2), (1, 2)))
        if (matrix.A[12:] != (0, 0, 0, 1) or min(lengths) < 1e-9 or not square
                or (node.dimensions == 2 and not _in_plane(matrix))):
            return Part("multmatrix", "node", {"Node": "multmatrix", "Matrix": matrix}, [part], colour=part.colour)
        mirrored = columns[0].cross(columns[1]) * columns[2] < 0
        factors = [1.0 if abs(length - 1) <= RIGID else length for length in lengths]
        if mirrored:
            # Of the axes that could be mirrored, the one that leaves the least to turn: mirror([1, 0, 0]) is -1, 1, 1
            # and no turn.
            turned = min(range(3), key=lambda i: columns[i][i] / lengths[i])
            factors[turned] = -factors[turned]
        placement = _placement(columns, factors, (matrix.A14, matrix.A24, 0 if node.dimensions == 2 else matrix.A34))
        if factors != [1, 1, 1]:
            part = Part("mirror" if mirrored and sorted(map(abs, factors)) == [1, 1, 1] else "scale", "scaled",
                        {"Operation": "Transform", "Factors": FreeCAD.Vector(*factors), "Step": FreeCAD.Vector()},
                        [part], colour=part.colour)
        part.placement = placement.multiply(part.placement)
        return part

    @staticmethod
    def _paint(part, node):
        """The outermost colour holds."""
        colour = node.arguments.get("") or node.arguments.get("c")
        if not isinstance(colour, list) or len(colour) < 3 or any(not isinstance(share, float) for share in colour):
            return
        shares = tuple(min(max(share, 0.0), 1.0) for share in (*colour, 1.0)[:4])
        if colour[0] < 0:  # none was given: color() with an opacity only
            return
        for each in part.walk():
            each.colour = shares


def _alone(node):
    """The text of a node without its own modifiers."""
    return node.text().lstrip("%*!#")


def _common(colours):
    """The colour that all have; None where they differ."""
    return colours[0] if all(colour == colours[0] for colour in colours) else None


def _in_plane(matrix):
    """Whether it turns and moves flat shapes only within their plane."""
    return (matrix.A13, matrix.A23, matrix.A31, matrix.A32, matrix.A33) == (0, 0, 0, 0, 1)


def _placement(columns, factors, base):
    """Rotation and translation of a matrix whose columns, divided by their factors, are at right angles. Rounding to
    six digits is corrected."""
    x = columns[0] / factors[0]
    x.normalize()
    y = columns[1] / factors[1]
    y = y - x * (x * y)
    y.normalize()
    return FreeCAD.Placement(FreeCAD.Vector(*base), _rotation(x, y, x.cross(y)))


def _rotation(x, y, z):
    return FreeCAD.Rotation(FreeCAD.Matrix(x.x, y.x, z.x, 0, x.y, y.y, z.y, 0, x.z, y.z, z.z, 0, 0, 0, 0, 1))
