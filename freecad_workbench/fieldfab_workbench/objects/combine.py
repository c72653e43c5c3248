"""Boolean operations, blends and morphs of solids."""

import functools

from ..openscad import OpenScadSource, node
from ..sources import Source
from ..words import marked, tr
from .solid import Solid, csg_of, source_of

OPERATIONS = marked(("Union", "Intersection", "Difference", "Blend", "Morph"))


class Combine(Solid):
    """Union, intersection, difference (the first solid minus the others), blend (a union with a fillet) or morph of
    other objects' solids."""

    NAME = "Combine"

    def add_own_properties(self, obj):
        if "Operation" not in obj.PropertiesList:
            obj.addProperty("App::PropertyEnumeration", "Operation", "Combine",
                            "How the sources are combined").Operation = list(OPERATIONS)
        self.add(obj, "LinkList", "Sources", "Combine", "Solids, meshes, Part objects or bodies, in order")
        self.add(obj, "Length", "Radius", "Combine", "Fillet radius of a blend", 2)
        self.add(obj, "FloatConstraint", "Weight", "Combine",
                 "Weight of a morph: 0 gives the first source, 1 the second",
                 (0.5, 0.0, 1.0, 0.05))
        self.show_what_matters(obj)

    def onChanged(self, obj, name):
        if name == "Operation":
            self.show_what_matters(obj)

    @staticmethod
    def show_what_matters(obj):
        for name, operation in (("Radius", "Blend"), ("Weight", "Morph")):
            if name in obj.PropertiesList:
                obj.setEditorMode(name, 0 if obj.Operation == operation else 2)

    def csg(self, obj):
        """Returns the OpenSCAD text of a Boolean operation if all sources are OpenSCAD shapes, otherwise None. OpenSCAD
        joins their faces exactly and also combines flat shapes."""
        texts = ([csg_of(each) for each in obj.Sources]
                 if obj.Operation in ("Union", "Intersection", "Difference") else [])
        return node(f"{obj.Operation.lower()}()", obj.Label, texts) if len(texts) > 1 and None not in texts else None

    def source(self, obj):
        operation, radius, weight = obj.Operation, obj.Radius.Value, obj.Weight
        if len(obj.Sources) < 2:
            raise ValueError(tr("{label}: choose at least two Sources").format(label=obj.Label))
        if operation == "Morph" and len(obj.Sources) != 2:
            raise ValueError(tr("{label}: a morph has two Sources").format(label=obj.Label))
        if operation == "Blend" and not radius > 0:
            raise ValueError(tr("{label}: the Radius of a blend must be above 0").format(label=obj.Label))
        text = self.csg(obj)
        if text is not None:
            return OpenScadSource(text, obj.Label)
        sources = [source_of(each) for each in obj.Sources]
        join = {
            "Union": lambda a, b: a | b,
            "Intersection": lambda a, b: a & b,
            "Difference": lambda a, b: a - b,
            "Blend": lambda a, b: a.blend(b, radius),
            "Morph": lambda a, b: a.morph(b, weight),
        }[operation]
        key = ("combine", operation, radius if operation == "Blend" else 0, weight if operation == "Morph" else 0,
               *(s.digest for s in sources))

        def make(progress):
            if operation == "Blend":
                fields = [s.distances(radius, progress) for s in sources]
            elif operation == "Morph":
                reach = max(_longest_side(s.field(progress).bounds()) for s in sources)
                fields = [s.distances(reach, progress) for s in sources]
            else:
                fields = [s.field(progress) for s in sources]
            return functools.reduce(join, fields)

        return Source(key, make)


def _longest_side(bounds):
    """Returns the longest side of field.bounds(), mm. Bounds of None belong to an infinite or empty solid."""
    return max(bounds[i + 3] - bounds[i] for i in range(3)) if bounds else 1.0
