"""Every function of the library: volume or area in closed form, values at points, a symmetry, and its quality as a
distance."""

import math

import numpy as np
import pytest

import fieldfab as ff
from fieldfab import shapes as s

RANDOM = np.random.default_rng(5)
POINTS = RANDOM.uniform(-4, 4, (3, 4000))
LIBRARY = {f["name"]: f for f in ff.library()}
SHAPES = {name for name, f in LIBRARY.items() if f["group"] != "numbers"}
COVERED = set()


def covers(*names):
    """Registers the functions that a test covers, for test_every_function_is_tested."""
    COVERED.update(names)
    return lambda test: test


def lump():
    """Returns a solid without any symmetry."""
    return ff.X + 0.3 * ff.Y * ff.Y - ff.sin(2 * ff.Z + ff.X) + 0.1 * ff.Z


def same(shape, expected, atol=2e-4):
    """Asserts that the shape's values are `expected(x, y, z)` at random points."""
    got, wanted = shape(*POINTS), expected(*POINTS)
    assert np.allclose(got, wanted, atol=atol, rtol=1e-3), np.abs(got - wanted).max()


def at(expression):
    return lambda x, y, z: expression(x, y, z)


def volume(shape, voxel):
    return ff.mesh(shape, voxel=voxel).volume


def area(shape, bounds=5.0, count=1500):
    """Returns the area of a flat shape by counting points; relative error some thousandths."""
    step = 2 * bounds / count
    axis = np.arange(count) * step - bounds + step / 2
    return float((shape(axis[:, None], axis[None, :], 0.0) < 0).sum()) * step * step


VOLUMES = {
    "sphere": (s.sphere(1), 4 / 3 * math.pi),
    "ellipsoid": (s.ellipsoid(1.5, 1, 0.5), 4 / 3 * math.pi * 0.75),
    "box": (s.box(2, 1, 1.5), 3),
    "exact_box": (s.exact_box(2, 1, 1.5), 3),
    "rounded_box": (
        s.rounded_box(2, 1.4, 1.2, 0.3),
        1.4 * 0.8 * 0.6 + 0.6 * (1.4 * 0.8 + 1.4 * 0.6 + 0.8 * 0.6) + math.pi * 0.09 * (1.4 + 0.8 + 0.6)
        + 4 / 3 * math.pi * 0.027,
    ),
    "cylinder": (s.cylinder(1, 1.5), 1.5 * math.pi),
    "exact_cylinder": (s.exact_cylinder(1, 1.5), 1.5 * math.pi),
    "cone": (s.cone(1, 1.5), 0.5 * math.pi),
    "exact_cone": (s.exact_cone(1, 1.5), 0.5 * math.pi),
    "pyramid": (s.pyramid(2, 1.5, 1.5), 1.5),
    "torus": (s.torus(1, 0.3), 2 * math.pi**2 * 0.09),
    "capsule": (s.capsule(0.5, 1), math.pi * 0.25 + 4 / 3 * math.pi * 0.125),
    "extrude": (s.extrude(s.circle(1), 0.7, base=-0.2), 0.7 * math.pi),
    "revolve": (s.revolve(s.move(s.rectangle(0.5, 0.8), 1)), 2 * math.pi * 0.4),
    "loft": (s.loft(s.circle(1), s.circle(0.5), 1.5), math.pi * 1.5 / 3 * (1 + 0.5 + 0.25)),
    "union": (s.union(s.box(1, 1, 1), s.move(s.box(1, 1, 1), 0.5), s.move(s.box(1, 1, 1), 1)), 2),
    "intersection": (s.intersection(s.box(1, 1, 1), s.move(s.box(1, 1, 1), 0.5)), 0.5),
    "difference": (s.difference(s.box(1, 1, 1), s.move(s.box(1, 1, 1), 0.5), s.move(s.box(1, 1, 1), -0.75)), 0.25),
    "offset": (s.offset(s.sphere(1), 0.25), 4 / 3 * math.pi * 1.25**3),
    "shell": (s.shell(s.sphere(1), 0.4), 4 / 3 * math.pi * (1.2**3 - 0.8**3)),
    "clearance": (s.clearance(s.box(2, 2, 1), s.cylinder(0.5, 3), 0.25), 4 - math.pi * 0.75**2),
}


