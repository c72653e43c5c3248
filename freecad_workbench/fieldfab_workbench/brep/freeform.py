"""Divides free-form regions into pieces that are height fields, each with a B-spline."""

import numpy as np

from .patches import fit_patch

SMOOTH = np.cos(np.radians(25))  # of the greatest angle between neighbouring triangles of a smooth region
SPREAD = 0.6  # cosine of the greatest angle of a piece's normals to their mean
MOST_FITS = 150  # of a solid; one with more free-form pieces is better shown as triangles
FEW = 20  # triangles of a piece that is not divided further
FITTED = 3000  # points of a fit


def divided(samples, region, fits, step=lambda: None):
    """Returns [(triangles, Patch)], or None if that takes more than a number of fits. Leaves out tiny pieces. `step()`
    is called before each fit; it may raise an exception to stop the work."""
    inside = np.zeros(len(samples.triangles), bool)
    inside[region] = True
    neighbours = _smooth_neighbours(samples)
    waiting, done = [], []
    while inside.any():
        piece = _facing_together(samples, inside, neighbours)
        inside[piece] = False
        waiting.append(piece)
        if len(waiting) > fits:
            return None
    while waiting:
        step()
        piece, fits = waiting.pop(), fits - 1
        few = len(piece) < FEW
        if few and samples.areas[piece].sum() < 0.5 * samples.cell ** 2:
            continue  # left to the pieces around it
        patch = _fitted(samples, piece, neighbours, (0.5 if few else 0.05) * samples.cell)
        if patch is not None:
            done.append((piece, patch))
        elif few or len(waiting) > fits:
            return None
        else:
            waiting += _halves(samples, piece, neighbours)
    return done


def _smooth_neighbours(samples):
    """Returns the neighbours, where those across a sharp edge are the triangle itself."""
    own = np.arange(len(samples.triangles))[:, None]
    cosine = np.einsum("ti,tji->tj", samples.normals, samples.normals[samples.neighbours])
    return np.where(cosine > SMOOTH, samples.neighbours, own)


def connected(start, inside, neighbours):
    inside, found, front = inside.copy(), [start], start
    inside[start] = False
    while len(front):
        front = np.unique(neighbours[front])
        front = front[inside[front]]
        inside[front] = False
        found.append(front)
    return np.concatenate(found)


def _facing_together(samples, inside, neighbours):
    """Returns a connected part of the triangles inside, with normals near their mean."""
    seed = np.flatnonzero(inside)[np.argmax(samples.areas[inside])]
    middle = samples.normals[seed]
    for _ in range(3):
        piece = connected(np.array([seed]), inside & (samples.normals @ middle > SPREAD), neighbours)
        middle = (samples.normals[piece] * samples.areas[piece, None]).sum(axis=0)
        middle = middle / max(np.linalg.norm(middle), 1e-30)
    return piece


def _fitted(samples, piece, neighbours, tolerance):
    """Returns the Patch of a piece, or None. Points of its smooth surroundings hold its border."""
    around = np.unique(neighbours[piece])
    around = np.unique(neighbours[around])
    inside = np.zeros(len(samples.triangles), bool)
    inside[around] = True
    counts = np.bincount(samples.triangles.ravel(), minlength=len(samples.vertices))
    own = np.bincount(samples.triangles[around].ravel(), minlength=len(samples.vertices))
    inner = np.flatnonzero((own == counts) & (own > 0))
    sure = around[samples.sure[around]]
    points = np.concatenate([samples.points[-1, sure], samples.vertices[inner]])
    if len(points) < 4:
        return None
    normals = samples.normals[piece]
    if len(points) > FITTED:
        points = np.random.default_rng(3).choice(points, FITTED, replace=False)
    return fit_patch(points, normals, tolerance)


def _halves(samples, piece, neighbours):
    """Returns the connected parts of both halves along the longer side."""
    centres = samples.points[-1, piece]
    offsets = centres - centres.mean(axis=0)
    along = offsets @ np.linalg.eigh(offsets.T @ offsets)[1][:, 2]
    parts = []
    for side in (along < np.median(along), along >= np.median(along)):
        inside = np.zeros(len(samples.triangles), bool)
        inside[piece[side]] = True
        while inside.any():
            parts.append(connected(np.flatnonzero(inside)[:1], inside, neighbours))
            inside[parts[-1]] = False
    return parts
