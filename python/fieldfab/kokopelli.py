"""kokopelli's shape library (Keeter 4.3, Appendix C), with its names, arguments and degrees, over fieldfab's own.

    from fieldfab.kokopelli import *
    part = circle(0, 0, 1) - rectangle(-0.2, 0.2, -2, 2)    # + is union, & intersection, - is difference
    part.color = "red"
    plate = extrusion(move(part, part.xmax, 0), 0, 0.5)

Flat shapes are unbounded along z until extruded.
"""

from __future__ import annotations

import functools as _functools
import math as _math

from . import shapes as _s
from . import text_widths as _widths
from ._core import Solid as _Solid
from ._core import X, Y, Z
from ._core import cos as _cos
from ._core import sqrt as _sqrt
from .math_tree import MathTree, matching
from .math_tree import kept as _kept
from .math_tree import placed as _placed
from .math_tree import plain as _plain

__all__ = """MathTree matching circle triangle right_triangle rectangle rounded_rectangle polygon tab slot text move
translate add subtract color rotate reflect_x reflect_y reflect_z reflect_xy reflect_xz reflect_yz scale_x scale_y
scale_z scale_xy scale_xyz taper_x_y taper_x_z taper_xy_z shear_x_y shear_x_z coscale_x_y coscale_x_z coscale_xy_z
twist_xy_z attract repel bend_x array array_xy iterate2d iterate_polar extrusion cylinder sphere cube box cone pyramid
torus loft loft_xy_z revolve_y revolve_x rotate_x rotate_y rotate_z blend morph shell offset clearance""".split()


def _shape(expression, *bounds):
    """Returns a shape; `bounds` are xmin, xmax, ymin, ymax and, unless it is flat, zmin, zmax."""
    made = MathTree(expression, shape=True)
    if bounds:
        made.bounds = [*bounds, None, None][:6]
    return made


def _about(expression, x0, y0, z0, change):
    """Applies `change` in coordinates relative to a point."""
    return _s.move(change(_s.move(_plain(expression), -x0, -y0, -z0)), x0, y0, z0)


# Flat shapes


def circle(x0, y0, r):
    r = abs(r)
    return _shape(_s.move(_s.circle(r), x0, y0), x0 - r, x0 + r, y0 - r, y0 + r)


def triangle(x0, y0, x1, y1, x2, y2):
    xs, ys = (x0, x1, x2), (y0, y1, y2)
    return _shape(_s.triangle(x0, y0, x1, y1, x2, y2), min(xs), max(xs), min(ys), max(ys))


def right_triangle(x0, y0, h):
    """A right triangle with the right angle at (x0, y0) and both legs of length h."""
    return triangle(x0, y0, x0 + h, y0, x0, y0 + h)


def rectangle(x0, x1, y0, y1):
    return _shape(_s.move(_s.rectangle(x1 - x0, y1 - y0), (x0 + x1) / 2, (y0 + y1) / 2), x0, x1, y0, y1)


def rounded_rectangle(x0, x1, y0, y1, r):
    """A rectangle; r is the corner radius as a fraction of half the shorter side, 0 to 1."""
    radius = r * min(x1 - x0, y1 - y0) / 2
    rounded = _s.rounded_rectangle(x1 - x0, y1 - y0, radius)
    return _shape(_s.move(rounded, (x0 + x1) / 2, (y0 + y1) / 2), x0, x1, y0, y1)


def polygon(*points):
    return _shape(_s.outline(*points))


def tab(x, y, width, height, angle=0, chamfer=0.2):
    """A tab that stands on (x, y); its upper corners are chamfered by a fraction of the height."""
    corner = triangle(width / 2 - chamfer * height, height, width / 2, height, width / 2, height - chamfer * height)
    upright = rectangle(-width / 2, width / 2, 0, height) - (corner + reflect_x(corner))
    return move(rotate(upright, angle), x, y)


def slot(x, y, width, height, angle=0, chamfer=0.2):
    """A slot that hangs from (x, y); its opening is widened on both sides by a fraction of the height."""
    mouth = triangle(width / 2, 0, width / 2 + chamfer * height, 0, width / 2, -chamfer * height)
    upright = rectangle(-width / 2, width / 2, -height, 0) + mouth + reflect_x(mouth)
    return move(rotate(upright, angle), x, y)


