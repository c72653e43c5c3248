"""Curves through points on the line where two surfaces meet: lines, circles and ellipses where these fit, otherwise
B-splines."""

from dataclasses import dataclass

import numpy as np

from .surfaces import perpendicular, unit


@dataclass
class Curve:
    """`kind`: LINE, CIRCLE, ELLIPSE or SPLINE. `centre`, `axis`, `first` (the direction of parameter 0), `radii` of a
    conic, which runs counterclockwise around its axis. `points`: of a spline."""

    kind: str
    centre: np.ndarray = None
    axis: np.ndarray = None
    first: np.ndarray = None
    radii: tuple = ()
    points: np.ndarray = None


def curve_through(points, first, second, tolerance):
    """Returns the Curve of points in order, on two surfaces; the first and the last are exact. Closed if they are the
    same."""
    closed = np.linalg.norm(points[0] - points[-1]) < tolerance
    if not closed and _deviation_from_line(points) < tolerance:
        return Curve("LINE", points[0], unit(points[-1] - points[0]))
    found = _circle(points, closed, tolerance) or _ellipse(points, first, second, closed, tolerance)
    return found or Curve("SPLINE", points=points)


def _deviation_from_line(points):
    along = unit(points[-1] - points[0])
    offsets = points - points[0]
    return np.linalg.norm(offsets - (offsets @ along)[:, None] * along, axis=1).max()


def _plane_of(points):
    """Returns the middle and the axis of a plane around which the points run counterclockwise, or None."""
    middle = points[:-1].mean(axis=0) if len(points) > 3 else points.mean(axis=0)
    offsets = points - middle
    turn = np.cross(offsets[:-1], offsets[1:]).sum(axis=0) + np.cross(offsets[-1], offsets[0])
    if np.linalg.norm(turn) < 1e-30:
        return None
    vectors = np.linalg.eigh(offsets.T @ offsets)[1]
    axis = vectors[:, 0]
    return middle, axis if axis @ turn > 0 else -axis


def _circle(points, closed, tolerance):
    if len(points) < 3 + closed:
        return None
    found = _plane_of(points)
    if found is None:
        return None
    middle, axis = found
    axis = unit(np.where(np.abs(axis) < 1e-6, 0, axis))
    frame = np.array(perpendicular(axis))
    flat = (points - middle) @ frame.T
    rows = np.column_stack([2 * flat, np.ones(len(flat))])
    answer = np.linalg.lstsq(rows, np.sum(flat ** 2, axis=1), rcond=None)[0]
    centre = middle + answer[:2] @ frame
    radius = np.sqrt(max(answer[2] + answer[0] ** 2 + answer[1] ** 2, 0))
    offsets = points - centre
    height = offsets @ axis
    error = np.hypot(np.linalg.norm(offsets - height[:, None] * axis, axis=1) - radius, height)
    if not error.max() < tolerance or not _turns_once(flat - answer[:2], closed):
        return None
    first = points[0] - centre
    return Curve("CIRCLE", centre, axis, unit(first - (first @ axis) * axis), (radius,))


def _turns_once(flat, closed):
    """Returns whether points in a plane run around the origin once at most, counterclockwise."""
    angles = np.unwrap(np.arctan2(flat[:, 1], flat[:, 0]))
    total = angles[-1] - angles[0]
    return abs(total - 2 * np.pi) < 0.1 if closed else 0 < total < 2 * np.pi


def _ellipse(points, first, second, closed, tolerance):
    """Returns the section of a cylinder by a plane, or None."""
    by_name = {surface.NAME: surface for surface in (first, second)}
    plane, cylinder = by_name.get("Plane"), by_name.get("Cylinder")
    if plane is None or cylinder is None:
        return None
    slope = plane.axis @ cylinder.axis
    if not 0.01 < abs(slope) < 1 - 1e-12:
        return None
    centre = cylinder.origin + (plane.origin - cylinder.origin) @ plane.axis / slope * cylinder.axis
    major = unit(cylinder.axis - slope * plane.axis)
    offsets = points - centre
    turn = (np.cross(offsets[:-1], offsets[1:])).sum(axis=0) @ plane.axis
    axis = plane.axis if turn > 0 else -plane.axis
    radii = cylinder.sizes[0] / abs(slope), cylinder.sizes[0]
    flat = np.column_stack([offsets @ major / radii[0], offsets @ np.cross(axis, major) / radii[1]])
    error = np.abs(np.linalg.norm(flat, axis=1) - 1).max() * radii[0]
    if error > tolerance or not _turns_once(flat, closed):
        return None
    return Curve("ELLIPSE", centre, axis, major, radii)


def thinned(points, least):
    """Returns points in order without steps backwards and without steps shorter than `least`; the ends stay. Vertices
    of a mesh may lie beyond a corner by a part of a cell."""
    least = min(least, 0.15 * np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    kept = [points[0]]
    for point in points[1:-1]:
        if np.linalg.norm(points[-1] - point) < least:
            continue
        _keep(kept, point, least)
    while len(kept) > 2 and (points[-1] - kept[-1]) @ (kept[-1] - kept[-2]) <= 0:
        kept.pop()
    return np.array([*kept, points[-1]])


def _keep(kept, point, least):
    step = point - kept[-1]
    if step @ step < least ** 2:
        return
    if len(kept) > 1 and step @ (kept[-1] - kept[-2]) <= 0:
        kept.pop()  # one of them is a step backwards
        step = point - kept[-1]
        if step @ step < least ** 2:
            return
    kept.append(point)


def smoothed(points, rounds=20):
    """Returns points moved towards the middles of their neighbours; the ends stay, unless they are the same."""
    closed = len(points) > 3 and np.allclose(points[0], points[-1])
    for _ in range(rounds):
        if closed:
            around = points[:-1]
            points = (2 * around + np.roll(around, 1, axis=0) + np.roll(around, -1, axis=0)) / 4
            points = np.concatenate([points, points[:1]])
        else:
            points = np.concatenate([points[:1], (2 * points[1:-1] + points[:-2] + points[2:]) / 4, points[-1:]])
    return points
