"""Progressive meshes of a solid for display: coarse at once, then finer, then finest near the eye. Needs no window."""

import time

import numpy as np

from .. import kernel, work
from ..certainty import doubt_of
from ..sources import with_cell
from . import inventor

ANGLE = 0.004  # radians; largest visual angle of a cell, about three pixels
CELLS = 32  # along each side of a block; blocks are refined separately
BLOCKS = 4  # most blocks along an axis
# Multiple of the triangle limit allowed near the eye, where most triangles are outside of the picture.
NEAR = 4
PIECE = 10_000  # most triangles of a piece
SMOOTH = 48  # cells along the longest side in which edges do not look ragged
QUICK = 0.03  # seconds for the first mesh after which the first picture has SMOOTH cells
MARGIN = 1 / 8  # growth of a solid, relative to its size, that does not require new bounds


class Refinement:
    """Meshes one solid from coarse to fine. For one thread at a time. Pictures are {piece: [bytes of a binary Inventor
    file, ...]}; a piece is small enough to be added to the scene quickly. Methods raise fieldfab.Error and
    work.Cancelled."""

    def __init__(self, source, settings, guess=None, cells=20, most=100_000, faces_first=False, smooth=False):
        """`settings`: those of source.mesh() for the final mesh. `guess`: expected bounds of the solid, (x0, y0, z0,
        x1, y1, z1), mm. `cells`: cells of the first mesh along its longest side. `most`: limit of displayed triangles.
        `faces_first`: whether to start with the solid's exact faces, if it has them. `smooth`: whether the first mesh
        may have more cells than `cells` if it takes little time."""
        self.source, self.settings, self.guess, self.cells, self.most, self.faces_first = (
            source, settings, guess, cells, most, faces_first)
        self.region, self.voxel, self.triangles, self._seconds = None, None, 0, 0.0  # of the last mesh
        self.smooth = smooth
        self._cell = None, None  # (region, edge of the smallest cell in it)
        self.extent = guess  # known bounds of the solid
        # Whether the final mesh was made: then features are found quickly in blocks, too.
        self.sharp = False
        self.doubt = ""  # doubt about the final mesh after it was made, see certainty.doubt_of()
        self.exact = False  # whether the mesh consists of the exact faces, so that no refinement is needed
        self.in_blocks = False  # whether the last picture consists of blocks
        self.details, self.shown = {}, {}  # {block: DetailMesh}, {block: displayed triangles}

    # The whole solid.
    def coarse(self, progress):
        """Returns the first mesh. It is made within the guess if this contains the solid, since a search for the bounds
        would take longer than the mesh."""
        if self.faces_first and (mesh := self._faces(progress)) is not None:
            return self._picture(mesh, progress)
        mesh = self._in_the_guess(progress) if self.guess and "bounds" not in self.settings else None
        if mesh is None:
            self.region = self._bounds(progress)
            mesh = self._first_mesh(progress)
        self._fit_region(mesh)
        if self.smooth and self._seconds < QUICK and self.cells < SMOOTH and len(mesh.triangles):
            mesh = self._mesh(max(self._longest() / SMOOTH, self._wanted()), progress)
        return self._picture(mesh, progress)

    def finer(self, progress):
        """Yields meshes with decreasing cells, down to the final mesh's cells or to the limit of triangles. None if
        final() has exact faces."""
        if self._faces(progress) is not None:
            return
        wanted = self._wanted()
        while self.voxel > wanted and self.triangles < 0.6 * self.most:
            step = min(2, (self.most / max(self.triangles, 1)) ** 0.5)
            mesh = self._mesh(max(self.voxel / step, wanted), progress)
            yield self._picture(mesh, progress)

    def final(self, progress):
        """Makes the final mesh, which the source caches. Yields the mesh, or coarser ones if it exceeds the limit of
        triangles and the picture is out of date."""
        mesh = self._faces(progress)
        if mesh is None:
            mesh = self.source.mesh(progress, **self.settings)
        blocks_are_shown = self.in_blocks
        self.sharp, self.in_blocks, self.doubt = True, False, doubt_of(mesh)
        if len(mesh.triangles) <= self.most:
            self.voxel, self.triangles = self._wanted(), len(mesh.triangles)
            yield self._picture(mesh, progress)
        # Parts outside of the guess are missing in the picture, or blocks must be replaced.
        elif self._fit_region(mesh) or blocks_are_shown:
            self.voxel, self.triangles = self._longest() / self.cells, 0
            yield from self.finer(progress)

    # Refinement near the eye (Keeter, 4.3.3).
    def is_coarse_for(self, eye):
        return not self.exact and any(self._is_coarse(block, eye, self.voxel) for block in self._blocks())

    def suffices(self, mesh, eye):
        """Returns whether the final mesh is within the limit of triangles, and fine enough for the eye."""
        return (len(mesh.triangles) <= self.most
                and not any(self._is_coarse(block, eye, self._wanted()) for block in self._blocks()))

    def divided(self, progress):
        """Returns the solid at the displayed resolution in blocks (i, j, k), which can be replaced separately by finer
        ones."""
        self.in_blocks, self.shown = True, {}
        return {block: self._of_block(block, self.voxel, lambda box: [self._meshed(box, self.voxel, progress)],
                                      progress) for block in self._blocks()}

    def detail(self, eye, progress):
        """Yields {block: [bytes, ...]}, the nearest blocks first, until cells are small enough for the eye or the limit
        of triangles is reached. Blocks begin with about the final mesh's cells: the search for features is slow in
        cells that are larger than the solid's thickness."""
        cell, near = (self._wanted(), sorted((b for b in self._blocks() if self._is_coarse(b, eye, self.voxel)),
                                             key=lambda b: self._distance(b, eye)))
        for block in list(self.shown):  # detail for a previous eye may be too fine for this one
            yield self._shown(block, eye, progress)
        pieces = 0
        for block in near if self.voxel > cell else ():
            if block not in self.shown and pieces * PIECE < NEAR * self.most:
                picture = self._of_block(block, cell, lambda box: [self._meshed(box, cell, progress)], progress)
                pieces += len(picture)
                yield {block: picture}
        for block in near:
            more = True
            while more and sum(self.shown.values()) < NEAR * self.most:
                more = self._detail_of(block).refine(eye, progress)
                yield self._shown(block, eye, progress)

    def _shown(self, block, eye, progress):
        meshes = [mesh for _, _, mesh in self._detail_of(block).parts(eye)]
        self.shown[block] = sum(len(mesh.triangles) for mesh in meshes)
        return {block: self._of_block(block, self._wanted(), lambda box: meshes, progress)}

    def _detail_of(self, block):
        if block not in self.details:
            box = self._box(block, self._wanted())
            self.details[block] = kernel.load().DetailMesh(self.field, box, cells=CELLS, deepest=6, angle=ANGLE,
                                                           most_triangles=self.most)
        return self.details[block]

    # Steps of the methods above.
    @property
    def field(self):
        return self.source.field()

    def _bounds(self, progress):
        if "bounds" in self.settings:
            return np.array(self.settings["bounds"], float)
        found = self.source.field(progress).bounds()
        if found is None:  # raises the mesher's error for an unbounded or empty solid
            kernel.load().mesh(self.field, voxel=1e3, progress=progress)
        return np.array(found, float)

    def _in_the_guess(self, progress):
        """Returns a mesh within the guess, or within larger boxes if the guess cuts the solid; None if this fails."""
        self.source.field(progress)
        low, high = np.array(self.guess[:3], float), np.array(self.guess[3:], float)
        for _ in range(4):
            grown = MARGIN * (high - low).max()
            self.region = np.concatenate([low - grown, high + grown])
            mesh = self._first_mesh(progress)
            if len(mesh.triangles) == 0:
                return None
            first, last = extent(mesh)
            at_low, at_high = first <= self.region[:3] + 0.01 * self.voxel, last >= self.region[3:] - 0.01 * self.voxel
            if not (at_low.any() or at_high.any()):
                small = 2 * (last - first).max() < self._longest()
                self._fit_region(mesh)
                return self._first_mesh(progress) if small else mesh
            size = high - low
            low, high = np.where(at_low, low - size, low), np.where(at_high, high + size, high)
        return None

    def _faces(self, progress):
        """Returns a mesh of the solid's exact faces if it has them and they are within the limit of triangles;
        otherwise None."""
        mesh = None if "bounds" in self.settings else self.source.faces(progress)
        if mesh is None or len(mesh.triangles) > self.most:
            return None
        self.extent = np.concatenate(extent(mesh))
        self.region, self.triangles, self.exact = self.extent, len(mesh.triangles), True
        self.voxel = self._wanted()
        return mesh

    def _first_mesh(self, progress):
        """Returns a mesh with few cells, or with smaller ones if the solid is too thin for these."""
        mesh = self._mesh(self._longest() / self.cells, progress)
        return mesh if len(mesh.triangles) else self._mesh(self._longest() / self.cells / 4, progress)

    def _mesh(self, cell, progress):
        self.voxel, began = cell, time.monotonic()
        mesh = self._meshed(tuple(self.region), cell, progress)
        self._seconds = time.monotonic() - began
        self.triangles = len(mesh.triangles)
        return mesh

    def _meshed(self, box, cell, progress):
        """Returns the mesh of a box. Features are slow to find, especially in cells larger than the solid's thickness,
        so they are searched only in fine cells. Without them cells are not merged, since merged cells would cut
        corners. Parts thinner than the cells appear only in the final mesh."""
        sharp = self.sharp and cell <= 1.01 * self._wanted()
        return kernel.load().mesh(self.field, bounds=box, voxel=cell, max_error=None if sharp else 0, features=sharp,
                                  depth=0, progress=progress)

    def _fit_region(self, mesh):
        """Fits the region to a mesh, unless it is given by the settings. Returns whether it grew."""
        if "bounds" in self.settings or len(mesh.triangles) == 0:
            return False
        before, (first, last) = self.region, extent(mesh)
        self.details, self.shown = {}, {}  # invalid, since the blocks have changed
        self.extent, self.region = (*first, *last), np.concatenate([first - self.voxel, last + self.voxel])
        return bool((self.region[:3] < before[:3] - self.voxel).any()
                    or (self.region[3:] > before[3:] + self.voxel).any())

    def _wanted(self):
        """Returns the edge of the final mesh's smallest cell, mm. Cached for each region, since the window needs it
        often."""
        region = tuple(self.region)
        if self._cell[0] != region:
            self._cell = (region, with_cell(self.field, **{"cells": kernel.load().default_cells, **self.settings,
                                                           "bounds": region})["voxel"])
        return self._cell[1]

    def _longest(self):
        return (self.region[3:] - self.region[:3]).max()

    # Blocks.
    def _grid(self):
        """Returns the number of blocks along x, y and z."""
        return np.clip(np.ceil((self.region[3:] - self.region[:3]) / (CELLS * self._wanted())), 1, BLOCKS).astype(int)

    def _blocks(self):
        return list(np.ndindex(*self._grid())) if self.voxel else []

    def _box(self, block, reach=0.0):
        """Returns the bounds (x0, y0, z0, x1, y1, z1) of a block, enlarged by `reach` into neighbouring blocks, so that
        no gaps are visible."""
        grid, place = self._grid(), np.array(block)
        size = (self.region[3:] - self.region[:3]) / grid
        lower = self.region[:3] + place * size
        return (*(lower - reach * (place > 0)), *(lower + size + reach * (place + 1 < grid)))

    def _distance(self, block, eye):
        box = np.array(self._box(block))
        return np.linalg.norm(np.clip(eye, box[:3], box[3:]) - eye)

    def _is_coarse(self, block, eye, cell):
        return cell > ANGLE * max(self._distance(block, eye), cell)

    def _of_block(self, block, cell, make, progress):
        """Joins the meshes that `make` makes of a block's box. Removes the triangles that close them at the borders to
        neighbouring blocks."""
        box, place, grid = self._box(block, cell), np.array(block), self._grid()
        vertices, triangles = joined(make(box))
        for axis in range(3):
            for side, goes_on in ((box[axis], place[axis] > 0), (box[axis + 3], place[axis] + 1 < grid[axis])):
                if goes_on:
                    at_side = np.abs(vertices[:, axis] - side) < 0.01 * cell
                    triangles = triangles[~at_side[triangles].all(axis=1)]
        return self._written(vertices, triangles, progress)

    def _picture(self, mesh, progress):
        return {"whole": self._written(mesh.vertices, mesh.triangles, progress)}

    def _written(self, vertices, triangles, progress):
        """Returns a mesh as several Inventor files."""
        return [self._piece(*compacted(vertices, triangles[first:first + PIECE]), progress)
                for first in range(0, len(triangles), PIECE)]

    def _piece(self, vertices, triangles, progress):
        if not progress(0, ""):
            raise work.Cancelled()
        if self.exact:
            return inventor.written(*inventor.creased(vertices, triangles))
        _, slopes = self.field.gradients(vertices)
        crease = inventor.CREASE if self.sharp else inventor.STEEP_CREASE
        return inventor.written(*inventor.corner_normals(vertices, triangles, slopes, crease))


def extent(mesh):
    """Returns the lower and the upper corner of a mesh's vertices."""
    return mesh.vertices.min(axis=0).astype(float), mesh.vertices.max(axis=0).astype(float)


def compacted(vertices, triangles):
    """Returns the used vertices, and the triangles with indices into these."""
    used, places = np.unique(triangles, return_inverse=True)
    return vertices[used], places.reshape(-1, 3).astype(np.int32)


def joined(meshes):
    """Returns vertices and triangles of several meshes as one mesh."""
    first = np.cumsum([0] + [len(mesh.vertices) for mesh in meshes])
    vertices = [np.empty((0, 3), np.float32)] + [mesh.vertices for mesh in meshes]
    triangles = [np.empty((0, 3), np.int32)] + [mesh.triangles.astype(np.int32) + n for mesh, n in zip(meshes, first)]
    return np.concatenate(vertices), np.concatenate(triangles)
