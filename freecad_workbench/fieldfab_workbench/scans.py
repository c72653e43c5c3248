"""CT volumes in files: how to read a file, and its solid at a threshold. Nothing here accesses a document."""

import dataclasses
import math
import os
import threading
import weakref

from . import kernel, work
from .sources import Source
from .words import marked, tr

SAMPLE_TYPES = (marked("as the file says"), "uint8", "int8", "uint16", "int16", "uint32", "int32", "float32", "float64")
DENOISING = marked(("none", "median", "gaussian", "anisotropic"))
FIELDS_KEPT = 2  # each may keep a whole volume in memory
OVERVIEW_SAMPLES = 300_000
SLAB_SAMPLES = 1 << 17  # samples of the coarse volume that are read at a time
BYTES_A_TRIANGLE = 120  # including its share of vertices, in the kernel and in FreeCAD


@dataclasses.dataclass(frozen=True)
class ScanFile:
    """A volume's file or folder of slices, and parameters for reading it. `spacing` in mm; None: as in the file."""

    path: str
    dims: tuple = None
    type: str = ""
    spacing: tuple = None
    series: str = ""

    def stamp(self):
        """Returns a text that identifies the content: size and modification time of a file, or of all files in a
        folder. Raises ValueError if it does not exist."""
        try:
            if os.path.isdir(self.path):
                with os.scandir(self.path) as entries:
                    seen = sorted((e.name, e.stat().st_size, e.stat().st_mtime_ns) for e in entries if e.is_file())
                return f"{len(seen)} {sum(size for _, size, _ in seen)} {max((time for *_, time in seen), default=0)}"
            seen = os.stat(self.path)
            return f"1 {seen.st_size} {seen.st_mtime_ns}"
        except OSError:
            raise ValueError(tr("the scan {path} is not there").format(path=self.path)) from None

    def open(self, progress=None):
        """Returns the fieldfab.Volume, shared with other users of the same file. Raises fieldfab.Error."""
        key = (self, self.stamp())
        with _lock:
            volume = _open.get(key)
        if volume is None:
            volume = kernel.load().Volume.open(self.path, dims=self.dims, type=self.type, spacing=self.spacing,
                                               series=self.series, progress=progress)
            with _lock:
                _open[key] = volume
        return volume


@dataclasses.dataclass(frozen=True)
class Cut:
    """The solid part of a volume. `threshold`: a density; None: halfway between the two most frequent ones. `crop`:
    first sample along x, y, z, then last, or None. Islands and holes smaller than these volumes, mm3, are removed; 0
    keeps all."""

    threshold: float = None
    below: bool = False
    crop: tuple = None
    denoise: str = ""
    keep_largest: bool = False
    smallest_island: float = 0
    smallest_hole: float = 0

    def cropped(self, volume):
        return volume.crop(self.crop[:3], self.crop[3:]) if self.crop else volume

    def cleaned(self):
        """Returns whether the whole volume must be in memory."""
        return bool(self.denoise or self.keep_largest or self.smallest_island or self.smallest_hole)

    def solid(self, volume, progress=None):
        """Returns the fieldfab.Field with the placement of the volume's file. Raises fieldfab.Error."""
        return self.cropped(volume).solid(
            self.threshold, below=self.below, denoise=self.denoise, keep_largest=self.keep_largest,
            min_island=self.smallest_island or None, min_hole=self.smallest_hole or None, progress=progress)


class ScanSource(Source):
    """The solid of a scan. Its mesh is not cached here, since the document stores it."""

    def __init__(self, file, cut):
        self.file, self.cut, self.stamp = file, cut, file.stamp()
        super().__init__(("scan", dataclasses.astuple(file), self.stamp, dataclasses.astuple(cut)), None)

    def field(self, progress=None):
        with _lock:
            for digest, field, _ in _fields:
                if digest == self.digest:
                    return field
        field, holder = self._made(progress)
        with _lock:
            _fields[:] = [(self.digest, field, holder), *_fields][:FIELDS_KEPT]
        return field

    def _made(self, progress):
        volume = self.file.open(progress)
        return self.cut.solid(volume, progress), volume

    def mesh(self, progress=None, cells=None, **settings):
        return self._meshed(progress, cells, settings)


