"""What went wrong in a simulation, worst first."""

from ..objects.simulation import event_order
from ..shim import QtCore, QtGui, QtWidgets
from ..words import tr

MOST = 2000  # rows
# Colour and sign of each kind.
LOOKS = {
    "fixture contact": ("#8e1b1b", "F"),
    "holder contact": ("#b3261e", "H"),
    "shank contact": ("#cf4520", "S"),
    "rapid contact": ("#d9660f", "R"),
    "over-travel": ("#7b4fb3", "T"),
    "spindle stopped": ("#5b6472", "0"),
    "gouge": ("#d64f45", "G"),
    "excess": ("#3a7fc1", "E"),
}
UNITS = {"gouge": "mm", "excess": "mm", "over-travel": ""}


def sign(kind):
    """A disc with a letter, by the kind of event."""
    colour, letter = LOOKS.get(kind, ("#5b6472", "?"))
    picture = QtGui.QPixmap(18, 18)
    picture.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(picture)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    painter.setPen(QtCore.Qt.NoPen)
    painter.setBrush(QtGui.QColor(colour))
    painter.drawEllipse(1, 1, 16, 16)
    font = painter.font()
    font.setPixelSize(11)
    font.setBold(True)
    painter.setFont(font)
    painter.setPen(QtGui.QColor("white"))
    painter.drawText(picture.rect(), QtCore.Qt.AlignCenter, letter)
    painter.end()
    return QtGui.QIcon(picture)


class EventList(QtWidgets.QTreeWidget):
    """`chosen` tells an event (a table of the report) that was clicked."""

    chosen = QtCore.Signal(dict)

    def __init__(self):
        super().__init__()
        self.setHeaderLabels([tr("Event"), tr("Line"), tr("Amount")])
        self.setRootIsDecorated(False)
        self.setUniformRowHeights(True)
        self.setAlternatingRowColors(True)
        self.header().setStretchLastSection(False)
        self.header().setSectionResizeMode(0, QtWidgets.QHeaderView.Stretch)
        for column in (1, 2):
            self.header().setSectionResizeMode(column, QtWidgets.QHeaderView.ResizeToContents)
        self.events = []
        # Clicks, and the arrow keys.
        self.itemClicked.connect(lambda item, column: self._tell(item))
        self.itemActivated.connect(lambda item, column: self._tell(item))

    def set_events(self, events):
        self.clear()
        self.events = sorted(events, key=event_order)
        if not self.events:
            self.addTopLevelItem(QtWidgets.QTreeWidgetItem([tr("nothing went wrong")]))
        signs = {kind: sign(kind) for kind in {event["kind"] for event in self.events}}
        for event in self.events[:MOST]:
            unit = UNITS.get(event["kind"], "mm\N{SUPERSCRIPT THREE}")
            item = QtWidgets.QTreeWidgetItem([tr(event["kind"]), str(event["line"]) if event["line"] else "", f"{event['amount']:.3g} {unit}".strip()])
            item.setIcon(0, signs[event["kind"]])
            for column in range(3):
                item.setToolTip(column, event["message"])
            for column in (1, 2):
                item.setTextAlignment(column, QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
            self.addTopLevelItem(item)
        if len(self.events) > MOST:
            self.addTopLevelItem(QtWidgets.QTreeWidgetItem([tr("and {count} more").format(count=len(self.events) - MOST)]))

    def _tell(self, item):
        row = self.indexOfTopLevelItem(item)
        if row < min(len(self.events), MOST):
            self.chosen.emit(self.events[row])

    def sizeHint(self):
        return QtCore.QSize(300, 90)  # more where there is room
