"""Runs inside FreeCAD's window: the real wheel over the panels of all kinds of objects."""

import FreeCAD
import FreeCADGui
import pytest
import window
from panels import Button, document, frep, panels
from pointer import click, is_seen, turn_wheel
from window import live, press

from fieldfab_workbench.objects import cam_operation, cam_setup, cam_tool, combine, modify, scan, simulation
from fieldfab_workbench.objects import solid as solids
from fieldfab_workbench.shim import QtWidgets

INPUTS = (QtWidgets.QAbstractSpinBox, QtWidgets.QComboBox, QtWidgets.QSlider, QtWidgets.QTabBar)


def of(kind, **values):
    def make(document):
        obj = solids.create(kind, document)
        for name, value in values.items():
            setattr(obj, name, value)
        return obj

    return make


def set_up(document):
    setup = cam_setup.create(document, frep(document, "box(20, 20, 8)", 1))
    cam_tool.add(setup, {"diameter": 3})
    cam_operation.add(setup, "rough")
    document.recompute()
    return setup


KINDS = {
    "frep": lambda document: frep(document, "size = 20\nbox(size, size, 8)", 1),
    "combine": of(combine.Combine, Operation="Blend"),
    "modify": of(modify.Modify, Operation="Transform"),
    "scan": of(scan.Scan),
    "simulation": of(simulation.Simulation),
    "set-up": set_up,
    "operation": lambda document: set_up(document).Operations[0],
}


def held(widget):
    for name in ("currentIndex", "rawValue", "value"):
        value = widget.property(name)
        if value is not None:
            return value.Value if isinstance(value, FreeCAD.Units.Quantity) else value
    raise AssertionError(type(widget))


@pytest.mark.parametrize("kind", KINDS)
def test_the_wheel_changes_nothing_on_its_way(kind, document, panels):
    for dock in FreeCADGui.getMainWindow().findChildren(QtWidgets.QDockWidget):
        if dock.objectName() in ("Python console", "Report view"):
            dock.hide()
    obj = KINDS[kind](document)
    FreeCADGui.ActiveDocument.setEdit(obj.Name)
    live(0.5)
    form = panels[-1].form
    for box in form.findChildren(QtWidgets.QToolButton):
        if box.isCheckable() and box.isVisible() and not box.isChecked():
            box.click()  # closed parts of the panel
    live(0.3)
    form.setFocus()
    before = {widget: held(widget) for widget in form.findChildren(QtWidgets.QWidget)
              if isinstance(widget, INPUTS) and widget.isVisible()}
    assert before
    tried = 0
    for notches in (-2, 2):
        for widget in before:
            if is_seen(widget):
                turn_wheel(widget, notches)
                tried += 1
    assert tried > 2
    for widget, value in before.items():
        assert held(widget) == value, (type(widget), widget.toolTip())
    window.shot(f"wheel_{kind}")
    press(Button.Cancel)


def test_the_panel_scrolls_instead_and_what_has_the_focus_takes_the_wheel(document, panels):
    setup = set_up(document)
    FreeCADGui.ActiveDocument.setEdit(setup.Name)
    live(0.5)
    panel = panels[-1]
    area = panel.form.parent()
    while not isinstance(area, QtWidgets.QScrollArea):
        area = area.parent()
    area.verticalScrollBar().setValue(0)
    live(0.1)
    zero = next(box for box in panel.form.findChildren(QtWidgets.QComboBox) if box.findData("corner") >= 0)
    turn_wheel(zero)
    assert area.verticalScrollBar().value() > 0 and setup.Zero == "model"
    area.verticalScrollBar().setValue(0)
    live(0.1)
    click(zero)
    live(0.2)
    # Chooses the current item again.
    click(zero.view().viewport(), zero.view().visualRect(zero.model().index(0, 0)).center())
    live(0.2)
    turn_wheel(zero, -1)
    assert setup.Zero == "corner" and zero.hasFocus()
    press(Button.Cancel)
