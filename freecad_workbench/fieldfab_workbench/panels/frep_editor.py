"""The editor of .frep text: colours, completion, what functions mean, line numbers, and the first mistake in its place."""

from .. import frep_language as language
from .. import kernel
from ..shim import QtCore, QtGui, QtWidgets
from ..words import tr

COLOURS = {"comment": "#6a737d", "string": "#8a5a00", "number": "#0b6e4f", "function": "#1f5fae", "constant": "#7a3e9d", "defined": "#a0341f"}
MISTAKE = QtGui.QColor("#c62828")


class Highlighter(QtGui.QSyntaxHighlighter):
    """Colours of the words of a text. `words`: {name: frep_language.Word}."""

    def __init__(self, document):
        super().__init__(document)
        self.words = {}
        self.formats = {}
        for kind, colour in COLOURS.items():
            self.formats[kind] = QtGui.QTextCharFormat()
            self.formats[kind].setForeground(QtGui.QColor(colour))
        self.formats["comment"].setFontItalic(True)

    def highlightBlock(self, line):
        for token in language.TOKEN.finditer(line):
            kind = token.lastgroup
            if kind == "name":
                kind = getattr(self.words.get(token["name"]), "kind", None)
            if kind:
                self.setFormat(token.start(), token.end() - token.start(), self.formats[kind])


class LineNumbers(QtWidgets.QWidget):
    """The strip left of the text."""

    def __init__(self, editor):
        super().__init__(editor)
        self.editor = editor

    def paintEvent(self, event):
        self.editor.paint_numbers(event)


