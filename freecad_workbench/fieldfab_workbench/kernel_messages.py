"""The kernel's messages in the user's language. The kernel makes them in English from templates, such as
"{0}: there is nothing left to cut"; a message is matched with the templates, and its values are filled into the
translation of the one that fits best."""

import functools
import pathlib
import re

from .words import tr

CONTEXT = "Kernel: message"
# Found by update.py in the kernel's sources.
TEMPLATES = pathlib.Path(__file__).resolve().parents[1] / "resources" / "translations" / "messages.txt"
_FIELD = re.compile(r"\{(\d+)\}")
_FILLED = re.compile(r"\{\{|\}\}|" + _FIELD.pattern)  # what is replaced in a translation


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
    return _FILLED.sub(lambda part: values[f"v{part[1]}"] if part[1] else part[0][0], tr(template, CONTEXT))


@functools.lru_cache(1)
def _patterns():
    """[(template, its words between the values, its regular expression)]."""
    return [(template, *_parts(template)) for template in TEMPLATES.read_text(encoding="utf-8").splitlines()]


def _parts(template):
    """Returns the words between a template's values, and its regular expression."""
    words, names = _FIELD.split(template)[::2], _FIELD.split(template)[1::2]
    words = [each.replace("{{", "{").replace("}}", "}") for each in words]
    values = [f"(?P=v{name})" if name in names[:place] else f"(?P<v{name}>.*?)" for place, name in enumerate(names)]
    pattern = "".join(re.escape(word) + value for word, value in zip(words, [*values, ""]))
    return words, re.compile(pattern, re.DOTALL)


def _speaks():
    """Returns whether there is a translation for the user's language."""
    return tr(_WITNESS, CONTEXT) != _WITNESS


_WITNESS = "cannot be read: {0}"