@pytest.mark.parametrize("name", VOLUMES)
@covers(*VOLUMES)
def test_volumes(name):
    shape, expected = VOLUMES[name]
    assert volume(shape, 0.04) == pytest.approx(expected, rel=4e-3)


AREAS = {
    "circle": (s.circle(2), 4 * math.pi),
    "rectangle": (s.rectangle(3, 2), 6),
    "exact_rectangle": (s.exact_rectangle(3, 2), 6),
    "rounded_rectangle": (s.rounded_rectangle(3, 2, 0.5), 6 - (4 - math.pi) * 0.25),
    "triangle": (s.triangle(-1, -1, 3, 0, 0, 2), 5.5),
    "polygon": (s.polygon(5, 2), 2.5 * 4 * math.sin(2 * math.pi / 5)),
    "outline": (s.outline([(-3, -3), (3, -3), (3, 3), (1, 3), (1, 0), (-1, 0), (-1, 3), (-3, 3)]), 36 - 6),
    "stroke": (s.stroke(-2, -1, 2, 2, 1), 5 + math.pi / 4),
    "tab": (s.tab(2, 3), 6),
    "slot": (s.slot(2, 3, 0.5), 6 + 0.25),
    "gear": (s.gear(20, 0.4, pressure_angle=math.radians(20)), math.pi * 16),
    "trace": (s.trace(1, (-2, -1), (2, -1)), 4 + math.pi / 4),
    "footprint_chip": (s.footprint_chip(), 2 * 1.6 * 1.8),
    "footprint_soic": (s.footprint_soic(8), 8 * 1.6 * 0.6),
    "footprint_header": (s.footprint_header(2, 3), 6 * math.pi * 0.85**2),
    "text": (s.text("l", h=6, weight=0.5), None),
}


@pytest.mark.parametrize("name", AREAS)
@covers(*AREAS)
def test_areas(name):
    shape, expected = AREAS[name]
    if name == "text":  # an l is a stroke from (1, 6) to (2, 6), one down to the base line, and one that closes it
        strokes = [s.stroke(1, 6, 2, 6, 0.5), s.stroke(2, 6, 2, 0, 0.5), s.stroke(1, 0, 3, 0, 0.5)]
        same(shape, at(s.union(*strokes)))
        return
    rough = 0.03 if name == "gear" else 4e-3  # teeth and gaps are equal at the pitch circle, nearly equal in area
    assert area(shape) == pytest.approx(expected, rel=rough)


def test_triangles_and_outlines_go_either_way_round():
    same(s.triangle(0, 2, 3, 0, -1, -1), at(AREAS["triangle"][0]))
    corners = [(-3, -3), (3, -3), (3, 3), (1, 3), (1, 0), (-1, 0), (-1, 3), (-3, 3)]
    same(s.outline(corners[::-1]), at(s.outline(corners)))
    spiral = [(0, 0), (3, 0), (3, 3), (-2, 3), (-2, -2), (2, -2), (2, -1.5), (-1.5, -1.5), (-1.5, 2.5), (2.5, 2.5),
              (2.5, 0.5), (0, 0.5)]

    def winding(x, y):
        inside = np.zeros(x.shape, bool)
        for (x0, y0), (x1, y1) in zip(spiral, spiral[1:] + spiral[:1]):
            crosses = (y0 > y) != (y1 > y)
            with np.errstate(divide="ignore", invalid="ignore"):
                inside ^= crosses & (x < (x1 - x0) * (y - y0) / (y1 - y0) + x0)
        return inside

    x, y, z = POINTS
    assert ((s.outline(spiral)(x, y, z) < 0) == winding(x, y)).all()
    for bad in ([(0, 0), (1, 1)], [(0, 0), (1, 1), (2, 2)]):
        with pytest.raises(ff.Error):
            s.outline(bad)


