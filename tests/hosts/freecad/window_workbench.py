"""Runs inside FreeCAD's window: features of the workbench other than its objects."""

import importlib
import os
import pathlib
import re

import FreeCAD
import FreeCADGui
from window import shot

from fieldfab_workbench import commands, objects, preferences, registry
from fieldfab_workbench.icons import FOLDER
from fieldfab_workbench.objects import cam_setup, cam_tool, combine, document_object, machine_program
from fieldfab_workbench.objects import part_shape, solid
from fieldfab_workbench.panels.cam_setup_panel import SetupPanel
from fieldfab_workbench.panels.kinds import PANELS
from fieldfab_workbench.panels.property_panel import PropertyPanel
from fieldfab_workbench.shim import QtCore, QtWidgets
from fieldfab_workbench.views import cam_view, part_shape_view, solid_view
from fieldfab_workbench.views.kinds import VIEWS


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
            assert (told["whatsThis"].endswith(".") and 1 <= len(re.findall(r"\.(?= [A-Z]|$)", told["whatsThis"])) <= 3
                    and len(told["whatsThis"]) > 60), name
    bars = {bar.windowTitle() for bar in FreeCADGui.getMainWindow().findChildren(QtWidgets.QToolBar) if bar.isVisible()}
    assert set(titles) <= bars


def kinds(base):
    """Returns the names of a class and its subclasses in the modules of objects."""
    return {base.__name__, *(name for kind in base.__subclasses__() for name in kinds(kind))}


def test_views_and_panels_are_of_classes_that_exist():
    for file in pathlib.Path(objects.__file__).parent.glob("*.py"):
        importlib.import_module(f"{objects.__name__}.{file.stem}")
    known = kinds(document_object.DocumentObject)
    assert len(known) > 10 and set(VIEWS) <= known and set(PANELS) <= known


def test_objects_find_their_view_and_panel_by_their_kind():
    """By their own class, or else its base class. A tool or a program has its set-up's panel, or else its
    properties."""
    document = FreeCAD.newDocument()
    try:
        tool = cam_tool.add(cam_setup.create(document))
        alone = document_object.create_object(cam_tool.CamTool, document, "Alone")
        union = solid.create(combine.Combine, document)
        shape = part_shape.create(document, union)
        assert type(tool.ViewObject.Proxy) is cam_view.ToolView and tool.ViewObject.DisplayMode == "Ways"
        assert type(union.ViewObject.Proxy) is solid_view.SolidView
        assert type(shape.ViewObject.Proxy) is part_shape_view.PartShapeView
        program = machine_program.create(tool.InList[0])
        expected = [(tool, SetupPanel, tool.InList[0]), (program, SetupPanel, tool.InList[0]),
                    (union, PropertyPanel, union)]
        program_alone = document_object.create_object(machine_program.MachineProgram, document, "Program")
        expected += [(alone, PropertyPanel, alone), (program_alone, PropertyPanel, program_alone)]
        for obj, kind, edited in expected:
            panel = registry.panel_for(obj)
            assert type(panel) is kind and panel.obj == edited
            panel.reject()
    finally:
        FreeCAD.closeDocument(document.Name)


def test_preferences_are_shown_and_kept():
    seen = []

    def change():
        dialog = QtWidgets.QApplication.activeModalWidget()
        if dialog is None:  # on a busy machine it takes its time
            QtCore.QTimer.singleShot(200, change)
            return
        box = dialog.findChild(QtWidgets.QSpinBox, "cells")
        seen.append(box.isVisible())
        box.setValue(64)
        shot("preferences")
        dialog.grab().save(os.path.join(os.environ.get("FIELDFAB_SHOTS", os.environ["HOME"]), "preferences_dialog.png"))
        dialog.findChild(QtWidgets.QDialogButtonBox).button(QtWidgets.QDialogButtonBox.Ok).click()

    QtCore.QTimer.singleShot(1500, change)
    FreeCADGui.showPreferences("Fieldfab")
    assert seen == [True] and preferences.cells() == 64
    FreeCAD.ParamGet(preferences.PATH).RemInt("Cells")


def test_icons_are_drawn():
    """By FreeCAD, as in its toolbars: Qt's own plugin for SVG is a package that FreeCAD does not need."""
    for name in sorted(os.listdir(FOLDER)):
        picture = FreeCADGui.getIcon(os.path.join(FOLDER, name)).pixmap(24, 24).toImage()
        shades = {picture.pixel(x, y) for x in range(picture.width()) for y in range(picture.height())}
        assert len(shades) > 20, f"{name} is nearly empty"
