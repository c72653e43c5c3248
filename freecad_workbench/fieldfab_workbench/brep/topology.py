"""Vertices, edges and loops of a boundary representation, from the outline of a mesh's regions and their surfaces."""

from dataclasses import dataclass, field

import numpy as np

from .contacts import met, touch
from .curves import Curve, curve_through, smoothed, thinned
from .outline import outline_of
from .surfaces import unit


@dataclass
class Edge:
    start: int
    end: int
    curve: Curve
    points: np.ndarray


@dataclass
class Topology:
    """`vertices` (n, 3); `edges`; `faces`: {region: loops of (edge, forward)}; a whole sphere or torus has no loops."""

    vertices: list = field(default_factory=list)
    edges: list = field(default_factory=list)
    faces: dict = field(default_factory=dict)

    def axis_of(self, loop):
        """Returns the unit normal of a loop's area."""
        points = np.concatenate([self.edges[e].points[::1 if forward else -1] for e, forward in loop])
        offsets = points - points.mean(axis=0)
        return unit(np.cross(offsets, np.roll(offsets, -1, axis=0)).sum(axis=0))


class Builder:
    """Makes the Topology of labelled triangles."""

    def __init__(self, segments, step=lambda: None):
        """`step()` is called often; it may raise an exception to stop the work."""
        self.step = step
        self.segments, self.samples, self.surfaces = segments, segments.samples, segments.surfaces
        self.pinned = self._apexes()
        self.outline = outline_of(self.samples.triangles, self.samples.neighbours, segments.labels, self.pinned)
        self.tolerance = max(20 * self.samples.noise, 1e-7)
        self.merged = self._merged_corners()

    def result(self):
        made, numbers = Topology(), {}
        for corner, place in self.places.items():
            numbers[corner] = len(made.vertices)
            made.vertices.append(place)
        edges = {}
        for index, chain in enumerate(self.outline.chains):
            if index in self.dropped:
                continue
            self.step()
            edge = self._edge(chain, numbers, made)
            edges[index] = len(made.edges)
            made.edges.append(edge)
        for region in range(len(self.surfaces)):
            loops = self.outline.loops.get(region)
            if loops is None:
                made.faces[region] = []
                continue
            kept = [[(edges[i], forward) for i, forward in loop if i in edges] for loop in loops]
            kept = [loop for loop in kept if loop]
            if kept:
                made.faces[region] = kept
        return made

    # Corners.
    def _apexes(self):
        """Returns {mesh vertex: apex} of cones that are cut through their apex."""
        found = {}
        for region in self.segments.parts:
            surface = self.surfaces[region]
            corners = np.unique(self.samples.triangles[self.segments.labels == region])
            away = np.linalg.norm(self.samples.vertices[corners] - surface.origin, axis=1)
            if surface.NAME == "Cone" and away.min() < self.samples.cell:
                found[int(corners[np.argmin(away)])] = surface.origin
        return found

    def _corner_place(self, corners, regions):
        for corner in corners:
            if corner in self.pinned:
                return self.pinned[corner]
        self.step()
        mean = self.samples.vertices[corners].mean(axis=0)[None]
        return met(self.segments.meeting(regions), mean, self.samples.cell)[0]

    def _merged_corners(self):
        """Returns {mesh vertex: its corner}: corners of short chains are one if their surfaces meet at one place."""
        parent = {corner: corner for corner in self.outline.corners}

        def root(corner):
            while parent[corner] != corner:
                corner = parent[corner]
            return corner

        regions = {corner: set(around) for corner, around in self.outline.corners.items()}
        self.places = {corner: self._corner_place([corner], around) for corner, around in regions.items()}
        groups = {corner: [corner] for corner in parent}
        chains = [chain for chain in self.outline.chains if chain.vertices[0] != chain.vertices[-1]]
        for chain in sorted(chains, key=self._length):
            first, second = root(chain.vertices[0]), root(chain.vertices[-1])
            if first == second or not self._is_point(chain, self.places[first], self.places[second]):
                continue
            parent[second] = first
            regions[first] |= regions.pop(second)
            groups[first] += groups.pop(second)
            del self.places[second]
            self.places[first] = self._corner_place(groups[first], regions[first])
        merged = {corner: root(corner) for corner in parent}
        self.dropped = {i for i, chain in enumerate(self.outline.chains) if chain.vertices[0] in merged
                        and merged[chain.vertices[0]] == merged[chain.vertices[-1]]
                        and (self._is_point(chain, *[self.places[merged[chain.vertices[0]]]] * 2)
                             or self._is_spot(chain))}
        self.dropped |= {i for i, chain in enumerate(self.outline.chains)
                         if chain.vertices[0] not in merged and self._is_spot(chain)}
        return merged

    def _length(self, chain):
        return np.linalg.norm(np.diff(self.samples.vertices[chain.vertices], axis=0), axis=1).sum()

    def _is_point(self, chain, first, second):
        """Returns whether a chain between two places is an artefact of the mesh: its surfaces meet in one place."""
        reach = 0.15 * self.samples.cell
        if np.linalg.norm(first - second) > reach or self._length(chain) > 6 * self.samples.cell:
            return False
        closed = chain.vertices[0] == chain.vertices[-1]
        if not closed and np.linalg.norm(first - second) < 0.02 * self.samples.cell:
            return True
        points = self._met(chain, self.samples.vertices[chain.vertices])
        return np.linalg.norm(points - first, axis=1).max() < 2 * reach

    def _is_spot(self, chain):
        """Returns whether a closed chain without corners is an artefact of the mesh."""
        points = self.samples.vertices[chain.vertices]
        if self._length(chain) > 6 * self.samples.cell:
            return False
        return np.ptp(self._met(chain, points), axis=0).max() < 0.3 * self.samples.cell or len(points) < 6

    def _met(self, chain, points):
        """Returns points moved to where the surfaces on both sides of a chain meet."""
        surfaces = self.segments.meeting((chain.left, chain.right))
        smooth = any(surface.FREE for surface in surfaces) and touch(*surfaces[:2], points)
        return met(surfaces, points, self.samples.cell, smooth)

    # Edges.
    def _edge(self, chain, numbers, made):
        surfaces = self.segments.meeting((chain.left, chain.right))
        start, end = (self.merged.get(v, v) for v in (chain.vertices[0], chain.vertices[-1]))
        points = self.samples.vertices[chain.vertices]
        free = any(surface.FREE for surface in surfaces)
        if start in self.places:
            points[0], points[-1] = self.places[start], self.places[end]
        scale = self.samples.cell
        smooth = free and touch(*surfaces[:2], points[1:-1] if len(points) > 2 else points)
        if smooth:
            points = smoothed(points)
        inner = met(surfaces, points[1:-1] if start in self.places else points, scale, smooth)
        points = np.concatenate([points[:1], inner, points[-1:]]) if start in self.places else inner
        if start not in self.places:
            points[-1] = points[0]
            self.places[start] = points[0]
            numbers[start] = len(made.vertices)
            made.vertices.append(points[0])
        if len(points) == 2 and start != end:
            middle = met(surfaces, points.mean(axis=0)[None], scale, smooth)
            points = np.concatenate([points[:1], middle, points[1:]])
        points = thinned(points, 0.5 * scale)
        return Edge(numbers[start], numbers[end], curve_through(points, *surfaces[:2], self.tolerance), points)