@covers("solid")
def test_a_formula_as_a_solid():
    """The solid has the formula's values; its operators are those of sets."""
    ball = s.solid(ff.X * ff.X + ff.Y * ff.Y + ff.Z * ff.Z - 4)
    same(ball, lambda x, y, z: x * x + y * y + z * z - 4)
    same(ball - s.plane(1, 0, 0, 0), lambda x, y, z: np.maximum(x * x + y * y + z * z - 4, -x))


@covers("plane")
def test_planes():
    same(s.plane(1, 2, -2, 0.5), lambda x, y, z: (x + 2 * y - 2 * z) / 3 - 0.5)


@covers("gyroid", "schwarz_p", "diamond")
def test_lattices_repeat_halve_space_and_have_their_symmetries():
    x, y, z = POINTS
    for lattice in (s.gyroid(2.5), s.schwarz_p(2.5), s.diamond(2.5)):
        values = lattice(x, y, z)
        assert np.allclose(values, lattice(x + 2.5, y - 5, z + 2.5), atol=1e-3)
        assert np.allclose(values, lattice(y, z, x), atol=1e-5)  # threefold symmetry
        cell = lattice(*RANDOM.uniform(0, 2.5, (3, 20000)))
        assert abs((cell < 0).mean() - 0.5) < 0.02
    assert np.allclose(s.gyroid(2.5)(x, y, z), -s.gyroid(2.5)(-x, -y, -z), atol=1e-5)
    graded = s.shell(s.gyroid(2), 0.2 + 0.1 * (ff.Z + 4) / 8)
    low, high = (graded(x, y, z) < 0)[z < -2].mean(), (graded(x, y, z) < 0)[z > 2].mean()
    assert low < high


def to_segments(starts, ends):
    """Returns the distance to the nearest of some segments, as a function of x, y, z."""
    starts, ends = np.asarray(starts, float), np.asarray(ends, float)

    def distance(x, y, z):
        best = np.full(len(x), np.inf)
        for a, b in zip(starts, ends):
            p, d = np.stack([x, y, z], -1) - a, b - a
            share = np.clip(p @ d / (d @ d), 0, 1)
            best = np.minimum(best, np.linalg.norm(p - share[:, None] * d, axis=1))
        return best

    return distance


def segments(kind, period, cubes=4):
    """Returns the struts of the cubes around the origin, one by one."""
    signs, half = (-1, 1), period / 2
    corners = np.array([[x, y, z] for x in signs for y in signs for z in signs]) * half
    faces = np.array([s * np.eye(3)[axis] for axis in range(3) for s in signs]) * half
    close = lambda many, others, length: [(a, b) for a in many for b in others
                                          if abs(np.linalg.norm(a - b) - length) < 1e-9]
    in_cube = {
        "cubic": close(corners, corners, period),
        "bcc": [(np.zeros(3), corner) for corner in corners],
        "fcc": close(corners, corners, period * math.sqrt(2)),
        "octet": close(corners, corners, period * math.sqrt(2)) + close(faces, faces, half * math.sqrt(2)),
    }[kind]
    steps = np.arange(-cubes, cubes + 1) * period
    middles = [np.array([x, y, z]) for x in steps for y in steps for z in steps
               if max(abs(x), abs(y), abs(z)) < 4 + period]
    return [a + m for m in middles for a, _ in in_cube], [b + m for m in middles for _, b in in_cube]


@covers("cubic_struts", "bcc_struts", "fcc_struts", "octet_struts")
def test_struts_are_the_distance_to_their_segments():
    for kind in ("cubic", "bcc", "fcc", "octet"):
        struts = getattr(s, f"{kind}_struts")
        same(struts(3), to_segments(*segments(kind, 3.0)))
        same(s.shell(struts(3), 0.4), lambda x, y, z: to_segments(*segments(kind, 3.0))(x, y, z) - 0.2)


