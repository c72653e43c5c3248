"""List of a simulation's events by kind, the worst first."""

from ..kernel_messages import translated
from .. import units
from ..objects.simulation import event_order
from ..shim import QtCore, QtGui, QtWidgets
from ..words import tr

# {kind: colour and letter}
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


EVENT = QtCore.Qt.UserRole
OPENED = 20  # kinds with at most this many events are expanded


def amount_of(event):
    return units.told(event["amount"], UNITS.get(event["kind"], "mm³"), 3)


def lines_of(event):
    """Returns the line of an event, or the first and the last line of events joined along a pass. "" for an event
    without a line."""
    first, last = event.get("first_line", event["line"]), event.get("last_line", event["line"])
    return f"{first}\N{EN DASH}{last}" if first < last else str(event["line"] or "")


# Sort key of each column; the worst event is first.
KEYS = (event_order, lambda event: (event.get("first_line", event["line"]), event["line"]),
        lambda event: -abs(event["amount"]))


def sign(kind):
    """Returns the icon for a kind of event: a disc with a letter."""
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
    """A tree with a row for each kind of event and the events as its children. A kind with a single event shows it
    directly. A click on a column header sorts by that column; a second click reverses the order. `chosen` emits the
    clicked event (a table of the report); a kind stands for its worst event."""

    chosen = QtCore.Signal(dict)

    def __init__(self):
        super().__init__()
        self.setHeaderLabels([tr("Event"), tr("Line"), tr("Amount")])
        self.setUniformRowHeights(True)
        self.setAlternatingRowColors(True)
        head = self.header()
        head.setStretchLastSection(False)
        head.setSectionResizeMode(0, QtWidgets.QHeaderView.Stretch)
        for column in (1, 2):
            head.setSectionResizeMode(column, QtWidgets.QHeaderView.ResizeToContents)
        head.setSectionsClickable(True)
        head.setSortIndicatorShown(True)
        head.setSortIndicator(0, QtCore.Qt.AscendingOrder)
        head.sortIndicatorChanged.connect(lambda column, order: self._fill())
        self.events = []
        # For clicks and arrow keys.
        self.itemClicked.connect(lambda item, column: self._tell(item))
        self.itemActivated.connect(lambda item, column: self._tell(item))

    def set_events(self, events):
        self.events = sorted(events, key=event_order)
        self._fill()

    def _fill(self):
        head, groups = self.header(), {}
        key, last_first = KEYS[head.sortIndicatorSection()], head.sortIndicatorOrder() == QtCore.Qt.DescendingOrder
        for event in sorted(self.events, key=key, reverse=last_first):
            groups.setdefault(event["kind"], []).append(event)
        self.clear()
        if not self.events:
            self.addTopLevelItem(QtWidgets.QTreeWidgetItem([tr("nothing went wrong")]))
        self.setRootIsDecorated(any(len(events) > 1 for events in groups.values()))
        for kind, events in groups.items():
            worst = min(events, key=event_order)
            item = self._item(worst)
            item.setIcon(0, sign(kind))
            self.addTopLevelItem(item)
            if len(events) > 1:
                item.setText(0, tr("{kind}: {count}").format(kind=tr(kind), count=len(events)))
                item.setText(1, "")
                item.addChildren([self._item(event) for event in events])
                item.setExpanded(len(events) <= OPENED)

    @staticmethod
    def _item(event):
        item = QtWidgets.QTreeWidgetItem([tr(event["kind"]), lines_of(event), amount_of(event)])
        item.setData(0, EVENT, event)
        for column in range(3):
            item.setToolTip(column, units.in_words(translated(event["message"])))
        for column in (1, 2):
            item.setTextAlignment(column, QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
        return item

    def _tell(self, item):
        if event := item.data(0, EVENT):
            self.chosen.emit(event)

    def sizeHint(self):
        return QtCore.QSize(300, 90)  # grows with the available room
