"""Deviations of a mesh from the Field that it approximates, and their colours."""

import numpy as np

# RGB from inside to outside.
STOPS = np.array([[0.10, 0.25, 0.80], [0.35, 0.70, 0.95], [0.92, 0.95, 0.92], [0.98, 0.70, 0.25], [0.80, 0.10, 0.08]])


def deviations(field, vertices, triangles):
    """Returns for each vertex a distance to the surface, mm, positive outside the solid. It is the distance of the
    vertex or of the centroid of an adjacent triangle, whichever has the greater magnitude."""
    triangles = np.asarray(triangles, dtype=np.int64)
    farthest = field.surface_distances(vertices)
    of_middles = field.surface_distances(vertices[triangles].mean(axis=1, dtype=np.float32))
    order = np.argsort(np.abs(of_middles))  # later writes win: the greatest magnitude goes last
    around = np.zeros(len(vertices), np.float32)
    for corner in range(3):
        here = np.zeros(len(vertices), np.float32)
        here[triangles[order, corner]] = of_middles[order]
        around = np.where(np.abs(here) > np.abs(around), here, around)
    return np.where(np.abs(around) > np.abs(farthest), around, farthest)


def colours(shares):
    """Returns red, green and blue of numbers from -1 (inside) to 1 (outside)."""
    at = (np.clip(np.nan_to_num(shares), -1, 1) + 1) / 2 * (len(STOPS) - 1)
    return np.stack([np.interp(at, np.arange(len(STOPS)), STOPS[:, channel]) for channel in range(3)], axis=-1)


def nice_reach(deviation):
    """Returns the end of the colour scale: the largest deviation, rounded up to 1, 2 or 5 times a power of ten."""
    most = max(float(np.abs(deviation).max(initial=0)), 1e-6)
    power = 10 ** np.floor(np.log10(most))
    return float(next(step * power for step in (1, 2, 5, 10) if step * power >= most * 0.999))
