"""kokopelli's names and the board library, against closed forms and Fieldfab's own functions."""

import math

import numpy as np
import pytest

import fieldfab as ff
from fieldfab import kokopelli as k
from fieldfab import pcb
from fieldfab import shapes as s

POINTS = np.random.default_rng(3).uniform(-4, 4, (3, 3000))
X, Y, Z = POINTS


def lump():
    return k.MathTree(ff.X + 0.3 * ff.Y * ff.Y - ff.sin(2 * ff.Z + ff.X))


def area(shape, bounds=6.0, count=1200):
    step = 2 * bounds / count
    axis = np.arange(count) * step - bounds + step / 2
    return float((shape(axis[:, None], axis[None, :], 0.0) < 0).sum()) * step * step


def at(shape, x, y, z):
    return shape(x, y, z)


SAME = {
    "circle": (lambda: k.circle(1, 2, 3), lambda: np.hypot(X - 1, Y - 2) - 3),
    "rectangle": (lambda: k.rectangle(-1, 3, 0, 2), lambda: np.maximum(np.abs(X - 1) - 2, np.abs(Y - 1) - 1)),
    "sphere": (lambda: k.sphere(1, 2, 3, 2), lambda: np.sqrt((X - 1) ** 2 + (Y - 2) ** 2 + (Z - 3) ** 2) - 2),
    "move": (lambda: k.move(lump(), 1, 2, 3), lambda: at(lump(), X - 1, Y - 2, Z - 3)),
    "rotate": (lambda: k.rotate(lump(), 90, 1, 0), lambda: at(lump(), Y + 1, 1 - X, Z)),
    "rotate_x": (lambda: k.rotate_x(lump(), 90, 1, 0), lambda: at(lump(), X, Z + 1, 1 - Y)),
    "rotate_y": (lambda: k.rotate_y(lump(), 90), lambda: at(lump(), Z, Y, -X)),
    "reflect_x": (lambda: k.reflect_x(lump(), 1), lambda: at(lump(), 2 - X, Y, Z)),
    "reflect_y": (lambda: k.reflect_y(lump(), 1), lambda: at(lump(), X, 2 - Y, Z)),
    "reflect_z": (lambda: k.reflect_z(lump(), 1), lambda: at(lump(), X, Y, 2 - Z)),
    "reflect_xy": (lambda: k.reflect_xy(lump()), lambda: at(lump(), Y, X, Z)),
    "reflect_xz": (lambda: k.reflect_xz(lump()), lambda: at(lump(), Z, Y, X)),
    "reflect_yz": (lambda: k.reflect_yz(lump()), lambda: at(lump(), X, Z, Y)),
    "scale_x": (lambda: k.scale_x(lump(), 1, 2), lambda: at(lump(), 1 + (X - 1) / 2, Y, Z)),
    "scale_y": (lambda: k.scale_y(lump(), 1, 2), lambda: at(lump(), X, 1 + (Y - 1) / 2, Z)),
    "scale_z": (lambda: k.scale_z(lump(), 1, 2), lambda: at(lump(), X, Y, 1 + (Z - 1) / 2)),
    "scale_xy": (lambda: k.scale_xy(lump(), 1, 0, 2), lambda: at(lump(), 1 + (X - 1) / 2, Y / 2, Z)),
    "scale_xyz": (lambda: k.scale_xyz(lump(), 1, 0, 0, 2), lambda: at(lump(), 1 + (X - 1) / 2, Y / 2, Z / 2)),
    "taper_x_y": (lambda: k.taper_x_y(lump(), 0, -5, 5, 1, 2), lambda: at(lump(), X / (1.5 + Y / 10), Y, Z)),
    "taper_x_z": (lambda: k.taper_x_z(lump(), 0, -5, 5, 1, 2), lambda: at(lump(), X / (1.5 + Z / 10), Y, Z)),
    "taper_xy_z": (lambda: k.taper_xy_z(lump(), 0, 0, -5, 5, 1, 2),
                   lambda: at(lump(), X / (1.5 + Z / 10), Y / (1.5 + Z / 10), Z)),
    "shear_x_y": (lambda: k.shear_x_y(lump(), 0, 4, 0, 2), lambda: at(lump(), X - Y / 2, Y, Z)),
    "shear_x_z": (lambda: k.shear_x_z(lump(), 0, 4, 0, 2), lambda: at(lump(), X - Z / 2, Y, Z)),
    "coscale_x_y": (lambda: k.coscale_x_y(lump(), 0, 0, 2, 0, 180, 0.2, 1),
                    lambda: at(lump(), X / (1 + 0.2 * np.cos(math.pi / 2 * Y)), Y, Z)),
    "coscale_x_z": (lambda: k.coscale_x_z(lump(), 0, 0, 2, 0, 180, 0.2, 1),
                    lambda: at(lump(), X / (1 + 0.2 * np.cos(math.pi / 2 * Z)), Y, Z)),
    "coscale_xy_z": (lambda: k.coscale_xy_z(lump(), 0, 0, 0, 2, 0, 180, 0.2, 1), lambda: at(
        lump(), X / (1 + 0.2 * np.cos(math.pi / 2 * Z)), Y / (1 + 0.2 * np.cos(math.pi / 2 * Z)), Z)),
    "twist_xy_z": (lambda: k.twist_xy_z(lump(), 0, 0, 0, 4, 0, 90), lambda: s.twist(lump(), math.pi / 8)(X, Y, Z)),
    "extrusion": (lambda: k.extrusion(k.circle(0, 0, 1), -1, 2),
                  lambda: np.maximum(np.hypot(X, Y) - 1, np.maximum(-1 - Z, Z - 2))),
    "cylinder": (lambda: k.cylinder(0, 0, -1, 2, 1), lambda: np.maximum(np.hypot(X, Y) - 1, np.maximum(-1 - Z, Z - 2))),
    "cube": (lambda: k.cube(-1, 1, 0, 2, 0, 3),
             lambda: np.maximum(np.maximum(abs(X) - 1, abs(Y - 1) - 1), abs(Z - 1.5) - 1.5)),
    "torus": (lambda: k.torus(0, 0, 1, 3, 1), lambda: np.hypot(np.hypot(X, Y) - 3, Z - 1) - 1),
    "revolve_y": (lambda: k.revolve_y(k.circle(2, 0, 1)), lambda: np.hypot(np.hypot(X, Z) - 2, Y) - 1),
    "revolve_x": (lambda: k.revolve_x(k.circle(0, 2, 1)), lambda: np.hypot(np.hypot(Y, Z) - 2, X) - 1),
    "offset": (lambda: k.offset(k.circle(0, 0, 1), 0.5), lambda: np.hypot(X, Y) - 1.5),
    "shell": (lambda: k.shell(k.circle(0, 0, 1), 0.5), lambda: np.abs(np.hypot(X, Y) - 1) - 0.25),
    "clearance": (lambda: k.clearance(lump(), k.circle(0, 0, 1), 0.5),
                  lambda: np.maximum(lump()(X, Y, Z), 1.5 - np.hypot(X, Y))),
    "morph": (lambda: k.morph(lump(), k.circle(0, 0, 1), 0.5),
              lambda: 0.5 * lump()(X, Y, Z) + 0.5 * (np.hypot(X, Y) - 1)),
    "blend": (lambda: k.blend(lump(), k.circle(0, 0, 1), 0.5), lambda: s.blend(lump(), s.circle(1), 0.5)(X, Y, Z)),
    "attract": (lambda: k.attract(lump(), 1, 2, 3, 2), lambda: s.attract(lump(), 1, 2, 3, 2)(X, Y, Z)),
    "repel": (lambda: k.repel(lump(), 1, 2, 3, 2), lambda: s.repel(lump(), 1, 2, 3, 2)(X, Y, Z)),
    "bend_x": (lambda: k.bend_x(lump(), 9), lambda: s.bend(lump(), 9)(X, Y, Z)),
    "iterate2d": (lambda: k.iterate2d(k.circle(0, 0, 1), 2, 2, 3, 1),
                  lambda: s.array_xy(s.circle(1), 2, 2, 3, 1)(X, Y, Z)),
    "array": (lambda: k.array(k.circle(0, 0, 1), 3, 2), lambda: s.array_x(s.circle(1), 3, 2)(X, Y, Z)),
    "iterate_polar": (lambda: k.iterate_polar(k.circle(3, 0, 1), 1, 0, 4), lambda: np.minimum(
        np.minimum(np.hypot(X - 3, Y) - 1, np.hypot(X + 1, Y) - 1),
        np.minimum(np.hypot(X - 1, Y - 2) - 1, np.hypot(X - 1, Y + 2) - 1))),
}


