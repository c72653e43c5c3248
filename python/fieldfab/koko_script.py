"""Runs kokopelli's scripts (.ko, Keeter 4.3): Python 2 with a variable `cad` for results, and modules of `koko`."""

from __future__ import annotations

import ast
import contextlib
import math
import operator
import re
import sys
import types
from typing import Any

from . import kokopelli, kokopelli_pcb, python2, python2_names
from . import shapes as s
from ._core import Solid
from .math_tree import MathTree, matching

AXES = "xyz"


class Cad:
    """Results of a script: shapes (`cad.shapes`, `cad.shape` or `cad.function`), mm_per_unit, render_mode and
    bounds.
    """

    def __init__(self):
        self._shapes, self._render_mode, self._mm_per_unit = None, None, 25.4
        self.border = 0.05
        self._set_bounds = {}

    @property
    def shapes(self):
        return self._shapes

    @shapes.setter
    def shapes(self, value):
        if value is not None:
            value = [_checked(each) for each in (value if isinstance(value, (list, tuple)) else [value])]
        self._shapes = value

    @property
    def shape(self):
        """The union of all shapes, without colours."""
        if not self._shapes:
            return None
        joint = self._shapes[0]
        for each in self._shapes[1:]:
            joint = kokopelli.color(joint, None) + kokopelli.color(each, None)
        return joint

    @shape.setter
    def shape(self, value):
        self.shapes = value

    function = shape

    @property
    def mm_per_unit(self):
        return self._mm_per_unit

    @mm_per_unit.setter
    def mm_per_unit(self, value):
        number = float(value)
        if not (math.isfinite(number) and number > 0):
            raise ValueError(f"cad.mm_per_unit is a length in mm, not {value!r}")
        self._mm_per_unit = number

    @property
    def render_mode(self):
        return self._render_mode

    @render_mode.setter
    def render_mode(self, value):
        if value not in ("2D", "3D", None):
            raise ValueError(f"cad.render_mode is '2D' or '3D', not {value!r}")
        self._render_mode = value

    def _limit(self, axis, side):
        """A bound of all shapes with a margin, unless the script has set it."""
        if (axis, side) in self._set_bounds:
            return self._set_bounds[axis, side]
        if not self._shapes:
            return None
        low, high = ([each.bounds[2 * axis + end] for each in self._shapes] for end in (0, 1))
        if None in low + high:
            return None
        border = self.border * (max(high) - min(low)) / 2
        return max(high) + border if side else min(low) - border

    def _size(self, axis):
        low, high = self._limit(axis, 0), self._limit(axis, 1)
        return None if low is None or high is None else high - low

    @property
    def bounded(self):
        return all(self._size(axis) is not None for axis in range(3))


def _limit_property(axis, side):
    def put(cad, value):
        cad._set_bounds[axis, side] = None if value is None else float(value)
    return property(lambda cad: cad._limit(axis, side), put)


def _size_property(axis):
    return property(lambda cad: cad._size(axis))


for _i, _name in enumerate(AXES):
    setattr(Cad, _name + "min", _limit_property(_i, 0))
    setattr(Cad, _name + "max", _limit_property(_i, 1))
    setattr(Cad, "d" + _name, _size_property(_i))


def _checked(value):
    """Returns a shape of cad.shapes. Raises TypeError for another type."""
    if not isinstance(value, (MathTree, Solid, str, int, float)):
        found = "None" if value is None else f"a {type(value).__name__}"
        raise TypeError(f"cad.shapes takes shapes, and this is {found}")
    return MathTree.wrap(value)


# Handles of kokopelli's window (points, sliders, lines), stored in a comment at the top of a script

HEADER = re.compile(r"\A\s*##    Geometry header    ##\n(.*?)\n##    End of geometry header    ##[^\n]*\n", re.DOTALL)


