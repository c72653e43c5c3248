"""Runs inside FreeCAD's window with German as the preferred language."""

import FreeCADGui
from window import live, shot

from fieldfab_workbench import words
from fieldfab_workbench.shim import QtCore, QtWidgets


def test_the_workbench_comes_up_in_german():
    FreeCADGui.activateWorkbench("FieldfabWorkbench")
    live(0.3)
    assert words.tr("Stock") == "Rohteil" and words.property_label("VoxelSize") == "Zellgröße"
    texts = {action.text() for menu in FreeCADGui.getMainWindow().menuBar().findChildren(QtWidgets.QMenu)
             for action in menu.actions()}
    assert {"Neuer F-Rep-Körper", "Operation hinzufügen", "Beispiele"} <= texts
    shot("german_start")


def test_the_preferences_are_german():
    seen = []

    def look():
        dialog = QtWidgets.QApplication.activeModalWidget()
        seen.extend(label.text() for label in dialog.findChildren(QtWidgets.QLabel) if label.isVisible())
        shot("german_preferences")
        dialog.reject()

    QtCore.QTimer.singleShot(1500, look)
    FreeCADGui.showPreferences("Fieldfab")
    assert "Farbe neuer Körper" in seen
