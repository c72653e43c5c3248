"""Points where surfaces meet, by Newton's method: curves of two surfaces and corners of three or more, also where these
touch without crossing."""

import itertools

import numpy as np

TOUCH = np.cos(np.radians(3))  # of the angle between normals below which surfaces touch
ROUNDS = 25


def met(surfaces, points, scale, smooth=False):
    """Returns the points (n, 3) moved to where all surfaces meet. `scale`: a length, such as an edge of a cell; steps
    are limited to it. `smooth`: the surfaces continue each other, and points only move along their normals."""
    if not len(points):
        return points
    rigid = [surface for surface in surfaces if not surface.FREE]
    points = _newton(lambda p: np.stack([s.distance(p) for s in surfaces], axis=1), points, scale,
                     0.1 if smooth else 1e-3)
    touching = [(a, b) for a, b in itertools.combinations(rigid, 2)
                if np.median(np.sum(a.normal(points) * b.normal(points), axis=1)) > TOUCH]
    if not touching:
        return points

    def residual(p):
        columns = [s.distance(p)[:, None] for s in surfaces]
        columns += [scale * (a.normal(p) - b.normal(p)) for a, b in touching]
        return np.concatenate(columns, axis=1)

    return _newton(residual, points, scale, 1e-4)


def touch(first, second, points):
    """Returns whether two surfaces have the same normals at points."""
    return np.median(np.sum(first.normal(points) * second.normal(points), axis=1)) > TOUCH


def _newton(residual, points, scale, cutoff):
    step = 1e-5 * scale
    for _ in range(ROUNDS):
        now = residual(points)
        jacobian = np.stack([(residual(points + step * axis) - now) / step for axis in np.eye(3)], axis=2)
        move = -np.einsum("nij,nj->ni", np.linalg.pinv(jacobian, rcond=cutoff), now)
        length = np.linalg.norm(move, axis=1, keepdims=True)
        points = points + move * np.minimum(1, scale / np.maximum(length, 1e-300))
        if length.max(initial=0) < 1e-9 * max(scale, np.abs(points).max(initial=0)):
            break
    return points