@pytest.mark.parametrize("name", SAME)
def test_kokopelli(name):
    shape, expected = SAME[name]
    assert isinstance(shape(), k.MathTree)
    assert np.allclose(shape()(X, Y, Z), expected(), atol=2e-3, rtol=1e-3)


AREAS = {
    "triangle": (lambda: k.triangle(0, 0, 4, 0, 0, 3), 6),
    "right_triangle": (lambda: k.right_triangle(-1, -1, 3), 4.5),
    "rounded_rectangle": (lambda: k.rounded_rectangle(-2, 2, -1, 1, 0.5), 8 - (4 - math.pi) * 0.25),
    "polygon": (lambda: k.polygon((0, 0), (4, 0), (4, 4), (2, 1), (0, 4)), 10),
    "tab": (lambda: k.tab(1, 0, 2, 3, 30), 6 - 0.6 * 0.6),
    "slot": (lambda: k.slot(1, 0, 2, 3, -40), 6 + 0.6 * 0.6),
}


@pytest.mark.parametrize("name", AREAS)
def test_kokopelli_areas(name):
    shape, expected = AREAS[name]
    assert area(shape()) == pytest.approx(expected, rel=4e-3)


def test_kokopelli_solids():
    for shape, expected in ((k.cone(1, 2, 0, 3, 1), math.pi), (k.pyramid(0, 2, 0, 1, 0, 3), 2),
                            (k.loft_xy_z(k.rectangle(0, 2, 0, 2), k.rectangle(0, 2, 0, 2), 1, 3), 8)):
        assert ff.mesh(shape, voxel=0.05).volume == pytest.approx(expected, rel=4e-3)


