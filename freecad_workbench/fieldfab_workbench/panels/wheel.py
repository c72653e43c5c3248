"""Keeps the mouse wheel from changing values while the user scrolls through a panel."""

from ..shim import QtCore, QtWidgets

INPUTS = (QtWidgets.QAbstractSpinBox, QtWidgets.QComboBox, QtWidgets.QAbstractSlider, QtWidgets.QTabBar)


class WheelGuard(QtCore.QObject):
    """Event filter for inputs below a widget, also those added later: they take the wheel only while they have the
    focus. Otherwise the wheel scrolls the surrounding widget."""

    def __init__(self, widget):
        super().__init__(widget)
        self._watch(widget)

    def _watch(self, widget):
        for each in (widget, *widget.findChildren(QtWidgets.QWidget)):
            each.installEventFilter(self)
            if _is_input(each) and each.focusPolicy() == QtCore.Qt.WheelFocus:
                each.setFocusPolicy(QtCore.Qt.StrongFocus)  # otherwise the wheel would first give it the focus

    def eventFilter(self, watched, event):
        if event.type() in (QtCore.QEvent.ChildAdded, QtCore.QEvent.ChildPolished):
            if isinstance(event.child(), QtWidgets.QWidget):
                self._watch(event.child())
        elif event.type() == QtCore.QEvent.Wheel and _is_input(watched) and not watched.hasFocus():
            event.ignore()  # passes the event to the parent
            return True
        return False


def _is_input(widget):
    return isinstance(widget, INPUTS) and not isinstance(widget, QtWidgets.QScrollBar)