@covers("honeycomb_walls")
def test_honeycombs_are_the_distance_to_the_borders_of_cells():
    middles = np.array([[2.5 * (i + j / 2), 2.5 * j * math.sqrt(3) / 2] for i in range(-8, 9) for j in range(-8, 9)])

    def expected(x, y, z):
        """The distance to the line between the two nearest middles, of all pairs with the nearest."""
        points = np.stack([x, y], -1)
        away = np.linalg.norm(points[:, None] - middles, axis=2)
        nearest = middles[away.argmin(1)]
        to_others = middles[None] - nearest[:, None]
        length = np.linalg.norm(to_others, axis=2)
        length[length < 1e-9] = np.inf
        along = ((points - nearest)[:, None] * to_others).sum(2) / length
        return np.where(np.isinf(length), np.inf, length / 2 - along).min(1)

    same(s.honeycomb_walls(2.5), expected)


@covers("spinodal")
def test_spinodal_walls_halve_space_and_have_about_their_thickness():
    x, y, z = RANDOM.uniform(-40, 40, (3, 100000))
    values = s.spinodal(5)(x, y, z)
    assert abs((values < 0).mean() - 0.5) < 0.03
    step = 1e-3
    near = np.abs(values) < 0.05
    shifted = [s.spinodal(5)(*(np.array([x, y, z])[:, near] + step * np.eye(3)[axis][:, None])) for axis in range(3)]
    slopes = np.linalg.norm([(there - values[near]) / step for there in shifted], axis=0)
    assert np.mean(slopes) == pytest.approx(1, abs=0.15)


@covers("thread")
def test_threads():
    bolt = s.thread(3, 1, 8)
    turn = 0.7
    near = (np.abs(POINTS[2]) < 2.5) & (np.hypot(POINTS[0], POINTS[1]) > 2)  # far from the ends
    x, y, z = (axis[near] for axis in POINTS)
    screwed = bolt(x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn),
                   z + turn / (2 * math.pi))
    assert np.allclose(bolt(x, y, z), screwed, atol=1e-3)  # a right-handed helix of its pitch
    depth = 0.625 * math.sqrt(3) / 2
    assert ((bolt(x, y, z)[np.hypot(x, y) < 3 - depth - 1e-3] < 0).all()
            and (bolt(x, y, z)[np.hypot(x, y) > 3] > 0).all())
    # ISO 68-1: thread and gap are equal at the pitch diameter.
    angle = np.linspace(0, 2 * math.pi, 4001)[:-1]
    pitch_radius = 3 - 3 / 8 * math.sqrt(3) / 2
    ring = bolt(pitch_radius * np.cos(angle), pitch_radius * np.sin(angle), 0.0)
    assert abs((ring < 0).mean() - 0.5) < 0.01


def test_gears_mesh():
    """Two gears that turn together at their pitch distance touch and do not overlap: involutes roll on each other."""
    module, teeth, other = 1.0, 17, 23
    apart = module * (teeth + other) / 2
    small, large = s.gear(teeth, module), s.gear(other, module)
    axis = np.linspace(-1.3, 1.3, 500)
    x, y = np.meshgrid(axis + module * teeth / 2, axis * 2.2)
    for turned in np.linspace(0, 2 * math.pi / teeth, 7):
        a = s.rotate_z(small, float(turned))
        b = s.move(s.rotate_z(large, math.pi + math.pi / other - float(turned) * teeth / other), apart)
        overlap = np.maximum(a(x, y, 0), b(x, y, 0)).min()
        assert -0.01 < overlap < 0.02, (turned, overlap)


@covers("blend")
def test_blend():
    a, b = s.sphere(1), s.plane(0, 0, 1, 0)
    same(s.blend(a, b, 0.5), lambda x, y, z: np.minimum(
        np.minimum(a(x, y, z), z), np.sqrt(np.abs(a(x, y, z))) + np.sqrt(np.abs(z)) - math.sqrt(0.5)))


@covers("smooth_union", "smooth_intersection", "smooth_difference", "chamfer_union", "chamfer_intersection",
        "chamfer_difference")
