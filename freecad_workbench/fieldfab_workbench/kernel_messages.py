"""The kernel's messages in the user's language. The kernel makes them in English from templates, such as
"{0}: there is nothing left to cut"; a message is matched with the templates, and its values are filled into the
translation of the one that fits best."""

import functools
import pathlib
import re

from .words import tr

CONTEXT = "Kernel: message"
TEMPLATES = pathlib.Path(__file__).resolve().parents[1] / "resources" / "translations" / "messages.txt"
_FIELD = re.compile(r"\{(\d+)\}")


def translated(message):
    """Returns a message of the kernel in the user's language. What no template fits is returned unchanged; before it
    may stand labels, names of files and lines, each with a colon."""
    if not message or not _speaks():
        return message
    return "\n".join(_of_line(line) for line in message.split("\n"))


def _of_line(line):
    fits = [(template, match) for template, pieces, pattern in _patterns()
            if all(piece in line for piece in pieces) and (match := pattern.fullmatch(line))]
    if not fits:
        before, colon, rest = line.partition(": ")
        return _of_line(before) + colon + _of_line(rest) if colon else line
    template, match = max(fits, key=lambda fit: len(_FIELD.sub("", fit[0])))
    values = {name: value if value == line else _of_line(value) for name, value in match.groupdict("").items()}
    return _FIELD.sub(lambda field: values[f"v{field[1]}"], tr(template, CONTEXT)).replace("{{", "{").replace("}}", "}")


@functools.lru_cache(1)
def _patterns():
    """[(template, its words between the values, its regular expression)]."""
    return [(template, [piece for piece in re.split(r"\{\d+\}", template.replace("{{", "{").replace("}}", "}"))],
             re.compile(_pattern(template), re.DOTALL)) for template in templates()]


def _pattern(template):
    seen = set()
    text = ""
    for place, piece in enumerate(_FIELD.split(template)):
        if place % 2 == 0:
            text += re.escape(piece.replace("{{", "{").replace("}}", "}"))
        else:
            text += f"(?P=v{piece})" if piece in seen else f"(?P<v{piece}>.*?)"
            seen.add(piece)
    return text


def templates():
    """Returns the templates of the kernel's messages, which update.py finds in its sources."""
    return TEMPLATES.read_text(encoding="utf-8").splitlines()


def _speaks():
    """Returns whether there is a translation for the user's language."""
    return tr(_WITNESS, CONTEXT) != _WITNESS


_WITNESS = "cannot be read: {0}"
