"""Editor for Python scripts with syntax colours."""

import builtins
import functools
import keyword
import re

from .. import kernel, scripts
from ..frep_language import Mistake
from ..shim import QtGui
from .code_editor import CodeEditor
from .frep_editor import COLOURS

TOKEN = re.compile(r"""(?P<comment>\#.*) | (?P<string>[rbfRBF]{0,2}(?:"(?:\\.|[^"\\])*"?|'(?:\\.|[^'\\])*'?))
    | (?P<number>\b\d[\w.]*) | (?P<name>\b[^\W\d]\w*)""", re.VERBOSE)
TRIPLE = re.compile(r"[rbfRBF]{0,2}(\"\"\"|''')")
KEYWORDS = {*keyword.kwlist, *dir(builtins)}
OUTSIDE, DOUBLE, SINGLE = -1, 0, 1  # states of a line's end: within which triple quotes
QUOTES = ('"""', "'''")


@functools.lru_cache(maxsize=None)
def shapes():
    """Returns the names of the shape library; without a kernel, none."""
    try:
        kernel.load()
        from fieldfab import shapes as library
    except ImportError:
        return frozenset()
    return frozenset(name for name in dir(library) if not name.startswith("_"))


class Highlighter(QtGui.QSyntaxHighlighter):
    def __init__(self, document):
        super().__init__(document)
        self.formats = {}
        for kind, colour in (*((kind, COLOURS[kind]) for kind in ("comment", "string", "number", "function")),
                             ("keyword", COLOURS["constant"])):
            self.formats[kind] = QtGui.QTextCharFormat()
            self.formats[kind].setForeground(QtGui.QColor(colour))
        self.formats["comment"].setFontItalic(True)

    def _colour(self, start, end, kind):
        self.setFormat(start, end - start, self.formats[kind])

    def highlightBlock(self, line):
        at, state = 0, self.previousBlockState()
        while True:
            if state == OUTSIDE:
                at, state = self._plain(line, at)
                if state == OUTSIDE:
                    break
            end = line.find(QUOTES[state], at)
            self._colour(at, len(line) if end < 0 else end + 3, "string")
            if end < 0:
                break
            at, state = end + 3, OUTSIDE
        self.setCurrentBlockState(state)

    def _plain(self, line, at):
        """Colours a line from a place outside of triple quotes. Returns the place behind the next ones, and their
        state; without any, the line's end and OUTSIDE."""
        while at < len(line):
            if triple := TRIPLE.match(line, at):
                self._colour(at, triple.end(), "string")
                return triple.end(), QUOTES.index(triple[1])
            found = TOKEN.match(line, at)
            if not found:
                at += 1
                continue
            kind = found.lastgroup
            if kind == "name":
                kind = "keyword" if found[0] in KEYWORDS else "function" if found[0] in shapes() else ""
            if kind:
                self._colour(found.start(), found.end(), kind)
            at = found.end()
        return len(line), OUTSIDE


class ScriptEditor(CodeEditor):
    """The count of `checked` is 0. Mistakes of a script that ran are shown by `tell`."""

    REST = 400  # each valid text is run

    def prepare(self):
        self.highlighter = Highlighter(self.document())

    def examine(self, text):
        self._set(scripts.mistake(text))
        return 0

    def tell(self, mistake):
        """Marks the line of a scripts.ScriptError until the next check."""
        self._set(mistake)
        self.mark()

    def _set(self, mistake):
        self.message, self.mistakes = str(mistake or ""), []
        block = self.document().findBlockByNumber(mistake.line - 1) if mistake and mistake.line else None
        if block is not None and block.isValid():
            line = block.text()
            start = block.position() + len(line) - len(line.lstrip())
            self.mistakes = [Mistake(start, block.position() + len(line), mistake.line - 1, mistake.words)]
