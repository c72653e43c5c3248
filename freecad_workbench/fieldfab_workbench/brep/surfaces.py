"""Planes, cylinders, cones, spheres and tori: distances, normals, and least-squares fits. Lengths are mm.

A surface has an outward side: `sense` is 1 for a boss (normals point away from the axis or centre), -1 for a hole."""

import math

import numpy as np


def unit(vectors):
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-300)


def perpendicular(axis):
    """Returns two unit vectors that make a right-handed frame with a unit vector as the third."""
    x, y, z = axis
    first = np.array(((0.0, z, -y), (-z, 0.0, x), (y, -x, 0.0))[int(np.argmin(np.abs(axis)))])
    first /= math.sqrt(first @ first)
    u, v, w = first
    return first, np.array((y * w - z * v, z * u - x * w, x * v - y * u))


class Surface:
    """`origin` (3,), `axis` (3,) unit, `sizes` (n,) and `sense`. Subclasses define their meaning."""

    NAME, FREE = "", False  # kind; whether it is free-form

    def __init__(self, origin, axis=(0.0, 0.0, 1.0), sizes=(), sense=1):
        self.origin, self.axis = np.asarray(origin, float), unit(np.asarray(axis, float))
        self.sizes, self.sense = np.asarray(sizes, float), sense

    def distance(self, points):
        """Returns the signed distances of points (n, 3), negative inside."""
        raise NotImplementedError

    def normal(self, points):
        """Returns the outward unit normals (n, 3) at the nearest places of the surface."""
        raise NotImplementedError

    def degrees_of_freedom(self):
        return 5 + len(self.sizes)

    def changed(self, step):
        """Returns the surface with changed parameters: origin (3), axis (2, tangential), sizes."""
        first, second = perpendicular(self.axis)
        return type(self)(self.origin + step[:3], self.axis + step[3] * first + step[4] * second,
                          self.sizes + step[5:], self.sense)

    def _along(self, points):
        offset = points - self.origin
        height = offset @ self.axis
        return height, offset - height[:, None] * self.axis


class Plane(Surface):
    NAME = "Plane"

    def distance(self, points):
        return (points - self.origin) @ self.axis

    def normal(self, points):
        return np.broadcast_to(self.axis, points.shape)


class Cylinder(Surface):
    """`sizes`: radius."""

    NAME = "Cylinder"

    def distance(self, points):
        return self.sense * (np.linalg.norm(self._along(points)[1], axis=1) - self.sizes[0])

    def normal(self, points):
        return self.sense * unit(self._along(points)[1])


class Cone(Surface):
    """`origin`: apex; the cone opens along `axis`. `sizes`: half angle, radians."""

    NAME = "Cone"

    def distance(self, points):
        height, radial = self._along(points)
        return self.sense * (np.linalg.norm(radial, axis=1) * np.cos(self.sizes[0]) - height * np.sin(self.sizes[0]))

    def normal(self, points):
        radial = unit(self._along(points)[1])
        return self.sense * (radial * np.cos(self.sizes[0]) - self.axis * np.sin(self.sizes[0]))


class Sphere(Surface):
    """`sizes`: radius."""

    NAME = "Sphere"

    def distance(self, points):
        return self.sense * (np.linalg.norm(points - self.origin, axis=1) - self.sizes[0])

    def normal(self, points):
        return self.sense * unit(points - self.origin)


class Torus(Surface):
    """`sizes`: radius of the circle of centres, radius of the tube."""

    NAME = "Torus"

    def _from_tube(self, points):
        height, radial = self._along(points)
        return points - self.origin - self.sizes[0] * unit(radial)

    def distance(self, points):
        return self.sense * (np.linalg.norm(self._from_tube(points), axis=1) - self.sizes[1])

    def normal(self, points):
        return self.sense * unit(self._from_tube(points))


def fit_plane(points, normals):
    centre, axis = points.mean(axis=0), unit(normals.mean(axis=0))
    offsets = points - centre
    values, vectors = np.linalg.eigh(offsets.T @ offsets)
    if values[1] <= 1e-9 * values[2]:
        return Plane(centre, axis)  # the points are on a line
    return Plane(centre, vectors[:, 0] if vectors[:, 0] @ axis > 0 else -vectors[:, 0])


def _circle(points, normals):
    """Returns (centre, signed radius) with points = centre + radius * normals in the least-squares sense, in any
    dimension, or None."""
    p, n = points - points.mean(axis=0), normals - normals.mean(axis=0)
    spread = np.sum(n * n)
    if spread < 1e-12:
        return None
    radius = np.sum(p * n) / spread
    return points.mean(axis=0) - radius * normals.mean(axis=0), radius


def _sense(radius):
    return abs(radius), 1 if radius > 0 else -1


def fit_sphere(points, normals):
    found = _circle(points, normals)
    if found is None or found[1] == 0:
        return None
    radius, sense = _sense(found[1])
    return Sphere(found[0], sizes=(radius,), sense=sense)


