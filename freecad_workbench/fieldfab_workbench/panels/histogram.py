"""Histogram of densities with a draggable threshold."""

import numpy as np

from ..shim import QtCore, QtGui, QtWidgets
from ..words import tr

MARGIN = 8


class Histogram(QtWidgets.QWidget):
    """Counts on a logarithmic scale: blue where the volume is solid, otherwise grey. `dragged` emits the density under
    the mouse."""

    dragged = QtCore.Signal(float)

    def __init__(self):
        super().__init__()
        self.setMinimumHeight(120)
        self.setCursor(QtCore.Qt.SplitHCursor)
        self.setToolTip(
            tr("Histogram of the densities, on a logarithmic scale. Drag the line to move the threshold"))
        self.counts, self.edges, self.threshold, self.below, self.enabled = [], [0.0, 1.0], 0.5, False, False

    def set_densities(self, counts, edges):
        """Sets the counts of n bins, and their n + 1 edges."""
        self.counts, self.edges, self.enabled = np.asarray(counts), edges, True
        self.update()

    def set_threshold(self, threshold, below):
        self.threshold, self.below = threshold, below
        self.update()

    def _area(self):
        return QtCore.QRectF(self.rect()).adjusted(MARGIN, 4, -MARGIN, -16)

    def place_of(self, density):
        """Returns the x coordinate of a density in the widget."""
        low, high = self.edges[0], self.edges[-1]
        return self._area().left() + (density - low) / (high - low) * self._area().width()

    def density_at(self, x):
        share = (x - self._area().left()) / self._area().width()
        low, high = self.edges[0], self.edges[-1]
        return low + min(max(share, 0.0), 1.0) * (high - low)

    def columns(self):
        """Returns the height of each pixel column, 0 to 1."""
        width = max(1, int(self._area().width()))
        if not len(self.counts):
            return np.zeros(width)
        first = (np.arange(width) * len(self.counts)) // width
        last = np.maximum(first + 1, (np.arange(1, width + 1) * len(self.counts)) // width)
        most = np.array([self.counts[a:b].max() for a, b in zip(first, last)])
        heights = np.log1p(most)
        return heights / max(heights.max(), 1e-30)

    def paintEvent(self, event):
        painter, area = QtGui.QPainter(self), self._area()
        palette = self.palette()
        painter.fillRect(area, palette.base())
        solid, air = QtGui.QColor("#4d90d6"), QtGui.QColor("#a8adb3")
        line = self.place_of(self.threshold)
        for i, height in enumerate(self.columns()):
            x = area.left() + i + 0.5
            painter.setPen(solid if (x >= line) != self.below else air)
            painter.drawLine(QtCore.QPointF(x, area.bottom()),
                             QtCore.QPointF(x, area.bottom() - height * (area.height() - 4)))
        painter.setPen(palette.mid().color())
        painter.drawRect(area)
        if not self.enabled:
            painter.setPen(palette.text().color())
            painter.drawText(area, QtCore.Qt.AlignCenter, tr("no densities yet"))
            return
        painter.setPen(QtGui.QPen(QtGui.QColor("#d9480f"), 2))
        painter.drawLine(QtCore.QPointF(line, area.top()), QtCore.QPointF(line, area.bottom()))
        painter.setPen(palette.text().color())
        below = QtCore.QRectF(area.left(), area.bottom(), area.width(), 16)
        painter.drawText(below, QtCore.Qt.AlignLeft | QtCore.Qt.AlignBottom, f"{self.edges[0]:.5g}")
        painter.drawText(below, QtCore.Qt.AlignRight | QtCore.Qt.AlignBottom, f"{self.edges[-1]:.5g}")

    def mousePressEvent(self, event):
        self.mouseMoveEvent(event)

    def mouseMoveEvent(self, event):
        if self.enabled and event.buttons() & QtCore.Qt.LeftButton:
            at = event.position() if hasattr(event, "position") else event.localPos()
            self.dragged.emit(self.density_at(at.x()))
