"""kokopelli's MathTree: a formula or a shape, with its colour and its bounds."""

from __future__ import annotations

import functools
import itertools
import math
import re

from . import _core
from . import shapes as s
from ._core import Solid

COLOURS = {"red": (255, 0, 0), "blue": (0, 0, 255), "green": (0, 255, 0), "white": (255, 255, 255),
           "grey": (128, 128, 128), "black": (0, 0, 0), "yellow": (255, 255, 0), "cyan": (0, 255, 255),
           "magenta": (255, 0, 255), "teal": (0, 255, 255), "pink": (255, 0, 255),
           "brown": (145, 82, 45), "tan": (125, 90, 60), "navy": (0, 0, 128)}
UNKNOWN = [None] * 6


def plain(value):
    """Returns the formula as a number: arithmetic on it is not set algebra."""
    return Solid(MathTree.wrap(value))


class _Text(str):
    """A math string: an attribute in kokopelli, and a method in fieldfab."""

    def __call__(self):
        return str(self)


class MathTree(Solid):
    """A formula. For shapes (`shape` is true) + is union, & intersection, - difference and ~ complement; for other
    formulas they are arithmetic. * and / are arithmetic for both. `math` is a number, a math string or a formula
    of fieldfab (a shape by default).
    """

    def __init__(self, math=0.0, shape=None, color=None):
        super().__init__(_core.parse_math(math) if isinstance(math, str) else math)
        self.shape = bool(getattr(math, "shape", isinstance(math, Solid)) if shape is None else shape)
        self.color = color
        self._bounds = None  # not yet searched

    @staticmethod
    def wrap(value):
        """Returns a MathTree of a number, a formula or a math string; None stays None."""
        if value is None or isinstance(value, MathTree):
            return value
        if not isinstance(value, (str, int, float, Solid)):
            raise TypeError(f"no shape and no number: {value!r}")
        return MathTree(value)

    def clone(self):
        copy = MathTree(self, self.shape, self._color)
        copy._bounds = self._bounds and list(self._bounds)
        return copy

    @property
    def math(self):
        return _Text(super().math())

    # Colour

    @property
    def color(self):
        return self._color

    @color.setter
    def color(self, rgb):
        """A name of COLOURS, three numbers from 0 to 255, or None."""
        if rgb is not None and not (isinstance(rgb, str) and rgb in COLOURS or _is_rgb(rgb)):
            known = ", ".join(COLOURS)
            raise ValueError(f"no colour: {rgb!r}; known are red, green and blue from 0 to 255, and the names {known}")
        self._color = COLOURS[rgb] if isinstance(rgb, str) else rgb and tuple(rgb)

    # Bounds

    @property
    def bounds(self):
        """xmin, xmax, ymin, ymax, zmin, zmax; None for an unbounded side. Sets keep kokopelli's bounds (a difference
        those of its left operand); for other shapes the bounds are searched, and may be slightly too large.
        """
        if self._bounds is None:
            self._bounds = _searched(self)
        return list(self._bounds)

    @bounds.setter
    def bounds(self, value):
        value = list(value)
        if len(value) != 6:
            raise ValueError(f"bounds are six numbers or None, not {len(value)}")
        self._bounds = [None if each is None else float(each) for each in value]

    @property
    def bounded(self):
        return None not in self.bounds

    @property
    def known_bounds(self):
        """The bounds known without a search, or None."""
        return self._bounds

    # Formulas

    def map(self, X=None, Y=None, Z=None, **lower):
        """Returns the formula with other coordinates (formulas, numbers, math strings)."""
        others = {name: each for name, each in (("x", X), ("y", Y), ("z", Z)) if each is not None} | lower
        return MathTree(plain(self).map(**{name: plain(each) for name, each in others.items()}), self.shape,
                        self._color)

    def map_bounds(self, X=None, Y=None, Z=None):
        """Returns the bounds after a map, computed from its inverse."""
        bounds, found = self.bounds, []
        known = [bounds[2 * i] is not None for i in range(3)]
        box = [bounds[2 * i + side] if known[i] else 0.0 for side in (0, 1) for i in range(3)]
        for i, each in enumerate((X, Y, Z)):
            formula = plain(each) if each is not None else (_core.X, _core.Y, _core.Z)[i]
            used = [name in re.findall(r"[a-z]\w*", str(formula)) for name in "xyz"]
            missing = any(u and not k for u, k in zip(used, known))
            found += (None, None) if missing else Solid(formula).interval(box)
        return found

    # Sets, and arithmetic

    def __add__(self, other):
        other = MathTree.wrap(other)
        if other is None:
            return self.clone()
        return _union(self, other) if self.shape or other.shape else _formula(plain(self) + plain(other))

    def __radd__(self, other):
        return self.clone() if other is None else MathTree.wrap(other) + self

    def __sub__(self, other):
        other = MathTree.wrap(other)
        if other is None:
            return self.clone()
        return _difference(self, other) if self.shape or other.shape else _formula(plain(self) - plain(other))

    def __rsub__(self, other):
        return _formula(-plain(self)) if other is None else MathTree.wrap(other) - self

    def __and__(self, other):
        return _intersection(*_of_shapes(self, other, "&"))

    def __rand__(self, other):
        return MathTree.wrap(other) & self

    def __or__(self, other):
        return _union(*_of_shapes(self, other, "|"))

    def __ror__(self, other):
        return MathTree.wrap(other) | self

    def __neg__(self):
        return MathTree(-plain(self), self.shape)

    __invert__ = __neg__

    def __mul__(self, other):
        return _formula(plain(self) * plain(other))

    def __rmul__(self, other):
        return _formula(plain(other) * plain(self))

    def __truediv__(self, other):
        return _formula(plain(self) / plain(other))

    def __rtruediv__(self, other):
        return _formula(plain(other) / plain(self))

    def __pow__(self, other):
        return _formula(plain(self) ** plain(other))

    def __rpow__(self, other):
        return _formula(plain(other) ** plain(self))

    @staticmethod
    def Constant(value):
        return MathTree(float(value))

    X = staticmethod(lambda: _formula(_core.X))
    Y = staticmethod(lambda: _formula(_core.Y))
    Z = staticmethod(lambda: _formula(_core.Z))
    min = staticmethod(lambda a, b: _formula(_core.minimum(plain(a), plain(b))))
    max = staticmethod(lambda a, b: _formula(_core.maximum(plain(a), plain(b))))
    pow = staticmethod(lambda a, b: _formula(plain(a) ** plain(b)))
    abs = staticmethod(lambda a: _formula(abs(plain(a))))
    sqrt = staticmethod(lambda a: _formula(_core.sqrt(plain(a))))
    square = staticmethod(lambda a: _formula(_core.square(plain(a))))
    sin = staticmethod(lambda a: _formula(_core.sin(plain(a))))
    cos = staticmethod(lambda a: _formula(_core.cos(plain(a))))
    tan = staticmethod(lambda a: _formula(_core.tan(plain(a))))
    asin = staticmethod(lambda a: _formula(_core.asin(plain(a))))
    acos = staticmethod(lambda a: _formula(_core.acos(plain(a))))
    atan = staticmethod(lambda a: _formula(_core.atan(plain(a))))


