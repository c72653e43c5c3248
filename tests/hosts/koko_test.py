"""kokopelli's scripts: Python 2, results and error messages."""

import ast
import math
import os
import random
import re
import subprocess
import sys

import numpy as np
import pytest
from conftest import BUILD, DATA

import fieldfab as ff
from fieldfab import kokopelli as k
from fieldfab import koko_script, kokopelli_pcb, python2
from fieldfab import shapes as s

INCH = 25.4
PART = re.compile(r'part\(([^"]*), "((?:[^"\\]|\\.)*)"(?:, "(#[0-9a-f]{6})")?\)')


def answer_of(path):
    """Returns the output of `python3 -m fieldfab.script`."""
    environment = {**os.environ, "PYTHONPATH": str(BUILD / "python")}
    words = [sys.executable, "-m", "fieldfab.script", path]
    done = subprocess.run(words, capture_output=True, text=True, env=environment, timeout=100)
    assert done.returncode == 0, done.stderr
    return done.stdout


def answer_to(tmp_path, text, name="design.ko"):
    (tmp_path / name).write_text(text)
    return answer_of(tmp_path / name)


def parts_in(answer):
    """Returns the parts of an answer: (formula, name, colour)."""
    assert answer.startswith("ok\n") and answer.endswith("\n")
    parts, bindings = [], []
    for line in answer[3:].splitlines():
        if re.match(r"\w+ = ", line):
            bindings.append(line)
            continue
        found = PART.fullmatch(line)
        result, name, colour = found.groups() if found else (line, None, None)
        name = name and re.sub(r"\\(.)", r"\1", name)
        parts.append((ff.parse("\n".join([*bindings, result])), name, colour))
        bindings = []
    assert bindings == []
    return parts


def koko(tmp_path, text):
    return parts_in(answer_to(tmp_path, "from koko.lib.shapes import *\ncad.mm_per_unit = 1\n" + text))


def area(shape, low, high, count=1000):
    step = (np.array(high) - low) / count
    x, y = (low[i] + step[i] * (np.arange(count) + 0.5) for i in (0, 1))
    return float((shape(x[:, None], y[None, :], 0.0) < 0).mean()) * (high[0] - low[0]) * (high[1] - low[1])


# The two scripts written for these tests


@pytest.fixture(scope="module")
def mill():
    return parts_in(answer_of(DATA / "koko" / "mill.ko"))


def test_mill_has_its_names_and_colours(mill):
    names = ["base", *(f"columns {i + 1}" for i in range(4))]
    names += [f"{name} {i + 1}" for name in ("plates", "balls", "pins") for i in range(10)]
    assert [name for _, name, _ in mill] == names
    colours = ["#787882", *["#ff0000"] * 4, *(f"#{220 - 10 * i:02x}997f" for i in range(10)), *[None] * 20]
    assert [colour for _, _, colour in mill] == colours


