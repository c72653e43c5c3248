"""Meshes of a solid for viewing: coarse within a moment, then finer, then finest where the eye is. Nothing here needs a
window."""

import numpy as np

from .. import kernel, work
from ..certainty import doubt_of
from ..sources import with_cell
from . import inventor

ANGLE = 0.004  # radians that a cell may fill in the eye: about three pixels
CELLS = 32  # along each side of a block, which is refined by itself
BLOCKS = 4  # most blocks along an axis
# How many times the triangles of a whole solid may be made where the eye is: most of them are then out of the picture.
NEAR = 4
PIECE = 10_000  # triangles of a piece
MARGIN = 1 / 8  # of a solid's size: how much it may grow before its bounds are looked for again


class Refinement:
    """Refines one solid from coarse to fine; one thread at a time may use it. Pictures are {piece: [bytes of a binary
    Inventor file, ...]}; no piece takes long to be added to the scene. Methods raise fieldfab.Error and
    work.Cancelled."""

    def __init__(self, source, settings, guess=None, cells=20, most=100_000, faces_first=False):
        """`settings`: those of source.mesh(), as the solid will be made. `guess`: bounds that the solid may have, (x0,
        y0, z0, x1, y1, z1), mm. `cells`: those of the first mesh, along its longest side. `most`: how many triangles
        can be shown. `faces_first`: whether the solid's own faces, where it has them, are made first."""
        self.source, self.settings, self.guess, self.cells, self.most, self.faces_first = (
            source, settings, guess, cells, most, faces_first)
        self.region, self.voxel, self.triangles = None, None, 0  # of the mesh that was made last
        self._cell = None, None  # a region, and the smallest cell in it
        self.extent = guess  # of the solid, as far as it is known
        # Whether the solid's own mesh has been made: then sharp edges are soon found in its blocks, too.
        self.sharp = False
        self.doubt = ""  # where the solid's own mesh may lack parts, once it has been made
        self.exact = False  # whether the solid's own faces are there, and nothing finer can be had
        self.in_blocks = False  # whether the last picture was one of blocks
        self.details, self.shown = {}, {}  # of each block: its DetailMesh, and how many triangles of that are shown

    # The whole solid.
    def coarse(self, progress):
        """The first mesh, within the guess where the guess contains the solid: a search for its bounds would take
        longer than the mesh."""
        if self.faces_first and (mesh := self._faces(progress)) is not None:
            return self._picture(mesh, progress)
        mesh = self._in_the_guess(progress) if self.guess and "bounds" not in self.settings else None
        if mesh is None:
            self.region = self._bounds(progress)
            mesh = self._first_mesh(progress)
        self._fit_region(mesh)
        return self._picture(mesh, progress)

    def finer(self, progress):
        """Yields meshes of smaller and smaller cells, down to the solid's own cells or to as many triangles as can be
        shown; none where final() has its faces."""
        if self._faces(progress) is not None:
            return
        wanted = self._wanted()
        while self.voxel > wanted and self.triangles < 0.6 * self.most:
            step = min(2, (self.most / max(self.triangles, 1)) ** 0.5)
            mesh = self._mesh(max(self.voxel / step, wanted), progress)
            yield self._picture(mesh, progress)

    def final(self, progress):
        """Makes the solid's own mesh, which its source keeps. Yields the mesh, or as much of its detail as can be
        shown."""
        mesh = self._faces(progress)
        if mesh is None:
            mesh = self.source.mesh(progress, **self.settings)
        blocks_are_shown = self.in_blocks
        self.sharp, self.in_blocks, self.doubt = True, False, doubt_of(mesh)
        if len(mesh.triangles) <= self.most:
            self.voxel, self.triangles = self._wanted(), len(mesh.triangles)
            yield self._picture(mesh, progress)
        # Parts outside of the guess were not seen, or blocks have to be replaced.
        elif self._fit_region(mesh) or blocks_are_shown:
            self.voxel, self.triangles = self._longest() / self.cells, 0
            yield from self.finer(progress)

    # Where the eye is (Keeter, 4.3.3).
    def is_coarse_for(self, eye):
        return not self.exact and any(self._is_coarse(block, eye, self.voxel) for block in self._blocks())

    def suffices(self, mesh, eye):
        """Whether the solid's own mesh can be shown, and is fine enough for the eye."""
        return (len(mesh.triangles) <= self.most
                and not any(self._is_coarse(block, eye, self._wanted()) for block in self._blocks()))

    def divided(self, progress):
        """The solid as fine as it is shown, in blocks (i, j, k), each of which can be replaced by a finer one."""
        self.in_blocks, self.shown = True, {}
        return {block: self._of_block(block, self.voxel, lambda box: [self._meshed(box, self.voxel, progress)],
                                      progress) for block in self._blocks()}

    def detail(self, eye, progress):
        """Yields {block: [bytes, ...]}, the nearest blocks first, until cells are small enough for the eye or there are
        as many triangles as can be shown. Blocks begin about as fine as the solid's own mesh: in coarser cells, sharp
        edges of a solid that is thinner than the cells would take long to find."""
        cell, near = (self._wanted(), sorted((b for b in self._blocks() if self._is_coarse(b, eye, self.voxel)),
                                             key=lambda b: self._distance(b, eye)))
        for block in list(self.shown):  # what another eye wanted may be finer than this one needs
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

    # Steps of these.
    @property
    def field(self):
        return self.source.field()

    def _bounds(self, progress):
        if "bounds" in self.settings:
            return np.array(self.settings["bounds"], float)
        found = self.source.field(progress).bounds()
        if found is None:  # the mesher says what is wrong with it
            kernel.load().mesh(self.field, voxel=1e3, progress=progress)
        return np.array(found, float)

    def _in_the_guess(self, progress):
        """A mesh in the guess, or where that cuts the solid, in larger boxes; None where it does not help."""
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
        """A mesh of the solid's own faces, where it has them, and as few as can be shown; else None."""
        mesh = None if "bounds" in self.settings else self.source.faces(progress)
        if mesh is None or len(mesh.triangles) > self.most:
            return None
        self.extent = np.concatenate(extent(mesh))
        self.region, self.triangles, self.exact = self.extent, len(mesh.triangles), True
        self.voxel = self._wanted()
        return mesh

    def _first_mesh(self, progress):
        """Of few cells; of more, where a solid is thinner than these."""
        mesh = self._mesh(self._longest() / self.cells, progress)
        return mesh if len(mesh.triangles) else self._mesh(self._longest() / self.cells / 4, progress)

    def _mesh(self, cell, progress):
        self.voxel = cell
        mesh = self._meshed(tuple(self.region), cell, progress)
        self.triangles = len(mesh.triangles)
        return mesh

    def _meshed(self, box, cell, progress):
        """Mesh of a box. Sharp edges take long, and very long in cells larger than the solid is thick. Without sharp
        edges all cells are kept, since merged cells would cut corners. Parts thinner than the cells wait for the
        solid's own mesh."""
        sharp = self.sharp and cell <= 1.01 * self._wanted()
        return kernel.load().mesh(self.field, bounds=box, voxel=cell, max_error=None if sharp else 0, features=sharp,
                                  depth=0, progress=progress)

    def _fit_region(self, mesh):
        """Fits the region to a mesh, unless it is given; True where it became larger."""
        if "bounds" in self.settings or len(mesh.triangles) == 0:
            return False
        before, (first, last) = self.region, extent(mesh)
        self.details, self.shown = {}, {}  # their blocks are no longer these
        self.extent, self.region = (*first, *last), np.concatenate([first - self.voxel, last + self.voxel])
        return bool((self.region[:3] < before[:3] - self.voxel).any()
                    or (self.region[3:] > before[3:] + self.voxel).any())

    def _wanted(self):
        """Edge of the smallest cell of the solid's own mesh, mm. The window asks often: it is computed once for each
        region."""
        region = tuple(self.region)
        if self._cell[0] != region:
            self._cell = (region, with_cell(self.field, **{"cells": kernel.load().default_cells, **self.settings,
                                                           "bounds": region})["voxel"])
        return self._cell[1]

    def _longest(self):
        return (self.region[3:] - self.region[:3]).max()

    # Blocks.
    def _grid(self):
        """How many blocks there are along x, y and z."""
        return np.clip(np.ceil((self.region[3:] - self.region[:3]) / (CELLS * self._wanted())), 1, BLOCKS).astype(int)

    def _blocks(self):
        return list(np.ndindex(*self._grid())) if self.voxel else []

    def _box(self, block, reach=0.0):
        """Bounds (x0, y0, z0, x1, y1, z1) of a block. Inside the solid it may reach into its neighbours, so that no gap
        shows."""
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
        """Joins the meshes that `make` makes of a block's box, without the triangles that close them where the block
        ends and the solid goes on."""
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
        """A mesh as several Inventor files."""
        return [self._piece(*compacted(vertices, triangles[first:first + PIECE]), progress)
                for first in range(0, len(triangles), PIECE)]

    def _piece(self, vertices, triangles, progress):
        if not progress(0, ""):
            raise work.Cancelled()
        if self.exact:
            return inventor.written(*inventor.creased(vertices, triangles))
        _, slopes = self.field.gradients(vertices)
        return inventor.written(*inventor.corner_normals(vertices, triangles, slopes))


def extent(mesh):
    """The lower and the upper corner of its vertices."""
    return mesh.vertices.min(axis=0).astype(float), mesh.vertices.max(axis=0).astype(float)


def compacted(vertices, triangles):
    """These triangles with only the vertices that they have."""
    used, places = np.unique(triangles, return_inverse=True)
    return vertices[used], places.reshape(-1, 3).astype(np.int32)


def joined(meshes):
    """Vertices and triangles of several meshes as one."""
    first = np.cumsum([0] + [len(mesh.vertices) for mesh in meshes])
    vertices = [np.empty((0, 3), np.float32)] + [mesh.vertices for mesh in meshes]
    triangles = [np.empty((0, 3), np.int32)] + [mesh.triangles.astype(np.int32) + n for mesh, n in zip(meshes, first)]
    return np.concatenate(vertices), np.concatenate(triangles)
