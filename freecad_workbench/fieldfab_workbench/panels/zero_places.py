"""Places on a part where the zero of a CAM job usually is."""

import FreeCAD

from ..objects import cam_setup

REACH = 0.05  # of the part's diagonal: greatest distance of a click from a place
ROUND = 0.01  # greatest deviation of a hole's points from a circle, relative to its radius
LEVELS = (0.02, 0.25, 0.5, 0.75, 0.98)  # heights at which a mesh is searched for holes, relative to its own


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