def test_kokopelli_sets_and_text():
    a, b = k.circle(0, 0, 2), k.rectangle(0, 4, -1, 1)
    assert (a + b)(3, 0, 0) < 0 and (a - b)(1, 0, 0) > 0 and (a & b)(-1, 0, 0) > 0 and (~a)(0, 0, 0) > 0
    low_x, low_y, _, high_x, high_y, _ = ff.Solid(k.extrusion(k.text("HI", 2, 3, 1), 0, 1)).bounds()
    assert (low_x + high_x) / 2 == pytest.approx(2, abs=0.15) and (low_y + high_y) / 2 == pytest.approx(3, abs=0.05)
    assert set(k.__all__) <= set(vars(k))


def test_boards():
    board = pcb.Board(30, 20, corner=2)
    chip = board.add(pcb.soic("chip"), 8, 10)
    led = board.add(pcb.chip_1206("LED"), 22, 10, angle=90)
    plug = board.add(pcb.header(rows=2), 4, 4)
    board.connect(chip["5"], (15, 8), led["2"], width=0.6)
    assert (led["2"] == pytest.approx((22, 11.7)) and chip["1"] == pytest.approx((5.3, 10 + 1.905))
            and chip["8"][1] == chip["1"][1])
    for pad in (chip["3"], led["1"], (15, 8)):
        assert board.copper(*pad, 0) < 0
    assert board.copper(*plug["1"], 0) > 0 and board.holes(*plug["1"], 0) < 0 and board.outline(0.1, 0.1, 0) > 0
    with pytest.raises(KeyError, match="no pad '9'"):
        chip["9"]
    image = ff.render(board.copper, mode="bitmap", size=600, bounds=board.bounds)
    copper = (image.pixels > 0).mean() * 600
    holes = 4 * math.pi * 0.25
    pads = 8 * 1.6 * 0.6 + 2 * 1.6 * 1.8 + 4 * math.pi * 0.85**2 - holes
    assert pads < copper < pads + 0.6 * 16
