"""Arrows in the 3D view for a CAM job's zero and stock, and places on the part where a zero usually is."""

import FreeCAD

from ..objects import cam_setup
from ..views.handles import Handle, Handles
from .property_handles import AXES, COLOURS

SNAP = 0.02  # of the part's diagonal: a dragged coordinate goes to that of a place which is so near
REACH = 0.05  # of the part's diagonal: greatest distance of a click from a place
ROUND = 0.01  # greatest deviation of a hole's points from a circle, relative to its radius
LEVELS = (0.02, 0.25, 0.5, 0.75, 0.98)  # heights at which a mesh is searched for holes, relative to its own


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


def places(part):
    """Returns corners, centres of edges and faces of the part's box, and the centres of its upright holes and round
    outlines at its top and bottom."""
    box = cam_setup.box_of(part)
    found = [FreeCAD.Vector(x, y, z) for z in (box.ZMax, box.Center.z, box.ZMin)
             for y in (box.YMin, box.Center.y, box.YMax) for x in (box.XMin, box.Center.x, box.XMax)]
    round_ones = _of_circles(part.Shape) if hasattr(part, "Shape") and not hasattr(part, "Mesh") else _of_mesh(part)
    return found + [FreeCAD.Vector(x, y, z) for x, y in round_ones for z in (box.ZMax, box.ZMin)]


def _of_circles(shape):
    return {(round(edge.Curve.Center.x, 6), round(edge.Curve.Center.y, 6)) for edge in shape.Edges
            if getattr(edge.Curve, "TypeId", "") == "Part::GeomCircle" and abs(edge.Curve.Axis.z) > 0.999}


def _of_mesh(part):
    mesh, box, found = part.Mesh, part.Mesh.BoundBox, []
    planes = [(FreeCAD.Vector(0, 0, box.ZMin + level * box.ZLength), FreeCAD.Vector(0, 0, 1)) for level in LEVELS]
    for loop in (loop for section in mesh.crossSections(planes, 1e-4 * box.DiagonalLength) for loop in section):
        if len(loop) < 9 or (loop[0] - loop[-1]).Length > 1e-3 * box.DiagonalLength:
            continue
        x, y = [max(p[axis] for p in loop) / 2 + min(p[axis] for p in loop) / 2 for axis in (0, 1)]
        radii = [((p.x - x) ** 2 + (p.y - y) ** 2) ** 0.5 for p in loop]
        if max(radii) - min(radii) < 2 * ROUND * max(radii) and not any(
                abs(x - a) + abs(y - b) < 1e-3 * box.DiagonalLength for a, b in found):
            found.append((x, y))
    return found


def place_at(part, origin, direction):
    """Returns the place on the part that is nearest to a ray; of several behind each other the first. None if all are
    far from it."""
    diagonal = cam_setup.box_of(part).DiagonalLength
    origin, direction = FreeCAD.Vector(*origin), FreeCAD.Vector(*direction)
    away = [(place.distanceToLine(origin, direction), (place - origin) * direction, place) for place in places(part)]
    near = [each for each in away if each[0] < REACH * diagonal]
    return min(near, key=lambda each: (round(each[0] / (0.2 * REACH * diagonal)), each[1]))[2] if near else None