def mill_expected():
    """Returns volume and bounds of each part, inches."""
    yield 25.0, (-5, -5, -0.25, 5, 5, 0)
    for i in range(4):
        x, y = (i % 2) * 8 - 4, (i // 2) * 8 - 4
        yield math.pi * (0.25 - 0.0625) * 6, (x - 0.5, y - 0.5, 0, x + 0.5, y + 0.5, 6)
    for i in range(10):
        yield 24.0, (-5, -5, 6 + i, 5, 5, 6.25 + i)
    for i in range(10):
        r, x = 0.375, -4.5 + i
        yield 4 / 3 * math.pi * r**3, (x - r, -r, 30 - r, x + r, r, 30 + r)
    for i in range(10):
        r, x = 0.125 + 0.01 * i, i - 4.5
        yield math.pi * r * r * 2, (x - r, 2 - r, 40, x + r, 2 + r, 42)


@pytest.mark.parametrize("i", [0, 1, 4, 5, 14, 15, 24, 25, 34])
def test_mill_in_closed_form(mill, i):
    formula, _, _ = mill[i]
    volume, bounds = list(mill_expected())[i]
    low, high = ff.measure(formula).volume
    assert low <= volume * INCH**3 <= high and high - low < 0.002 * low
    assert np.allclose(np.array(ff.Solid(formula).bounds()) / INCH, bounds, atol=0.03)


def test_kit_is_flat_and_measures_what_it_should():
    [(kit, name, colour)] = parts_in(answer_of(DATA / "koko" / "kit.ko"))
    assert (name, colour) == ("kit", None)
    assert np.allclose(kit(3.0, 4.0, [-1e3, 0.0, 5.0]), kit(3.0, 4.0, 1.0))
    side, slot = 0.73, 0.15 * 0.13 + 0.03**2
    for i in range(3):
        for j in range(2):
            middle = np.array([i * 0.83, j * 0.83])
            found = area(kit, (middle - 0.4) * INCH, (middle + 0.4) * INCH) / INCH**2
            assert found == pytest.approx(side * side - 3 * slot, rel=4e-3)
    inside = [kit(x * INCH, -INCH, 0) < 0 for x in (0, -0.25, 0.27, 0.5)]
    assert inside == [True, False, True, False]
    turned = [(math.cos(math.radians(a)), math.sin(math.radians(a))) for a in (180, 300, 60)]
    assert all(kit(0.22 * u * INCH, (0.22 * v - 1) * INCH, 0) > 0 for u, v in turned)  # its three slots


# Python 2

PROGRAMS = {
    "7 / 2, -7 / 2, 7 / 2., 7.0 // 2": (3, -4, 3.5, 3.0),
    "map(lambda a: a * 2, [1, 2]) + filter(None, [0, 3])": [2, 4, 3],
    "map(None, [1, 2], [3]), map(max, [1, 5], [4, 2])": ([(1, 3), (2, None)], [4, 5]),
    "filter(lambda c: c > 'a', 'abc'), filter(None, (0, 1))": ("bc", (1,)),
    "zip([1, 2], 'ab') + [range(3), range(4, 0, -2)]": [(1, "a"), (2, "b"), [0, 1, 2], [4, 2]],
    "list(xrange(3)), reduce(lambda a, b: a + b, [1, 2, 3])": ([0, 1, 2], 6),
    "{'a': 1}.keys() + {'a': 1}.values(), {'a': 1}.items()[0]": (["a", 1], ("a", 1)),
    "{'a': 1}.has_key('a'), {}.has_key(1), list({1: 2}.iteritems())": (True, False, [(1, 2)]),
    "sorted([1, 3, 2], lambda a, b: cmp(b, a)), sorted('ba', key=ord)": ([3, 2, 1], ["a", "b"]),
    "0777, 0x1F, 10L, 0b11, 0": (511, 31, 10, 3, 0),
    "`1 + 1`, 1 <> 2, 1 <> 1": ("2", True, False),
    "unicode(3), long(4.5), isinstance(3L, (int, long)), isinstance(u'x', basestring)": ("3", 4, True, True),
    "'\\u12', u'\\u0041', ur'\\d', b'x', '\\x41'": ("\\u12", "A", "\\d", "x", "A"),
    "round(2.5), round(-0.5), round(1.25, 1)": (3.0, -1.0, 1.3),
    "(lambda (a, (b, c)), d=4: a + b * c - d)((1, (2, 3)))": 3,
    "[(lambda (i, p): i * p)(pair) for pair in enumerate([5, 6])]": [0, 6],
    "apply(max, [1, 2]), unichr(65), iter([7]).next()": (2, "A", 7),
    "None < -5, 3 < 'a', 'a' >= [], 2 < 1, 1 < 2 < 3, None > 0": (True, True, True, False, True, False),
    "sorted([3, None, 'b', 1]), cmp(None, 1), cmp(2, 1)": ([None, 1, 3, "b"], -1, 1),
    "'ab'.decode('utf-8'), 'a b'.split(), 'aa'.count('a')": ("ab", ["a", "b"], 2),
}
STATEMENTS = {
    "x = 9\nx /= 2": 4,
    "x = [9, 1]\nx[0] /= 2": [4, 1],
    "class C: pass\nc = C(); c.n = 7; c.n /= 2\nx = c.n": 3,
    "from __future__ import division\nx = 7 / 2": 3.5,
    "from __future__ import print_function\nprint('a', file=None)\nx = 1": 1,
    "try:\n    raise ValueError, 'bad'\nexcept (KeyError, ValueError), e:\n    pass\nx = str(e)": "bad",
    "try: raise KeyError, 5, None\nexcept KeyError, e: x = e.args": (5,),
    "if 1:\n        a = 1\n\tb = 2\nx = a + b": 3,
    "def f(a, (b, c), *d):\n    'words'\n    return a, b, c, d\nx = f(1, (2, 3), 4), f.func_name, f.__doc__":
        ((1, 2, 3, (4,)), "f", "words"),
    "x = [3, 1, 2]\nx.sort(lambda a, b: cmp(a, b))": [1, 2, 3],
    "x = [3, None, 'a']\nx.sort(reverse=True)": ["a", 3, None],
    "exec 'x = 5 / 2'": 2,
    "d = {}\nexec 'y = 5 / 2' in d\nx = d['y']": 2,
    "exec('x = 1; x /= 2')": 0,
    "import string\nfrom string import join\nx = string.letters[:2] + join(['a', 'b'], '-') + string.upper('c')":
        "aba-bC",
    "import itertools, sys\nx = list(itertools.izip([1], [2])), sys.maxint > 9": ([(1, 2)], True),
    "from StringIO import StringIO\nf = StringIO()\nprint >>f, 1, 'a',\nprint >>f\n"
    "print >> f, (1, 2)\nx = f.getvalue()":
        "1 a \n(1, 2)\n",
    "class C:\n  def next(self): return 3\n  def __iter__(self): return self\n  def __nonzero__(self): return False\n"
    "  def __div__(self, o): return 'div'\nx = iter(C()).next(), bool(C()), C() / 2": (3, False, "div"),
    "import math\nfrom koko.lib.shapes import math as m\nx = math.floor(3) / 2, m.ceil(3.) / 2": (1.5, 1.5),
    "class C:\n  def __init__(self, n): self.n = n\n  def __cmp__(self, o): return cmp(self.n, o.n)\n"
    "x = C(2) < C(1), C(2) >= C(1), cmp(C(1), C(2)), [c.n for c in sorted([C(2), C(1)])]": (False, True, -1, [1, 2]),
    "try: raise ValueError, 'bad'\nexcept ValueError, e: x = e.message": "bad",
    "nonlocal = 1; async = 2\nx = nonlocal + async": 3,
    "f = lambda: 1; x = f()": 1,
    "import os\nx = os.environ.keys()[:0], os.environ.has_key('no such name')": ([], False),
    "# -*- coding: latin-1 -*-\nx = 1; print x; print; print 'a' 'b', ; print(1, 2), -1": 1,
}


def run(tmp_path, text):
    path = tmp_path / "program.ko"
    path.write_bytes(text.encode())
    return koko_script.run(str(path))[0]


@pytest.mark.parametrize("expression", PROGRAMS)
def test_python2_expressions(tmp_path, expression):
    x, expected = run(tmp_path, f"x = {expression}\n")["x"], PROGRAMS[expression]
    assert x == expected and repr(x) == repr(expected)


@pytest.mark.parametrize("text", STATEMENTS)
def test_python2_statements(tmp_path, text):
    x, expected = run(tmp_path, text)["x"], STATEMENTS[text]
    assert x == expected and repr(x) == repr(expected)


def test_random_numbers_are_those_of_python2(tmp_path):
    """A text as seed is hashed as in Python 2 (version 1 in Python 3); choice() scales random()."""
    found = run(tmp_path, "from random import *\nseed('mtm a-z')\na = random()\n"
                          "seed(5)\nb = random()\nseed(5)\nc = choice(range(10))\n")
    expected = random.Random()
    expected.seed("mtm a-z", version=1)
    assert found["a"] == expected.random()
    assert found["b"] == random.Random(5).random() and found["c"] == int(random.Random(5).random() * 10)


def test_python2_text_keeps_its_lines():
    text = "a = '''\n\n'''\nprint (1,\n  2), \\\n  3\ndef f((a,\n  b)): return a\nx = 1 / \\\n 2\n"
    assert python2.rewritten(text)[0].count("\n") == text.count("\n")
    assert [node.lineno for node in ast.parse(python2.rewritten(text)[0]).body] == [1, 4, 7, 9]


with pytest.raises(ZeroDivisionError) as DIVISION:  # Python 3.14 says it in other words
    1 // 0

ERRORS = {
    "x = 1\nprint 1\ny = x / 0\n": f"error 3 ZeroDivisionError: {DIVISION.value}",
    "x = (1,\n     2\n\ny = 3\n": "error 1 SyntaxError: '(' was never closed",
    "def f(n):\n    return g(n)\n\nx = f(1)\n": "error 2 NameError: name 'g' is not defined",
    "from koko.lib.shapes import *\nc = circle(0, 0, 1)\nc.color = 'mauve'\n": "error 3 ValueError: no colour: 'mauve'",
    "from koko.lib.shapes import *\ncad.shapes = [circle(0, 0, 1), None]\n":
        "error 2 TypeError: cad.shapes takes shapes, and this is None",
    "cad.shapes = []\n": "error 0 cad.shapes is empty",
    "x = 1\n": "error 0 the script sets neither cad.shape nor cad.shapes",
    "\n\ncad.mm_per_unit = 0\n": "error 3 ValueError: cad.mm_per_unit is a length in mm, not 0",
    "cad.render_mode = '4D'\n": "error 1 ValueError: cad.render_mode is '2D' or '3D'",
    "name = raw_input('name: ')\n": "error 1 RuntimeError: raw_input(): a design script cannot ask for input",
    "from koko.lib.shapes import *\na = circle(0, 0, 1)\na.color = 'red'\nb = color(a, 'blue')\nc = a + b\n":
        "error 5 ValueError: objects of different colours cannot be combined",
    "from koko.lib.pcb import *\nr = R_1206(0, 0)\nr['A']\n": "error 3 IndexError: R_1206 has no pin 'A'; it has 2",
    "raise SystemExit, 3\n": "error 0 the script ended itself with 3",
    "import koko.fab.asdf\n": "error 1 ModuleNotFoundError: No module named 'koko.fab.asdf'",
    "cad = 3\n": "error 0 the script's 'cad' is no longer kokopelli's",
    "##    Geometry header    ##\n[(os.system, {'name': 'a'})]\n##    End of geometry header    ##\nx = 1\n":
        "error 0 the geometry header cannot be read",
}


@pytest.mark.parametrize("text", ERRORS)
def test_errors_name_their_line(tmp_path, text):
    answer = answer_to(tmp_path, text)
    assert answer.startswith(ERRORS[text]) and "\n" not in answer


# Shapes of scripts


def test_none_is_no_shape(tmp_path):
    [(formula, name, _)] = koko(tmp_path, "a = None\na += circle(0, 0, 1)\na = a + None - None\ncad.shape = a\n")
    assert name == "a" and formula(0.5, 0, 0) == pytest.approx(-0.5)


def test_names_are_found_and_unique(tmp_path):
    parts = koko(tmp_path, "a = circle(0, 0, 1)\nrow = [move(a, i, 0) for i in range(2)]\n"
                           "for b in row: b.color = (1.4, 300 - 100, 255)\n"
                           "cad.shapes = [a, a] + row + [circle(0, 0, 2)]\n")
    assert [name for _, name, _ in parts] == ["a", "a (2)", "row 1", "row 2", "part 5"]
    assert [colour for _, _, colour in parts] == [None, None, "#01c8ff", "#01c8ff", None]


def test_units_default_to_inches_and_function_takes_math_strings(tmp_path):
    [(formula, name, colour)] = parts_in(answer_to(tmp_path, "cad.function = '-r+qXqYf2'\n"))
    assert (name, colour) == (None, None) and formula(0, 3 * INCH, 0) == pytest.approx(INCH)


def test_what_has_no_end_ends_at_its_bounds(tmp_path):
    """A mould, the complement of a ball, as in kokopelli's examples."""
    [(formula, _, _)] = koko(tmp_path, "m = MathTree(-1)\nm -= sphere(0, 0, 0, 1)\n"
                                       "m.bounds = [-2, 2, -2, 2, -2, 0]\ncad.shape = m\n")
    low, high = ff.measure(formula).volume
    assert low <= 32 - 2 / 3 * math.pi <= high


def test_formulas_are_arithmetic_and_shapes_are_sets(tmp_path):
    """A tooth made of formulas; `shape` decides between arithmetic and sets."""
    [(formula, _, _)] = koko(tmp_path, "r = MathTree.sqrt(MathTree.square(X) + MathTree.square(Y))\n"
                                       "t = 2 * r - 1 / MathTree.max(r, 0.5)\nt.shape = True\nt &= -X\ncad.shape = t\n")
    x, y, _ = np.random.default_rng(1).uniform(-2, 2, (3, 500))
    r = np.hypot(x, y)
    assert np.allclose(formula(x, y, 0.0), np.maximum(2 * r - 1 / np.maximum(r, 0.5), -x), atol=1e-5)


def test_handles_of_the_window_have_values(tmp_path):
    header = ("##    Geometry header    ##\n"
              "[(koko.prims.points.Point, {'name': 'p', 'x': '1.5', 'y': 'width.value + sqrt(4)'}),"
              "(koko.prims.utils.Slider, {'name': 'width', 'min': '0', 'max': '9', 'value': '5', 'size': '1'})]\n"
              "##    End of geometry header    ##\n")
    found = run(tmp_path, header + "x = p.x, p.y, width.value, width.max\n")["x"]
    assert found == (1.5, 7.0, 5.0, 9.0)
    assert answer_to(tmp_path, header + "x = 1 / 0\n").startswith("error 4 ")


BOUNDS = {
    "circle(1, 2, 3)": [-2, 4, -1, 5, None, None],
    "circle(0, 0, 2) + rectangle(1, 5, 0, 1)": [-2, 5, -2, 2, None, None],
    "circle(0, 0, 2) & rectangle(1, 5, 0, 1)": [1, 2, 0, 1, None, None],
    "circle(0, 0, 2) - rectangle(1, 5, -9, 9)": [-2, 2, -2, 2, None, None],
    "extrusion(rectangle(0, 2, 0, 1), -1, 3)": [0, 2, 0, 1, -1, 3],
    "rotate(rectangle(0, 2, 0, 1), 90)": [-1, 0, 0, 2, None, None],
    "rotate_x(cube(0, 1, 0, 2, 0, 3), 90)": [0, 1, -3, 0, 0, 2],
    "rotate_y(cube(0, 1, 0, 2, 0, 3), 90)": [-3, 0, 0, 2, 0, 1],
    "reflect_xz(cube(0, 1, 0, 2, 0, 3))": [0, 3, 0, 2, 0, 1],
    "reflect_x(cube(0, 1, 0, 2, 0, 3), 2)": [3, 4, 0, 2, 0, 3],
    "scale_xy(cube(0, 1, 0, 2, 0, 3), 0, 1, 2)": [0, 2, -1, 3, 0, 3],
    "taper_x_y(rectangle(-1, 1, 0, 2), 0, 0, 2, 1, 3)": [-3, 3, 0, 2, None, None],
    "shear_x_y(rectangle(0, 1, 0, 2), 0, 2, 0, 5)": [0, 6, 0, 2, None, None],
    "move(revolve_y(rectangle(1, 2, 0, 1)), 0, 1, 0)": [-2, 2, 1, 2, -2, 2],
    "blend(circle(0, 0, 1), circle(2, 0, 1), 0.2)": [-1, 3, -1, 1, None, None],
    "rotate_x(circle(0, 0, 1), 30)": [-1, 1, None, None, None, None],
    "color(sphere(0, 0, 0, 1), 'red')": [-1, 1, -1, 1, -1, 1],
}


@pytest.mark.parametrize("expression", BOUNDS)
def test_bounds_follow_the_making(expression):
    shape = eval(expression, vars(k).copy())
    assert shape.known_bounds is not None
    assert [None if v is None else pytest.approx(v, abs=1e-9) for v in BOUNDS[expression]] == shape.bounds
    if shape.bounded:
        assert shape.dx == pytest.approx(shape.xmax - shape.xmin) and shape.dz == pytest.approx(shape.zmax - shape.zmin)


def test_bounds_of_other_shapes_are_searched_for():
    shape = k.MathTree(s.sphere(2))
    assert np.allclose(shape.bounds, [-2, 2] * 3, atol=0.02) and shape.dy == pytest.approx(4, abs=0.04)
    assert k.MathTree(-1).bounds == [None] * 6 and k.MathTree(-1).dx is None
    flat = k.MathTree(s.circle(1))
    assert flat.zmin is None and flat.xmax == pytest.approx(1, abs=0.02)
    flat.xmax = 7
    assert flat.xmax == 7 and flat.clone().bounds == flat.bounds


def test_map_bounds_takes_the_inverse():
    assert k.cube(0, 1, 0, 2, 0, 3).map_bounds(X="*f2X", Y="-YX") == pytest.approx([0, 2, -1, 2, 0, 3])
    assert k.circle(0, 0, 1).map_bounds(X="+XZ") == [None, None, -1, 1, None, None]


def test_colours_go_along(tmp_path):
    for text in ("move(a, 1, 2)", "a - b", "b + a", "extrusion(a, 0, 1)", "scale_x(a, 0, 2)", "blend(a, b, 1)",
                 "a.map(X=Y)", "a & b", "loft(a, b, 0, 1)", "revolve_y(a)", "shell(a, 0.1)"):
        made = f"a, b = circle(2, 0, 1), circle(2, 0, 2)\na.color = 'tan'\ncad.shape = {text}\n"
        [(_, _, colour)] = koko(tmp_path, made)
        assert colour == "#7d5a3c", text


def test_all_names_of_the_libraries_are_there(tmp_path):
    names = """circle triangle right_triangle rectangle rounded_rectangle tab slot move translate add subtract rotate
    reflect_x reflect_y reflect_xy scale_x scale_y scale_xy shear_x_y taper_x_y blend color extrusion cylinder sphere
    cube cone pyramid rotate_x rotate_y rotate_z reflect_z reflect_xz reflect_yz scale_z shear_x_z taper_xy_z revolve_y
    revolve_x loft MathTree X Y Z matching math""".split()
    boards = """PCB Component Pin BoundPin Point Connection R_1206 C_1206 SJ D_SOD_123 USB_mini_B Header_4 Header_ISP
    Header_FTDI NMOS_SOT23 PMOS_SOT23 Regulator_SOT23 XTAL_NX5032GA ATtiny45_SOIC ATtiny44_SOIC ATmega88_TQFP CBA
    s2d text radians""".split()
    text = ("import koko.lib.shapes2d as s2d\nimport koko.lib.shapes\n"
            "from koko.lib.text import *\nfrom koko.fab.tree import MathTree as M\n"
            f"from koko.lib.shapes import {', '.join(names)}\nfrom koko.lib.pcb import {', '.join(boards)}\n")
    found = run(tmp_path, text + "x = koko.lib.shapes.circle is s2d.circle, M is MathTree, callable(text)\n")
    assert found["x"] == (True,) * 3


# Text and boards


def test_text_takes_the_room_of_kokopellis():
    """Widths of letters: H 0.6, i 0.15; gap 0.1; line height 1.55."""
    for align, x, y in (("LT", 0, -2), ("CC", -0.85, -1), ("RB", -1.7, 0)):
        shape = k.text("Hi", 0, 0, 2, align)
        assert shape.bounds[:4] == pytest.approx([x, x + 1.7, y, y + 2])
    two = k.text("H\ny", 1, 2, align="LB")
    assert two.bounds[:4] == pytest.approx([1, 1.6, 2 - 0.375, 2 + 2.55])
    found = ff.Solid(k.extrusion(k.text("Wide", 0, 0, align="LB"), 0, 1)).bounds()
    assert (found[0], found[3]) == pytest.approx((0, 0.8 + 0.15 + 0.525 + 0.55 + 0.3), abs=0.03)
    assert k.text(" \n", 0, 0) is None


def test_boards_connect_their_pins():
    board = kokopelli_pcb.PCB(0, 0, 1, 1)
    chip, jumper = kokopelli_pcb.ATtiny45_SOIC(0.5, 0.6, 90, "IC"), kokopelli_pcb.SJ(0.2, 0.2)
    board += chip
    board += jumper
    board.connectH(chip["VCC"], jumper[1])
    board.connectV(jumper[2], (0.8, 0.8), width=0.05)
    assert (chip["RST"].x, chip["RST"].y) == pytest.approx((0.5 - 0.075, 0.6 - 0.14))
    assert (chip[0].pin, chip[8].pin.name) == (chip[8].pin, "VCC") and (jumper[0].x, jumper[2].x) == (0.229, 0.229)
    corner, other = (jumper[1].x, chip["VCC"].y), (jumper[2].x, 0.8)
    for x, y in (corner, other, (0.5, 0.8), (0.8 - 1e-3, 0.8), (chip["PB3"].x, chip["PB3"].y)):
        assert board.traces(x, y, 0) < 0, (x, y)
    assert board.traces(0.5, 0.83, 0) > 0 and board.traces.bounds == [0, 1, 0, 1, None, None]
    assert [each.color for each in board.layout] == [(125, 200, 60), (255, 90, 60), (125, 90, 60)]
    with pytest.raises(TypeError, match="components and connections"):
        board += 3
    for part in vars(kokopelli_pcb).values():
        if isinstance(part, type) and issubclass(part, kokopelli_pcb.Component) and part is not kokopelli_pcb.Component:
            placed = part(0.1, 0.2)
            assert all(placed.pads(placed[i + 1].x, placed[i + 1].y, 0) < 0 for i in range(len(part.pins))), part


# Python scripts give answers in the same form

SHAPES = "from fieldfab.shapes import *\nfrom fieldfab import X, Y, Z\n"


def test_python_scripts_name_their_solid(tmp_path):
    text = SHAPES + "a = sphere(9)\nsolid = box(2, 2, 2)\nb = sphere(3)\n"
    [(formula, name, colour)] = parts_in(answer_to(tmp_path, text, "model.py"))
    assert (name, colour) == (None, None) and formula(1.5, 0, 0) == pytest.approx(0.5)
    [(formula, _, _)] = parts_in(answer_to(tmp_path, SHAPES + "a = sphere(9)\nb = a\n", "model.py"))
    assert formula(10, 0, 0) == pytest.approx(1)
    (tmp_path / "library.py").write_text(SHAPES + "nut = sphere(3)\n")
    text = SHAPES + "from library import nut\nmine = nut - 1.0\n"
    [(formula, _, _)] = parts_in(answer_to(tmp_path, text, "model.py"))
    assert formula(10, 0, 0) == pytest.approx(6)


@pytest.mark.parametrize("text, message", [
    ("a = sphere(1)\nb = sphere(2)\n",
     "error 0 the script makes several shapes, a and b, and none is called 'solid'; name the parts with part(...)"),
    ("for i in range(12): globals()['s%d' % i] = sphere(i + 1)\n",
     "error 0 the script makes several shapes, " + ", ".join(f"s{i}" for i in range(10))
     + " and 2 more, and none is called 'solid'; name the parts with part(...)"),
    ("x = 1\n", "error 0 the script makes no shape: give one the name 'solid'"),
    ("a = 1\nb = box(1, 1)[0]\n", "error 4 TypeError"),
])
def test_python_scripts_say_what_is_missing(tmp_path, text, message):
    assert answer_to(tmp_path, SHAPES + text, "model.py").startswith(message)


def test_parts_have_names_of_their_own():
    from fieldfab.script import NoSolid, text_of_parts
    ball, box = s.sphere(1), s.box(1, 2, 3)
    assert text_of_parts([(ball, None, None)]) == str(ball) + "\n"
    text = text_of_parts([(ball, 'a "b" \\', "#010203"), (box, None, None), (box, "part 2", None)])
    assert [part[1:] for part in parts_in("ok\n" + text)] == [
        ('a "b" \\', "#010203"), ("part 2'", None), ("part 2", None)]
    with pytest.raises(NoSolid, match="two parts are called 'a'"):
        text_of_parts([(ball, "a", None), (box, "a", None)])
    turned = s.rotate_z(s.union(box, ball), 0.3)
    [(again, _, _)] = parts_in("ok\n" + text_of_parts([(turned, "turned", None)]))
    points = np.random.default_rng(2).uniform(-2, 2, (3, 500))
    assert np.allclose(again(*points), turned(*points), atol=1e-6)
