"""Editor for .frep text with syntax colours, completion, help on names, line numbers and underlined mistakes."""

from html import escape

from .. import frep_language as language
from .. import kernel
from ..shim import QtCore, QtGui, QtWidgets
from ..words import tr

COLOURS = {"comment": "#6a737d", "string": "#8a5a00", "number": "#0b6e4f", "function": "#1f5fae", "constant": "#7a3e9d",
           "variable": "#a0341f",
           "parameter": "#00695c", "option": "#00695c", "colour": "#8a5a00"}
MISTAKE = QtGui.QColor("#c62828")
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


class LineNumbers(QtWidgets.QWidget):
    """The line number area to the left of the text."""

    def __init__(self, editor):
        super().__init__(editor)
        self.editor = editor

    def paintEvent(self, event):
        self.editor.paint_numbers(event)


class FrepEditor(QtWidgets.QPlainTextEdit):
    """Emits `checked(node_count, message)` after each check; the message is empty for a valid text. Without a kernel
    the message is the reason, and the editor has no colours, completion or help."""

    checked = QtCore.Signal(int, str)

    def __init__(self, text=""):
        super().__init__()
        font = QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.FixedFont)
        font.setPointSizeF(max(font.pointSizeF(), 10))
        self.setFont(font)
        self.setLineWrapMode(QtWidgets.QPlainTextEdit.NoWrap)
        self.setTabChangesFocus(False)
        self.mistakes, self.message = [], ""
        self.highlighter = Highlighter(self.document())
        self.numbers = LineNumbers(self)
        self.popup = self._completer()
        self.blockCountChanged.connect(lambda count: self._make_room())
        self.updateRequest.connect(self._follow)
        self.textChanged.connect(self._changed)
        self._timer = QtCore.QTimer(self, singleShot=True, interval=60)
        self._timer.timeout.connect(self.check)
        self._make_room()
        self.setPlainText(text)
        self.check()

    # Check and colours.
    def _changed(self):
        self._timer.start()

    def check(self):
        """Parses the text and marks its mistakes."""
        text, count = self.toPlainText(), 0
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
        self._mark()
        self.checked.emit(count, self.message)

    def _colour(self, kinds):
        if kinds != self.highlighter.kinds:
            self.highlighter.kinds = kinds
            self.blockSignals(True)  # a change of colours is not a change of the text
            self.highlighter.rehighlight()
            self.blockSignals(False)

    def _mark(self):
        """Underlines each mistake. If a token is missing, underlines the preceding character."""
        marks = []
        for mistake in self.mistakes:
            wave = QtWidgets.QTextEdit.ExtraSelection()
            wave.cursor = QtGui.QTextCursor(self.document())
            wave.cursor.setPosition(mistake.start)
            wave.cursor.setPosition(mistake.end, QtGui.QTextCursor.KeepAnchor)
            if mistake.start == mistake.end and not wave.cursor.atBlockStart():
                wave.cursor.movePosition(QtGui.QTextCursor.Left, QtGui.QTextCursor.KeepAnchor)
            wave.format.setUnderlineStyle(QtGui.QTextCharFormat.WaveUnderline)
            wave.format.setUnderlineColor(MISTAKE)
            wave.format.setBackground(QtGui.QColor(255, 205, 205))
            marks.append(wave)
        self.setExtraSelections(marks)
        self.numbers.update()

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

    def insert(self, text):
        """Inserts text at the cursor."""
        self.textCursor().insertText(text)
        self.setFocus()

    # Overrides of Qt methods.
    def keyPressEvent(self, event):
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

    # Line numbers.
    def _width(self):
        return 16 + self.fontMetrics().horizontalAdvance("9") * max(2, len(str(self.blockCount())))

    def _make_room(self):
        self.setViewportMargins(self._width(), 0, 0, 0)

    def _follow(self, rectangle, dy):
        (self.numbers.scroll(0, dy) if dy
         else self.numbers.update(0, rectangle.y(), self.numbers.width(), rectangle.height()))

    def resizeEvent(self, event):
        super().resizeEvent(event)
        inside = self.contentsRect()
        self.numbers.setGeometry(inside.left(), inside.top(), self._width(), inside.height())

    def paint_numbers(self, event):
        painter, block, lines = (QtGui.QPainter(self.numbers), self.firstVisibleBlock(),
                                 {mistake.line for mistake in self.mistakes})
        painter.fillRect(event.rect(), self.palette().alternateBase())
        painter.setFont(self.font())
        top = self.blockBoundingGeometry(block).translated(self.contentOffset()).top()
        while block.isValid() and top <= event.rect().bottom():
            height, wrong = self.blockBoundingRect(block).height(), block.blockNumber() in lines
            if wrong:
                painter.fillRect(0, round(top), self.numbers.width(), round(height), MISTAKE)
            painter.setPen(QtCore.Qt.white if wrong
                           else self.palette().color(QtGui.QPalette.Disabled, QtGui.QPalette.Text))
            painter.drawText(0, round(top), self.numbers.width() - 6, round(height), QtCore.Qt.AlignRight,
                             str(block.blockNumber() + 1))
            top, block = top + height, block.next()