class FrepEditor(QtWidgets.QPlainTextEdit):
    """`checked(node_count, message)` is emitted after each check; the message is empty where the text is in order."""

    checked = QtCore.Signal(int, str)

    def __init__(self, text=""):
        super().__init__()
        font = QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.FixedFont)
        font.setPointSizeF(max(font.pointSizeF(), 10))
        self.setFont(font)
        self.setLineWrapMode(QtWidgets.QPlainTextEdit.NoWrap)
        self.setTabChangesFocus(False)
        self.known = {**language.library(), **language.constants()}
        self.words, self.mistake = self.known, None  # mistake: (line, column, message)
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

    # What is wrong, and what there is.
    def _changed(self):
        self._timer.start()

    def check(self):
        """Reads the text; marks the first mistake."""
        fieldfab, text = kernel.load(), self.toPlainText()
        count, self.mistake = 0, None
        try:
            count = fieldfab.parse(text).node_count()
        except fieldfab.Error as error:
            line, column = language.place_of(error) or (0, 0)
            said = str(error)
            self.mistake = (line, column, said[len(error.place) + 2:] if error.place and said.startswith(error.place) else said)
        self._take_words({**self.known, **language.defined(text)})
        self._mark()
        self.checked.emit(count, tr("Line {line}: {words}").format(line=self.mistake[0] + 1, words=self.mistake[2]) if self.mistake else "")

    def _take_words(self, words):
        if {n: w.kind for n, w in words.items()} != {n: w.kind for n, w in self.highlighter.words.items()}:
            self.highlighter.words = words
            self.blockSignals(True)  # colours are no change of the text
            self.highlighter.rehighlight()
            self.blockSignals(False)
        self.words = words

    def _mark(self):
        """Underlines the word that a mistake begins at, or the character before it where it is the end of the line."""
        marks = []
        if self.mistake:
            line, column, _ = self.mistake
            block = self.document().findBlockByNumber(min(line, self.blockCount() - 1))
            text = block.text()
            start = min(len(text.encode()[:column].decode(errors="ignore")), max(0, len(text) - 1))
            length = max(1, len(language.word_at(text, start)))
            wave = QtWidgets.QTextEdit.ExtraSelection()
            wave.cursor = QtGui.QTextCursor(block)
            wave.cursor.setPosition(block.position() + start)
            wave.cursor.setPosition(block.position() + min(start + length, len(text)), QtGui.QTextCursor.KeepAnchor)
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

    def word_under_cursor(self):
        """The beginning of the name before the cursor."""
        cursor = self.textCursor()
        return language.word_before(cursor.block().text()[:cursor.positionInBlock()])

    def complete(self, asked=False):
        """Shows the names that begin like the one before the cursor; asked for, also where there is none yet."""
        start = self.word_under_cursor()
        self.words = {**self.known, **language.defined(self.toPlainText())}
        fitting = [word for name, word in sorted(self.words.items()) if name.lower().startswith(start.lower()) and name != start]
        if not fitting or not (asked or len(start) > 1):
            self.popup.popup().hide()
            return
        model = self.popup.model()
        model.clear()
        for word in fitting:
            item = QtGui.QStandardItem(word.signature)
            item.setData(word.name, QtCore.Qt.UserRole)
            item.setToolTip(word.meaning)
            item.setForeground(QtGui.QColor(COLOURS[word.kind]))
            model.appendRow(item)
        self.popup.setCompletionPrefix(start)
        place = self.cursorRect().translated(self.viewport().pos())
        place.setWidth(min(460, self.popup.popup().sizeHintForColumn(0) + 40))
        self.popup.complete(place)
        self.popup.popup().setCurrentIndex(self.popup.completionModel().index(0, 0))

    def _insert_completion(self, index):
        """Puts the chosen name where its beginning stands; the cursor goes between the parentheses of a function."""
        word, cursor = self.words[index.data(QtCore.Qt.UserRole)], self.textCursor()
        cursor.movePosition(QtGui.QTextCursor.Left, QtGui.QTextCursor.KeepAnchor, len(self.word_under_cursor()))
        calls = "(" in word.signature and not cursor.block().text()[self.textCursor().positionInBlock():].startswith("(")
        cursor.insertText(word.name + "()" * calls)
        if calls:
            cursor.movePosition(QtGui.QTextCursor.Left)
        self.setTextCursor(cursor)

    def insert(self, text):
        """Puts text where the cursor is."""
        self.textCursor().insertText(text)
        self.setFocus()

    # Qt.
    def keyPressEvent(self, event):
        keys, shown = QtCore.Qt, self.popup.popup().isVisible()
        if shown and event.key() in (keys.Key_Enter, keys.Key_Return, keys.Key_Tab, keys.Key_Escape, keys.Key_Backtab):
            event.ignore()  # the popup's
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
        """What the word at a cursor means, or the mistake of its line."""
        word = self.words.get(language.word_at(cursor.block().text(), cursor.positionInBlock()))
        if word is None:
            return self.mistake[2] if self.mistake and self.mistake[0] == cursor.blockNumber() else ""
        example = f"<br><code>{word.example}</code>" if word.example else ""
        return f"<b>{word.signature}</b><br>{word.meaning}{example}"

    # Line numbers.
    def _width(self):
        return 16 + self.fontMetrics().horizontalAdvance("9") * max(2, len(str(self.blockCount())))

    def _make_room(self):
        self.setViewportMargins(self._width(), 0, 0, 0)

    def _follow(self, rectangle, dy):
        self.numbers.scroll(0, dy) if dy else self.numbers.update(0, rectangle.y(), self.numbers.width(), rectangle.height())

    def resizeEvent(self, event):
        super().resizeEvent(event)
        inside = self.contentsRect()
        self.numbers.setGeometry(inside.left(), inside.top(), self._width(), inside.height())

    def paint_numbers(self, event):
        painter, block = QtGui.QPainter(self.numbers), self.firstVisibleBlock()
        painter.fillRect(event.rect(), self.palette().alternateBase())
        painter.setFont(self.font())
        top = self.blockBoundingGeometry(block).translated(self.contentOffset()).top()
        while block.isValid() and top <= event.rect().bottom():
            height, wrong = self.blockBoundingRect(block).height(), self.mistake and self.mistake[0] == block.blockNumber()
            if wrong:
                painter.fillRect(0, round(top), self.numbers.width(), round(height), MISTAKE)
            painter.setPen(QtCore.Qt.white if wrong else self.palette().color(QtGui.QPalette.Disabled, QtGui.QPalette.Text))
            painter.drawText(0, round(top), self.numbers.width() - 6, round(height), QtCore.Qt.AlignRight, str(block.blockNumber() + 1))
            top, block = top + height, block.next()
