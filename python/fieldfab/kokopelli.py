"""kokopelli's shape library (Keeter 4.3, Appendix C), with its names, arguments and degrees, over fieldfab's own.

    from fieldfab.kokopelli import *
    part = circle(0, 0, 1) - rectangle(-0.2, 0.2, -2, 2)    # + is union, & intersection, - is difference

Flat shapes are unbounded along z until extruded.
"""

from __future__ import annotations

import math as _math

from . import shapes as _s
from ._core import Expression as _Expression
from ._core import X, Y, Z
from ._core import cos as _cos
from ._core import maximum as _max
from ._core import sqrt as _sqrt

__all__ = """MathTree circle triangle right_triangle rectangle rounded_rectangle polygon tab slot text move rotate reflect_x
reflect_y reflect_z reflect_xy reflect_xz reflect_yz scale_x scale_y scale_z scale_xy scale_xyz taper_x_y taper_x_z taper_xy_z
shear_x_y shear_x_z coscale_x_y coscale_x_z coscale_xy_z twist_xy_z attract repel bend_x array array_xy iterate2d iterate_polar
extrusion cylinder sphere cube box cone pyramid torus loft_xy_z revolve_y revolve_x rotate_x rotate_y rotate_z blend morph shell
offset clearance""".split()


class MathTree(_Expression):
    """A shape on which + is union, & and * intersection, - difference, and ~ the complement, as in kokopelli."""

    def __init__(self, value=0.0):
        super().__init__(value)

    def __add__(self, other):
        return _tree(_s.union(self, other))

    def __sub__(self, other):
        return _tree(_s.difference(self, other))

    def __and__(self, other):
        return _tree(_s.intersection(self, other))

    __mul__ = __and__
    __or__ = __add__

    def __neg__(self):
        return _tree(_Expression.__neg__(self))

    __invert__ = __neg__


def _tree(expression):
    return MathTree(expression)


def _moved(shape, dx=0.0, dy=0.0, dz=0.0):
    return _tree(_s.move(_plain(shape), dx, dy, dz))


def _plain(shape):
    """Arithmetic on a formula, not on a set."""
    return _Expression(shape)


def _about(shape, x0, y0, z0, change):
    """`change` as seen from a point."""
    return _tree(_s.move(change(_s.move(_plain(shape), -x0, -y0, -z0)), x0, y0, z0))


# Flat shapes


def circle(x0, y0, r):
    return _moved(_s.circle(r), x0, y0)


def triangle(x0, y0, x1, y1, x2, y2):
    return _tree(_s.triangle(x0, y0, x1, y1, x2, y2))


def right_triangle(x, y, h):
    """The right angle at (x, y), both legs h long."""
    return triangle(x, y, x + h, y, x, y + h)


def rectangle(x0, x1, y0, y1):
    return _moved(_s.rectangle(x1 - x0, y1 - y0), (x0 + x1) / 2, (y0 + y1) / 2)


def rounded_rectangle(x0, x1, y0, y1, r):
    """r is a share of half the shorter side, 0 to 1."""
    radius = r * min(x1 - x0, y1 - y0) / 2
    return _moved(_s.rounded_rectangle(x1 - x0, y1 - y0, radius), (x0 + x1) / 2, (y0 + y1) / 2)


def polygon(*points):
    return _tree(_s.outline(*points))


def tab(x, y, width, height, angle=0, chamfer=0.2):
    """Stands on (x, y); its upper corners are cut by a share of the width."""
    cut = _s.chamfer_intersection(_s.plane(0, 1, 0, height), _plain(abs(X)) - width / 2, chamfer * width)
    return move(rotate(_tree(_s.intersection(cut, -Y)), angle), x, y)


def slot(x, y, width, height, angle=0, chamfer=0.2):
    """Hangs from (x, y); its mouth is wider by a share of the width on each side."""
    return move(rotate(_tree(_s.slot(width, height, chamfer * width)), angle), x, y)


