"""Arrows in the 3D view for a CAM job's zero and stock."""

import FreeCAD

from ..objects import cam_setup
from ..views.handles import Handle, Handles
from .property_handles import AXES, COLOURS
from .zero_places import places

SNAP = 0.02  # of the part's diagonal: a dragged coordinate goes to that of a place which is so near


def handles_of(panel):
    """Returns the Handles of what the panel's open boxes show, or None."""
    obj, made = panel.obj, []
    try:
        lower, upper = cam_setup.stock_box(obj)
        if obj.Part is not None and panel.part_box.button.isChecked():
            made += _of_zero(panel)
        if panel.stock_box.button.isChecked():
            made += list(_of_stock(panel))
    except ValueError:  # something has no size yet
        return None
    return Handles(panel.document, made, (upper - lower).Length) if made else None


def _of_zero(panel):
    obj, box = panel.obj, cam_setup.box_of(panel.obj.Part)
    known, near = [], SNAP * box.DiagonalLength

    def write(axis, value):
        if not known:  # looking for holes takes a moment
            known.extend(places(obj.Part))
        nearest = min((place[axis] for place in known), key=lambda at: abs(at - value))
        point = cam_setup.zero_of(obj)
        point[axis] = nearest if abs(nearest - value) < near else value
        panel.set_zero(point)

    def start(axis):
        point = cam_setup.zero_of(obj)
        point[axis] = 0
        return point

    return [Handle(lambda axis=axis: start(axis), along, lambda axis=axis: cam_setup.zero_of(obj)[axis],
                   lambda value, axis=axis: write(axis, value), COLOURS[axis]) for axis, along in enumerate(AXES)]


def _of_stock(panel):
    obj = panel.obj
    if obj.StockFrom == "Box":
        for axis, along in enumerate(AXES):
            for name, other, sign in (("StockUpper", "StockLower", 1), ("StockLower", "StockUpper", -1)):
                yield Handle(lambda axis=axis: _across(obj, axis), along * sign,
                             lambda name=name, axis=axis, sign=sign: sign * getattr(obj, name)[axis],
                             lambda value, name=name, other=other, axis=axis, sign=sign:
                             panel.set_corner(name, axis, sign * max(value, sign * getattr(obj, other)[axis])))
    elif obj.StockFrom == "Margins" and obj.Part is not None:
        box = cam_setup.box_of(obj.Part)
        side = FreeCAD.Vector(box.XMax, box.Center.y, box.Center.z)
        yield Handle(lambda: side, AXES[0], lambda: obj.Margin.Value,
                     lambda value: panel.set_length("Margin", max(value, 0)))
        top = FreeCAD.Vector(box.Center.x, box.Center.y, box.ZMax)
        yield Handle(lambda: top, AXES[2], lambda: obj.Top.Value,
                     lambda value: panel.set_length("Top", max(value, 0)))
        yield Handle(lambda: top + AXES[2] * obj.Top.Value, AXES[2] * -1,
                     lambda: obj.Thickness.Value or box.ZLength + obj.Top.Value,
                     lambda value: panel.set_length("Thickness", max(value, 0)))


def _across(obj, axis):
    """Returns the middle of the stock with a coordinate of 0."""
    middle = (obj.StockLower + obj.StockUpper) * 0.5
    middle[axis] = 0
    return middle
