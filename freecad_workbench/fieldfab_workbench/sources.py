"""Sources of solids: a key that identifies the solid, and a function that makes its Field. Fields and meshes are
cached, so that panels, recomputes and dependent solids share them."""

import hashlib
import math
import threading
import time
from collections import OrderedDict

from . import kernel

KEPT, KEPT_BYTES = 64, 400_000_000
DISTANCES_BYTES = 17_000_000  # estimate for a lattice of 160 points a side


class Source:
    """Source of a solid. `key`: plain values that determine the Field. `make(progress)`: makes the Field on any thread;
    it must not access the document."""

    def __init__(self, key, make):
        self.digest = hashlib.sha1(repr(key).encode()).hexdigest()
        self._make = make
        self.faces_took = None  # seconds to make the faces; None before that

    def field(self, progress=None):
        """Returns the Field. Raises fieldfab.Error."""
        return kept(("field", self.digest), lambda: self._make(progress))

    def distances(self, reach, progress=None):
        """Returns a Field whose values are distances up to `reach` mm from the surface, for offsets, shells, blends and
        morphs. A sampled Field, such as a scan's, has distances only near its surface and gets a new Field. Other
        Fields are returned unchanged. Raises fieldfab.Error."""
        field = self.field(progress)
        if not field.sampled:
            return field
        enough = 2.0 ** (math.floor(math.log2(reach)) + 1)  # a slider seldom requires new distances
        return kept(("distances", self.digest, enough), lambda: field.distances(enough, progress=progress))

    def faces(self, progress=None):
        """Returns the mesh of the solid's exact faces, or None if it has none (only OpenSCAD solids have). Raises
        fieldfab.Error."""

        def make():
            field, began = self.field(progress), time.monotonic()
            faces = field.faces(progress)
            self.faces_took = time.monotonic() - began
            return faces

        return kept(("faces", self.digest), make)

    def mesh(self, progress=None, cells=None, **settings):
        """Returns the mesh of the solid's faces. Without faces, or with given bounds, returns a contour with these
        settings of fieldfab.mesh(). Without a cell size in the settings, the contour has `cells` cells along the
        longest side of the bounds."""
        faces = None if "bounds" in settings else self.faces(progress)
        if faces is not None:
            return faces
        key = ("mesh", self.digest, cells, *sorted(settings.items()))
        return kept(key, lambda: self._meshed(progress, cells, settings))

    def _meshed(self, progress, cells, settings):
        field = self.field(progress)
        return kernel.load().mesh(field, progress=progress, exact=False, **with_cell(field, cells=cells, **settings))

    def moved(self, placement):
        """Returns the Source of the solid transformed by a FreeCAD placement."""
        if placement.isIdentity():
            return self
        axis, angle, base = tuple(placement.Rotation.Axis), placement.Rotation.Angle, tuple(placement.Base)
        return Source(("moved", self.digest, axis, angle, base),
                      lambda progress: self.field(progress).rotate(axis, angle).translate(*base))


def with_cell(field, cells=None, **settings):
    """Returns settings of fieldfab.mesh() and similar functions. Without a voxel in them, computes it from the number
    `cells`. Raises fieldfab.Error."""
    if cells and "voxel" not in settings:
        settings["voxel"] = field.default_voxel(settings.get("bounds"), cells)
    return settings


_store, _lock = OrderedDict(), threading.Lock()


def kept(key, make):
    with _lock:
        if key in _store:
            _store.move_to_end(key)
            return _store[key]
    made = make()
    with _lock:
        _store[key] = made
        while len(_store) > KEPT or (len(_store) > 1 and sum(_size(*item) for item in _store.items()) > KEPT_BYTES):
            _store.popitem(last=False)
    return made


def _size(key, made):
    """Returns the bytes of a mesh or of distances; 0 for other Fields."""
    return (made.vertices.nbytes + made.triangles.nbytes if hasattr(made, "triangles") else DISTANCES_BYTES
            if key[0] == "distances" else 0)
