"""Shapes of the gallery: every library function that makes one, and the designs in examples/, each with its text. Needs
no window."""

import os
from dataclasses import dataclass, field

from . import frep_language as language
from . import kernel
from .words import marked

WORKBENCH = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))
DESIGNS = marked("Designs")


def found(*parts):
    """Returns a file or folder in an installed workbench or in the source tree, or None if it does not exist."""
    for start in (WORKBENCH, os.path.join(WORKBENCH, "..", "docs"), os.path.join(WORKBENCH, "..")):
        path = os.path.normpath(os.path.join(start, *parts))
        if os.path.exists(path):
            return path
    return None


@dataclass
class Shape:
    """A library function as a shape. `values`: {parameter: text}; plain numbers become named parameters in the text of
    a new solid. `before` and `after`: text that turns the call into a solid, such as `extrude(` and `, 1)`."""

    name: str
    group: str
    signature: str
    meaning: str
    picture: str | None
    values: dict = field(default_factory=dict)
    defaults: dict = field(default_factory=dict)
    before: str = ""
    after: str = ""
    text: str = ""  # text of a design, otherwise ""

    def call(self, values):
        """Returns only the call, for insertion into an existing text."""
        return self.text or f"{self.name}({', '.join(self._argument(name, value) for name, value in values.items())})"

    def solid(self, values):
        """Returns a complete text. Its numbers become lines `name = number`, hence properties."""
        if self.text:
            return self.text
        named = {name: self._variable(name) for name, value in values.items()
                 if is_number(value) and name.isidentifier()}
        lines = [f"{variable} = {values[name]}" for name, variable in named.items()]
        call = f"{self.name}({', '.join(self._argument(n, named.get(n, v)) for n, v in values.items())})"
        return "\n".join([*lines, self.before + call + self.after]) + "\n"

    @staticmethod
    def _argument(name, value):
        return f"{name} = {value}" if name.isidentifier() else value

    @staticmethod
    def _variable(name):
        return f"{name}_" if name in language.words() else name


def is_number(text):
    kinds = [kind for kind, start, end, token in language.tokens(str(text).strip().removeprefix("-"))]
    return kinds == ["number"]


def shapes():
    """Returns all shapes in the library's order, with the designs last."""
    return [_of_function(f) for f in kernel.load().library() if f["example"]] + designs()


def designs():
    folder = found("examples")
    made = []
    for file in sorted(os.listdir(folder)) if folder else []:
        if file.endswith(".frep"):
            with open(os.path.join(folder, file), encoding="utf-8") as opened:
                text = opened.read()
            name = file[:-5]
            words = text.split("\n")[0].lstrip("# ") if text.startswith("#") else ""
            made.append(Shape(name, DESIGNS, name.replace("_", " "), words, found("figures", "gallery", f"{name}.png"),
                              text=text))
    return made


def _of_function(function):
    """Returns the Shape of a function. Its values are those of the example, as in the picture, and defaults for omitted
    parameters."""
    name, example = function["name"], function["example"]
    start, arguments, end = _call(example, name)
    parameters = [p["name"] for p in function["parameters"]]
    defaults = {p["name"]: f"{p['default']:g}" for p in function["parameters"] if p["default"] is not None}
    given = {**defaults, **dict(zip(parameters, arguments))}
    # A variable number of arguments has no names, so all are positional.
    values = {"…": ", ".join(arguments)} if function["any_number"] else {p: given[p] for p in parameters}
    return Shape(name, function["group"], function["signature"], language.meaning(function["help"]),
                 found("figures", "shapes", f"{name}.png"),
                 values, defaults, example[:start], example[end:])


def _call(text, name):
    """Returns the start of the first call of a function, its arguments, and its end. The text is ASCII."""
    tokens = language.tokens(text)
    first = next(i for i, token in enumerate(tokens) if token[3] == name and tokens[i + 1][3] == "(")
    given, depth, begun = [], 0, tokens[first + 1][2]
    for kind, start, end, token in tokens[first + 2:]:
        if token in (",", ")") and not depth:
            given.append(text[begun:start].strip())
            begun = end
            if token == ")":
                break
        depth += (token == "(") - (token == ")")
    return tokens[first][1], [each for each in given if each], begun
