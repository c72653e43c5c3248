"""A solid from a Python script that the document keeps."""

from .. import kernel, scripts
from ..sources import Source
from ..words import tr
from .frep_solid import FrepSolid

DEFAULT = """# a ring of holes in a plate
from fieldfab.shapes import *

count = 7  # 1 to 24, number of holes
radius = 3  # 1 to 6, their radius
size = 50  # 20 to 100, diameter of the plate

plate = cylinder(size / 2, 6)
for i in range(round(count)):
    hole = cylinder(radius, 10).translate(0.35 * size, 0, 0)
    plate = plate - hole.rotate((0, 0, 1), 360 * i / round(count))
solid = plate
"""


class ScriptSolid(FrepSolid):
    """A solid of a Python script, which runs in a process of its own, and only after the user has agreed to that for
    the document. The document keeps the formula that the script made: until the script or a parameter changes, nothing
    runs. Each line `name = number` at the script's left edge is also a property."""

    NAME = "ScriptSolid"
    TEXT = "Script"

    def add_own_properties(self, obj):
        self.add(obj, "String", "FollowedText", "Result", "Text from which the parameters were last read", mode=4)
        self.add(obj, "String", "Script", "Script", "Python script that makes the solid", DEFAULT)
        # Hidden.
        self.add(obj, "String", "Formula", "Result", "Formula that the script made", mode=4)
        self.add(obj, "String", "FormulaOf", "Result", "Script that made the formula, with its values", mode=4)
        self.follow_text(obj)

    @staticmethod
    def parameters(text):
        return scripts.parameters(text)

    @staticmethod
    def is_wrong(text):
        return scripts.mistake(text) is not None

    @staticmethod
    def source_of_text(text, formula=None):
        """Returns the Source of a script; `formula`: what it made, if that is known."""
        def make(progress):
            fieldfab = kernel.load()
            made = scripts.formula_of(text, progress) if formula is None else formula
            return fieldfab.Solid(fieldfab.parse(made))

        return Source(("script", text), make)

    def text(self, obj):
        """Returns the formula as .frep text. Raises ValueError."""
        self._ask(obj)
        script = self.written(obj)
        return obj.Formula if script == obj.FormulaOf else scripts.formula_of(script)

    def source(self, obj):
        self._ask(obj)
        script = self.written(obj)
        return self.source_of_text(script, obj.Formula if script == obj.FormulaOf else None)

    def _ask(self, obj):
        """Raises ValueError if the script would have to run and may not."""
        if self.written(obj) != obj.FormulaOf and not scripts.may_run(obj.Document):
            told = tr("{label}: its script may run only after you have agreed; double-click the solid")
            raise ValueError(told.format(label=obj.Label))

    def make_mesh(self, obj):
        try:
            super().make_mesh(obj)
            script = self.written(obj)
            if script != obj.FormulaOf:
                obj.Formula, obj.FormulaOf = scripts.formula_of(script), script
        except scripts.ScriptError as error:
            raise ValueError(f"{obj.Label}: {error}") from None
