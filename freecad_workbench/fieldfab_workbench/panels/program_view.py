"""View of a program's text of any length: only visible lines are rendered."""

from ..shim import QtCore, QtGui, QtWidgets
from ..words import tr


class Lines(QtCore.QAbstractTableModel):
    """A model with one column: the lines with their numbers."""

    def __init__(self, lines, parent):
        super().__init__(parent)
        self.lines, self.digits = lines, len(str(len(lines)))

    def rowCount(self, parent=QtCore.QModelIndex()):
        return 0 if parent.isValid() else len(self.lines)

    def columnCount(self, parent=QtCore.QModelIndex()):
        return 1

    def data(self, index, role=QtCore.Qt.DisplayRole):
        return (f"{index.row() + 1:>{self.digits}}  {self.lines[index.row()].expandtabs()}"
                if role == QtCore.Qt.DisplayRole else None)


class ProgramView(QtWidgets.QTableView):  # a list view would lay out every line
    """Marks the current line. A click on another line emits `asked` with its number, from 1."""

    asked = QtCore.Signal(int)

    def __init__(self):
        super().__init__()
        self.setFont(QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.FixedFont))
        self.horizontalHeader().hide()
        self.verticalHeader().hide()
        self.verticalHeader().setSectionResizeMode(QtWidgets.QHeaderView.Fixed)
        self.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 1)
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.setSelectionMode(QtWidgets.QAbstractItemView.SingleSelection)
        self.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.setStyleSheet("QTableView::item:selected { background: #ffe08a; color: #1d1d1f }")
        self.text_width = 0
        self.setToolTip(tr("The program. Click a line to go to its moment"))
        self.clicked.connect(lambda index: self.asked.emit(index.row() + 1))

    def set_lines(self, lines):
        self.setModel(Lines(lines, self))
        longest = max(map(len, lines), default=0) + len(str(len(lines))) + 4
        self.text_width = min(longest, 400) * self.fontMetrics().averageCharWidth()
        self.resizeEvent(None)

    def resizeEvent(self, event):
        if event is not None:
            super().resizeEvent(event)
        self.setColumnWidth(0, max(self.text_width, self.viewport().width()))

    def line(self):
        """Returns the number of the marked line, from 1, or 0 for none."""
        return self.currentIndex().row() + 1

    def mark(self, line):
        index = self.model().index(line - 1, 0) if self.model() else QtCore.QModelIndex()
        if not index.isValid() or index == self.currentIndex():
            return
        seen = range(self.rowAt(0), max(self.rowAt(self.viewport().height() - 1), 0))
        self.setCurrentIndex(index)
        if index.row() not in seen:  # scroll by pages, not line by line
            self.scrollTo(index, QtWidgets.QAbstractItemView.PositionAtCenter)

    def sizeHint(self):
        return QtCore.QSize(300, 90)  # grows with the available room