def test_fillets_and_chamfers():
    # Two planes at a right angle: the fillet is a cylinder of that radius, the chamfer a plane that cuts off `size` of
    # each.
    a, b = s.plane(1, 0, 0, 0), s.plane(0, 1, 0, 0)
    inside = lambda shape, x, y: shape(x, y, 0) < 0
    assert not inside(s.smooth_union(a, b, 1), 1 - math.sqrt(0.5) + 0.01, 1 - math.sqrt(0.5) + 0.01)
    assert inside(s.smooth_union(a, b, 1), 1 - math.sqrt(0.5) - 0.01, 1 - math.sqrt(0.5) - 0.01)
    assert inside(s.chamfer_union(a, b, 1), 0.49, 0.49) and not inside(s.chamfer_union(a, b, 1), 0.51, 0.51)
    assert not inside(s.chamfer_union(a, b, 1), 1.01, 0.001) and not inside(s.smooth_union(a, b, 1), 1.01, 0.001)
    for kind in ("smooth", "chamfer"):
        union = getattr(s, kind + "_union")
        same(getattr(s, kind + "_intersection")(a, b, 0.7), at(-union(-a, -b, 0.7)))
        same(getattr(s, kind + "_difference")(a, b, 0.7), at(-union(-a, b, 0.7)))
        far = s.move(s.sphere(0.5), 50)
        same(union(s.sphere(1), far, 0.7), at(s.sphere(1)))  # distant solids are unchanged


@covers("morph")
def test_morph():
    a, b = lump(), s.sphere(1)
    same(s.morph(a, b, 0), at(a))
    same(s.morph(a, b, 1), at(b))
    same(s.morph(a, b, 0.25), lambda x, y, z: 0.75 * a(x, y, z) + 0.25 * b(x, y, z))


C, S = math.cos(0.6), math.sin(0.6)
MOVES = {
    "move": (s.move(lump(), 1, -2, 0.5), lambda x, y, z: (x - 1, y + 2, z - 0.5)),
    "rotate_x": (s.rotate_x(lump(), 0.6), lambda x, y, z: (x, C * y + S * z, C * z - S * y)),
    "rotate_y": (s.rotate_y(lump(), 0.6), lambda x, y, z: (C * x - S * z, y, C * z + S * x)),
    "rotate_z": (s.rotate_z(lump(), 0.6), lambda x, y, z: (C * x + S * y, C * y - S * x, z)),
    "scale_xyz": (s.scale_xyz(lump(), 2, 0.5, 1 + ff.X * ff.X), lambda x, y, z: (x / 2, y * 2, z / (1 + x * x))),
    "mirror_x": (s.mirror_x(lump()), lambda x, y, z: (-x, y, z)),
    "mirror_y": (s.mirror_y(lump()), lambda x, y, z: (x, -y, z)),
    "mirror_z": (s.mirror_z(lump()), lambda x, y, z: (x, y, -z)),
    "symmetric_x": (s.symmetric_x(lump()), lambda x, y, z: (abs(x), y, z)),
    "symmetric_y": (s.symmetric_y(lump()), lambda x, y, z: (x, abs(y), z)),
    "symmetric_z": (s.symmetric_z(lump()), lambda x, y, z: (x, y, abs(z))),
    "shear_x_y": (s.shear_x_y(lump(), 0.5), lambda x, y, z: (x - 0.5 * y, y, z)),
    "shear_x_z": (s.shear_x_z(lump(), 0.5), lambda x, y, z: (x - 0.5 * z, y, z)),
    "twist": (s.twist(lump(), 0.3), lambda x, y, z: (
        np.cos(0.3 * z) * x + np.sin(0.3 * z) * y, np.cos(0.3 * z) * y - np.sin(0.3 * z) * x, z)),
    "taper": (s.taper(lump(), 10, 0.5), lambda x, y, z: (x / (1 - 0.05 * z), y / (1 - 0.05 * z), z)),
    "bend": (s.bend(lump(), 5), lambda x, y, z: (5 * np.arctan2(x, 5 - z), y, 5 - np.hypot(x, 5 - z))),
    "attract": (s.attract(lump(), 1, 0, 0, 2), lambda x, y, z: pulled(x, y, z, 1)),
    "repel": (s.repel(lump(), 1, 0, 0, 2), lambda x, y, z: pulled(x, y, z, -1)),
    "repeat_x": (s.repeat_x(lump(), 3), lambda x, y, z: ((x + 1.5) % 3 - 1.5, y, z)),
    "repeat_y": (s.repeat_y(lump(), 3), lambda x, y, z: (x, (y + 1.5) % 3 - 1.5, z)),
    "repeat_z": (s.repeat_z(lump(), 3), lambda x, y, z: (x, y, (z + 1.5) % 3 - 1.5)),
    "map": (s.map(lump(), ff.Y, ff.Z * 2, ff.X), lambda x, y, z: (y, 2 * z, x)),
}


