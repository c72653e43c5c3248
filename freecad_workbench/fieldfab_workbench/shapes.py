"""The gallery's shapes: every function of the library that makes one, and the designs of examples/, each with the text
that makes it. Needs no window."""

import os
from dataclasses import dataclass, field

from . import frep_language as language
from . import kernel
from .words import marked

WORKBENCH = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))
DESIGNS = marked("Designs")


def found(*parts):
    """A file or folder that lies beside an installed workbench, or in the source tree; None where it is not there."""
    for start in (WORKBENCH, os.path.join(WORKBENCH, "..", "docs"), os.path.join(WORKBENCH, "..")):
        path = os.path.normpath(os.path.join(start, *parts))
        if os.path.exists(path):
            return path
    return None


@dataclass
class Shape:
    """A function of the library as a shape. `values`: {parameter: its text}; a plain number becomes a name of its own
    in the text of a new solid. `before` and `after`: text that makes a solid of the call, such as `extrude(` and `,
    1)`."""

    name: str
    group: str
    signature: str
    meaning: str
    picture: str | None
    values: dict = field(default_factory=dict)
    defaults: dict = field(default_factory=dict)
    before: str = ""
    after: str = ""
    text: str = ""  # of a design

    def call(self, values):
        """The call alone, for a text that has a solid already."""
        return self.text or f"{self.name}({', '.join(self._argument(name, value) for name, value in values.items())})"

    def solid(self, values):
        """A text of its own: its numbers as lines `name = number`, which become properties."""
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
    """All of them, in the library's order; the designs last."""
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
    """Values are those of the example, which the picture shows, and the defaults of what it leaves out."""
    name, example = function["name"], function["example"]
    start, arguments, end = _call(example, name)
    parameters = [p["name"] for p in function["parameters"]]
    defaults = {p["name"]: f"{p['default']:g}" for p in function["parameters"] if p["default"] is not None}
    given = {**defaults, **dict(zip(parameters, arguments))}
    # A list has no names, and all before it goes by its place.
    values = {"…": ", ".join(arguments)} if function["any_number"] else {p: given[p] for p in parameters}
    return Shape(name, function["group"], function["signature"], language.meaning(function["help"]),
                 found("figures", "shapes", f"{name}.png"),
                 values, defaults, example[:start], example[end:])


def _call(text, name):
    """Where the first call of a function begins, its arguments, and where it ends. The text is ASCII."""
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