class Handle:
    """A handle of the geometry header. Its parameters are formulas, which may refer to other handles."""

    DEFAULTS: dict[str, float | str] = {"x": 0, "y": 0}  # numbers or formulas

    def __init__(self, name="point", **formulas):
        self.name, self.formulas, self._others = name, {**self.DEFAULTS, **formulas}, {}
        self._asked = set()

    def __getattr__(self, parameter):
        formulas = self.__dict__.get("formulas", {})
        if parameter not in formulas:
            raise AttributeError(f"a {type(self).__name__} has no '{parameter}'")
        if parameter in self._asked:
            raise ValueError(f"the handle {self.name} asks for its own {parameter}")
        self._asked.add(parameter)
        try:
            known = {**vars(math), **self._others}
            value = eval(compile(str(formulas[parameter]), f"<{self.name}.{parameter}>", "eval"), known)
        finally:
            self._asked.discard(parameter)
        return float(value) if isinstance(value, (int, float)) else value


class Point(Handle):
    pass


class Slider(Handle):
    DEFAULTS = {"x": 0, "y": 0, "min": 0, "max": 1, "value": 0.5, "size": 1}


class Line(Handle):
    DEFAULTS = {"A": "pt0", "B": "pt1"}
    x = property(lambda self: (self.A.x + self.B.x) / 2)
    y = property(lambda self: (self.A.y + self.B.y) / 2)


HANDLES = {"koko.prims.points.Point": Point, "koko.prims.utils.Slider": Slider, "koko.prims.lines.Line": Line}


def _elements(node):
    """Returns the nodes of a list or tuple. Raises ValueError for other expressions."""
    if not isinstance(node, (ast.List, ast.Tuple)):
        raise ValueError(f"'{ast.unparse(node)}' is not a list")
    return node.elts


def handles_of(header):
    """Returns the handles of a geometry header by name. Parses the header; does not execute it."""
    made = {}
    try:
        for pair in _elements(ast.parse(header.strip(), mode="eval").body):
            kind, parameters = _elements(pair)
            handle = HANDLES[ast.unparse(kind)](**ast.literal_eval(parameters))
            made[handle.name] = handle
    except (SyntaxError, ValueError, TypeError, AttributeError, KeyError) as error:
        raise ValueError(f"the geometry header cannot be read: {error}") from None
    for handle in made.values():
        handle._others.update(made)
    return made


# The modules


def _modules(python2_math):
    """Returns kokopelli's modules for scripts, by name."""
    shapes: dict[str, Any] = {name: getattr(kokopelli, name) for name in kokopelli.__all__}
    shapes.update(X=MathTree.X(), Y=MathTree.Y(), Z=MathTree.Z(), math=python2_math)
    flat = {name: value for name, value in shapes.items() if name != "text"}
    boards: dict[str, Any] = {
        name: value for name, value in vars(kokopelli_pcb).items() if isinstance(value, type)}
    boards.update({name: getattr(math, name) for name in ("cos", "sin", "atan2", "radians", "degrees", "sqrt")},
                  operator=operator, text=kokopelli.text)
    contents: dict[str, dict[str, Any]] = {
        "koko": {}, "koko.lib": {}, "koko.fab": {}, "koko.prims": {},
        "koko.lib.shapes2d": flat, "koko.lib.shapes3d": flat, "koko.lib.shapes": flat, "koko.lib.text": shapes,
        "koko.lib.pcb": boards,
        "koko.fab.tree": {"MathTree": MathTree, "matching": matching, **{name: shapes[name] for name in "XYZ"}},
        "koko.fab.fabvars": {"FabVars": Cad, "MathTree": MathTree, "color": kokopelli.color},
        "koko.prims.points": {"Point": Point}, "koko.prims.lines": {"Line": Line},
        "koko.prims.utils": {"Slider": Slider},
    }
    modules = {}
    for name, names in contents.items():
        modules[name] = module = types.ModuleType(name)
        vars(module).update(names)
        if name in ("koko", "koko.lib", "koko.fab", "koko.prims"):
            module.__path__ = []
        outer, _, inner = name.rpartition(".")
        if outer:
            setattr(modules[outer], inner, module)
    vars(modules["koko.lib.pcb"])["s2d"] = modules["koko.lib.shapes2d"]
    return modules


@contextlib.contextmanager
def _in_place(modules):
    """Context manager that installs modules in sys.modules temporarily."""
    before = {name: sys.modules.get(name) for name in modules}
    sys.modules.update(modules)
    try:
        yield
    finally:
        for name, module in before.items():
            if module is None:
                sys.modules.pop(name, None)
            else:
                sys.modules[name] = module


