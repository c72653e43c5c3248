"""Conversion of an OpenSCAD design's tree to parts, each of which becomes a document object. Groups with a single child
are skipped. Colours and transforms move to the parts. Changes no document."""

import dataclasses
import heapq
import itertools
import os
from collections.abc import Callable

import FreeCAD

from .openscad_nodes import Unfit, key_of, properties_of

# In larger designs, branches become single objects with their text: a larger tree would be slow and hard to use.
MOST_PARTS = 300
DEEPEST = 100  # nesting depth of parts
MOST_NODES = 20_000  # in the file, including groups and transforms; a larger file becomes one object
RIGID = 1e-5  # OpenSCAD writes matrices with six digits

SETS = {"group": "Union", "union": "Union", "render": "Union", "color": "Union", "multmatrix": "Union",
        "difference": "Difference", "intersection": "Intersection"}


class TooLarge(Exception):
    """The tree has too many nodes, or is too deep, for separate objects."""


@dataclasses.dataclass
class Part:
    """Description of an object to create: its type (`make`: node, set, scaled or text), properties, children, placement
    and looks."""

    label: str
    make: str
    values: dict
    children: list = dataclasses.field(default_factory=list)
    placement: FreeCAD.Placement = dataclasses.field(default_factory=FreeCAD.Placement)
    colour: tuple = None  # red, green, blue and opacity
    highlight: bool = False
    origin: Callable = None  # function that returns its text without the placement

    def walk(self):
        """Yields the part and all its descendants."""
        waiting = [self]
        while waiting:
            part = waiting.pop()
            yield part
            waiting += part.children

    def become_text(self, folder):
        """Replaces the branch below the part by its text."""
        self.make, self.values, self.children = "text", {"Text": self.origin(), "Folder": folder}, []


class Design:
    """The parts of a fieldfab.OpenScadTree that was read from a file in `folder`. `root`: the root part, or None for an
    empty design. `shown`: background parts (%). `branches`: number of branches converted to text because of their size.
    Raises TooLarge."""

    def __init__(self, tree, folder):
        self.folder = folder
        if len(tree) > MOST_NODES:
            raise TooLarge(len(tree))
        nodes = [tree[i] for i in range(len(tree))]
        start = next((i for i, node in enumerate(nodes) if node.root), 0)
        made = [None] * len(nodes)  # (the part or None, background parts)
        for i in reversed(range(len(nodes))):  # children come after their parents
            made[i] = self._made(nodes[i], [(nodes[child], *made[child]) for child in nodes[i].children])
        self.root, self.shown = made[start]
        self.branches = self._prune(([self.root] if self.root else []) + self.shown)

    def _prune(self, tops):
        """Reduces the parts to MOST_PARTS. Expands the largest branches first; the remaining branches become text.
        Returns the number of branches converted to text."""
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
        """Returns a node's part (or None) and its background parts. `below`: (child node, part, background parts) of
        each child."""
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
                raise Unfit(node.name)  # empty, which may matter to the parent: kept as text
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
        """Returns a node with its descendants as one part with its text."""
        return Part(label, "text", {"Text": _alone(node), "Folder": self.folder})

    def _with_paths(self, values):
        return {**values, "File": os.path.join(self.folder, values["File"])} if values.get("File") else values

    @staticmethod
    def _moved(part, node):
        """Applies a matrix to a part: as its placement if possible, otherwise as a part of its own around it. Raises
        Unfit."""
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
            # Mirrors the axis that leaves the smallest rotation: mirror([1, 0, 0]) gives the factors -1, 1, 1 without
            # a rotation.
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
        """Applies a colour to a part and its descendants. The outermost colour wins."""
        colour = node.arguments.get("") or node.arguments.get("c")
        if not isinstance(colour, list) or len(colour) < 3 or any(not isinstance(share, float) for share in colour):
            return
        shares = tuple(min(max(share, 0.0), 1.0) for share in (*colour, 1.0)[:4])
        if colour[0] < 0:  # color() without a colour, only with an opacity
            return
        for each in part.walk():
            each.colour = shares


def _alone(node):
    """Returns the text of a node without its own modifiers."""
    return node.text().lstrip("%*!#")


def _common(colours):
    """Returns the colour if all are equal, otherwise None."""
    return colours[0] if all(colour == colours[0] for colour in colours) else None


def _in_plane(matrix):
    """Returns whether the linear part of a matrix acts only within the xy plane, as a placement of a flat shape
    requires."""
    return (matrix.A13, matrix.A23, matrix.A31, matrix.A32, matrix.A33) == (0, 0, 0, 0, 1)


def _placement(columns, factors, base):
    """Returns the rotation and translation of a matrix whose columns, divided by `factors`, are orthonormal. Corrects
    the rounding to six digits."""
    x = columns[0] / factors[0]
    x.normalize()
    y = columns[1] / factors[1]
    y = y - x * (x * y)
    y.normalize()
    return FreeCAD.Placement(FreeCAD.Vector(*base), _rotation(x, y, x.cross(y)))


def _rotation(x, y, z):
    return FreeCAD.Rotation(FreeCAD.Matrix(x.x, y.x, z.x, 0, x.y, y.y, z.y, 0, x.z, y.z, z.z, 0, 0, 0, 0, 1))
