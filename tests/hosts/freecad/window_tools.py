"""Runs inside FreeCAD's window: the names of tools, in the panel's table, in the tree and in the operation."""

import FreeCADGui
import window
from panels import Button, document, document_tree, frep, panels
from window import live, press

from fieldfab_workbench.objects import cam_setup


def new_setup(document):
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(frep(document, "box(20, 20, 8)", 1))
    FreeCADGui.runCommand("Fieldfab_NewCamSetup")
    live(0.4)
    return next(obj for obj in document.Objects if cam_setup.is_setup(obj))


def shown(panel):
    """Returns the name of the first tool in the table, in the tree and in the operation."""
    tree, tool = document_tree(), panel.obj.Tools[0]
    [item] = [item for item in tree.findItems("*", window.QtCore.Qt.MatchWildcard | window.QtCore.Qt.MatchRecursive)
              if item.text(0) == tool.Label]
    return {panel.tools.table.item(0, 1).text(), item.text(0), panel.operation_form.tool.itemText(0).split(": ", 1)[1]}


def choose_shape(panel, shape):
    box = panel.tools.table.cellWidget(0, 2)
    box.setCurrentIndex(box.findData(shape))
    box.activated.emit(box.currentIndex())
    live(0.2)


def test_a_name_follows_shape_and_diameter_until_one_is_written(document, panels):
    new_setup(document)
    panel = panels[-1]
    panel.tools_box.open()
    assert shown(panel) == {"3 mm end mill"}
    choose_shape(panel, "ball")
    assert shown(panel) == {"3 mm ball end mill"}
    panel.tools.table.item(0, 3).setText("6")
    live(0.2)
    assert shown(panel) == {"6 mm ball end mill"}
    panel.obj.Tools[0].Diameter = "8 mm"  # as in the property editor
    panel.tools.fill()
    panel._refresh()
    assert shown(panel) == {"8 mm ball end mill"}
    panel.tools.table.item(0, 1).setText("my favourite")
    live(0.2)
    choose_shape(panel, "flat")
    panel.tools.table.item(0, 3).setText("5")
    live(0.2)
    assert shown(panel) == {"my favourite"}
    panel.tools.table.item(0, 1).setText("")
    live(0.2)
    assert shown(panel) == {"5 mm end mill"}, "no name is its own again"
    window.shot("tool_names")
    press(Button.Ok)
    assert panel.obj.Tools[0].Label == "5 mm end mill"
