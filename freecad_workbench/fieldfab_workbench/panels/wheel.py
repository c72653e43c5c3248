"""Keeps the mouse wheel from changing what a panel holds while somebody scrolls through it."""

from ..shim import QtCore, QtWidgets

INPUTS = (QtWidgets.QAbstractSpinBox, QtWidgets.QComboBox, QtWidgets.QAbstractSlider, QtWidgets.QTabBar)


class WheelGuard(QtCore.QObject):
    """Inputs below a widget, now or later, take the wheel only while they have the focus; otherwise the wheel scrolls
    what is around them."""

    def __init__(self, widget):
        super().__init__(widget)
        self._watch(widget)

    def _watch(self, widget):
        for each in (widget, *widget.findChildren(QtWidgets.QWidget)):
            each.installEventFilter(self)
            if _is_input(each) and each.focusPolicy() == QtCore.Qt.WheelFocus:
                each.setFocusPolicy(QtCore.Qt.StrongFocus)  # else the wheel would give it the focus first

    def eventFilter(self, watched, event):
        if event.type() in (QtCore.QEvent.ChildAdded, QtCore.QEvent.ChildPolished):
            if isinstance(event.child(), QtWidgets.QWidget):
                self._watch(event.child())
        elif event.type() == QtCore.QEvent.Wheel and _is_input(watched) and not watched.hasFocus():
            event.ignore()  # its parent is asked next
            return True
        return False


def _is_input(widget):
    return isinstance(widget, INPUTS) and not isinstance(widget, QtWidgets.QScrollBar)
