"""The kernel's grammar of .frep text, for a window: places are counted in UTF-16 units, as Qt does. Needs no window
itself."""

from bisect import bisect_right
from dataclasses import dataclass
from itertools import accumulate

from . import kernel
from .words import marked, tr

MEANINGS = marked(("the first coordinate, mm", "the second coordinate, mm", "the third coordinate, mm",
                   "exact distance", "never more than the distance"))


def grammar():
    """The kernel's functions. Raises ImportError without a kernel."""
    return kernel.load().language


class Places:
    """A text as the kernel takes it, and its places: bytes of UTF-8 there, UTF-16 units here."""

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
        """Where a token, a mistake or a completion begins and ends."""
        return self.unit(thing.offset), self.unit(thing.offset + thing.length)


@dataclass
class Mistake:
    start: int
    end: int  # the start where something is missing
    line: int  # from 0
    message: str


def tokens(text):
    """(kind, start, end, the token) of each token."""
    places = Places(text)
    return [(t.kind, *places.span(t), places.data[t.offset:t.offset + t.length].decode("utf-8", "replace"))
            for t in grammar().tokens(places.data)]


def parameters(text):
    """The numbers that a text names, in its order: {name: fieldfab.language.Parameter}."""
    return {each.name: each for each in grammar().parameters(Places(text).data)}


def with_values(text, values):
    """The text with other numbers for its parameters."""
    return grammar().with_values(Places(text).data, values)


def mistakes(text):
    places = Places(text)
    return [Mistake(*places.span(each), each.line - 1, each.message) for each in grammar().diagnostics(places.data)]


def words(text=""):
    """All names that a text can use: {name: fieldfab.language.Word}."""
    return {word.name: word for word in grammar().words(Places(text).data)}


def meaning(kernels):
    """The kernel's words for a meaning, in the user's language where they are its standing ones."""
    return " · ".join(tr(each) for each in kernels.split(" · "))


def completions(text, at):
    """Where the name before a place begins, and what fits there: fieldfab.language.Completion each."""
    places = Places(text)
    fitting = grammar().completions(places.data, places.byte(at))
    return places.unit(fitting.offset), fitting.entries


def word_at(text, at):
    """The word at a place, or None."""
    places = Places(text)
    return grammar().word_at(places.data, places.byte(at))
