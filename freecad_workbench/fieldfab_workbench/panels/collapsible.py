"""Collapsible box for a stack of panels (Keeter, Fig. 6-2)."""

from ..shim import QtCore, QtWidgets


class Box(QtWidgets.QFrame):
    """A header with a title and a grey hint, which is visible while the box is closed. `body` is a vertical layout
    below the header."""

    def __init__(self, title, hint="", opened=True, tip=""):
        super().__init__()
        self.setFrameShape(QtWidgets.QFrame.StyledPanel)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        head = QtWidgets.QWidget()
        head.setStyleSheet("background: palette(midlight)")
        head.setToolTip(tip)
        row = QtWidgets.QHBoxLayout(head)
        row.setContentsMargins(4, 2, 6, 2)
        self.button = QtWidgets.QToolButton()
        self.button.setText(title)
        self.button.setStyleSheet("QToolButton { border: none; font-weight: bold }")
        self.button.setToolButtonStyle(QtCore.Qt.ToolButtonTextBesideIcon)
        self.button.setCheckable(True)
        self.button.setChecked(opened)
        self.button.toggled.connect(self._show)
        self.hint = QtWidgets.QLabel(hint)
        self.hint.setStyleSheet("color: gray")
        row.addWidget(self.button)
        row.addWidget(self.hint, 1, QtCore.Qt.AlignRight)
        column.addWidget(head)
        self.inside = QtWidgets.QWidget()
        self.body = QtWidgets.QVBoxLayout(self.inside)
        self.body.setContentsMargins(8, 6, 8, 8)
        self.body.setSpacing(4)
        column.addWidget(self.inside)
        self._show(opened)

    def _show(self, opened):
        self.button.setArrowType(QtCore.Qt.DownArrow if opened else QtCore.Qt.RightArrow)
        self.inside.setVisible(opened)

    def open(self, opened=True):
        self.button.setChecked(opened)
