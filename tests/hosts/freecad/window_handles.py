"""Runs inside FreeCAD's window: arrows in the 3D view that change a panel's numbers, dragged by the real pointer."""

import FreeCAD
import FreeCADGui
import pytest
import window
from panels import Button, document, edit, frep, panels, shown  # noqa: F401
from pointer import drag_arrow
from window import press

from fieldfab_workbench.objects import modify
from fieldfab_workbench.objects import solid as solids


def modified(document, operation, **values):  # noqa: F811
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


def test_an_offset_is_dragged(document, panels):  # noqa: F811
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


def test_cancel_takes_a_drag_back(document, panels):  # noqa: F811
    made = modified(document, "Shell", Wall=2)
    edit(made)
    drag_arrow(document, panels[-1].handles, 0, 3)
    assert made.Wall.Value == pytest.approx(5, abs=0.6)
    press(Button.Cancel)
    assert made.Wall.Value == 2


def test_a_wall_is_not_dragged_below_nothing(document, panels):  # noqa: F811
    made = modified(document, "Shell", Wall=2)
    edit(made)
    drag_arrow(document, panels[-1].handles, 0, -8)
    assert made.Wall.Value == 0
    press(Button.Cancel)


def test_the_step_of_an_array_is_dragged_along_each_axis(document, panels):  # noqa: F811
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


def test_arrows_follow_the_operation_and_leave_computed_numbers_alone(document, panels):  # noqa: F811
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