def text(words, x, y, height=1, align="CC"):
    """`align`: L, C or R, then T, C or B."""
    lines = words.split("\\n") if "\\n" in words else words.split("\n")
    unit = height / 6
    wide = max(len(line) for line in lines) * 6 * unit - 2 * unit
    tall = height + (len(lines) - 1) * 11 * unit
    dx = {"L": 0.0, "C": -wide / 2, "R": -wide}[align[0]]
    dy = {"T": -height, "C": tall / 2 - height, "B": tall - height}[align[1]]
    return _moved(_s.text("\n".join(lines), h=height, weight=height / 7), x + dx, y + dy)


# Solids


def extrusion(shape, z0, z1):
    return _tree(_s.extrude(_plain(shape), z1 - z0, z0))


def cylinder(x0, y0, z0, z1, r):
    return extrusion(circle(x0, y0, r), z0, z1)


def sphere(x0, y0, z0, r):
    return _moved(_s.sphere(r), x0, y0, z0)


def cube(x0, x1, y0, y1, z0, z1):
    return extrusion(rectangle(x0, x1, y0, y1), z0, z1)


box = cube


def cone(x0, y0, z0, z1, r):
    """Its base of radius r at z0, its tip at z1."""
    return _moved(_s.cone(r, z1 - z0), x0, y0, (z0 + z1) / 2)