class AsdfSource(ScanSource):
    """The solid of an .asdf file, which is a distance field already."""

    def _made(self, progress):
        return kernel.load().open(self.file.path), None


class Overview:
    """A volume reduced to a few samples, for interactive thresholds. `threshold`: the automatic threshold of these
    samples. Surfaces are in lattice coordinates: mm from the first sample along the lattice's axes."""

    def __init__(self, file, progress=None):
        import numpy as np  # imported late: the workbench must load quickly

        self.volume = file.open(progress)
        self.halvings, coarse = 0, self.volume
        while math.prod(coarse.size) > OVERVIEW_SAMPLES:
            self.halvings, coarse = self.halvings + 1, coarse.half()
        self._densities = _read(coarse, progress)
        plain = self._plain(self.volume.spacing)
        self.counts, self.edges = plain.histogram()
        self.darkest, self.brightest = np.percentile(self._densities, (0.5, 99.5))  # for pictures
        # The surface of a level set is at 0, but the plain array is no longer marked as one. In .vdb files, only level
        # sets have densities on both sides of 0.
        level_set = file.path.lower().endswith(".vdb") and self.edges[0] < 0 < self.edges[-1]
        self.threshold = 0.0 if level_set else plain.threshold("halfway")

    def _plain(self, spacing):
        return kernel.load().Volume(self._densities, spacing=[s * 2**self.halvings for s in spacing])

    def surface(self, cut, spacing=None, progress=None):
        """Returns the coarse mesh of a Cut, and the edge length of its cells in mm. The crop counts samples of the
        whole volume."""
        spacing = spacing or self.volume.spacing
        step, plain = 2**self.halvings, self._plain(spacing)
        cut = dataclasses.replace(cut, threshold=self.threshold if cut.threshold is None else cut.threshold)
        if cut.crop:
            first = [n // step for n in cut.crop[:3]]
            last = [min(max(-(-n // step), a + 1), size - 1) for n, a, size in zip(cut.crop[3:], first, plain.size)]
            cut = dataclasses.replace(cut, crop=(*first, *last))
        cell = math.prod(plain.spacing) ** (1 / 3)
        return kernel.load().mesh(cut.solid(plain, progress), voxel=cell, features=False, progress=progress), cell


def layer(volume, axis, place):
    """Returns the densities on the plane across one of a volume's axes at a place, counted in samples (a fraction is
    interpolated): an array of rows along the later one of the other two axes. None beyond the samples. Reads two
    slices."""
    import numpy as np

    size = volume.size
    if not 0 <= place <= size[axis] - 1:
        return None
    first, last = [0, 0, 0], [count - 1 for count in size]
    first[axis] = min(int(place), size[axis] - 2)
    last[axis] = first[axis] + 1
    lower, upper = np.moveaxis(volume.crop(tuple(first), tuple(last)).densities(), 2 - axis, 0)
    return lower + (upper - lower) * np.float32(place - first[axis])


def _read(volume, progress):
    """Returns all densities. Reads some slices at a time, so that it can be cancelled."""
    import numpy as np  # imported late: the workbench must load quickly

    across, along, deep = volume.size
    layers, step = [], max(1, SLAB_SAMPLES // (across * along))
    for first in range(0, deep, step):
        last = min(first + step, deep) - 1
        layers.append(volume.crop((0, 0, first), (across - 1, along - 1, last)).densities())
        if progress is not None and progress(first / deep, "reading") is False:
            raise work.Cancelled()
    return np.concatenate(layers)


def estimate(samples, cleaned, triangles, finer):
    """Returns estimates of (bytes of memory, triangles) of a solid from the triangles of its overview, whose cells are
    `finer` times larger."""
    triangles = round(triangles * finer**2)
    return samples * (14 if cleaned else 4) + triangles * BYTES_A_TRIANGLE, triangles


_lock = threading.Lock()
_open, _fields = weakref.WeakValueDictionary(), []  # volumes in use; (digest, field, its volume), newest first
