"""A legend of colours over the 3D view."""

import FreeCADGui

from ..deviations import colours
from ..shim import QtCore, QtGui, QtWidgets

LINE = 16


class Legend(QtWidgets.QWidget):
    """A bar from `reach` at the top to -`reach` at its foot, mm, in the active 3D view's left lower corner. `close()` takes it away."""

    def __init__(self, title, reach, words=("outside", "inside")):
        super().__init__(view_widget())
        self.title, self.reach, self.words = title, reach, words
        self.setAttribute(QtCore.Qt.WA_TransparentForMouseEvents)
        self.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self.resize(150, 210)
        self.parentWidget().installEventFilter(self)
        self._place()
        self.show()
        self.raise_()

    def _place(self):
        self.move(12, self.parentWidget().height() - self.height() - 12)

    def eventFilter(self, watched, event):
        if event.type() == QtCore.QEvent.Resize:
            self._place()
        return False

    def paintEvent(self, event):
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.setPen(QtCore.Qt.NoPen)
        painter.setBrush(QtGui.QColor(250, 250, 252, 235))
        painter.drawRoundedRect(self.rect(), 6, 6)
        painter.setPen(QtGui.QColor("#202428"))
        painter.drawText(10, 6, self.width() - 20, LINE, QtCore.Qt.AlignLeft, self.title)
        bar = QtCore.QRect(12, 34, 22, self.height() - 48)
        gradient = QtGui.QLinearGradient(0, bar.top(), 0, bar.bottom())
        for share in (i / 16 for i in range(17)):
            gradient.setColorAt(share, QtGui.QColor.fromRgbF(*colours(1 - 2 * share)))
        painter.fillRect(bar, gradient)
        for share in (1, 0.5, 0, -0.5, -1):
            y = bar.top() + (1 - share) / 2 * bar.height()
            word = {1: self.words[0], -1: self.words[1]}.get(share, "")
            painter.drawLine(bar.right() + 2, int(y), bar.right() + 6, int(y))
            painter.drawText(bar.right() + 10, int(y) - LINE // 2, 110, LINE, QtCore.Qt.AlignVCenter, f"{share * self.reach:+.3g} {word}" if share else "0")


def view_widget():
    """The widget of the active 3D view."""
    area = FreeCADGui.getMainWindow().centralWidget()
    window = area.activeSubWindow() or (area.subWindowList() or [None])[0]
    return window.findChild(QtWidgets.QGraphicsView) or window
