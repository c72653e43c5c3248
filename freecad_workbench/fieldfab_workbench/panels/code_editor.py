"""Editor for program text with line numbers and underlined mistakes, which is checked while it is typed."""

from ..shim import QtCore, QtGui, QtWidgets

MISTAKE = QtGui.QColor("#c62828")


class LineNumbers(QtWidgets.QWidget):
    """The line number area to the left of the text."""

    def __init__(self, editor):
        super().__init__(editor)
        self.editor = editor

    def paintEvent(self, event):
        self.editor.paint_numbers(event)


class CodeEditor(QtWidgets.QPlainTextEdit):
    """Emits `checked(count, message)` after each check, soon after a change; the message is empty for a valid text.
    Subclasses examine the text."""

    checked = QtCore.Signal(int, str)
    REST = 60  # ms from a change to its check

    def __init__(self, text=""):
        super().__init__()
        font = QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.FixedFont)
        font.setPointSizeF(max(font.pointSizeF(), 10))
        self.setFont(font)
        self.setLineWrapMode(QtWidgets.QPlainTextEdit.NoWrap)
        self.setTabChangesFocus(False)
        self.mistakes, self.message = [], ""  # frep_language.Mistake of each, the line for the panel
        self.numbers = LineNumbers(self)
        self.blockCountChanged.connect(lambda count: self._make_room())
        self.updateRequest.connect(self._follow)
        self.textChanged.connect(self._changed)
        self._timer = QtCore.QTimer(self, singleShot=True, interval=self.REST)
        self._timer.timeout.connect(self.check)
        self._make_room()
        self.prepare()
        self.setPlainText(text)
        self.check()

    def prepare(self):
        """Makes what the subclass needs before the text is there."""

    def examine(self, text):
        """Sets `mistakes` and `message` for a text. Returns the count for `checked`."""
        raise NotImplementedError

    def _changed(self):
        self._timer.start()

    def check(self):
        """Examines the text and marks its mistakes."""
        self._timer.stop()
        count = self.examine(self.toPlainText())
        self.mark()
        self.checked.emit(count, self.message)

    def mark(self):
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

    def insert(self, text):
        """Inserts text at the cursor."""
        self.textCursor().insertText(text)
        self.setFocus()

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
