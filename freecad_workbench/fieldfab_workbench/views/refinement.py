"""Meshes of a solid for looking at: coarse within a moment, then finer, then finest where the eye is. Nothing here needs a window."""

import numpy as np

from .. import kernel
from . import inventor

ANGLE = 0.004  # radians that a cell may fill in the eye: about three pixels
CELLS = 32  # along each side of a block, which is refined by itself
BLOCKS = 4  # most blocks along an axis
MARGIN = 1 / 8  # of a solid's size: how much it may grow before its bounds are looked for again


class Refinement:
    """One solid on its way from coarse to fine; one thread at a time may use it. What it yields is {block: bytes of a binary Inventor file}, where a
    block is its place (i, j, k) in a grid over the solid; a yield with all blocks stands for the whole solid. Its methods raise fieldfab.Error."""

    def __init__(self, source, settings, guess=None, cells=20, most=100_000):
        """`settings`: of fieldfab.mesh(), as the solid will be made. `guess`: bounds that it may have, (x0, y0, z0, x1, y1, z1), mm. `cells`: of the
        first mesh, along its longest side. `most`: triangles that can be shown."""
        self.source, self.settings, self.guess, self.cells, self.most = source, settings, guess, cells, most
        self.region, self.voxel, self.triangles = None, None, 0  # of the mesh that was made last
        self.extent = guess  # of the solid, as far as it is known
        self.details, self.shown = {}, {}  # of each block: its DetailMesh, and how many triangles of that are shown

    # The whole solid.
    def coarse(self, progress):
        """The first mesh, within the guess where that holds the solid: a search for its bounds would take longer than the mesh."""
        mesh = self._in_the_guess(progress) if self.guess and "bounds" not in self.settings else None
        if mesh is None:
            self.region = self._bounds(progress)
            mesh = self._mesh(self._longest() / self.cells, progress)
            if len(mesh.triangles) == 0:  # thinner than the cells
                mesh = self._mesh(self._longest() / self.cells / 4, progress)
        blocks = self._blocks(mesh, (1, 1, 1))
        self._fit_region(mesh)
        return blocks

    def finer(self, progress):
        """Yields meshes of smaller and smaller cells, down to the solid's own or to as many triangles as can be shown."""
        wanted = self.settings.get("voxel") or self._longest() / 128
        while self.voxel > wanted and self.triangles < 0.6 * self.most:
            step = min(2, (self.most / max(self.triangles, 1)) ** 0.5)
            mesh = self._mesh(max(self.voxel / step, wanted), progress)
            yield self._blocks(mesh, self.grid())

    def final(self, progress):
        """Makes the solid's own mesh, which its source keeps, and yields it, or as much of its detail as can be shown."""
        mesh = self.source.mesh(progress, **self.settings)
        if len(mesh.triangles) <= self.most:
            yield self._blocks(mesh, self.grid())
        elif self._fit_region(mesh):  # the guess was too small: parts of the solid were not seen
            self.voxel, self.triangles = self._longest() / self.cells, 0
            yield from self.finer(progress)

    # Where the eye is (Keeter, 4.3.3).
    def is_coarse_for(self, eye):
        return self.voxel is not None and any(self._is_coarse(block, eye) for block in self._all_blocks())

    def detail(self, eye, progress):
        """Yields {block: bytes}, the nearest blocks first, until cells are small enough for the eye or there are as many triangles as can be shown. Blocks are as fine as the whole to
        begin with: sharp edges of a solid that is thinner than its cells would take long to find."""
        fieldfab = kernel.load()
        for block in sorted((b for b in self._all_blocks() if self._is_coarse(b, eye)), key=lambda b: self._distance(b, eye)):
            if block not in self.details:
                lower, upper = self._box(block, self.voxel)
                self.details[block] = fieldfab.DetailMesh(self.field, (*lower, *upper), cells=CELLS, deepest=6, angle=ANGLE, most_triangles=self.most)
            more = True
            while more and sum(self.shown.values()) < self.most:
                more = self.details[block].refine(eye, progress)
                parts = self.details[block].parts(eye)
                self.shown[block] = sum(len(part.triangles) for _, _, part in parts)
                meshes = [(part.vertices, part.triangles) for _, _, part in parts]
                yield {block: b"".join(self._written(*one) for one in joined(meshes))}

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
            mesh = self._mesh(self._longest() / self.cells, progress)
            if len(mesh.triangles) == 0:
                return None
            first, last = extent(mesh)
            at_low, at_high = first <= self.region[:3] + 0.01 * self.voxel, last >= self.region[3:] - 0.01 * self.voxel
            if not (at_low.any() or at_high.any()):
                small = 2 * (last - first).max() < self._longest()
                self._fit_region(mesh)
                return self._mesh(self._longest() / self.cells, progress) if small else mesh
            size = high - low
            low, high = np.where(at_low, low - size, low), np.where(at_high, high + size, high)
        return None

    def _mesh(self, cell, progress):
        mesh = kernel.load().mesh(self.field, bounds=tuple(self.region), voxel=cell, features=False, progress=progress)
        self.voxel, self.triangles = cell, len(mesh.triangles)
        return mesh

    def _fit_region(self, mesh):
        """Fits the region to a mesh, unless it is given; True where it became larger."""
        if "bounds" in self.settings or len(mesh.triangles) == 0:
            return False
        before, (first, last) = self.region, extent(mesh)
        self.extent, self.region = (*first, *last), np.concatenate([first - self.voxel, last + self.voxel])
        return bool((self.region[:3] < before[:3] - self.voxel).any() or (self.region[3:] > before[3:] + self.voxel).any())

    def _longest(self):
        return (self.region[3:] - self.region[:3]).max()

    # Blocks.
    def grid(self):
        """How many blocks there are along x, y and z."""
        return tuple(int(n) for n in np.clip(np.ceil((self.region[3:] - self.region[:3]) / (CELLS * self.voxel)), 1, BLOCKS))

    def _all_blocks(self):
        return [tuple(int(n) for n in block) for block in np.ndindex(*self.grid())]

    def _box(self, block, margin=0.0):
        size = (self.region[3:] - self.region[:3]) / self.grid()
        lower = self.region[:3] + np.array(block) * size
        return lower - margin, lower + size + margin

    def _distance(self, block, eye):
        lower, upper = self._box(block)
        return np.linalg.norm(np.clip(eye, lower, upper) - eye)

    def _is_coarse(self, block, eye):
        return self.voxel > ANGLE * max(self._distance(block, eye), self.voxel)

    def _blocks(self, mesh, grid):
        """The mesh divided among blocks: each triangle is where its first corner is."""
        size = (self.region[3:] - self.region[:3]) / grid
        vertices, triangles = mesh.vertices, mesh.triangles
        if np.prod(grid) == 1:
            return {(0, 0, 0): self._written(vertices, triangles)} if len(triangles) else {}
        places = np.clip(((vertices[triangles[:, 0]] - self.region[:3]) / size).astype(int), 0, np.array(grid) - 1)
        order, numbers = np.lexsort(places.T[::-1]), np.ravel_multi_index(places.T, grid)
        parts = np.split(order, np.nonzero(np.diff(numbers[order]))[0] + 1)
        return {tuple(int(n) for n in places[part[0]]): self._written(*compacted(vertices, triangles[part])) for part in parts if len(part)}

    def _written(self, vertices, triangles):
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
    """Meshes of few triangles as one; [] where there are none at all."""
    meshes = [mesh for mesh in meshes if len(mesh[1])]
    if not meshes:
        return []
    first = np.cumsum([0] + [len(vertices) for vertices, _ in meshes[:-1]])
    return [(np.concatenate([v for v, _ in meshes]), np.concatenate([t.astype(np.int32) + n for (_, t), n in zip(meshes, first)]))]
