"""Runs inside FreeCAD's window: arrows in the 3D view that change a panel's numbers, dragged by the real pointer."""

import FreeCAD
import FreeCADGui
import pytest
import window
from panels import Button, document, edit, frep, panels, shown
from pointer import drag_arrow
from window import live, press

from fieldfab_workbench.objects import cam_job, cam_setup, modify
from fieldfab_workbench.objects import solid as solids
from fieldfab_workbench.views.part_view import PartView


def modified(document, operation, **values):
    source = frep(document, "box(20, 20, 20)")
    made = solids.create(modify.Modify, document)
    made.Source, made.Operation = source, operation
    for name, value in values.items():
        setattr(made, name, value)
    document.recompute()
    source.ViewObject.Visibility = False
    FreeCADGui.ActiveDocument.ActiveView.viewFront()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    FreeCADGui.ActiveDocument.ActiveView.getCameraNode().height = 80
    return made


def arrows(panel):
    return [handle for handle, *_ in panel.handles.arrows]


def test_an_offset_is_dragged(document, panels):
    made = modified(document, "Offset", Distance=1)
    scene = FreeCADGui.ActiveDocument.ActiveView.getSceneGraph()
    before = scene.getNumChildren()
    edit(made)
    panel = panels[-1]
    window.shot("handle_offset")
    drag_arrow(document, panel.handles, 0, 4)
    assert made.Distance.Value == pytest.approx(5, abs=0.6)
    assert panel.widgets["Distance"].property("rawValue") == pytest.approx(made.Distance.Value)
    shown(panel.preview, "final", "detail", "divided")
    window.shot("handle_offset_dragged")
    panel.set_number("Distance", 2.0)
    assert arrows(panel)[0].read() == 2
    assert panel.handles.arrows[0][2].translation.getValue()[0] * panel.handles.size == pytest.approx(2)
    press(Button.Ok)
    assert scene.getNumChildren() == before and made.Mesh.BoundBox.ZMax == pytest.approx(12, abs=0.1)


def test_cancel_takes_a_drag_back(document, panels):
    made = modified(document, "Shell", Wall=2)
    edit(made)
    drag_arrow(document, panels[-1].handles, 0, 3)
    assert made.Wall.Value == pytest.approx(5, abs=0.6)
    press(Button.Cancel)
    assert made.Wall.Value == 2


def test_a_wall_is_not_dragged_below_nothing(document, panels):
    made = modified(document, "Shell", Wall=2)
    edit(made)
    drag_arrow(document, panels[-1].handles, 0, -8)
    assert made.Wall.Value == 0
    press(Button.Cancel)


def test_the_step_of_an_array_is_dragged_along_each_axis(document, panels):
    made = modified(document, "Linear array", Step=FreeCAD.Vector(24, 0, 0), Count=2)
    edit(made)
    panel = panels[-1]
    assert len(arrows(panel)) == 3
    window.shot("handle_step")
    drag_arrow(document, panel.handles, 2, 8)
    assert tuple(made.Step) == (24, 0, pytest.approx(8, abs=0.8))
    window.shot("handle_step_up")
    drag_arrow(document, panel.handles, 0, -6)
    assert made.Step.x == pytest.approx(18, abs=0.8) and made.Step.z == pytest.approx(8, abs=0.8)
    window.shot("handle_step_dragged")
    press(Button.Ok)


def test_arrows_follow_the_operation_and_leave_computed_numbers_alone(document, panels):
    made = modified(document, "Offset", Distance=1)
    made.setExpression("Distance", "2 mm")
    document.recompute()
    edit(made)
    panel = panels[-1]
    assert panel.handles is None
    made.Operation = "Mirror"
    panel.fill()
    assert len(arrows(panel)) == 3
    press(Button.Cancel)


# Numbers of a formula.
FORMULA = "width = 20  # 5 to 60\nbox(width, 20, 20) | move(sphere(6), 0, 0, 14)"


def formula(document, text=FORMULA):
    solid = frep(document, text)
    FreeCADGui.ActiveDocument.ActiveView.viewFront()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    FreeCADGui.ActiveDocument.ActiveView.getCameraNode().height = 80
    edit(solid)
    return solid


def arrow_of(panel, value):
    """Returns the place of a number's arrow among those that are shown, once it is."""
    found = lambda: [place for place, (handle, *_) in enumerate(
        panel.handles.handles.arrows if panel.handles.handles else []) if handle.read() == value]
    window.wait(lambda: panel.handles._task is None and found(), f"an arrow at {value}")
    return found()[0]


def test_a_move_of_a_formula_is_dragged(document, panels):
    solid = formula(document)
    panel = panels[-1]
    place = arrow_of(panel, 14)
    window.shot("handle_formula")
    drag_arrow(document, panel.handles.handles, place, 8)
    moved = float(panel.text.toPlainText().rsplit(",", 1)[1].strip(" )"))
    assert moved == pytest.approx(22, abs=0.8)
    assert panel.text.textCursor().selectedText() == f"{moved:g}"
    shown(panel.preview, "final", "detail", "divided")
    again = panel.handles.handles.arrows[arrow_of(panel, moved)][0]
    assert tuple(again.start() + again.along * moved) == pytest.approx((0, 0, moved), abs=0.5)
    window.shot("handle_formula_dragged")
    panel.text.undo()
    assert panel.text.toPlainText() == FORMULA  # one step for the whole drag
    panel.text.redo()
    press(Button.Ok)
    assert solid.Mesh.BoundBox.ZMax == pytest.approx(moved + 6, abs=0.2)