def fit_cylinder(points, normals):
    axis = np.linalg.svd(normals, full_matrices=False)[2][2]
    frame = np.array(perpendicular(axis))
    found = _circle(points @ frame.T, normals @ frame.T)
    if found is None or found[1] == 0:
        return None
    radius, sense = _sense(found[1])
    centre = found[0] @ frame + (points.mean(axis=0) @ axis) * axis
    return Cylinder(centre, axis, (radius,), sense)


def fit_cone(points, normals):
    middle = normals.mean(axis=0)
    axis = np.linalg.svd(normals - middle, full_matrices=False)[2][2]
    apex, _, rank, _ = np.linalg.lstsq(normals, np.sum(normals * points, axis=1), rcond=1e-9)
    if rank < 3:
        return None
    if np.mean((points - apex) @ axis) < 0:
        axis = -axis
    radial = points - apex - ((points - apex) @ axis)[:, None] * axis
    sense = 1 if np.mean(np.sum(radial * normals, axis=1)) > 0 else -1
    angle = np.arcsin(np.clip(-sense * np.mean(normals @ axis), -1, 1))
    return Cone(apex, axis, (angle,), sense) if 0.01 < angle < 1.56 else None


def fit_torus(points, normals):
    """The normals of a surface of revolution meet its axis: their Pluecker coordinates and the axis' are
    reciprocal."""
    centre, scale = points.mean(axis=0), max(np.ptp(points, axis=0).max(), 1e-12)
    local = (points - centre) / scale
    rows = np.hstack([np.cross(local, normals), normals])
    values, vectors = np.linalg.svd(rows, full_matrices=False)[1:]
    line = vectors[5]
    length = np.linalg.norm(line[:3])
    if values[4] < 1e-9 * values[0] or length < 1e-6:
        return None
    axis, moment = line[:3] / length, line[3:] / length
    foot = np.cross(axis, moment)
    offset = local - foot
    height = offset @ axis
    radial = offset - height[:, None] * axis
    distance = np.linalg.norm(radial, axis=1)
    across = np.sum(radial * normals, axis=1) / np.maximum(distance, 1e-12)
    found = _circle(np.column_stack([distance, height]), np.column_stack([across, normals @ axis]))
    if found is None or found[1] == 0:
        return None
    (ring, rise), (radius, sense) = found[0], _sense(found[1])
    if ring <= 1.02 * radius:
        return None  # it meets itself
    return Torus(centre + scale * (foot + rise * axis), axis, (scale * ring, scale * radius), sense)


FITS = (fit_plane, fit_sphere, fit_cylinder, fit_cone, fit_torus)


def refined(surface, points, rounds=12):
    """Returns the surface with the least squares of distances to points (Levenberg-Marquardt), or None if that
    diverges."""
    if isinstance(surface, Plane):
        return fit_plane(points, surface.axis[None])
    scale = max(np.ptp(points, axis=0).max(), 1e-9)
    count = surface.degrees_of_freedom()
    step = np.full(count, 1e-7)
    step[:3] *= scale
    if not isinstance(surface, Cone):
        step[5:] *= scale
    damping, residual = 1e-6, surface.distance(points)
    for _ in range(rounds):
        jacobian = np.column_stack([(surface.changed(step[i] * np.eye(count)[i]).distance(points) - residual)
                                    for i in range(count)])
        normal = jacobian.T @ jacobian
        for _ in range(6):
            change = np.linalg.lstsq(normal + damping * np.diag(np.diag(normal) + 1e-30),
                                     -jacobian.T @ residual, rcond=1e-14)[0] * step
            new = surface.changed(change)
            after = new.distance(points)
            if np.all(np.isfinite(after)) and after @ after <= residual @ residual:
                break
            damping *= 10
        else:
            break
        gained = residual @ residual - after @ after
        surface, residual, damping = new, after, max(damping / 10, 1e-12)
        if gained <= 1e-6 * (after @ after) + 1e-24:
            break
    fine = np.all(surface.sizes > 0) and np.all(np.isfinite(surface.sizes))
    return surface if fine else None


def snapped(surface, points, tolerance):
    """Returns the surface with axis and sizes at round values, where these fit the points as well within the
    tolerance."""
    limit = np.median(np.abs(surface.distance(points))) + tolerance / 2
    best = surface
    axis = unit(np.where(np.abs(surface.axis) < 1e-4, 0, surface.axis))
    tries = [{"axis": axis}] if np.abs(axis - surface.axis).max() else []
    for digits in (6, 5, 4, 3, 2, 1):
        tries += [{"sizes": np.round(surface.sizes, digits)}] if not isinstance(surface, Cone) else []
        tries += [{"origin": np.round(surface.origin, digits)}]
    for change in tries:
        made = type(surface)(**{"origin": best.origin, "axis": best.axis, "sizes": best.sizes, "sense": best.sense,
                                **change})
        if np.all(made.sizes > 0) and np.median(np.abs(made.distance(points))) <= limit:
            best = made
    return best
