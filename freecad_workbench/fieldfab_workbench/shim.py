"""Differences between FreeCAD 0.20 (PySide2, Path) and 1.x (PySide6, CAM). Tested with 0.20.2 and 1.0;
PySide6 follows FreeCAD's sources."""

try:
    from PySide2 import QtCore, QtGui, QtSvg, QtWidgets
except ImportError:
    from PySide6 import QtCore, QtGui, QtSvg, QtWidgets

__all__ = ["QtCore", "QtGui", "QtSvg", "QtWidgets", "flags"]


def flags(value):
    """Returns Qt flags (enum.Flag in Qt 6) as the integer that FreeCAD expects."""
    return int(getattr(value, "value", value))
