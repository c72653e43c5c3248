"""Tool paths as lines for display. Works on whole numpy arrays, without a loop over moves."""

import numpy as np

CHORD = 0.15  # radians; largest angle of an arc's chord


def points_of(moves, start=None):
    """Returns the points of a polyline along (n, 8) moves, with arcs as chords, and whether a rapid leads to each
    point: (m, 3) and (m,) arrays. The first point is `start`, or the end of the first move."""
    if not len(moves):
        return np.zeros((0, 3)), np.zeros(0, bool)
    to, bulge, rapid = moves[:, :3], moves[:, 4], moves[:, 3] == 0
    begin = np.vstack([to[:1] if start is None else np.reshape(start, (1, 3)), to[:-1]])
    turn = 4 * np.arctan(bulge)
    chords = np.maximum(1, np.ceil(np.abs(turn) / CHORD)).astype(int)
    move = np.repeat(np.arange(len(moves)), chords)
    step = np.arange(len(move)) - np.repeat(np.cumsum(chords) - chords, chords) + 1
    share = (step / chords[move])[:, None]
    points = begin[move] + share * (to - begin)[move]
    bent = bulge[move] != 0
    if bent.any():
        a, b, k, part = begin[move[bent]], to[move[bent]], bulge[move[bent], None], turn[move[bent]] * share[bent, 0]
        across = np.stack([a[:, 1] - b[:, 1], b[:, 0] - a[:, 0]], axis=1)
        centre = (a[:, :2] + b[:, :2]) / 2 + (1 - k * k) / (4 * k) * across
        arm, c, s = a[:, :2] - centre, np.cos(part), np.sin(part)
        points[bent, :2] = centre + np.stack([c * arm[:, 0] - s * arm[:, 1], s * arm[:, 0] + c * arm[:, 1]], axis=1)
    return np.vstack([begin[:1], points]), np.concatenate([[rapid[0]], rapid[move]])


def runs(points, rapid, wanted):
    """Returns the polylines that consist of rapids (`wanted` True) or of cuts: their points, concatenated, and the
    number of points of each."""
    steps = rapid[1:] == wanted
    if not steps.any():
        return np.zeros((0, 3), "f4"), np.zeros(0, "i4")
    edges = np.flatnonzero(np.diff(np.concatenate([[False], steps, [False]]).astype("i1")))
    first, last = edges[::2], edges[1::2]  # a run of steps first..last-1 has the points first..last
    counts = last - first + 1
    index = np.repeat(first - np.cumsum(counts) + counts, counts) + np.arange(counts.sum())
    return points[index].astype("f4"), counts.astype("i4")
