"""A mesh prepared for the recognition of faces: neighbours, and one or more exact places of the surface a triangle."""

from dataclasses import dataclass

import numpy as np

from .surfaces import unit


FACET = np.radians(2.2)  # of triangles to their surface in a mesh alone: 27 segments a turn or more count as round


@dataclass
class Samples:
    """`vertices` (n, 3), `triangles` (m, 3). `neighbours` (m, 3): the triangle across the side from corner i to i + 1.
    `points` (k, m, 3) and `normals` (m, 3): places of the surface for each triangle. `sure` (m,): whether they are
    usable. `tolerance`: greatest distance of the points from the surface, mm. `angle`: greatest angle of the normals to
    it, radians. `noise`: usual distance of the points from the surface. `rounding`: error of
    single precision. `volume`, `slack`: estimate of the volume, and its greatest error.
    `exact`: whether a Field gave the places; otherwise they are the corners and the middle of flat triangles."""

    vertices: np.ndarray
    triangles: np.ndarray
    neighbours: np.ndarray
    areas: np.ndarray
    points: np.ndarray
    normals: np.ndarray
    sure: np.ndarray
    tolerance: float
    noise: float
    rounding: float
    angle: float
    cell: float
    volume: float
    slack: float
    exact: bool = True

    def fitted(self):
        """Returns the places (k, m, 3) that fits use: the vertices of a mesh alone."""
        return self.points if self.exact else self.points[:3]


def neighbours_of(triangles):
    """Returns the neighbours (m, 3) in a closed manifold mesh. Raises ValueError for another one."""
    starts, ends = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    count = int(triangles.max()) + 1
    forward, backward = starts.astype(np.int64) * count + ends, ends.astype(np.int64) * count + starts
    order = np.argsort(forward)
    place = np.searchsorted(forward[order], backward)
    place[place == len(order)] = 0
    opposite = order[place]
    if np.any(forward[opposite] != backward) or len(np.unique(forward)) != len(forward):
        raise ValueError("the mesh is not closed")
    return (opposite // 3).reshape(-1, 3)


def samples_of(vertices, triangles, field=None):
    """Returns the Samples of a closed mesh. `field`: the solid's own fieldfab.Solid, whose values and gradients refine
    the places; None for a mesh alone, whose vertices count as exact."""
    vertices, triangles = np.asarray(vertices, float), np.asarray(triangles, np.int64)
    corners = vertices[triangles]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas, flat = np.linalg.norm(cross, axis=1) / 2, unit(cross)
    size = float(np.linalg.norm(np.ptp(vertices, axis=0)))
    volume = float(np.einsum("ni,ni->", corners[:, 0], cross) / 6)
    centres = corners.mean(axis=1)
    cell = float(np.sqrt(areas.mean()))
    usual = (vertices, triangles, neighbours_of(triangles), areas)
    if field is None:
        tolerance = 2e-5 * size
        return Samples(*usual, np.concatenate([corners.transpose(1, 0, 2), centres[None]]), flat, areas > 0, tolerance,
                       tolerance, 1e-7 * size, FACET, cell, volume, 0.0, exact=False)
    points, normals = projected(field, centres)
    moved = np.linalg.norm(points - centres, axis=1)
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    value = np.abs(field.values(points.astype(np.float32)))
    sure = (areas > 0) & (moved < np.maximum(longest, cell)) & (value < 1e-5 * size)
    sure &= np.sum(normals * flat, axis=1) > 0.5
    lid = (value > 1e-3 * size) & (areas > 0)  # where bounds cut the solid, its mesh is flat
    points[lid], normals[lid] = centres[lid], flat[lid]
    sure |= lid
    shift = np.where(sure, np.sum((points - centres) * flat, axis=1), 0)
    exact, _ = projected(field, vertices)
    near = np.linalg.norm(exact - vertices, axis=1) < cell
    usual = (np.where(near[:, None], exact, vertices), *usual[1:])
    slack = float(np.sum(areas * np.where(sure, np.abs(shift), moved.clip(0, cell))))
    return Samples(*usual, points[None], normals, sure, 3e-6 * size, 1e-7 * size, 1e-7 * size, np.radians(0.5), cell,
                   volume + float(np.sum(areas * shift)), 0.5 * slack + 1e-4 * abs(volume))


def projected(field, points, rounds=4):
    """Returns the places where a Field is zero nearest to points, and its unit gradients there (Newton's method)."""
    points = points.copy()
    for _ in range(rounds):
        values, gradients = field.gradients(points.astype(np.float32))
        square = np.sum(gradients.astype(float) ** 2, axis=1)
        points -= (values / np.maximum(square, 1e-12))[:, None] * gradients
    return points, unit(field.gradients(points.astype(np.float32))[1].astype(float))