def _bound(i):
    def put(tree, value):
        tree.bounds = [*tree.bounds[:i], value, *tree.bounds[i + 1:]]
    return property(lambda tree: tree.bounds[i], put)


def _size(i):
    def size(tree):
        low, high = tree.bounds[2 * i:2 * i + 2]
        return None if low is None or high is None else high - low
    return property(size)


for _i, _axis in enumerate("xyz"):
    setattr(MathTree, f"{_axis}min", _bound(2 * _i))
    setattr(MathTree, f"{_axis}max", _bound(2 * _i + 1))
    setattr(MathTree, f"d{_axis}", _size(_i))


def _is_rgb(value):
    if not isinstance(value, (tuple, list)) or len(value) != 3:
        return False
    return all(isinstance(each, (int, float)) and 0 <= each <= 255 for each in value)


def _formula(expression):
    return MathTree(expression, shape=False)


def _of_shapes(a, b, operator):
    b = MathTree.wrap(b)
    if not (a.shape or b.shape):
        raise NotImplementedError(f"'{operator}' is of shapes, and these are formulas; set one's .shape to True")
    return a, b


def matching(function):
    """Decorator for functions of shapes: the result has the common colour of the arguments. Raises ValueError for
    two colours.
    """
    @functools.wraps(function)
    def matched(*arguments, **named):
        given = [*arguments, *named.values()]
        colours = {each.color for each in given if isinstance(each, MathTree) and each.shape and each.color is not None}
        if len(colours) > 1:
            raise ValueError("objects of different colours cannot be combined")
        result = function(*arguments, **named)
        if colours:
            result.color = colours.pop()
        return result
    return matched


def _set(expression, bounds):
    made = MathTree(expression, shape=True)
    made._bounds = bounds
    return made


def _joined(a, b, lower, upper):
    """Returns the bounds of a union or an intersection; None if those of an argument are unknown."""
    if a.known_bounds is None or b.known_bounds is None:
        return None
    found = []
    for i in (0, 2, 4):
        ends = [*a.known_bounds[i:i + 2], *b.known_bounds[i:i + 2]]
        found += [None, None] if None in ends else [lower(ends[0], ends[2]), upper(ends[1], ends[3])]
    return found


@matching
def _union(a, b):
    return _set(s.union(plain(a), plain(b)), _joined(a, b, min, max))


@matching
def _intersection(a, b):
    return _set(s.intersection(plain(a), plain(b)), _joined(a, b, max, min))


@matching
def _difference(a, b):
    return _set(s.difference(plain(a), plain(b)), a.known_bounds and list(a.known_bounds))


def kept(expression, part, bounds=None):
    """Returns a shape derived from `part` with its colour; `bounds` computes its bounds from those of `part`."""
    made = MathTree(expression, getattr(part, "shape", True), getattr(part, "color", None))
    if bounds is not None and getattr(part, "known_bounds", None) is not None:
        made._bounds = bounds(part.known_bounds)
    return made


def placed(expression, part, forward):
    """Returns a shape derived from `part` by a map of space; `forward` maps a point of the part and is linear in
    each coordinate.
    """
    def corners(bounds):
        axes = [bounds[i:i + 2] if None not in bounds[i:i + 2] else [math.nan] for i in (0, 2, 4)]
        found = []
        for values in zip(*(forward(*corner) for corner in itertools.product(*axes))):
            found += [None, None] if any(math.isnan(each) for each in values) else [min(values), max(values)]
        return found
    return kept(expression, part, corners)


def _searched(tree):
    for solid, axes in ((plain(tree), 3), (s.extrude(plain(tree), 1.0), 2)):
        found = Solid(solid).bounds()
        if found is not None:
            return [found[i + side] for i in range(axes) for side in (0, 3)] + UNKNOWN[2 * axes:]
    return list(UNKNOWN)
