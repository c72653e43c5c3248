"""Differences between FreeCAD 0.20 (PySide2, Path) and 1.x (PySide6, CAM), in one place. Tried with 0.20.2; the rest
follows FreeCAD's sources."""

try:
    from PySide2 import QtCore, QtGui, QtSvg, QtWidgets
except ImportError:
    from PySide6 import QtCore, QtGui, QtSvg, QtWidgets  # noqa: F401


def flags(value):
    """Qt flags as the whole number that FreeCAD asks for (they are enum.Flag in Qt 6)."""
    return int(getattr(value, "value", value))
