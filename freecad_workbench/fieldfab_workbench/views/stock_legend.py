"""What the colours of deviations mean, over the 3D view."""

from ..shim import QtCore, QtGui, QtWidgets

BAR = QtCore.QRect(14, 30, 260, 14)


class DeviationLegend(QtWidgets.QWidget):
    """A strip of colours with its numbers in a corner of a widget. `scale`: gouge, excess and full, mm; `colour(deviation)`: red, green, blue."""

    def __init__(self, over, scale, colour):
        super().__init__(over)
        self.scale = scale
        self.strip = QtGui.QImage(BAR.width(), 1, QtGui.QImage.Format_RGB32)
        for x in range(BAR.width()):
            self.strip.setPixelColor(x, 0, QtGui.QColor(*colour(scale["full"] * (2 * (x + 0.5) / BAR.width() - 1))))
        self.setObjectName("FieldfabDeviationLegend")
        self.setAttribute(QtCore.Qt.WA_TransparentForMouseEvents)
        self.resize(BAR.width() + 28, 78)
        over.installEventFilter(self)
        self._place()

    def remove(self):
        self.parent().removeEventFilter(self)
        self.hide()
        self.deleteLater()

    def eventFilter(self, watched, event):
        if event.type() == QtCore.QEvent.Resize:
            self._place()
        return False

    def _place(self):
        self.move(16, max(0, self.parent().height() - self.height() - 16))

    def paintEvent(self, event):
        painter, full = QtGui.QPainter(self), self.scale["full"]
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.setPen(QtCore.Qt.NoPen)
        painter.setBrush(QtGui.QColor(250, 250, 252, 225))
        painter.drawRoundedRect(self.rect(), 6, 6)
        painter.drawImage(BAR, self.strip)
        painter.setPen(QtGui.QColor(40, 44, 52))
        words = QtCore.QRect(BAR.left(), 8, BAR.width(), 18)
        for side, text in ((QtCore.Qt.AlignLeft, "gouge"), (QtCore.Qt.AlignHCenter, "deviation, mm"), (QtCore.Qt.AlignRight, "left over")):
            painter.drawText(words, side, text)
        numbers = QtCore.QRect(BAR.left(), BAR.bottom() + 6, BAR.width(), 18)
        for side, text in ((QtCore.Qt.AlignLeft, f"\N{MINUS SIGN}{full:g}"), (QtCore.Qt.AlignHCenter, "0"), (QtCore.Qt.AlignRight, f"+{full:g}")):
            painter.drawText(numbers, side, text)
