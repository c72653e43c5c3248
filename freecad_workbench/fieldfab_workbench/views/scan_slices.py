"""Densities of scans on a section plane."""

import FreeCAD
import numpy as np
from pivy import coin

from .. import kernel, scans, work
from ..objects.scan import Scan

PARALLEL = 0.99999  # least cosine between the plane's normal and an axis of the scan's samples
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
        """Shows the pictures for a plane. Returns False if some are still being prepared."""
        wanted, ready = [], True
        for obj in self._document.Objects:
            if not isinstance(getattr(obj, "Proxy", None), Scan) or not obj.ViewObject.Visibility:
                continue
            try:
                task = self._overview(obj.Proxy.file(obj))
            except ValueError:  # it has no file now
                continue
            ready = ready and not task.is_alive()
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
        return ready

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
    corners = []
    for j, k in ((0, 0), (1, 0), (1, 1), (0, 1)):
        samples = {axis: index, across: -0.5 + j * volume.size[across], up: -0.5 + k * volume.size[up]}
        point = origin + sum((axes[i] * (samples[i] * volume.spacing[i]) for i in range(3)), FreeCAD.Vector())
        corners.append(tuple(place.multVec(point)))
    level = overview.threshold if obj.AutoThreshold else obj.Threshold
    return _textured(corners, _colours(densities, overview, level, obj.Below))


def _colours(densities, overview, level, below):
    """Returns rows of red, green, blue as bytes."""
    span = max(overview.brightest - overview.darkest, 1e-30)
    grey = np.clip((densities - overview.darkest) / span, 0, 1)[..., None]
    solid = (densities < level if below else densities > level)[..., None]
    tinted = np.array(SOLID_COLOUR) * (0.45 + 0.55 * grey)
    return np.rint(255 * np.where(solid, tinted, 0.85 * grey)).astype(np.uint8)


def _textured(corners, colours):
    """Returns a rectangle with a picture; its first corner is that of the first pixel, and columns go to the second."""
    root, texture, points, places, face = (coin.SoSeparator(), coin.SoTexture2(), coin.SoCoordinate3(),
                                           coin.SoTextureCoordinate2(), coin.SoFaceSet())
    rows, columns = colours.shape[:2]
    texture.image.setValue(coin.SbVec2s(columns, rows), 3, colours.tobytes())
    texture.model = coin.SoTexture2.DECAL
    texture.wrapS = texture.wrapT = coin.SoTexture2.CLAMP
    points.point.setValues(0, 4, corners)
    places.point.setValues(0, 4, [(0, 0), (1, 0), (1, 1), (0, 1)])
    face.numVertices = 4
    for node in (texture, places, points, face):
        root.addChild(node)
    return root
