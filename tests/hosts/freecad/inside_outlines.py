"""Runs inside FreeCAD, without its window: thickness of walls and gaps in outlines, against closed forms."""

import math

import numpy as np
import pytest

from fieldfab_workbench.outlines import chord_at, nearest_on


def closed(points):
    points = np.asarray(points, float)
    return np.hstack([points, np.roll(points, -1, axis=0)])


def circle(radius, count=720):
    angles = np.arange(count) * 2 * np.pi / count
    return closed(radius * np.stack([np.cos(angles), np.sin(angles)], 1))


def rectangle(width, height, turn=0.0):
    x, y = width / 2, height / 2
    c, s = math.cos(turn), math.sin(turn)
    return closed([(c * a - s * b, s * a + c * b) for a, b in ((-x, -y), (x, -y), (x, y), (-x, y))])


@pytest.mark.parametrize("turn", [0, 0.1, 1.234, 2.9])
def test_a_wall_is_as_thick_as_it_is(turn):
    """Also near its end, and of a point on its side."""
    outline, way = rectangle(40, 3, turn), np.array([math.cos(turn), math.sin(turn)])
    across = np.array([-way[1], way[0]])
    for along, aside in ((-12, 0.1), (0, -0.3), (7.5, 1.2), (18.4, 1), (3, 1.5), (-3, -1.5)):
        chord = chord_at(outline, along * way + aside * across)
        assert chord.solid and chord.length == pytest.approx(3, abs=1e-6)
    assert chord_at(outline, 19.5 * way).length == pytest.approx(40), "the end's side is nearer"


def test_a_ring_has_a_wall_and_a_gap():
    ring = np.vstack([circle(10), circle(6)])
    chord = chord_at(ring, np.array([8.1, 0.3]))
    assert chord.solid and chord.length == pytest.approx(4, abs=1e-3)
    for point in ((0.1, 0.2), (-4, 3)):
        chord = chord_at(ring, np.array(point))
        assert not chord.solid and chord.length == pytest.approx(12, abs=0.01)
    assert chord_at(ring, np.array([11.0, 0.0])) is None, "there is no other side"
    assert chord_at(np.zeros((0, 4)), np.array([0.0, 0.0])) is None


def test_a_slow_twin_finds_the_same():
    """Random convex polygons: from the nearest edge, along its normal, to the nearest of all other edges."""
    r = np.random.default_rng(5)
    for _ in range(200):
        angles = np.sort(r.uniform(0, 2 * np.pi, 9))
        points = np.stack([5 * np.cos(angles), 3 * np.sin(angles)], 1)
        at, best = r.dirichlet(np.ones(9)) @ points, (np.inf, None, None)
        edges = [(points[i], points[(i + 1) % 9]) for i in range(9)]
        for k, (a, b) in enumerate(edges):
            normal = np.array([b[1] - a[1], a[0] - b[0]]) / math.dist(a, b)
            away = (a - at) @ normal
            if away < best[0]:
                best = away, normal, k
        away, normal, k = best
        times = [((a - at) @ n) / (-normal @ n) for i, (a, b) in enumerate(edges) if i != k
                 for n in [np.array([b[1] - a[1], a[0] - b[0]])] if -normal @ n > 0]
        chord = chord_at(closed(points), at)
        assert chord.solid and chord.length == pytest.approx(away + min(times), rel=1e-9)


def test_the_nearest_place_of_an_outline():
    place, away = nearest_on(rectangle(10, 4), np.array([1.0, 1.5]))
    assert place == pytest.approx((1, 2)) and away == pytest.approx(0.5)
    place, away = nearest_on(rectangle(10, 4), np.array([8.0, 6.0]))
    assert place == pytest.approx((5, 2)) and away == pytest.approx(5)