def test_a_parameter_is_dragged_by_its_face(document, panels):
    solid = formula(document)
    panel = panels[-1]
    arrow_of(panel, 14)
    place = [each.number.name for each in panel.handles._chosen()].index("width")
    drag_arrow(document, panel.handles.handles, place, 4)  # half of the change of the width
    assert panel.rows["width"].value() == pytest.approx(28, abs=1.5)
    assert panel.text.toPlainText() == FORMULA
    press(Button.Ok)
    assert solid.width == pytest.approx(28, abs=1.5)
    assert solid.Mesh.BoundBox.XMax == pytest.approx(solid.width / 2, abs=0.1)


def test_of_many_numbers_those_of_the_cursors_line_have_arrows(document, panels):
    lines = [f"move(box(4, 5, 6), {10 * i}, 1, 2)" for i in range(1, 4)]
    formula(document, "union(" + ",\n  ".join(lines) + ")")
    panel = panels[-1]
    window.wait(lambda: panel.handles._task is None and panel.handles.found, "arrows")
    cursor = panel.text.textCursor()
    for line in (1, 2):
        cursor.setPosition(panel.text.document().findBlockByNumber(line).position())
        panel.text.setTextCursor(cursor)
        values = {handle.read() for handle, *_ in panel.handles.handles.arrows}
        assert 10 * (line + 1) in values and 10 * line not in values, values
    press(Button.Cancel)
    assert panel.handles.handles is None


def test_a_formula_with_a_mistake_has_no_arrows(document, panels):
    formula(document)
    panel = panels[-1]
    arrow_of(panel, 14)
    panel.text.setPlainText("box(1, 2")
    window.wait(lambda: panel.handles.handles is None, "the arrows to go")
    press(Button.Cancel)


# A job's zero and stock.
def job(document, text="difference(box(40, 30, 10), move(cylinder(4, 30), 9, 5, 0))"):
    part = frep(document, text)
    made = cam_setup.create(document, part)
    document.recompute()
    FreeCADGui.ActiveDocument.ActiveView.viewFront()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    FreeCADGui.ActiveDocument.ActiveView.getCameraNode().height = 90
    edit(made)
    return made


def open_only(panel, box):
    for each in (panel.part_box, panel.stock_box):
        each.open(each is box)
    live(0.1)


def test_the_zero_is_dragged_and_snaps_to_a_corner(document, panels):
    made = job(document)
    panel = panels[-1]
    open_only(panel, panel.part_box)
    assert len(arrows(panel)) == 3
    window.shot("handle_zero")
    drag_arrow(document, panel.handles, 0, -19.4)
    assert made.Zero == "point" and made.ZeroPoint.x == pytest.approx(-20, abs=0.02) and made.ZeroPoint.z == 0
    drag_arrow(document, panel.handles, 2, 3)
    assert made.ZeroPoint.z == pytest.approx(3, abs=0.4)
    assert "zero = [-20" in cam_job.Job(made).text
    window.shot("handle_zero_dragged")
    press(Button.Cancel)
    assert made.Zero == "model"


def test_the_zero_is_picked_on_a_hole(document, panels):
    made = job(document)
    panel = panels[-1]
    FreeCADGui.ActiveDocument.ActiveView.viewTop()
    live(0.3)
    panel.pick_zero()
    view = PartView(document)
    panel._picked(*view.ray(*view.pixel_of((9.4, 4.8, 5))))
    assert tuple(made.ZeroPoint) == pytest.approx((9, 5, 5), abs=0.05)
    panel.pick_zero()
    panel._picked(*view.ray(*view.pixel_of((-13, 7, 5))))  # nothing is near
    assert tuple(made.ZeroPoint) == pytest.approx((9, 5, 5), abs=0.05) and "again" in panel.message.text()
    panel._picked(*view.ray(*view.pixel_of((20.3, -14.9, 5))))
    assert tuple(made.ZeroPoint) == pytest.approx((20, -15, 5), abs=0.05)
    press(Button.Cancel)


def test_the_stock_is_dragged(document, panels):
    made = job(document)
    panel = panels[-1]
    open_only(panel, panel.stock_box)
    assert len(arrows(panel)) == 3
    window.shot("handle_stock")
    drag_arrow(document, panel.handles, 1, 4)
    assert made.Top.Value == pytest.approx(5, abs=0.6)
    drag_arrow(document, panel.handles, 0, -9)
    assert made.Margin.Value == 0
    panel._set("StockFrom", "Box")
    made.StockLower, made.StockUpper = FreeCAD.Vector(-25, -20, -8), FreeCAD.Vector(25, 20, 6)
    panel._fill_stock()
    panel._refresh()
    assert len(arrows(panel)) == 6
    drag_arrow(document, panel.handles, 0, 5)
    drag_arrow(document, panel.handles, 5, 3)  # the bottom
    assert made.StockUpper.x == pytest.approx(30, abs=0.6) and made.StockLower.z == pytest.approx(-11, abs=0.6)
    assert made.StockLower.x == -25 and made.StockUpper.z == 6
    window.shot("handle_stock_box")
    press(Button.Ok)
