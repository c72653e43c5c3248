"""A program's text, of any length: only the lines that are seen are looked at."""

from ..shim import QtCore, QtGui, QtWidgets


class Lines(QtCore.QAbstractListModel):
    def __init__(self, lines, parent):
        super().__init__(parent)
        self.lines, self.digits = lines, len(str(len(lines)))

    def rowCount(self, parent=QtCore.QModelIndex()):
        return 0 if parent.isValid() else len(self.lines)

    def data(self, index, role=QtCore.Qt.DisplayRole):
        return f"{index.row() + 1:>{self.digits}}  {self.lines[index.row()].expandtabs()}" if role == QtCore.Qt.DisplayRole else None


class ProgramView(QtWidgets.QListView):
    """Marks the current line; a click on another one asks to go there (`asked`, the line from 1)."""

    asked = QtCore.Signal(int)

    def __init__(self):
        super().__init__()
        self.setFont(QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.FixedFont))
        self.setUniformItemSizes(True)
        self.setEditTriggers(self.NoEditTriggers)
        self.setStyleSheet("QListView::item:selected { background: #ffe08a; color: #1d1d1f }")
        self.setToolTip("The program. Click a line to go to where it is done")
        self.clicked.connect(lambda index: self.asked.emit(index.row() + 1))

    def set_lines(self, lines):
        self.setModel(Lines(lines, self))

    def line(self):
        """The marked line, from 1; 0: none."""
        return self.currentIndex().row() + 1

    def mark(self, line):
        index = self.model().index(line - 1, 0) if self.model() else QtCore.QModelIndex()
        if not index.isValid() or index == self.currentIndex():
            return
        self.setCurrentIndex(index)
        rows = self.viewport().height() // max(1, self.visualRect(index).height() or self.sizeHintForRow(0))
        shown = self.indexAt(QtCore.QPoint(4, 4)).row()
        if not shown + 1 <= index.row() < shown + rows - 2:  # it moves on by pages, not line by line
            self.scrollTo(index, self.PositionAtCenter)

    def sizeHint(self):
        return QtCore.QSize(300, 90)  # more where there is room
