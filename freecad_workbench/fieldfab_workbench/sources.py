"""Sources of solids: a key that tells one from another, and how to make its Field. Fields and meshes are kept for a
while, so that a panel, a recompute and the solids built on this one share them."""

import hashlib
import math
import threading
import time
from collections import OrderedDict

from . import kernel

KEPT, KEPT_BYTES = 64, 400_000_000
DISTANCES_BYTES = 17_000_000  # of those on a lattice of 160 places a side


class Source:
    """Source of a solid. `key`: plain values that say all that the Field depends on. `make(progress)`: makes the Field,
    on any thread; it must not look at the document."""

    def __init__(self, key, make):
        self.digest = hashlib.sha1(repr(key).encode()).hexdigest()
        self._make = make
        self.faces_took = None  # seconds, where they were made here

    def field(self, progress=None):
        """The Field. Raises fieldfab.Error."""
        return kept(("field", self.digest), lambda: self._make(progress))

    def distances(self, reach, progress=None):
        """The Field for offsets, shells, blends and morphs that look so many mm beyond the surface. The values of a
        scan are distances only next to its surface: it gets a Field with distances. Others return the Field itself.
        Raises fieldfab.Error."""
        field = self.field(progress)
        if not field.sampled:
            return field
        enough = 2.0 ** (math.floor(math.log2(reach)) + 1)  # so that moving a slider seldom asks for others
        return kept(("distances", self.digest, enough), lambda: field.distances(enough, progress=progress))

    def faces(self, progress=None):
        """Mesh of the solid's own faces, if it is one of OpenSCAD's and its faces can be had; else None. Raises
        fieldfab.Error."""

        def make():
            field, began = self.field(progress), time.monotonic()
            faces = field.faces(progress)
            self.faces_took = time.monotonic() - began
            return faces

        return kept(("faces", self.digest), make)

    def mesh(self, progress=None, cells=None, **settings):
        """Mesh of its faces. Without faces, or where bounds are given, a contour with these settings of
        fieldfab.mesh(). Where no setting gives the size of cells there are `cells` of them along the longest side of
        the bounds."""
        faces = None if "bounds" in settings else self.faces(progress)
        if faces is not None:
            return faces
        key = ("mesh", self.digest, cells, *sorted(settings.items()))
        return kept(key, lambda: self._meshed(progress, cells, settings))

    def _meshed(self, progress, cells, settings):
        field = self.field(progress)
        return kernel.load().mesh(field, progress=progress, exact=False, **with_cell(field, cells=cells, **settings))

    def moved(self, placement):
        """The solid where a FreeCAD placement puts it."""
        if placement.isIdentity():
            return self
        axis, angle, base = tuple(placement.Rotation.Axis), placement.Rotation.Angle, tuple(placement.Base)
        return Source(("moved", self.digest, axis, angle, base),
                      lambda progress: self.field(progress).rotate(axis, angle).translate(*base))


def with_cell(field, cells=None, **settings):
    """Settings of fieldfab.mesh() and the like, with the edge of the smallest cell where only a number of `cells` is
    asked for. Raises fieldfab.Error."""
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
    """Bytes of a mesh or of distances; other Fields are taken for small."""
    return (made.vertices.nbytes + made.triangles.nbytes if hasattr(made, "triangles") else DISTANCES_BYTES
            if key[0] == "distances" else 0)