def pyramid(x0, x1, y0, y1, z0, z1):
    return _moved(_s.pyramid(x1 - x0, y1 - y0, z1 - z0), (x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2)


def torus(x0, y0, z0, R, r):
    return _moved(_s.torus(R, r), x0, y0, z0)


def loft_xy_z(a, b, z0, z1):
    return _moved(_s.loft(_s.move(_plain(a), 0, 0, -z0), _s.move(_plain(b), 0, 0, -z0), z1 - z0), 0, 0, z0)


def revolve_y(shape):
    """The half x > 0 turned about the y axis."""
    return _tree(_plain(shape).map(x=_sqrt(X * X + Z * Z)))


def revolve_x(shape):
    """The half y > 0 turned about the x axis."""
    return _tree(_plain(shape).map(y=_sqrt(Y * Y + Z * Z)))


# Moving and bending; angles in degrees


def move(shape, dx, dy, dz=0):
    return _moved(shape, dx, dy, dz)


def rotate(shape, angle, x0=0, y0=0):
    return _about(shape, x0, y0, 0, lambda s: _s.rotate_z(s, _math.radians(angle)))


rotate_z = rotate


def rotate_x(shape, angle, y0=0, z0=0):
    return _about(shape, 0, y0, z0, lambda s: _s.rotate_x(s, _math.radians(angle)))


def rotate_y(shape, angle, x0=0, z0=0):
    return _about(shape, x0, 0, z0, lambda s: _s.rotate_y(s, _math.radians(angle)))


def reflect_x(shape, x0=0):
    return _tree(_plain(shape).map(x=2 * x0 - X))


def reflect_y(shape, y0=0):
    return _tree(_plain(shape).map(y=2 * y0 - Y))


def reflect_z(shape, z0=0):
    return _tree(_plain(shape).map(z=2 * z0 - Z))


def reflect_xy(shape):
    return _tree(_plain(shape).map(x=Y, y=X))


def reflect_xz(shape):
    return _tree(_plain(shape).map(x=Z, z=X))


def reflect_yz(shape):
    return _tree(_plain(shape).map(y=Z, z=Y))


def scale_x(shape, x0, sx):
    return _about(shape, x0, 0, 0, lambda s: _s.scale_xyz(s, sx))


def scale_y(shape, y0, sy):
    return _about(shape, 0, y0, 0, lambda s: _s.scale_xyz(s, 1, sy))


def scale_z(shape, z0, sz):
    return _about(shape, 0, 0, z0, lambda s: _s.scale_xyz(s, 1, 1, sz))


def scale_xy(shape, x0, y0, sxy):
    return _about(shape, x0, y0, 0, lambda s: _s.scale_xyz(s, sxy, sxy))


def scale_xyz(shape, x0, y0, z0, sxyz):
    return _about(shape, x0, y0, z0, lambda s: _s.scale_xyz(s, sxyz, sxyz, sxyz))


def _between(at, low, high, first, last):
    """From `first` where a coordinate is `low` to `last` where it is `high`."""
    return first + (last - first) * (at - low) / (high - low)


def taper_x_y(shape, x0, y0, y1, s0, s1):
    return _about(shape, x0, 0, 0, lambda s: _s.scale_xyz(s, _between(Y, y0, y1, s0, s1)))


def taper_x_z(shape, x0, z0, z1, s0, s1):
    return _about(shape, x0, 0, 0, lambda s: _s.scale_xyz(s, _between(Z, z0, z1, s0, s1)))


def taper_xy_z(shape, x0, y0, z0, z1, s0, s1):
    size = _between(Z, z0, z1, s0, s1)
    return _about(shape, x0, y0, 0, lambda s: _s.scale_xyz(s, size, size))


def shear_x_y(shape, y0, y1, dx0, dx1):
    return _tree(_plain(shape).map(x=X - _between(Y, y0, y1, dx0, dx1)))


def shear_x_z(shape, z0, z1, dx0, dx1):
    return _tree(_plain(shape).map(x=X - _between(Z, z0, z1, dx0, dx1)))


def _wave(at, low, high, amplitude, offset, first, last):
    """Scale by a cosine whose phase runs from `first` to `last` degrees."""
    return offset + amplitude * _cos(_between(at, low, high, _math.radians(first), _math.radians(last)))


def coscale_x_y(shape, x0, y0, y1, phi0, phi1, amp, off):
    return _about(shape, x0, 0, 0, lambda s: _s.scale_xyz(s, _wave(Y, y0, y1, amp, off, phi0, phi1)))


def coscale_x_z(shape, x0, z0, z1, phi0, phi1, amp, off):
    return _about(shape, x0, 0, 0, lambda s: _s.scale_xyz(s, _wave(Z, z0, z1, amp, off, phi0, phi1)))


def coscale_xy_z(shape, x0, y0, z0, z1, phi0, phi1, amp, off):
    size = _wave(Z, z0, z1, amp, off, phi0, phi1)
    return _about(shape, x0, y0, 0, lambda s: _s.scale_xyz(s, size, size))


def twist_xy_z(shape, x0, y0, z0, z1, t0, t1):
    """Turned by t0 degrees at z0, by t1 at z1."""
    angle = _between(Z, z0, z1, _math.radians(t0), _math.radians(t1))
    return _about(shape, x0, y0, 0, lambda s: _s.rotate_z(s, angle))


def attract(shape, x, y, z, r):
    return _tree(_s.attract(_plain(shape), x, y, z, r))


def repel(shape, x, y, z, r):
    return _tree(_s.repel(_plain(shape), x, y, z, r))


def bend_x(shape, r):
    return _tree(_s.bend(_plain(shape), r))


# Many, and mixtures


def iterate2d(shape, i, j, dx, dy):
    return _tree(_s.array_xy(_plain(shape), i, j, dx, dy))


array_xy = iterate2d


def array(shape, count, dx):
    return _tree(_s.array_x(_plain(shape), count, dx))


def iterate_polar(shape, x0, y0, n):
    return _about(shape, x0, y0, 0, lambda s: _s.array_polar(s, n))


def blend(a, b, amount):
    return _tree(_s.blend(_plain(a), _plain(b), amount))


def morph(a, b, weight):
    return _tree(_s.morph(_plain(a), _plain(b), weight))


def shell(shape, thickness):
    return _tree(_s.shell(_plain(shape), thickness))


def offset(shape, distance):
    return _tree(_s.offset(_plain(shape), distance))


def clearance(a, b, gap):
    return _tree(_s.clearance(_plain(a), _plain(b), gap))
