"""Text of a STEP file (ISO 10303-21) with a closed solid. OpenCASCADE's reader makes the rest: curves in the
surfaces' parameters, seams and poles."""

import numpy as np

from .surfaces import perpendicular, unit

HEAD = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('','',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));
ENDSEC;
DATA;
#1=APPLICATION_CONTEXT('automotive design');
#2=PRODUCT_CONTEXT('',#1,'mechanical');
#3=PRODUCT('solid','solid','',(#2));
#4=PRODUCT_DEFINITION_FORMATION('','',#3);
#5=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');
#6=PRODUCT_DEFINITION('design','',#4,#5);
#7=PRODUCT_DEFINITION_SHAPE('','',#6);
#8=SHAPE_DEFINITION_REPRESENTATION(#7,#9);
#9=ADVANCED_BREP_SHAPE_REPRESENTATION('',({solids}),#10);
#10=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#14))
GLOBAL_UNIT_ASSIGNED_CONTEXT((#11,#12,#13))REPRESENTATION_CONTEXT('',''));
#11=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));
#12=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));
#13=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());
#14=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({uncertainty}),#11,'distance_accuracy_value','');
"""


def _number(value):
    text = repr(float(value)).upper()
    return text if "." in text else text.replace("E", ".E") if "E" in text else text + "."


def _list(items):
    return "(" + ",".join(items) + ")"


class StepText:
    """Writes entities. `spline(points)` returns (degree, poles, multiplicities, knots) of a curve through points."""

    def __init__(self, spline):
        self.lines, self.spline = [], spline

    def add(self, text):
        self.lines.append(f"#{len(self.lines) + 15}={text};\n")
        return f"#{len(self.lines) + 14}"

    def point(self, place):
        return self.add(f"CARTESIAN_POINT('',{_list(map(_number, place))})")

    def direction(self, vector):
        return self.add(f"DIRECTION('',{_list(map(_number, vector))})")

    def placement(self, origin, axis, first):
        names = self.point(origin), self.direction(axis), self.direction(first)
        return self.add(f"AXIS2_PLACEMENT_3D('',{','.join(names)})")

    # Edges.
    def curve(self, curve):
        if curve.kind == "LINE":
            vector = self.add(f"VECTOR('',{self.direction(curve.axis)},1.)")
            return self.add(f"LINE('',{self.point(curve.centre)},{vector})")
        if curve.kind == "SPLINE":
            degree, poles, counts, knots = self.spline(curve.points)
            poles = _list([self.point(p) for p in poles])
            return self.add(f"B_SPLINE_CURVE_WITH_KNOTS('',{degree},{poles},.UNSPECIFIED.,.F.,.F.,"
                            f"{_list(map(str, counts))},{_list(map(_number, knots))},.UNSPECIFIED.)")
        place = self.placement(curve.centre, curve.axis, curve.first)
        return self.add(f"{curve.kind}('',{place},{','.join(map(_number, curve.radii))})")

    # Faces.
    def surface(self, surface, points, hole=None):
        """Writes a surface with its seam away from points of the face, if possible. `hole`: the axis of the only loop
        of a part of a sphere, which becomes the axis through the poles."""
        name = surface.NAME
        if name == "BSplineSurface":
            return self._patch(surface)
        axis = surface.axis
        if name == "Sphere":
            axis = best_pole(surface, points) if hole is None else hole
        origin, first = surface.origin, away_from(surface.origin, axis, points)
        sizes = list(surface.sizes)
        if name == "Cone":
            height = max(np.max((points - origin) @ axis), 1e-6)
            origin, sizes = origin + height * axis, [height * np.tan(sizes[0]), sizes[0]]
        place = self.placement(origin, axis, first)
        kind = {"Plane": "PLANE", "Cylinder": "CYLINDRICAL_SURFACE", "Cone": "CONICAL_SURFACE",
                "Sphere": "SPHERICAL_SURFACE", "Torus": "TOROIDAL_SURFACE"}[name]
        return self.add(f"{kind}({','.join([repr(''), place, *map(_number, sizes)])})")

    def _patch(self, patch):
        poles = _list([_list([self.point(p) for p in row]) for row in patch.poles()])
        knots = []
        for spans in patch.spans:
            knots.append((_list(["4", *["1"] * (spans - 1), "4"]),
                          _list(map(_number, np.linspace(0, 1, spans + 1)))))
        (u_counts, u), (v_counts, v) = knots
        return self.add(f"B_SPLINE_SURFACE_WITH_KNOTS('',3,3,{poles},.UNSPECIFIED.,.F.,.F.,.F.,"
                        f"{u_counts},{v_counts},{u},{v},.UNSPECIFIED.)")

    def solids(self, topology, surfaces, points_of, shells):
        """Writes a solid for each of `shells`: lists of shells, each a list of regions; the first shell bounds the
        solid, the others are cavities. Returns their names. Raises ValueError for a face without edges, except of a
        whole sphere or torus."""
        vertices = [self.add(f"VERTEX_POINT('',{self.point(place)})") for place in topology.vertices]
        edges = [self.add(f"EDGE_CURVE('',{vertices[e.start]},{vertices[e.end]},{self.curve(e.curve)},.T.)")
                 for e in topology.edges]
        made = []
        for shell_regions in shells:
            hull, *cavities = [self._shell(regions, topology, surfaces, points_of, edges) for regions in shell_regions]
            if cavities:
                voids = [self.add(f"ORIENTED_CLOSED_SHELL('',*,{cavity},.T.)") for cavity in cavities]
                made.append(self.add(f"BREP_WITH_VOIDS('',{hull},{_list(voids)})"))
            else:
                made.append(self.add(f"MANIFOLD_SOLID_BREP('',{hull})"))
        return made

    def _shell(self, regions, topology, surfaces, points_of, edges):
        faces = [self._face(topology.faces[r], surfaces[r], points_of(r), edges, topology)
                 for r in regions if r in topology.faces]
        return self.add(f"CLOSED_SHELL('',{_list(faces)})")

    def _face(self, loops, surface, points, edges, topology):
        bounds = []
        for loop in loops:
            used = [self.add(f"ORIENTED_EDGE('',*,*,{edges[e]},.{'T' if forward else 'F'}.)") for e, forward in loop]
            bounds.append(self.add(f"EDGE_LOOP('',{_list(used)})"))
        if not loops:
            if surface.NAME not in ("Sphere", "Torus"):
                raise ValueError(f"a face without edges on a {surface.NAME}")
            ring = perpendicular(surface.axis)[0] * surface.sizes[0] if surface.NAME == "Torus" else 0
            start = self.point(surface.origin + ring + surface.axis * surface.sizes[-1])
            vertex = self.add(f"VERTEX_POINT('',{start})")
            bounds.append(self.add(f"VERTEX_LOOP('',{vertex})"))
        bounds = [self.add(f"FACE_BOUND('',{bound},.T.)") for bound in bounds]
        hole = topology.axis_of(loops[0]) if len(loops) == 1 else None
        name = self.surface(surface, points, hole)
        return self.add(f"ADVANCED_FACE('',{_list(bounds)},{name},.{'T' if surface.sense > 0 else 'F'}.)")

    def text(self, solids, uncertainty):
        head = HEAD.format(solids=",".join(solids), uncertainty=_number(uncertainty))
        return head + "".join(self.lines) + "ENDSEC;\nEND-ISO-10303-21;\n"


def away_from(origin, axis, points):
    """Returns the direction perpendicular to the axis in the middle of the widest gap between points around it."""
    first, second = perpendicular(axis)
    if not len(points):
        return first
    offsets = points - origin
    angles = np.sort(np.arctan2(offsets @ second, offsets @ first))
    gaps = np.diff(np.append(angles, angles[0] + 2 * np.pi))
    widest = np.argmax(gaps)
    if gaps[widest] < 0.3:
        return first
    middle = angles[widest] + gaps[widest] / 2
    return np.cos(middle) * first + np.sin(middle) * second


def best_pole(sphere, points):
    """Returns the axis through a sphere that is farthest from points of its face."""
    steps = np.array([(x, y, z) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1) if (x, y, z) > (0, 0, 0)])
    away = unit(points - sphere.origin)
    middle = unit(away.mean(axis=0)) if np.linalg.norm(away.mean(axis=0)) > 0.1 else np.array([0.0, 0.0, 1.0])
    choices = unit(np.concatenate([steps, perpendicular(middle)]).astype(float))
    return choices[np.argmin(np.abs(away @ choices.T).max(axis=0))]
