"""The kernel's grammar of .frep text for an editor. Positions are in UTF-16 units, as in Qt. Needs no window."""

from bisect import bisect_right
from dataclasses import dataclass
from itertools import accumulate

from . import kernel
from .kernel_messages import translated
from .words import marked, tr

MEANINGS = marked(("the first coordinate, mm", "the second coordinate, mm", "the third coordinate, mm",
                   "exact distance", "never more than the distance"))


def grammar():
    """Returns the kernel's language functions. Raises ImportError without a kernel."""
    return kernel.load().language


class Places:
    """A text as UTF-8 for the kernel, with conversion of its positions from bytes to UTF-16 units."""

    def __init__(self, text):
        self.data = text.encode("utf-8", "replace")  # half of a surrogate pair becomes one byte
        self._same = len(self.data) == len(text)
        if not self._same:
            self._bytes = [0, *accumulate(len(c.encode("utf-8", "replace")) for c in text)]
            self._units = [0, *accumulate(1 + (ord(c) > 0xFFFF) for c in text)]

    def unit(self, byte):
        return byte if self._same else self._units[bisect_right(self._bytes, byte) - 1]

    def byte(self, unit):
        return unit if self._same else self._bytes[bisect_right(self._units, unit) - 1]

    def span(self, thing):
        """Returns the start and the end of a token, a mistake or a completion."""
        return self.unit(thing.offset), self.unit(thing.offset + thing.length)


@dataclass
class Mistake:
    start: int
    end: int  # equals the start if a token is missing
    line: int  # from 0
    message: str


def tokens(text):
    """Returns (kind, start, end, text) of each token."""
    places = Places(text)
    return [(t.kind, *places.span(t), places.data[t.offset:t.offset + t.length].decode("utf-8", "replace"))
            for t in grammar().tokens(places.data)]


def parameters(text):
    """Returns the text's named numbers in order: {name: fieldfab.language.Parameter}."""
    return {each.name: each for each in grammar().parameters(Places(text).data)}


def with_values(text, values):
    """Returns the text with new numbers for its parameters."""
    return grammar().with_values(Places(text).data, values)


def mistakes(text):
    places = Places(text)
    return [Mistake(*places.span(each), each.line - 1, translated(each.message))
            for each in grammar().diagnostics(places.data)]


def words(text=""):
    """Returns all names that a text can use: {name: fieldfab.language.Word}."""
    return {word.name: word for word in grammar().words(Places(text).data)}


def meaning(kernels):
    """Returns the kernel's description of a word, translated if it is one of the kernel's fixed texts."""
    return " · ".join(tr(each) for each in kernels.split(" · "))


def completions(text, at):
    """Returns the start of the name before a position, and the matching completions (fieldfab.language.Completion)."""
    places = Places(text)
    fitting = grammar().completions(places.data, places.byte(at))
    return places.unit(fitting.offset), fitting.entries


def word_at(text, at):
    """Returns the word at a position, or None."""
    places = Places(text)
    return grammar().word_at(places.data, places.byte(at))
