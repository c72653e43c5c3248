"""Arrows on the faces of a scan's crop."""

import FreeCAD

from ..views.handles import Handle, Handles


def handles_of(panel):
    """Returns the Handles of an opened scan's crop."""
    volume, place = panel.overview.volume, panel.obj.getGlobalPlacement()
    axes, corner = [FreeCAD.Vector(*axis) for axis in volume.axes], FreeCAD.Vector(*volume.origin)
    spacing = panel.spacing_asked() or volume.spacing

    def middle_of_face(face):
        """Returns the middle of the crop's face with a coordinate of 0 across it."""
        sums = [panel.crop[axis].value() + panel.crop[axis + 3].value() for axis in range(3)]
        sums[face % 3] = 0
        return place.multVec(sum((axis * (0.5 * n * step) for axis, n, step in zip(axes, sums, spacing)), corner))

    def handle(face):
        axis, out, box = face % 3, 1 if face > 2 else -1, panel.crop[face]

        def write(value):
            sample, other = round(out * value / spacing[axis]), panel.crop[(face + 3) % 6].value()
            box.setValue(max(sample, other + 1) if face > 2 else min(sample, other - 1))

        return Handle(lambda: middle_of_face(face), place.Rotation.multVec(axes[axis]) * out,
                      lambda: out * box.value() * spacing[axis], write)

    size = [(n - 1) * step for n, step in zip(volume.size, spacing)]
    return Handles(panel.document, [handle(face) for face in range(6)], FreeCAD.Vector(*size).Length)
