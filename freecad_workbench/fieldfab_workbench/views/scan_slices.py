"""Densities of scans on a section plane."""

import FreeCAD
import numpy as np
from pivy import coin

from .. import kernel, scans, work
from ..objects.scan import Scan
from . import inventor

PARALLEL = 0.99999  # least cosine between the plane's normal and an axis of the scan's samples
MOST = 400  # samples along a side of a picture
SOLID_COLOUR = (0.96, 0.66, 0.28)  # as other cut faces have it


class ScanSlices:
    """Pictures of the visible scans of a document on a plane: grey outside of the solid, tinted inside. `root`: their
    node. Scans that lie obliquely to the plane have none."""

    def __init__(self, document):
        self._document, self.root = document, coin.SoSeparator()
        light, pick = coin.SoLightModel(), coin.SoPickStyle()
        light.model, pick.style = coin.SoLightModel.BASE_COLOR, coin.SoPickStyle.UNPICKABLE
        self._pictures = coin.SoGroup()
        for node in (light, pick, self._pictures):
            self.root.addChild(node)
        self._overviews = {}  # {(scans.ScanFile, its stamp): work.Task that makes the scans.Overview}
        self.shown = None  # what the pictures were made of

    def show(self, normal, at):
        """Shows the pictures for a plane; those that are still being prepared come with a later call."""
        wanted = []
        for obj in self._document.Objects:
            if not isinstance(getattr(obj, "Proxy", None), Scan) or not obj.ViewObject.Visibility:
                continue
            try:
                task = self._overview(obj.Proxy.file(obj))
            except ValueError:  # it has no file now
                continue
            if not task.is_alive() and task.error is None:
                wanted.append((obj, task.result))
        shown = (tuple(normal), tuple(at), [(obj.Name, obj.Placement.toMatrix().A, obj.Threshold, obj.AutoThreshold,
                                             obj.Below) for obj, _ in wanted])
        if shown != self.shown:
            self.shown = shown
            self._pictures.removeAllChildren()
            for obj, overview in wanted:
                if picture := _picture(obj, overview, normal, at):
                    self._pictures.addChild(picture)

    def _overview(self, file):
        if file.path.lower().endswith(".asdf"):
            raise ValueError("distances are no densities")
        key = (file, file.stamp())
        if key not in self._overviews:
            self._overviews[key] = work.Task(lambda progress: scans.Overview(file, progress))
            self._overviews[key].start()
        return self._overviews[key]

    def close(self):
        for task in self._overviews.values():
            task.cancel()


def _picture(obj, overview, normal, at):
    """Returns the node of a scan's picture, or None if the plane does not meet it along its samples."""
    volume, place = overview.volume, obj.getGlobalPlacement()
    axes = [FreeCAD.Vector(*axis) for axis in volume.axes]
    along = [abs(place.Rotation.multVec(axis) * normal) for axis in axes]
    axis = max(range(3), key=lambda i: along[i])
    if along[axis] < PARALLEL:
        return None
    origin = FreeCAD.Vector(*volume.origin)
    index = ((place.inverse().multVec(at) - origin) * axes[axis]) / volume.spacing[axis]
    try:
        densities = scans.layer(volume, axis, index)
    except kernel.load().Error:  # the file is gone meanwhile
        return None
    if densities is None:
        return None
    across, up = (i for i in range(3) if i != axis)
    step = max(1, -(-max(densities.shape) // MOST))
    densities = densities[::step, ::step]
    rows, columns = densities.shape

    def way(i, samples):
        """Returns the vector along an axis of the lattice, in the document's coordinates."""
        return np.array(place.Rotation.multVec(axes[i] * (samples * volume.spacing[i])))

    start = np.array(place.multVec(origin)) + way(axis, index)
    points = (start + np.arange(columns)[None, :, None] * way(across, step)
              + np.arange(rows)[:, None, None] * way(up, step))
    level = overview.threshold if obj.AutoThreshold else obj.Threshold
    return _coloured(points, _colours(densities, overview, level, obj.Below))


def _colours(densities, overview, level, below):
    """Returns rows of red, green, blue as bytes."""
    span = max(overview.brightest - overview.darkest, 1e-30)
    grey = np.clip((densities - overview.darkest) / span, 0, 1)[..., None]
    solid = (densities < level if below else densities > level)[..., None]
    tinted = np.array(SOLID_COLOUR) * (0.45 + 0.55 * grey)
    return np.rint(255 * np.where(solid, tinted, 0.85 * grey)).astype(np.uint8)


def _coloured(points, colours):
    """Returns the node of a grid of points with colours in between."""
    root, binding, grid = coin.SoSeparator(), coin.SoMaterialBinding(), coin.SoQuadMesh()
    rows, columns = colours.shape[:2]
    packed = (colours.astype(">u4") << np.array([24, 16, 8])).sum(axis=-1) + 255
    binding.value = coin.SoMaterialBinding.PER_VERTEX
    grid.verticesPerRow, grid.verticesPerColumn = columns, rows
    arrays = (inventor.node_bytes("PackedColor", "orderedRGBA", packed.size, packed.astype(">u4")),
              inventor.node_bytes("Coordinate3", "point", rows * columns, points.astype(">f4")))
    for node in (*map(inventor.read_node, arrays), binding, grid):
        root.addChild(node)
    return root
