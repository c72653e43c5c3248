"""Free-form surfaces: cubic B-splines over a plane (height fields), fitted to points by least squares."""

import numpy as np

from .surfaces import Surface, unit

SPANS = (3, 6, 12, 18)  # knot spans along the longer side, tried in turn
SMOOTH = 1e-7  # weight of the second differences of poles


def knots_of(spans):
    return np.concatenate([[0, 0, 0], np.linspace(0, 1, spans + 1), [1, 1, 1]])


def basis(spans, t):
    """Returns the first pole's index (n,), and the values and the derivatives (n, 4) of the cubic basis functions that
    are not zero at t in [0, 1]."""
    knots = knots_of(spans)
    first = np.clip((t * spans).astype(int), 0, spans - 1)
    span = first + 3
    values = [np.ones_like(t)]
    for degree in (1, 2, 3):
        below = values
        values = [np.zeros_like(t) for _ in range(degree + 1)]
        for j in range(degree):
            right, left = knots[span + j + 1], knots[span + j + 1 - degree]
            share = below[j] / (right - left)
            values[j] += (right - t) * share
            values[j + 1] += (t - left) * share
    slopes = [np.zeros_like(t) for _ in range(4)]
    for j in range(3):
        share = 3 * below[j] / (knots[span + j + 1] - knots[span + j - 2])
        slopes[j] -= share
        slopes[j + 1] += share
    return first, np.stack(values, axis=1), np.stack(slopes, axis=1)


def greville(spans):
    knots = knots_of(spans)
    return (knots[1:-3] + knots[2:-2] + knots[3:-1]) / 3


class Patch(Surface):
    """`frame` (3, 3): rows u, v and w; the outward side is that of w. `low`, `size` (2,): the rectangle in u and v.
    `heights`: poles along w."""

    NAME, FREE = "BSplineSurface", True

    def __init__(self, origin, frame, low, size, heights):
        super().__init__(origin, frame[2])
        self.frame, self.low, self.size, self.heights = frame, low, size, heights
        self.spans = heights.shape[0] - 3, heights.shape[1] - 3

    def _at(self, points):
        """Returns the heights of the surface and its slopes along u and v below points, and the points' heights."""
        local = (points - self.origin) @ self.frame.T
        first, values, slopes = zip(*(basis(self.spans[i], np.clip((local[:, i] - self.low[i]) / self.size[i], 0, 1))
                                      for i in (0, 1)))
        poles = self.heights[first[0][:, None, None] + np.arange(4)[:, None], first[1][:, None, None] + np.arange(4)]
        height = np.einsum("ni,nj,nij->n", values[0], values[1], poles)
        slope = (np.einsum("ni,nj,nij->n", slopes[0], values[1], poles) / self.size[0],
                 np.einsum("ni,nj,nij->n", values[0], slopes[1], poles) / self.size[1])
        return height, *slope, local[:, 2]

    def distance(self, points):
        height, along, across, own = self._at(points)
        return (own - height) / np.sqrt(1 + along ** 2 + across ** 2)

    def normal(self, points):
        _, along, across, _ = self._at(points)
        return unit(np.stack([-along, -across, np.ones_like(along)], axis=1) @ self.frame)

    def poles(self):
        """Returns the poles (nu, nv, 3)."""
        u, v = (self.low[i] + self.size[i] * greville(self.spans[i]) for i in (0, 1))
        local = np.stack([*np.meshgrid(u, v, indexing="ij"), self.heights], axis=-1)
        return self.origin + local @ self.frame


def fit_patch(points, normals, tolerance):
    """Returns a Patch within the tolerance of points (n, 3), or None. Each point has a normal, from which the plane is
    chosen."""
    middle, axis = points.mean(axis=0), unit(normals.mean(axis=0))
    if np.min(normals @ axis) < 0.15:
        return None
    offsets = points - middle
    flat = offsets - (offsets @ axis)[:, None] * axis
    first = np.linalg.eigh(flat.T @ flat)[1][:, 2]
    first = unit(first - (first @ axis) * axis)
    frame = np.array([first, np.cross(axis, first), axis])
    local = offsets @ frame.T
    low, high = local[:, :2].min(axis=0), local[:, :2].max(axis=0)
    margin = 0.05 * (high - low).max()
    low, size = low - margin, high - low + 2 * margin
    for most in SPANS:
        spans = np.maximum(np.ceil(most * size / size.max()).astype(int), 2)
        heights = _heights(local, low, size, spans)
        patch = Patch(middle, frame, low, size, heights)
        if np.abs(patch.distance(points)).max() <= tolerance:
            return patch
    return None


def _heights(local, low, size, spans):
    (u, a, _), (v, b, _) = (basis(spans[i], (local[:, i] - low[i]) / size[i]) for i in (0, 1))
    shape = spans + 3
    rows = np.zeros((len(local), *shape))
    places = np.arange(len(local))
    for i in range(4):
        for j in range(4):
            rows[places, u + i, v + j] = a[:, i] * b[:, j]
    rows = rows.reshape(len(local), -1)
    normal = rows.T @ rows
    along, across = (np.diff(np.eye(n), 2, axis=0) for n in shape)
    bend = (np.kron(along.T @ along, np.eye(shape[1])) + np.kron(np.eye(shape[0]), across.T @ across))
    weight = SMOOTH * len(local)
    matrix = normal + weight * bend + 1e-12 * len(local) * np.eye(len(normal))
    return np.linalg.solve(matrix, rows.T @ local[:, 2]).reshape(shape)