def _ink(drawn, cells=32):
    """Returns the range of x in which a letter of height 1 may have strokes, or None. Uses intervals over cells."""
    field, size = _Solid(drawn), 1 / cells
    found = [i for i in range(-cells // 4, cells * 5 // 4) if any(
        field.interval((i * size, j * size, 0, (i + 1) * size, (j + 1) * size, 0))[0] <= 0
        for j in range(-cells // 2, cells * 5 // 4))]
    return (found[0] * size, (found[-1] + 1) * size) if found else None


@_functools.lru_cache(maxsize=None)
def _letter(letter):
    """Returns a letter of height 1 on the base line with kokopelli's width; None for a letter without strokes."""
    drawn = _s.text(letter, h=1, weight=1 / 7)
    ink, wide = _ink(drawn), _widths.width_of(letter)
    if ink is None:
        return None
    size = min(1.0, wide / (ink[1] - ink[0]))
    return _s.move(_s.scale_xyz(_s.move(drawn, -(ink[0] + ink[1]) / 2), size), wide / 2)


def text(text, x, y, height=1, align="CC"):
    """Returns text; `align` is L, C or R, then T, C or B. None for text without strokes."""
    lines = text.split("\n")
    tall = 1 + _widths.LINE * (len(lines) - 1)
    base = {"T": -1.0, "C": tall / 2 - 1, "B": tall - 1}[align[1]]
    letters, left, right, low = [], [], [], []
    for line in lines:
        wide = _widths.width_of(line)
        at = {"L": 0.0, "C": -wide / 2, "R": -wide}[align[0]]
        left, right = left + [at], right + [at + wide]
        for letter in line:
            if letter.strip() and _letter(letter) is not None:
                letters.append(_s.move(_letter(letter), at, base))
                low.append(base - _widths.DESCENTS.get(letter, 0.0))
            at += _widths.width_of(letter) + _widths.GAP
        base -= _widths.LINE
    if not letters:
        return None
    drawn = _s.union(*letters) if len(letters) > 1 else letters[0]
    top = {"T": 0.0, "C": tall / 2, "B": tall}[align[1]]
    shape = _shape(_s.scale_xyz(drawn, height, height), *(height * v for v in (min(left), max(right), min(low), top)))
    return move(shape, x, y)


# Solids


def extrusion(part, z0, z1):
    return _kept(_s.extrude(_plain(part), z1 - z0, z0), part, lambda flat: [*flat[:4], z0, z1])


def cylinder(x0, y0, z0, z1, r):
    return extrusion(circle(x0, y0, r), z0, z1)


def sphere(x0, y0, z0, r):
    return _shape(_s.move(_s.sphere(r), x0, y0, z0), x0 - r, x0 + r, y0 - r, y0 + r, z0 - r, z0 + r)


def cube(x0, x1, y0, y1, z0, z1):
    return extrusion(rectangle(x0, x1, y0, y1), z0, z1)


box = cube


def cone(x0, y0, z0, z1, r):
    """A cone with its base of radius r at z0 and its tip at z1."""
    return _shape(_s.move(_s.cone(r, z1 - z0), x0, y0, (z0 + z1) / 2), x0 - r, x0 + r, y0 - r, y0 + r, z0, z1)


def pyramid(x0, x1, y0, y1, z0, z1):
    upright = _s.pyramid(x1 - x0, y1 - y0, z1 - z0)
    return _shape(_s.move(upright, (x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2), x0, x1, y0, y1, z0, z1)


def torus(x0, y0, z0, R, r):
    return _shape(_s.move(_s.torus(R, r), x0, y0, z0), x0 - R - r, x0 + R + r, y0 - R - r, y0 + R + r, z0 - r, z0 + r)


@matching
def loft_xy_z(a, b, z0, z1):
    return _shape(_s.move(_s.loft(_s.move(_plain(a), 0, 0, -z0), _s.move(_plain(b), 0, 0, -z0), z1 - z0), 0, 0, z0))


loft = loft_xy_z


def revolve_y(part):
    """Revolves the half x > 0 about the y axis."""
    def turned(b):
        r = None if b[0] is None else max(abs(b[0]), abs(b[1]))
        return [r if r is None else -r, r, b[2], b[3], r if r is None else -r, r]
    return _kept(_plain(part).map(x=_sqrt(X * X + Z * Z)), part, turned)


def revolve_x(part):
    """Revolves the half y > 0 about the x axis."""
    def turned(b):
        r = None if b[2] is None else max(abs(b[2]), abs(b[3]))
        return [b[0], b[1], r if r is None else -r, r, r if r is None else -r, r]
    return _kept(_plain(part).map(y=_sqrt(Y * Y + Z * Z)), part, turned)


# Sets and colours


def add(a, b):
    return a + b


def subtract(a, b):
    return a - b


def color(part, rgb):
    """Returns a copy in another colour."""
    painted = part.clone()
    painted.color = rgb
    return painted


# Moving and bending; angles in degrees. placed() takes functions that map points of the part.


def move(part, dx, dy, dz=0):
    return _placed(_s.move(_plain(part), dx, dy, dz), part, lambda x, y, z: (x + dx, y + dy, z + dz))


translate = move


def _turned(angle, a, b):
    """Returns the coordinates a and b, rotated by an angle in degrees."""
    cos, sin = _math.cos(_math.radians(angle)), _math.sin(_math.radians(angle))
    return cos * a - sin * b, sin * a + cos * b


def rotate(part, angle, x0=0, y0=0):
    def forward(x, y, z):
        u, v = _turned(angle, x - x0, y - y0)
        return x0 + u, y0 + v, z
    return _placed(_about(part, x0, y0, 0, lambda s: _s.rotate_z(s, _math.radians(angle))), part, forward)


rotate_z = rotate


def rotate_x(part, angle, y0=0, z0=0):
    def forward(x, y, z):
        u, v = _turned(angle, y - y0, z - z0)
        return x, y0 + u, z0 + v
    return _placed(_about(part, 0, y0, z0, lambda s: _s.rotate_x(s, _math.radians(angle))), part, forward)


def rotate_y(part, angle, x0=0, z0=0):
    """Rotates x towards z, as kokopelli does: opposite to the right-hand rule."""
    def forward(x, y, z):
        u, v = _turned(angle, x - x0, z - z0)
        return x0 + u, y, z0 + v
    return _placed(_about(part, x0, 0, z0, lambda s: _s.rotate_y(s, -_math.radians(angle))), part, forward)


def reflect_x(part, x0=0):
    return _placed(_plain(part).map(x=2 * x0 - X), part, lambda x, y, z: (2 * x0 - x, y, z))


def reflect_y(part, y0=0):
    return _placed(_plain(part).map(y=2 * y0 - Y), part, lambda x, y, z: (x, 2 * y0 - y, z))


def reflect_z(part, z0=0):
    return _placed(_plain(part).map(z=2 * z0 - Z), part, lambda x, y, z: (x, y, 2 * z0 - z))


def reflect_xy(part):
    return _placed(_plain(part).map(x=Y, y=X), part, lambda x, y, z: (y, x, z))


def reflect_xz(part):
    return _placed(_plain(part).map(x=Z, z=X), part, lambda x, y, z: (z, y, x))


def reflect_yz(part):
    return _placed(_plain(part).map(y=Z, z=Y), part, lambda x, y, z: (x, z, y))


def _scaled(part, origin, sizes):
    """Scales the part about a point. The factors are numbers, or functions of a point and formulas of X, Y and Z."""
    def sizes_at(x, y, z):
        return [size(x, y, z) if callable(size) else size for size in sizes]

    def forward(*point):
        return [o + s * (p - o) for o, s, p in zip(origin, sizes_at(*point), point)]
    x0, y0, z0 = origin
    return _placed(_about(part, x0, y0, z0, lambda s: _s.scale_xyz(s, *sizes_at(X, Y, Z))), part, forward)


def scale_x(part, x0, sx):
    return _scaled(part, (x0, 0, 0), (sx, 1, 1))


def scale_y(part, y0, sy):
    return _scaled(part, (0, y0, 0), (1, sy, 1))


def scale_z(part, z0, sz):
    return _scaled(part, (0, 0, z0), (1, 1, sz))


def scale_xy(part, x0, y0, sxy):
    return _scaled(part, (x0, y0, 0), (sxy, sxy, 1))


def scale_xyz(part, x0, y0, z0, sxyz):
    return _scaled(part, (x0, y0, z0), (sxyz, sxyz, sxyz))


def _between(at, low, high, first, last):
    """Interpolates from `first` where a coordinate is `low` to `last` where it is `high`."""
    return first + (last - first) * (at - low) / (high - low)


def taper_x_y(part, x0, y0, y1, s0, s1):
    return _scaled(part, (x0, 0, 0), (lambda x, y, z: _between(y, y0, y1, s0, s1), 1, 1))


def taper_x_z(part, x0, z0, z1, s0, s1):
    return _scaled(part, (x0, 0, 0), (lambda x, y, z: _between(z, z0, z1, s0, s1), 1, 1))


def taper_xy_z(part, x0, y0, z0, z1, s0, s1):
    def size(x, y, z):
        return _between(z, z0, z1, s0, s1)
    return _scaled(part, (x0, y0, 0), (size, size, 1))


def shear_x_y(part, y0, y1, dx0, dx1):
    return _placed(_plain(part).map(x=X - _between(Y, y0, y1, dx0, dx1)), part,
                   lambda x, y, z: (x + _between(y, y0, y1, dx0, dx1), y, z))


def shear_x_z(part, z0, z1, dx0, dx1):
    return _placed(_plain(part).map(x=X - _between(Z, z0, z1, dx0, dx1)), part,
                   lambda x, y, z: (x + _between(z, z0, z1, dx0, dx1), y, z))


def _wave(at, low, high, amplitude, offset, first, last):
    """Returns a scale factor that follows a cosine with a phase from `first` to `last` degrees."""
    return offset + amplitude * _cos(_between(at, low, high, _math.radians(first), _math.radians(last)))


def coscale_x_y(part, x0, y0, y1, phi0, phi1, amp, off):
    return _kept(_about(part, x0, 0, 0, lambda s: _s.scale_xyz(s, _wave(Y, y0, y1, amp, off, phi0, phi1))), part)


def coscale_x_z(part, x0, z0, z1, phi0, phi1, amp, off):
    return _kept(_about(part, x0, 0, 0, lambda s: _s.scale_xyz(s, _wave(Z, z0, z1, amp, off, phi0, phi1))), part)


def coscale_xy_z(part, x0, y0, z0, z1, phi0, phi1, amp, off):
    size = _wave(Z, z0, z1, amp, off, phi0, phi1)
    return _kept(_about(part, x0, y0, 0, lambda s: _s.scale_xyz(s, size, size)), part)


def twist_xy_z(part, x0, y0, z0, z1, t0, t1):
    """Twists about z: by t0 degrees at z0, by t1 degrees at z1."""
    angle = _between(Z, z0, z1, _math.radians(t0), _math.radians(t1))
    return _kept(_about(part, x0, y0, 0, lambda s: _s.rotate_z(s, angle)), part)


def attract(part, x, y, z, r):
    return _kept(_s.attract(_plain(part), x, y, z, r), part)


def repel(part, x, y, z, r):
    return _kept(_s.repel(_plain(part), x, y, z, r), part)


def bend_x(part, r):
    return _kept(_s.bend(_plain(part), r), part)


# Many, and mixtures


def iterate2d(part, i, j, dx, dy):
    return _kept(_s.array_xy(_plain(part), i, j, dx, dy), part)


array_xy = iterate2d


def array(part, count, dx):
    return _kept(_s.array_x(_plain(part), count, dx), part)


def iterate_polar(part, x0, y0, n):
    return _kept(_about(part, x0, y0, 0, lambda s: _s.array_polar(s, n)), part)


@matching
def blend(a, b, amount):
    return _kept(_s.blend(_plain(a), _plain(b), amount), MathTree.wrap(a) | MathTree.wrap(b), list)


@matching
def morph(a, b, weight):
    return _shape(_s.morph(_plain(a), _plain(b), weight))


def shell(part, thickness):
    return _kept(_s.shell(_plain(part), thickness), part)


def offset(part, distance):
    return _kept(_s.offset(_plain(part), distance), part)


@matching
def clearance(a, b, gap):
    return _shape(_s.clearance(_plain(a), _plain(b), gap))
