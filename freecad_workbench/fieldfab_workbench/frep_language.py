"""What an editor must know of .frep text: its words, where they stand, what they mean. Nothing here needs a window."""

import re
from dataclasses import dataclass

from . import kernel
from .words import marked, tr

TOKEN = re.compile(r"""(?P<comment>\#.*|//.*)|(?P<string>"(?:\\.|[^"\\])*"?)|(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)|(?P<name>[A-Za-z_]\w*)""")
CONSTANTS = {"x": marked("the first coordinate, mm"), "y": marked("the second coordinate, mm"), "z": marked("the third coordinate, mm"),
             "pi": "3.14159…", "tau": "6.28318…", "e": "2.71828…"}
_DEFINITION = re.compile(r"^[ \t]*([A-Za-z_]\w*)[ \t]*(\([^)]*\))?[ \t]*=(?!=)", re.MULTILINE)
_PLACE = re.compile(r":(\d+):(\d+)$")


@dataclass
class Word:
    """A name that means something: what a tooltip and a completion say of it."""

    name: str
    kind: str  # function, constant or defined
    signature: str
    meaning: str = ""
    example: str = ""


def library():
    """{name: Word} of the functions that every text may use, in the library's order."""
    return {each["name"]: Word(each["name"], "function", signature(each), meaning(each), each["example"]) for each in kernel.load().library()}


def signature(function):
    """sphere(r = 1)"""
    shown = [p["name"] if p["default"] is None else f"{p['name']} = {p['default']:g}" for p in function["parameters"]]
    return f"{function['name']}({', '.join(shown + ['…'] * function['any_number'])})"


def meaning(function):
    """Its words, and what its value is good for."""
    value = {"exact": tr("exact distance"), "bound": tr("never more than the distance")}.get(function["distance"], "")
    angles = tr("angles in degrees") if any(p["kind"] == "angle" for p in function["parameters"]) else ""
    return " · ".join(each for each in (function["meaning"], value, angles) if each)


def constants():
    return {name: Word(name, "constant", name, tr(words)) for name, words in CONSTANTS.items()}


def defined(text):
    """{name: Word} of what a text defines itself."""
    bare = "\n".join(line.split("#")[0].split("//")[0] for line in text.split("\n"))
    words = {}
    for match in _DEFINITION.finditer(bare):
        line = bare[match.start():].split("\n")[0].strip()
        words[match[1]] = Word(match[1], "defined", match[1] + (match[2] or ""), line)
    return words


def word_before(line):
    """The beginning of a name that ends a piece of a line, where it is not part of a comment, a string or a number."""
    for token in TOKEN.finditer(line):
        if token.end() == len(line):
            return token["name"] or ""
    return ""


def word_at(line, column):
    """The name that a column of a line is in, or none."""
    for token in TOKEN.finditer(line):
        if token.start() <= column < token.end():
            return token["name"] or ""
    return ""


def place_of(error):
    """(line, column) from 0 of a fieldfab.Error; its columns count bytes. None where it does not say."""
    match = _PLACE.search(error.place)
    return (int(match[1]) - 1, int(match[2]) - 1) if match else None
