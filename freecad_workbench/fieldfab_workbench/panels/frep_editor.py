"""Editor for .frep text with syntax colours, completion and help on names."""

import time
from html import escape

from .. import frep_language as language
from .. import kernel
from ..shim import QtCore, QtGui, QtWidgets
from ..words import tr
from .code_editor import CodeEditor

COLOURS = {"comment": "#6a737d", "string": "#8a5a00", "number": "#0b6e4f", "function": "#1f5fae", "constant": "#7a3e9d",
           "variable": "#a0341f",
           "parameter": "#00695c", "option": "#00695c", "colour": "#8a5a00"}
TYPING = 1.0  # s after a key in which the focus is not given away
INSERTED = QtCore.Qt.UserRole + 1  # item role: the text that a completion inserts


class Highlighter(QtGui.QSyntaxHighlighter):
    """Syntax colours. `kinds`: {name: kind}, or None (without a kernel) for no colours."""

    def __init__(self, document):
        super().__init__(document)
        self.kinds = None
        self.formats = {}
        for kind, colour in COLOURS.items():
            self.formats[kind] = QtGui.QTextCharFormat()
            self.formats[kind].setForeground(QtGui.QColor(colour))
        self.formats["comment"].setFontItalic(True)

    def highlightBlock(self, line):
        for kind, start, end, name in [] if self.kinds is None else language.tokens(line):
            found = self.formats.get(self.kinds.get(name) if kind == "name" else kind)
            if found:
                self.setFormat(start, end - start, found)


class FrepEditor(CodeEditor):
    """The count of `checked` is the number of nodes. Without a kernel the message is the reason, and the editor has no
    colours, completion or help."""

    def prepare(self):
        self.highlighter = Highlighter(self.document())
        self.popup = self._completer()
        self._typed = 0.0  # time of the last key

    # Check and colours.
    def examine(self, text):
        count = 0
        try:
            self.mistakes, self.message = language.mistakes(text), ""
            count = 0 if self.mistakes else kernel.load().parse(text).node_count()
            self._colour({name: word.kind for name, word in language.words(text).items()})
        except ImportError as error:
            self.mistakes, self.message = [], str(error)
        if self.mistakes:
            first, more = self.mistakes[0], len(self.mistakes) - 1
            form = tr("Line {line}: {words} (and {count} more)") if more else tr("Line {line}: {words}")
            self.message = form.format(line=first.line + 1, words=first.message, count=more)
        return count

    def _colour(self, kinds):
        if kinds != self.highlighter.kinds:
            self.highlighter.kinds = kinds
            self.blockSignals(True)  # a change of colours is not a change of the text
            self.highlighter.rehighlight()
            self.blockSignals(False)

    # Completion.
    def _completer(self):
        popup = QtWidgets.QCompleter(self)
        popup.setWidget(self)
        popup.setModel(QtGui.QStandardItemModel(popup))
        popup.setCompletionMode(QtWidgets.QCompleter.PopupCompletion)
        popup.setCaseSensitivity(QtCore.Qt.CaseInsensitive)
        popup.setFilterMode(QtCore.Qt.MatchStartsWith)
        popup.setCompletionRole(QtCore.Qt.UserRole)
        popup.setMaxVisibleItems(12)
        popup.activated[QtCore.QModelIndex].connect(self._insert_completion)
        popup.popup().setFont(self.font())
        return popup

    def complete(self, asked=False):
        """Shows completions for the name before the cursor. `asked`: on request, even without a name before the
        cursor."""
        text, at = self.toPlainText(), self.textCursor().position()
        try:
            self.completed_from, entries = language.completions(text, at)
        except ImportError:
            return
        cursor = self.textCursor()
        cursor.setPosition(self.completed_from, QtGui.QTextCursor.KeepAnchor)
        start = cursor.selectedText()
        fitting = [entry for entry in entries if entry.name != start or entry.insert.endswith("= ")]
        if not fitting or not (asked or len(start) > 1):
            self.popup.popup().hide()
            return
        model = self.popup.model()
        model.clear()
        for entry in fitting:
            item = QtGui.QStandardItem(entry.signature)
            item.setData(entry.name, QtCore.Qt.UserRole)
            item.setData(entry.insert, INSERTED)
            item.setToolTip(language.meaning(entry.meaning))
            item.setForeground(QtGui.QColor(COLOURS[entry.kind]))
            model.appendRow(item)
        self.popup.setCompletionPrefix(start)
        place = self.cursorRect().translated(self.viewport().pos())
        place.setWidth(min(460, self.popup.popup().sizeHintForColumn(0) + 40))
        self.popup.complete(place)
        self.popup.popup().setCurrentIndex(self.popup.completionModel().index(0, 0))

    def _insert_completion(self, index):
        """Replaces the beginning of the name by the chosen completion. For a function, places the cursor between the
        parentheses."""
        inserted, cursor = index.data(INSERTED), self.textCursor()
        cursor.setPosition(self.completed_from, QtGui.QTextCursor.KeepAnchor)
        cursor.insertText(inserted)
        if inserted.endswith("()"):
            cursor.movePosition(QtGui.QTextCursor.Left)
        self.setTextCursor(cursor)

    # Overrides of Qt methods.
    def keyPressEvent(self, event):
        self._typed = time.monotonic()
        keys, shown = QtCore.Qt, self.popup.popup().isVisible()
        if shown and event.key() in (keys.Key_Enter, keys.Key_Return, keys.Key_Tab, keys.Key_Escape, keys.Key_Backtab):
            event.ignore()  # handled by the popup
            return
        if event.key() == keys.Key_Space and event.modifiers() & keys.ControlModifier:
            self.complete(asked=True)
            return
        super().keyPressEvent(event)
        if event.text().isidentifier() or event.text().isdigit() or (shown and event.key() == keys.Key_Backspace):
            self.complete()
        elif event.text():
            self.popup.popup().hide()

    def focusOutEvent(self, event):
        """Takes the focus back while the user types. In Qt 6 on X11 a completion's popup becomes the active window,
        and FreeCAD's, when it is active again, gives the focus to the 3D view."""
        super().focusOutEvent(event)
        if event.reason() == QtCore.Qt.OtherFocusReason and time.monotonic() - self._typed < TYPING:
            self.setFocus()

    def event(self, event):
        if event.type() == QtCore.QEvent.ToolTip:
            at = self.viewport().mapFromGlobal(event.globalPos())
            words = self.help_at(self.cursorForPosition(at))
            QtWidgets.QToolTip.showText(event.globalPos(), words, self) if words else QtWidgets.QToolTip.hideText()
            return True
        return super().event(event)

    def help_at(self, cursor):
        """Returns the mistake at a cursor, otherwise the help on its word, otherwise the mistakes of its line."""
        at, line = cursor.position(), cursor.blockNumber()
        here = [m.message for m in self.mistakes if m.start <= at < m.end]
        try:
            word = None if here else language.word_at(self.toPlainText(), at)
        except ImportError:
            return ""
        if word is None:
            return "<br>".join(escape(m) for m in here or [m.message for m in self.mistakes if m.line == line])
        example = f"<br><code>{escape(word.example)}</code>" if word.example else ""
        return f"<b>{escape(word.signature)}</b><br>{escape(language.meaning(word.meaning))}{example}"
