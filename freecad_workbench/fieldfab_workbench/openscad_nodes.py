"""Table for the conversion between OpenSCAD nodes and properties of FreeCAD objects, in both directions."""

import dataclasses
import math

from .words import described

IGNORED = {"convexity", "timestamp"}  # for OpenSCAD's preview and cache; without effect on the solid


class Unfit(Exception):
    """A node's arguments cannot be stored in properties: infinite numbers, values of other types, or unknown names."""


@dataclasses.dataclass(frozen=True)
class Argument:
    """An argument and its properties, (name, description) each. A list is stored in several properties. `kind`: type of
    the properties."""

    name: str
    kind: str
    properties: tuple
    defaults: tuple

    def to_properties(self, value):
        """Returns {property: value} for an argument's value. Raises Unfit."""
        if value is None:
            values = self.defaults
        elif len(self.properties) == 1:
            values = (value,)
        elif isinstance(value, list) and len(value) >= len(self.properties):
            values = value
        else:
            raise Unfit(self.name)
        read = READERS[self.kind]
        return {name: read(each) for (name, _), each in zip(self.properties, values)}

    def value(self, obj):
        """Returns the argument's value from an object's properties."""
        values = [WRITERS.get(self.kind, lambda held: held)(getattr(obj, name)) for name, _ in self.properties]
        return values[0] if len(values) == 1 else values


def _number(value):
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        raise Unfit(value)
    return value


def _truth(value):
    if isinstance(value, (bool, float, int)):
        return bool(value)
    raise Unfit(value)


def _words(value):
    if isinstance(value, str):
        return value
    raise Unfit(value)


def _points(value):
    if (not isinstance(value, (list, tuple))
            or any(not isinstance(point, list) or len(point) not in (2, 3) for point in value)):
        raise Unfit(value)
    return [tuple(map(_number, [*point, 0][:3])) for point in value]


def _paths(value):
    """Returns lists of point indices as lines of text, one for each list."""
    if value == ():
        return []
    if not isinstance(value, list) or any(not isinstance(path, list) for path in value):
        raise Unfit(value)
    return [", ".join(f"{_number(place):g}" for place in path) for path in value]


def _paths_of(lines):
    """Returns the lists of numbers in lines of text, or None without lines. Raises ValueError for invalid numbers."""
    return [[float(word) for word in line.replace(",", " ").split()] for line in lines] or None


def _matrix(value):
    import FreeCAD

    if (not isinstance(value, list) or len(value) not in (3, 4)
            or any(not isinstance(row, list) or len(row) != 4 for row in value)):
        raise Unfit(value)
    return FreeCAD.Matrix(*(_number(each) for row in (*value, [0, 0, 0, 1])[:4] for each in row))


READERS = {"Length": _number, "Distance": _number, "Angle": _number, "Float": _number, "Bool": _truth, "String": _words,
           "File": _words,
           "VectorList": _points, "StringList": _paths, "Matrix": _matrix}
WRITERS = {"Length": lambda held: held.Value, "Distance": lambda held: held.Value, "Angle": lambda held: held.Value,
           "VectorList": lambda held: [tuple(point) for point in held], "StringList": _paths_of,
           "Matrix": lambda held: [held.A[i:i + 4] for i in (0, 4, 8, 12)]}


@dataclasses.dataclass(frozen=True)
class Kind:
    """A kind of node: OpenSCAD's name, its arguments, and whether it has children."""

    name: str
    arguments: tuple = ()
    children: bool = False


FRAGMENTS = (
    Argument("$fn", "Float", (described("Fn", "Number of sides of a circle; 0: from Fa and Fs"),), (0,)),
    Argument("$fa", "Angle", (described("Fa", "Smallest angle that a side of a circle spans"),), (12,)),
    Argument("$fs", "Length", (described("Fs", "Smallest length of a side of a circle"),), (2,)),
)
CENTRED = Argument("center", "Bool", (described("Centred", "Around the origin"),), (False,))
HEIGHT = described("Height", "Along z")
LENGTH, WIDTH = described("Length", "Along x"), described("Width", "Along y")
RADIUS = Argument("r", "Length", (described("Radius", "Radius of the circle or sphere"),), (1,))
FILE = Argument("file", "File", (described("File", "The file that is imported"),), ("",))

