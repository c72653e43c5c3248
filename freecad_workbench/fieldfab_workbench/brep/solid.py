"""A closed mesh as a Part solid with few faces: flat, cylindrical, conical, spherical, toroidal, and B-splines."""

import itertools
import os
import tempfile
import time

import FreeCAD
import numpy as np
import Part

from . import step
from .samples import samples_of
from .segments import Segments
from .topology import Builder

MOST_FACES = 1500
COARSE = 0.5  # greatest distance of an edge from its faces, in cells
LONGEST = 60.0  # seconds; what takes longer are organic shapes and lattices, which gain nothing


def shape_of(vertices, triangles, field=None, progress=lambda fraction: None):
    """Returns the Part shape of a closed mesh, or None if no valid one of the same volume comes out in time. `field`:
    the fieldfab.Solid that the mesh shows. `progress(fraction)` may raise an exception to stop the work."""
    ends = time.monotonic() + LONGEST

    def advance(fraction):
        progress(fraction)
        if time.monotonic() > ends:
            raise ValueError("it takes too long")

    try:
        return _shape_of(samples_of(vertices, triangles, field), advance)
    except (ArithmeticError, ValueError, np.linalg.LinAlgError, Part.OCCError) as error:
        FreeCAD.Console.PrintLog(f"Fieldfab: no curved faces: {error}\n")
        return None


def _shape_of(samples, progress):
    segments = Segments(samples, lambda fraction: progress(0.6 * fraction))
    if not segments.complete or len(segments.surfaces) > MOST_FACES:
        return None
    progress(0.6)
    if not samples.exact:
        _estimate_volume(samples, segments)
    return made_of(segments, progress)


def _estimate_volume(samples, segments):
    """Adds the volume between the triangles and the surfaces through their corners. Over a triangle the mean of a
    quadratic function that is zero at its corners is 3/4 of that in the middle."""
    for region, surface in enumerate(segments.surfaces):
        inside = segments.labels == region
        bulge = -0.75 * samples.areas[inside] * surface.distance(samples.points[-1, inside])
        samples.volume += bulge.sum()
        samples.slack += 0.2 * np.abs(bulge).sum()
    samples.slack += 1e-4 * abs(samples.volume)


def made_of(segments, progress=lambda fraction: None):
    """Returns the shape of segments, or None. Faces around an axis or a tube that OpenCASCADE trims wrongly are cut
    into parts: first those with missing places, then all."""
    shape = _read(_text(segments, lambda: progress(0.7)))
    for choose in (missing_regions, lambda shape, segments: range(len(segments.surfaces))):
        if is_right(shape, segments.samples):
            return shape
        if segments.cut(choose(shape, segments)):
            shape = _read(_text(segments, lambda: progress(0.9)))
    return shape if is_right(shape, segments.samples) else None


def missing_regions(shape, segments):
    """Returns the regions of which some places are not on a shape."""
    if shape.isNull() or not shape.Faces:
        return range(len(segments.surfaces))
    samples, random, found = segments.samples, np.random.default_rng(4), []
    for region in range(len(segments.surfaces)):
        inside = np.flatnonzero((segments.labels == region) & samples.sure)
        if len(inside) == 0 or segments.surfaces[region].NAME in ("Plane", "BSplineSurface"):
            continue
        chosen = random.choice(inside, min(6, len(inside)), replace=False)
        far = [shape.distToShape(Part.Vertex(*samples.points[-1, t]))[0] for t in chosen]
        if max(far) > 0.3 * samples.cell:
            found.append(region)
    return found


def _text(segments, advance=lambda: None):
    samples, topology = segments.samples, Builder(segments, advance).result()
    writer = step.StepText(_spline)

    def points_of(region):
        return samples.points[-1, segments.labels == region]

    solids = writer.solids(topology, segments.surfaces, points_of, _shells(samples, segments))
    return writer.text(solids, 1e-6)


def _shells(samples, segments):
    """Returns the regions of each shell, by solids: a piece, and the cavities in it."""
    every = np.ones(len(samples.triangles), bool)
    pieces, cavities = [], []
    for component in segments.components(every):
        corners = samples.vertices[samples.triangles[component]]
        volume = np.einsum("ni,ni->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2]))
        shell = (np.unique(segments.labels[component]), corners)
        (pieces if volume > 0 else cavities).append(shell)
    solids = [[regions] for regions, _ in pieces]
    for regions, corners in cavities:
        around = [i for i, (_, outer) in enumerate(pieces) if is_inside(corners[0, 0], outer)]
        if not around:
            raise ValueError("a cavity is outside of all pieces")
        solids[min(around, key=lambda i: np.ptp(pieces[i][1].reshape(-1, 3), axis=0).max())].append(regions)
    return solids


def is_inside(point, corners):
    """Returns whether a point is inside a closed mesh of triangles (n, 3, 3), by their solid angles."""
    a, b, c = (corners[:, i] - point for i in range(3))
    la, lb, lc = (np.linalg.norm(v, axis=1) for v in (a, b, c))
    below = la * lb * lc + np.sum(a * b, axis=1) * lc + np.sum(b * c, axis=1) * la + np.sum(c * a, axis=1) * lb
    return np.arctan2(np.sum(a * np.cross(b, c), axis=1), below).sum() > np.pi


def _spline(points):
    """Returns (degree, poles, multiplicities, knots) of a B-spline through points."""
    curve = Part.BSplineCurve()
    curve.interpolate([tuple(p) for p in points])
    return curve.Degree, [tuple(p) for p in curve.getPoles()], curve.getMultiplicities(), curve.getKnots()


def _read(text):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "solid.step")
        with open(path, "w", encoding="ascii") as file:
            file.write(text)
        shape = Part.read(path)
    if not shape.isNull():
        _set_tolerances(shape)
    return shape


def _set_tolerances(shape):
    """Gives edges and vertices tolerances that cover the distance of each edge from its faces."""
    for edge in shape.Edges:
        far = 0.0 if edge.Degenerated else max(_distances(edge))
        if far > 0.3 * edge.Tolerance:
            edge.fixTolerance(3 * far)
    for edge in shape.Edges:
        for vertex in edge.Vertexes:
            if vertex.Tolerance < edge.Tolerance:
                vertex.fixTolerance(edge.Tolerance)


def _distances(edge):
    """Yields the greatest distance of an edge from each of its surfaces at the same parameters."""
    yield 0.0
    for index in itertools.count():
        on_surface = edge.curveOnSurface(index)
        if on_surface is None:
            return
        flat, surface, placement, first, last = on_surface
        places = ((flat.value(t), edge.valueAt(t)) for t in np.linspace(first, last, 100))
        yield max(placement.multVec(surface.value(uv.x, uv.y)).distanceToPoint(place) for uv, place in places)


def is_right(shape, samples):
    """Returns whether a shape is valid, closed and precise, and has the volume and the bounds of the mesh."""
    if shape.isNull() or not shape.Solids or not shape.isValid() or not all(shell.isClosed() for shell in shape.Shells):
        return False
    if shape.getTolerance(1) > COARSE * samples.cell:
        return False
    if abs(shape.Volume - samples.volume) > min(samples.slack, 0.01 * abs(samples.volume)):
        return False
    reach = max(samples.cell, 5e-3 * shape.BoundBox.DiagonalLength)
    places, _ = shape.tessellate(0.3 * reach)
    places = np.array([tuple(place) for place in places])
    used = samples.vertices[np.unique(samples.triangles)]
    return all(np.abs(bound(places, axis=0) - bound(used, axis=0)).max() < reach for bound in (np.min, np.max))
