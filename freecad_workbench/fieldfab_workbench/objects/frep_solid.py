"""A solid from a formula, with the formula's numbers as properties."""

import FreeCAD

from .. import kernel
from ..frep_language import mistakes, parameters, with_values
from ..sources import Source
from .solid import Solid

DEFAULT = """# a rounded box with a gyroid inside
size = 40
wall = 2.4
period = 14
outer = rounded_box(size, size, size, 6)
gyroids = shell(gyroid(period), 1.6)
window = sphere(r = 0.625 * size)
difference(shell(outer, wall), window) | (outer & gyroids)
"""

GROUP = "Parameters"


def source_of_text(text):
    """Of .frep text or a prefix math string."""
    return Source(("frep", text), lambda progress: kernel.load().Solid(kernel.load().parse(text)))


def property_name(name):
    """Name of the property for a parameter: the parameter's own name. FreeCAD's expressions take `r`, `h` or `min` for
    units; such names get a line below."""
    try:
        FreeCAD.Units.parseQuantity(f"1 {name}")
    except Exception:  # not a unit; 0.20 raises OSError
        return name
    return name + "_"


class FrepSolid(Solid):
    """A solid of .frep text. Each line `name = number` of the text is a property, too: its value counts instead of the
    number, and expressions may drive it."""

    NAME = "FrepSolid"

    def add_own_properties(self, obj):
        self.add(obj, "String", "FollowedText", "Result", "Text from which the parameters were last read", mode=4)
        self.add(obj, "String", "Expression", "F-rep", "The solid as .frep text or as a prefix math string", DEFAULT)
        self.follow_text(obj)

    def onChanged(self, obj, name):
        if name == "Expression" and "FollowedText" in obj.PropertiesList and not obj.Document.Restoring:
            self.follow_text(obj)

    @staticmethod
    def follow_text(obj):
        """Gives the object the parameters of its text. A number that has changed in the text is taken over; otherwise
        the property keeps its value. A text with mistakes is not followed, since it may lack parameters only until it
        is corrected."""
        if obj.FollowedText == obj.Expression:
            return
        try:
            if mistakes(obj.Expression):
                return
        except ImportError:  # no kernel: a recompute tells of it
            return
        before, wanted = parameters(obj.FollowedText), parameters(obj.Expression)
        own = {name for name in obj.PropertiesList if obj.getGroupOfProperty(name) == GROUP}
        for name in own - {property_name(n) for n in wanted}:
            obj.removeProperty(name)
        for name, parameter in wanted.items():
            held = property_name(name)
            if held not in obj.PropertiesList:
                obj.addProperty("App::PropertyFloat", held, GROUP)
                own.add(held)
                setattr(obj, held, parameter.value)
            elif held in own and (name not in before or before[name].value != parameter.value):
                setattr(obj, held, parameter.value)
            if held in own:
                obj.setDocumentationOfProperty(held, parameter.comment or f"{name} of the text")
        obj.FollowedText = obj.Expression

    def text(self, obj):
        """The text with the values of its parameters."""
        held = {name: property_name(name) for name in parameters(obj.Expression)}
        own = {name for name in obj.PropertiesList if obj.getGroupOfProperty(name) == GROUP}
        return with_values(obj.Expression, {name: getattr(obj, prop) for name, prop in held.items() if prop in own})

    def source(self, obj):
        return source_of_text(self.text(obj))
