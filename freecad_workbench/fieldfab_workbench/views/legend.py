"""Legends for colours, in a corner of the 3D view."""

import FreeCADGui

from .. import units
from ..deviations import colours
from ..shim import QtCore, QtGui, QtWidgets
from ..words import tr

LINE = 16  # height of a text line, pixels
EDGE = 12
STRIP = QtCore.QRect(14, 30, 260, 14)


class Legend(QtWidgets.QWidget):
    """A card in the lower left corner of a widget. Clicks pass through it. `close()` removes it."""

    def __init__(self, over, width, height):
        super().__init__(over)
        self.setAttribute(QtCore.Qt.WA_TransparentForMouseEvents)
        self.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self.resize(width, height)
        over.installEventFilter(self)
        self._place()

    def _place(self):
        self.move(EDGE, max(0, self.parentWidget().height() - self.height() - EDGE))

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
        self.paint(painter)

    def paint(self, painter):
        """Draws the contents of the card."""
        raise NotImplementedError


class ReachLegend(Legend):
    """A colour bar over the active 3D view, from `reach` mm at the top to -`reach` at the bottom. Numbers are in the
    user's unit, which replaces {unit} in the title."""

    def __init__(self, title, reach):
        super().__init__(view_widget(), 150, 210)
        self.title, self.reach = title.format(unit=units.shown_unit("mm")), reach
        self.show()
        self.raise_()

    def paint(self, painter):
        painter.drawText(10, 6, self.width() - 20, LINE, QtCore.Qt.AlignLeft, self.title)
        bar = QtCore.QRect(12, 34, 22, self.height() - 48)
        gradient = QtGui.QLinearGradient(0, bar.top(), 0, bar.bottom())
        for share in (i / 16 for i in range(17)):
            gradient.setColorAt(share, QtGui.QColor.fromRgbF(*colours(1 - 2 * share)))
        painter.fillRect(bar, gradient)
        for share in (1, 0.5, 0, -0.5, -1):
            y = bar.top() + (1 - share) / 2 * bar.height()
            word = {1: tr("outside"), -1: tr("inside")}.get(share, "")
            painter.drawLine(bar.right() + 2, int(y), bar.right() + 6, int(y))
            painter.drawText(bar.right() + 10, int(y) - LINE // 2, 110, LINE, QtCore.Qt.AlignVCenter,
                             f"{units.shown(share * self.reach):+.3g} {word}" if share else "0")


class ColourLegend(Legend):
    """A row for each colour, in the upper left corner. `entries`: (colour as three numbers from 0 to 1, text, whether
    the line is dashed)."""

    def __init__(self, over, entries):
        self.entries = entries
        wide = max(over.fontMetrics().horizontalAdvance(words) for _, words, _ in entries)
        super().__init__(over, 62 + wide, 14 + 20 * len(entries))
        self.show()

    def _place(self):
        self.move(EDGE, EDGE)

    def paint(self, painter):
        for row, (colour, words, dashed) in enumerate(self.entries):
            y = 17 + 20 * row
            painter.setPen(QtGui.QPen(QtGui.QColor.fromRgbF(*colour), 2.5,
                                      QtCore.Qt.DashLine if dashed else QtCore.Qt.SolidLine))
            painter.drawLine(12, y, 40, y)
            painter.setPen(QtGui.QColor("#202428"))
            painter.drawText(50, y - LINE // 2 - 1, self.width(), LINE + 2, QtCore.Qt.AlignVCenter, words)


class ScaleLegend(Legend):
    """A strip of the colours of deviations in a simulation. `scale`: gouge, excess and full, mm; `colour(deviation)`:
    red, green, blue."""

    def __init__(self, over, scale, colour):
        super().__init__(over, STRIP.width() + 28, 78)
        self.scale = scale
        self.strip = QtGui.QImage(STRIP.width(), 1, QtGui.QImage.Format_RGB32)
        for x in range(STRIP.width()):
            self.strip.setPixelColor(x, 0, QtGui.QColor(*colour(scale["full"] * (2 * (x + 0.5) / STRIP.width() - 1))))

    def paint(self, painter):
        painter.drawImage(STRIP, self.strip)
        full, title = units.shown(self.scale["full"]), tr("deviation, {unit}").format(unit=units.shown_unit("mm"))
        for y, words in ((8, (tr("gouge"), title, tr("left over"))),
                         (STRIP.bottom() + 6, (f"\N{MINUS SIGN}{full:.4g}", "0", f"+{full:.4g}"))):
            for side, text in zip((QtCore.Qt.AlignLeft, QtCore.Qt.AlignHCenter, QtCore.Qt.AlignRight), words):
                painter.drawText(QtCore.QRect(STRIP.left(), y, STRIP.width(), LINE + 2), side, text)


def view_widget():
    """Returns the widget of the active 3D view."""
    area = FreeCADGui.getMainWindow().centralWidget()
    window = area.activeSubWindow() or (area.subWindowList() or [None])[0]
    found = window.findChild(QtWidgets.QGraphicsView) or window
    found.owners = (area, window)  # PySide treats a widget as deleted without Python references to its parents
    return found
