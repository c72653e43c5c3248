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
    """Returns the Source of .frep text or of a prefix math string."""
    return Source(("frep", text), lambda progress: kernel.load().Solid(kernel.load().parse(text)))


def property_name(name):
    """Returns the property name for a parameter: normally the parameter's own name. FreeCAD's expressions read `r`, `h`
    or `min` as units, so such names get an underscore appended."""
    try:
        FreeCAD.Units.parseQuantity(f"1 {name}")
    except Exception:  # not a unit; 0.20 raises OSError
        return name
    return name + "_"


class FrepSolid(Solid):
    """A solid of .frep text. Each line `name = number` of the text is also a property. The property's value replaces
    the number, and expressions may set it."""

    NAME = "FrepSolid"
    TEXT = "Expression"  # property with the text

    def add_own_properties(self, obj):
        self.add(obj, "String", "FollowedText", "Result", "Text from which the parameters were last read", mode=4)
        self.add(obj, "String", "Expression", "F-rep", "The solid as .frep text or as a prefix math string", DEFAULT)
        self.follow_text(obj)

    def onChanged(self, obj, name):
        if name == self.TEXT and "FollowedText" in obj.PropertiesList and not obj.Document.Restoring:
            self.follow_text(obj)

    @staticmethod
    def parameters(text):
        """Returns the named numbers of a text: {name: fieldfab.language.Parameter}."""
        return parameters(text)

    @staticmethod
    def is_wrong(text):
        return bool(mistakes(text))

    @staticmethod
    def source_of_text(text):
        return source_of_text(text)

    def follow_text(self, obj):
        """Updates the properties to the parameters of the text. If a number has changed in the text, the property takes
        it; otherwise the property keeps its value. A text with errors is ignored, since parameters may be missing only
        temporarily."""
        text = getattr(obj, self.TEXT)
        if obj.FollowedText == text:
            return
        try:
            if self.is_wrong(text):
                return
        except ImportError:  # no kernel: the recompute reports it
            return
        before, wanted = self.parameters(obj.FollowedText), self.parameters(text)
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
        obj.FollowedText = text

    def written(self, obj):
        """Returns the object's text with the current values of its parameters."""
        text = getattr(obj, self.TEXT)
        held = {name: property_name(name) for name in self.parameters(text)}
        own = {name for name in obj.PropertiesList if obj.getGroupOfProperty(name) == GROUP}
        return with_values(text, {name: getattr(obj, prop) for name, prop in held.items() if prop in own})

    def text(self, obj):
        """Returns the solid as .frep text. Raises ValueError."""
        return self.written(obj)

    def source(self, obj):
        return self.source_of_text(self.text(obj))