def pulled(x, y, z, sign):
    factor = 1 + sign * np.exp(-np.sqrt((x - 1) ** 2 + y**2 + z**2) / 2)
    return 1 + (x - 1) * factor, y * factor, z * factor


@pytest.mark.parametrize("name", MOVES)
@covers(*MOVES)
def test_moves(name):
    moved, back = MOVES[name]
    same(moved, lambda x, y, z: lump()(*back(x, y, z)), atol=2e-3)


@covers("scale")
def test_scale_keeps_distances():
    same(s.scale(s.sphere(1), 2), at(s.sphere(2)))


@covers("array_x", "array_xy", "array_polar")
def test_arrays():
    peg = s.move(s.sphere(0.5), 2)
    same(s.array_x(peg, 3, 1.5), at(s.union(peg, s.move(peg, 1.5), s.move(peg, 3))))
    same(s.array_xy(peg, 2, 2, 1, -2), at(s.union(peg, s.move(peg, 1), s.move(peg, 0, -2), s.move(peg, 1, -2))))
    same(s.array_polar(peg, 3), at(s.union(peg, s.rotate_z(peg, 2 * math.pi / 3), s.rotate_z(peg, -2 * math.pi / 3))))
    with pytest.raises(ff.Error):
        s.array_x(peg, 1.5, 1)
    with pytest.raises(ff.Error):
        s.array_polar(peg, 0)


def test_every_function_is_tested():
    assert SHAPES == COVERED


@pytest.mark.parametrize("name", sorted(n for n in SHAPES if LIBRARY[n]["distance"]))
def test_distances_are_what_the_docstring_says(name):
    """A bound is Lipschitz continuous with constant 1. A step along the gradient by an exact distance ends on the
    surface."""
    said = LIBRARY[name]["distance"]
    assert {"exact": "exact distance", "bound": "a bound", "neither": "neither"}[said] in getattr(s, name).__doc__
    shape = VOLUMES.get(name, AREAS.get(name, (s.plane(1, 2, 3, 0.5) if name == "plane" else None, None)))[0]
    if said == "neither" or shape is None:
        return
    x, y, z = POINTS
    points = np.ascontiguousarray(POINTS.T, np.float32)
    values, gradients = ff.Solid(shape).gradients(points)
    steep = np.linalg.norm(gradients, axis=1)
    assert np.percentile(steep, 99.5) < 1 + 1e-3
    if said != "exact":
        return
    outside = values > 0 if "outside" in LIBRARY[name]["meaning"] else np.ones(len(values), bool)
    landed = np.abs(ff.Solid(shape).values(points - (values[:, None] * gradients).astype(np.float32)))
    assert np.mean(landed[outside] < 2e-3) > 0.99


def test_examples_have_something_to_see():
    for name, function in LIBRARY.items():
        if function["example"]:
            bounds = ff.Solid(ff.parse(function["example"])).bounds()
            assert bounds and max(b - a for a, b in zip(bounds[:3], bounds[3:])) < 40, name


def test_arguments_are_checked():
    with pytest.raises(ff.Error, match="lacks its argument 'shape'"):
        s.extrude()
    with pytest.raises(TypeError, match="at most 1"):
        s.sphere(1, 2)
    with pytest.raises(TypeError, match="no argument 'radius'"):
        s.sphere(radius=2)
    with pytest.raises(ff.Error, match="plain whole number"):
        s.gear(12.5)
    with pytest.raises(ff.Error, match="plain number"):
        s.text("a", h=ff.X)
    assert s.sphere() == s.sphere(r=1) == ff.parse("sphere()")
    assert s.rotate_x(s.box(1, 2, 3), math.pi / 2) == ff.parse("rotate_x(box(1, 2, 3), 90)")
    assert s.text("a\nb", h=3) == ff.parse('text("a\\nb", h = 3)')
