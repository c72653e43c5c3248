"""Runs inside FreeCAD's window: what the workbench brings besides its objects."""

import os
import re

import FreeCAD
import FreeCADGui
from window import live, press, shot, wait  # noqa: F401

from fieldfab_workbench import commands, preferences
from fieldfab_workbench.shim import QtCore, QtGui, QtWidgets


def test_every_command_has_an_icon_a_name_and_help():
    FreeCADGui.activateWorkbench("FieldfabWorkbench")
    titles = []
    for title, names, toolbar in commands.register():
        titles += [title] * toolbar
        for name in names:
            if name == "Separator":
                continue
            told = FreeCADGui.Command.get(name).getInfo()
            assert told["menuText"] and told["toolTip"] and told["pixmap"], name
            assert os.path.isfile(told["pixmap"]), told["pixmap"]
            assert re.match(r"[A-Z]", told["menuText"]) and not told["toolTip"].endswith("."), name
            assert told["statusTip"] == told["toolTip"], name
            assert told["whatsThis"].endswith(".") and 1 <= len(re.findall(r"\.(?= [A-Z]|$)", told["whatsThis"])) <= 3 and len(told["whatsThis"]) > 60, name
    bars = {bar.windowTitle() for bar in FreeCADGui.getMainWindow().findChildren(QtWidgets.QToolBar) if bar.isVisible()}
    assert set(titles) <= bars


def test_preferences_are_shown_and_kept():
    before, seen = preferences.cells(), []

    def change():
        dialog = QtWidgets.QApplication.activeModalWidget()
        box = dialog.findChild(QtWidgets.QSpinBox, "cells")
        seen.append(box.isVisible())
        box.setValue(64)
        shot("preferences")
        dialog.grab().save(os.path.join(os.environ.get("FIELDFAB_SHOTS", os.environ["HOME"]), "preferences_dialog.png"))
        dialog.findChild(QtWidgets.QDialogButtonBox).button(QtWidgets.QDialogButtonBox.Ok).click()

    QtCore.QTimer.singleShot(1500, change)
    FreeCADGui.showPreferences("Fieldfab")
    assert seen == [True] and preferences.cells() == 64
    FreeCAD.ParamGet(preferences.PATH).SetInt("Cells", before)


def test_icons_are_drawn():
    for name in sorted(os.listdir(os.path.join(os.path.dirname(os.path.dirname(commands.__file__)), "..", "icons"))):
        icon = QtGui.QIcon(os.path.join(os.path.dirname(os.path.dirname(commands.__file__)), "..", "icons", name))
        picture = icon.pixmap(24, 24).toImage()
        shades = {picture.pixel(x, y) for x in range(24) for y in range(24)}
        assert len(shades) > 20, f"{name} is nearly empty"