# {value of the objects' property Node: Kind}
KINDS = {
    "cube": Kind("cube", (Argument("size", "Length", (LENGTH, WIDTH, HEIGHT), (1, 1, 1)), CENTRED)),
    "sphere": Kind("sphere", (RADIUS, *FRAGMENTS)),
    "cylinder": Kind("cylinder", (
        Argument("h", "Length", (HEIGHT,), (1,)),
        Argument("r1", "Length", (described("BottomRadius", "Radius of the lower circle"),), (1,)),
        Argument("r2", "Length", (described("TopRadius", "Radius of the upper circle"),), (1,)), CENTRED, *FRAGMENTS)),
    "polyhedron": Kind("polyhedron", (
        Argument("points", "VectorList", (described("Points", "Corners"),), ((),)),
        Argument("faces", "StringList",
                 (described("Faces", "Corners of each face, clockwise from outside, numbered from 0"),), ((),)))),
    "square": Kind("square", (Argument("size", "Length", (LENGTH, WIDTH), (1, 1)), CENTRED)),
    "circle": Kind("circle", (RADIUS, *FRAGMENTS)),
    "polygon": Kind("polygon", (
        Argument("points", "VectorList", (described("Points", "Corners"),), ((),)),
        Argument("paths", "StringList", (
            described("Paths", "Corners of each outline, numbered from 0; empty: all in their order"),), ((),)))),
    "text": Kind("text", (
        Argument("text", "String", (described("Words", "Text to be written"),), ("",)),
        Argument("size", "Length", (described("TextSize", "Height of a capital letter"),), (10,)),
        Argument("font", "String", (described("Font", "Name of the font, also with style=..."),), ("",)),
        Argument("halign", "String", (described("HorizontalAlignment", "left, center or right"),), ("left",)),
        Argument("valign", "String", (described("VerticalAlignment", "baseline, bottom, center or top"),),
                 ("baseline",)),
        Argument("spacing", "Float", (described("Spacing", "Spacing of the letters; 1 is normal"),), (1,)),
        Argument("direction", "String", (described("WritingDirection", "ltr, rtl, ttb or btt"),), ("ltr",)),
        Argument("language", "String", (described("Language", "Language of the text: en, de, ..."),), ("en",)),
        Argument("script", "String", (described("Script", "Script of the text: Latn, ..."),), ("Latn",)), *FRAGMENTS)),
    "linear_extrude": Kind("linear_extrude", (
        Argument("height", "Length", (HEIGHT,), (100,)), CENTRED,
        Argument("twist", "Angle", (described("Twist", "Rotation of the upper end against the lower"),), (0,)),
        Argument("scale", "Float", (described("ScaleX", "Scale of the upper end along x"),
                                    described("ScaleY", "Scale of the upper end along y")), (1, 1)),
        Argument("slices", "Float", (described("Slices",
                                               "Number of slices if twisted or scaled; 0: from Fn, Fa and Fs"),), (0,)),
        *FRAGMENTS), True),
    "rotate_extrude": Kind("rotate_extrude", (
        Argument("angle", "Angle", (described("Angle", "Angle of the revolution, from the x axis"),), (360,)),
        *FRAGMENTS), True),
    "hull": Kind("hull", (), True),
    "minkowski": Kind("minkowski", (), True),
    "projection": Kind("projection", (
        Argument("cut", "Bool", (described("Cut", "Section at z = 0 instead of the projection"),), (False,)),), True),
    "offset": Kind("offset", (
        Argument("delta", "Distance", (described("Distance", "Distance outwards; negative values inwards"),), (0,)),
        Argument("chamfer", "Bool", (described("Chamfered", "Cut off the corners"),), (False,))), True),
    "round offset": Kind("offset", (
        Argument("r", "Distance", (described("Distance", "Distance outwards; negative values inwards"),), (0,)),
        *FRAGMENTS), True),
    "resize": Kind("resize", (
        Argument("newsize", "Length",
                 (described("NewLength", "Length along x; 0: unchanged"),
                  described("NewWidth", "Width along y; 0: unchanged"),
                  described("NewHeight", "Height along z; 0: unchanged")), (0, 0, 0)),
        Argument("auto", "Bool", (described("AutoLength", "Scale the length in proportion if NewLength is 0"),
                                  described("AutoWidth", "Scale the width in proportion if NewWidth is 0"),
                                  described("AutoHeight", "Scale the height in proportion if NewHeight is 0")),
                 (False, False, False))), True),
    "multmatrix": Kind("multmatrix",
                       (Argument("", "Matrix", (described("Matrix",
                                                          "Transformation of the children"),), (None,)),), True),
    "import": Kind("import", (
        FILE, Argument("layer", "String", (described("Layer", "Layer of a .dxf file; empty: all layers"),), ("",)),
        Argument("origin", "Float", (described("OriginX", "Origin of the drawing in a .dxf file"),
                                     described("OriginY", "Origin of the drawing in a .dxf file")), (0, 0)),
        Argument("scale", "Float", (described("Scale", "Scale of the drawing in a .dxf or .svg file"),), (1,)),
        CENTRED, Argument("dpi", "Float", (described("Dpi", "Dots per inch of an .svg file"),), (72,)), *FRAGMENTS)),
    "surface": Kind("surface", (
        FILE, CENTRED, Argument("invert", "Bool", (described("Inverted",
            "Dark parts of a picture are high"),), (False,)))),
}


def key_of(node):
    """Returns the key in KINDS of a fieldfab.OpenScadNode. Raises Unfit for an unknown node."""
    key = "round offset" if node.name == "offset" and "r" in node.arguments else node.name
    if key not in KINDS:
        raise Unfit(key)
    return key


def properties_of(node):
    """Returns {property: value} of a fieldfab.OpenScadNode. Raises Unfit."""
    kind, given = KINDS[key_of(node)], node.arguments
    if set(given) - {argument.name for argument in kind.arguments} - IGNORED:
        raise Unfit(node.name)
    return {name: value for argument in kind.arguments
            for name, value in argument.to_properties(given.get(argument.name)).items()}


def values_of(key, obj):
    """Returns {argument: value} of an object. Raises ValueError for invalid properties."""
    values = {argument.name: argument.value(obj) for argument in KINDS[key].arguments}
    if key == "polygon":
        values["points"] = [point[:2] for point in values["points"]]
    return values