def _execute(code, names=None, local_names=None):
    """Implements Python 2's exec statement, for a text or compiled code."""
    if isinstance(code, tuple):  # exec(code, globals, locals)
        code, names, local_names = (*code, None)[:3]
    names.setdefault("__builtins__", python2_names.builtins_of_python2(_execute))
    exec(python2.compiled(code, "<exec>") if isinstance(code, str) else code, names, local_names)


# Running a script


def run(path):
    """Runs a script. Returns its variables, except loop variables, and its Cad. Raises what the script raises."""
    text = python2.read(path).replace("\r\n", "\n")
    header = HEADER.match(text)
    older = python2_names.modules()
    modules = _modules(older["math"])
    given = handles_of(header.group(1)) if header else {}
    if header:
        text = "\n" * header.group().count("\n") + text[header.end():]
    names = {"__name__": "__main__", "__file__": path, "__builtins__": python2_names.builtins_of_python2(_execute),
             "cad": Cad(), **given}
    with _in_place({**older, **modules}):
        exec(python2.compiled(text, path), names)
    cad = names.get("cad")
    if not isinstance(cad, Cad):
        raise ValueError("the script's 'cad' is no longer kokopelli's")
    imported = {id(value) for module in modules.values() for value in vars(module).values()}
    loops = python2.loop_names(text)
    return {name: value for name, value in names.items() if name not in loops and id(value) not in imported}, cad


def parts(path):
    """Returns the parts of a script, each (formula in mm, name, colour)."""
    variables, cad = run(path)
    if cad.shapes is None:
        raise ValueError("the script sets neither cad.shape nor cad.shapes")
    if not cad.shapes:
        raise ValueError("cad.shapes is empty")
    shapes = [_checked(each) for each in cad.shapes]
    names = _names(cad.shapes, variables)
    return [(_in_mm(shape, cad), name, _colour(shape.color)) for shape, name in zip(shapes, names)]


def _in_mm(shape, cad):
    size = cad.mm_per_unit
    return s.scale(_within(shape, cad), size)


def _within(shape, cad):
    """Returns the formula; if no bounds can be found, its intersection with the bounds known by construction or set
    by the script.
    """
    formula = Solid(shape)
    limits = shape.known_bounds or [cad._set_bounds.get((i // 2, i % 2)) for i in range(6)]
    if None in limits[:4] or _ends_at(formula, limits):
        return formula
    if Solid(formula).bounds() or Solid(s.extrude(formula, 1.0)).bounds():
        return formula
    box = kokopelli.rectangle(*limits[:4])
    return s.intersection(formula, Solid(box if None in limits else kokopelli.extrusion(box, *limits[4:])))


def _ends_at(formula, limits):
    """Whether intervals prove that a shape lies within its bounds, searched up to a thousand times its size. Much
    faster than a search for bounds.
    """
    field = Solid(formula)
    size = max(limits[1] - limits[0], limits[3] - limits[2])
    for i, limit in enumerate(limits):
        if limit is not None:
            slab = [-1000.0 * size] * 3 + [1000.0 * size] * 3  # xmin, ymin, zmin, xmax, ymax, zmax
            slab[i // 2 + (0 if i % 2 else 3)] = limit + (0.001 if i % 2 else -0.001) * size
            if not field.interval(slab)[0] > 0:
                return False
    return True


def _colour(rgb):
    return rgb and "#" + "".join(f"{min(255, max(0, round(each))):02x}" for each in rgb)


def _names(shapes, variables):
    """Returns a unique name for each shape, from its variable, its list or its index; None for a single shape
    without either.
    """
    known = {id(value): name for name, value in reversed(variables.items()) if isinstance(value, Solid)}
    for name, value in variables.items():
        if isinstance(value, (list, tuple)):
            for i, each in enumerate(value):
                known.setdefault(id(each), f"{name} {i + 1}")
    if len(shapes) == 1:
        return [known.get(id(shapes[0]))]
    made = []
    for i, shape in enumerate(shapes):
        name = wanted = known.get(id(shape), f"part {i + 1}")
        again = 1
        while name in made:
            again += 1
            name = f"{wanted} ({again})"
        made.append(name)
    return made
