"""Divides a mesh into connected regions, each on one surface: flat and curved surfaces by fits that grow from small
patches, the rest by the directions of its normals."""

import numpy as np

from . import freeform
from .surfaces import FITS, Plane, perpendicular, refined, snapped

PATCH = (10, 30)  # triangles of the patches that surfaces are fitted to
FAILURES = 300  # patches without a surface, one after another, until the rest counts as free-form
LEAST = 12  # triangles of a curved region
BEND = np.radians(8)  # least angle between normals of a curved region
FITTED = 1500  # samples of a region that a fit uses
SLANTED = np.radians(12)  # greatest angle of thin triangles, as at the poles of a mesh alone, to their surface
FREE = -1


class Segments:
    """`labels` (m,): the region of each triangle; `surfaces`: that of each region, None if free-form."""

    def __init__(self, samples, progress=lambda fraction: None):
        self.samples, self.progress = samples, progress
        self.labels, self.surfaces = np.full(len(samples.triangles), FREE), []
        # A facet of a round face in a mesh alone is flat, too: curved surfaces come first.
        for fits in [FITS] if samples.exact else [FITS[1:], FITS[:1]]:
            self._tried, self._fits = ~samples.sure, fits
            self._grow_all()
        self._absorb_slivers()
        self._divide_free()
        self.parts = {}  # region: (planes that cut it from others, its sides of these)
        if self.complete:
            self._connect()

    def _grow_all(self):
        order, failures, done = np.argsort(-self.samples.areas, kind="stable"), 0, 0
        half = np.random.default_rng(1).permutation(order)
        for seed in np.column_stack([order, half]).ravel():
            if self._tried[seed] or self.labels[seed] != FREE:
                continue
            done += 1
            if done % 10 == 0:
                self.progress(1 - np.mean(self.labels == FREE))
            found = self._found_at(seed)
            if found is None:
                failures += 1
                if failures > FAILURES:
                    break
                continue
            failures = 0
            surface, region = found
            self.labels[region] = len(self.surfaces)
            self.surfaces.append(surface)

    def _found_at(self, seed):
        """Returns the largest (surface, triangles) around a triangle, or None."""
        patch, best = self._patch(seed, PATCH[-1]), None
        for fit in self._fits:
            for count in PATCH:
                some = patch[:count]
                if fit is FITS[0] and not self.samples.exact:
                    some = some[self._along_with(seed, some)]
                if fit is not FITS[0] and len(some) < PATCH[0]:
                    continue
                surface = self._fitted(fit, some)
                grown = surface and self._grown(seed, surface)
                if grown and (best is None or len(grown[1]) > 1.5 * len(best[1])):
                    best = grown
                if best is not None:
                    break
            if best is not None:
                break
        if best is None:
            self._tried[patch[:PATCH[0] // 2]] = True
        return best

    def _along_with(self, seed, some):
        """Returns which triangles have the normal of a triangle."""
        normals = self.samples.normals
        return normals[some] @ normals[seed] > np.cos(self.samples.angle)

    def _patch(self, seed, count):
        """Returns the nearest free triangles by sides, with normals within 30 degrees, in order of discovery."""
        normals, neighbours, labels = self.samples.normals, self.samples.neighbours, self.labels
        found, seen, i = [seed], {seed}, 0
        while i < len(found) and len(found) < count:
            for other in neighbours[found[i]]:
                if (other not in seen and labels[other] == FREE and self.samples.sure[other]
                        and normals[other] @ normals[seed] > 0.85):
                    found.append(other)
                seen.add(other)
            i += 1
        return np.array(found[:count])

    def _fitted(self, fit, patch):
        """Returns a surface that fits a patch within the tolerance, or None."""
        points, normals = self._places(patch)
        surface, tolerance = fit(points, normals), self.samples.tolerance
        if surface is None or not np.all(np.isfinite(surface.origin)):
            return None
        far = np.abs(surface.distance(points)).max()
        if tolerance < far and (far < 30 * tolerance or not self.samples.exact) and not isinstance(surface, Plane):
            surface = refined(surface, points, 5)
            far = np.inf if surface is None else np.abs(surface.distance(points)).max()
        return None if far > tolerance or self._turned(surface, patch).max() > 2 * self.samples.angle else surface

    def _places(self, chosen):
        points = self.samples.fitted()[:, chosen]
        return points.reshape(-1, 3), np.tile(self.samples.normals[chosen], (len(points), 1))

    def _turned(self, surface, chosen):
        """Returns the angles between the normals of triangles and those of a surface."""
        cosine = np.sum(surface.normal(self.samples.points[-1, chosen]) * self.samples.normals[chosen], axis=1)
        return np.arccos(np.clip(cosine, -1, 1))

    def _grown(self, seed, surface):
        """Returns (surface, triangles) after growing and fitting in turns, or None if that is no region."""
        random, region, before = np.random.default_rng(2), None, -1
        for _ in range(6):
            region = self._reached(seed, surface)
            if len(region) == 0 or len(region) == before:
                break
            before = len(region)
            some = region if len(region) <= FITTED else random.choice(region, FITTED, replace=False)
            points = self._places(some)[0]
            better = refined(surface, points)
            far = np.inf if better is None else np.abs(better.distance(points))
            if self.samples.exact and np.median(far) > 2 * self.samples.noise:
                return None  # it only touches the surface
            if np.max(far) > self.samples.tolerance:
                break
            surface = better
        if region is None or not self._counts(surface, region):
            return None
        surface = snapped(surface, self._places(region)[0], self.samples.rounding)
        region = self._reached(seed, surface, self.samples.angle if self.samples.exact else SLANTED)
        return (surface, region) if self._counts(surface, region) else None

    def _counts(self, surface, region):
        """Returns whether a region is large enough for its surface, and as near to it as the samples are exact."""
        if not len(region) or np.median(np.abs(surface.distance(self._places(region)[0]))) > self.samples.noise:
            return False
        if self.samples.areas[region].sum() < self.samples.cell ** 2 or isinstance(surface, Plane):
            return self.samples.areas[region].sum() >= self.samples.cell ** 2
        normals = self.samples.normals[region]
        return len(region) >= LEAST and np.arccos(np.clip((normals @ normals[0]).min(), -1, 1)) > BEND

    def _reached(self, seed, surface, angle=None):
        """Returns the free triangles on a surface that are connected with a triangle. `angle`: of their normals to it;
        None for the samples' own."""
        free = np.flatnonzero((self.labels == FREE) & self.samples.sure)
        points = self.samples.fitted()
        fits = np.ones(len(free), bool)
        for level in points:
            fits &= np.abs(surface.distance(level[free])) <= self.samples.tolerance
        free = free[fits]
        free = free[self._turned(surface, free) <= (self.samples.angle if angle is None else angle)]
        inside = np.zeros(len(self.labels), bool)
        inside[free] = True
        return self.connected(np.array([seed]), inside) if inside[seed] else np.array([], int)

    def connected(self, start, inside):
        """Returns the triangles of a mask that are connected with some of its triangles."""
        return freeform.connected(start, inside, self.samples.neighbours)

    # Free triangles between regions.
    def _absorb_slivers(self):
        """Gives thin strips of free triangles, as along sharp edges, to the neighbours they fit best."""
        for component in self.components(self.labels == FREE):
            if not self._is_wide(component):
                self._absorb(component)

    def components(self, inside):
        inside, parts = inside.copy(), []
        while True:
            first = np.flatnonzero(inside)
            if not len(first):
                return parts
            parts.append(self.connected(first[:1], inside))
            inside[parts[-1]] = False

    def _is_wide(self, component):
        """Returns whether it has inner vertices, and not only in a few triangles."""
        inside = np.zeros(len(self.labels), bool)
        inside[component] = True
        outer = ~inside[self.samples.neighbours[component]].all(axis=1)
        rim = np.unique(self.samples.triangles[component[outer]])
        inner = ~np.isin(self.samples.triangles[component], rim).any(axis=1)
        return inner.sum() >= 3

    def _absorb(self, component):
        free = component
        while len(free):
            beside = self.labels[self.samples.neighbours[free]]
            touched = (beside != FREE).any(axis=1)
            if not touched.any():
                return
            for t, labels in zip(free[touched], beside[touched]):
                choices = np.unique(labels[labels != FREE])
                best = min(choices, key=lambda label: self._misfit(t, label))
                if self._misfit(t, best) < 2 * self.samples.cell:
                    self.labels[t] = best
            if np.all(self.labels[free[touched]] == FREE):
                return
            free = free[self.labels[free] == FREE]

    def _misfit(self, triangle, label):
        surface = self.surfaces[label]
        if surface is None:
            return self.samples.cell
        corners = self.samples.vertices[self.samples.triangles[triangle]]
        return np.abs(surface.distance(corners)).sum() + np.abs(surface.distance(corners.mean(axis=0)[None]))[0]

    def _divide_free(self):
        """Divides the free triangles into regions, each with a Patch. Sets `complete` to False if that fails."""
        inside = self.labels == FREE
        self.complete, fits = True, freeform.MOST_FITS
        for component in self.components(inside):
            small = self.samples.areas[component].sum() < 4 * self.samples.cell ** 2
            if small and self._merged(component):
                continue
            pieces = freeform.divided(self.samples, component, fits, lambda: self.progress(1.0))
            if pieces is None:
                self.complete = False
                return
            fits -= len(pieces)
            for triangles, patch in pieces:
                self.labels[triangles] = len(self.surfaces)
                self.surfaces.append(patch)
        for speck in self.components(self.labels == FREE):
            self.complete &= self._give_away(speck)

    def _merged(self, component):
        """Gives a small component to its neighbours if these are near. Returns whether they are."""
        beside = np.unique(self.labels[self.samples.neighbours[component]])
        near = [np.abs(self.surfaces[label].distance(self.samples.points[-1, component])) for label in beside
                if label != FREE]
        speck = self._area(component) < 0.05 * self.samples.cell ** 2
        if not near or not speck and np.min(near, axis=0).max() > 0.1 * self.samples.cell:
            return False
        self._absorb(component)
        return bool(np.all(self.labels[component] != FREE))

    # Connectivity.
    def _connect(self):
        """Makes each region connected: small parts go to the regions around them, others become regions."""
        for _ in range(3):
            changed = False
            for label in range(len(self.surfaces)):
                parts = sorted(self.components(self.labels == label), key=lambda part: -self._area(part))
                if parts and self._area(parts[0]) < 0.1 * self.samples.cell ** 2:
                    parts.insert(0, None)  # the region is small itself
                for part in parts[1:]:
                    changed = True
                    if self._area(part) < self.samples.cell ** 2 and self._give_away(part):
                        continue
                    self.labels[part] = len(self.surfaces)
                    self.surfaces.append(self.surfaces[label])
                    if label in self.parts:
                        self.parts[len(self.surfaces) - 1] = self.parts[label]
            if not changed:
                break
        self._renumber()

    def _area(self, triangles):
        return self.samples.areas[triangles].sum()

    def _give_away(self, part):
        """Gives triangles to the region that most of their surroundings belong to. Returns whether there is one."""
        beside = self.labels[self.samples.neighbours[part]].ravel()
        beside = beside[beside != self.labels[part[0]]]
        if not len(beside):
            return False
        self.labels[part] = np.bincount(beside).argmax()
        return True

    def _renumber(self):
        used, labels = np.unique(self.labels, return_inverse=True)
        self.labels = labels.reshape(-1)
        self.parts = {new: self.parts[old] for new, old in enumerate(used) if old in self.parts}
        self.surfaces = [self.surfaces[old] for old in used]

    def cut(self, regions):
        """Cuts regions on closed surfaces into parts that do not surround an axis or a tube. Returns whether there are
        any."""
        found = False
        for region in regions:
            planes = cuts_of(self.surfaces[region]) if region not in self.parts else []
            if not planes:
                continue
            found = True
            inside = np.flatnonzero(self.labels == region)
            sides = np.stack([plane.distance(self.samples.points[-1, inside]) > 0 for plane in planes], axis=1)
            for side in np.unique(sides, axis=0):
                self.labels[inside[(sides == side).all(axis=1)]] = len(self.surfaces)
                self.parts[len(self.surfaces)] = tuple(planes), tuple(side)
                self.surfaces.append(self.surfaces[region])
        self._connect()
        return found

    def meeting(self, regions):
        """Returns the surfaces whose common places bound regions, with the planes between parts of a cut region."""
        regions = sorted(regions)
        found = {id(self.surfaces[r]): self.surfaces[r] for r in regions}
        cut = [r for r in regions if r in self.parts]
        for i, first in enumerate(cut):
            for second in cut[i + 1:]:
                (planes, sides), (others, other_sides) = self.parts[first], self.parts[second]
                if planes == others:
                    found.update((id(plane), plane)
                                 for plane, a, b in zip(planes, sides, other_sides) if a != b)
        return list(found.values())


def cuts_of(surface):
    """Returns the planes that cut a closed surface into parts."""
    if surface.NAME not in ("Cylinder", "Cone", "Sphere", "Torus"):
        return []
    first, second = perpendicular(surface.axis)
    axes = {"Sphere": [first, second], "Torus": [first, surface.axis]}.get(surface.NAME, [first])
    return [Plane(surface.origin, axis) for axis in axes]
