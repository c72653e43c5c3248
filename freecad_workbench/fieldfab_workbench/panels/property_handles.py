"""Which numbers of a property panel have an arrow in the 3D view, and where."""

import FreeCAD

from ..views.handles import Handle, Handles

UP = FreeCAD.Vector(0, 0, 1)
AXES = (FreeCAD.Vector(1, 0, 0), FreeCAD.Vector(0, 1, 0), UP)
COLOURS = ((0.85, 0.15, 0.15), (0.1, 0.65, 0.2), (0.15, 0.35, 0.95))  # of axes
LENGTHS = {"Distance": 1, "Wall": -1}  # from the top of the source, upwards or downwards
POINTS = {"Centre": lambda box: FreeCAD.Vector(), "Step": lambda box: box.Center}  # what they are counted from


def handles_of(panel):
    """Returns the Handles of a panel's object, or None if none of its numbers has a place."""
    source = getattr(panel.obj, "Source", None)
    box = _bounds(source) if source is not None else None
    if box is None:
        return None
    computed = {path.split(".")[0] for path, expression in panel.obj.ExpressionEngine}
    made = [handle for name in panel.writers if name not in computed for handle in _handles(panel, name, box)]
    return Handles(panel.document, made, box.DiagonalLength) if made else None


def _bounds(source):
    shape = getattr(source, "Mesh", None) or getattr(source, "Shape", None)
    return shape.BoundBox if shape is not None and shape.BoundBox.isValid() and shape.BoundBox.DiagonalLength else None


def _handles(panel, name, box):
    obj = panel.obj
    if name in LENGTHS:
        top, way = FreeCAD.Vector(box.Center.x, box.Center.y, box.ZMax), UP * LENGTHS[name]
        yield Handle(lambda: top, way, lambda: getattr(obj, name).Value,
                     lambda value: panel.set_number(name, value if name == "Distance" else max(value, 0)))
    elif name in POINTS:
        origin = POINTS[name](box)
        for axis, along in enumerate(AXES):
            yield Handle(lambda axis=axis: origin + _without(getattr(obj, name), axis), along,
                         lambda axis=axis: getattr(obj, name)[axis],
                         lambda value, axis=axis: panel.set_coordinate(name, axis, value), COLOURS[axis])


def _without(vector, axis):
    """Returns a vector with a coordinate of 0."""
    return FreeCAD.Vector(*(0 if i == axis else value for i, value in enumerate(vector)))
