"""Runs inside FreeCAD's window: the state of solids whose mesh is valid but not certain, and the uncertain places."""

import FreeCAD
import FreeCADGui
import pytest
import window
from panels import Button, document, edit, frep, panels, shown
from window import live, press, wait

from fieldfab_workbench import certainty
from fieldfab_workbench.commands.exchange import COMMANDS
from fieldfab_workbench.panels import check_panel
from fieldfab_workbench.panels.edit_panel import COLOURS

TOUCHING = "union(move(sphere(2), dx = -2), move(sphere(2), dx = 2))"
AMBER = COLOURS[certainty.DOUBTFUL]


def choose(*solids):
    FreeCADGui.Selection.clearSelection()
    for solid in solids:
        FreeCADGui.Selection.addSelection(solid)


def show():
    command = COMMANDS["Fieldfab_ShowUncertainPlaces"]
    assert command.IsActive()
    command.Activated()
    live(0.2)


def colour(label):
    return label.styleSheet().split()[-1]


def test_the_panel_says_in_amber_where_a_valid_mesh_is_not_certain(document, panels):
    solid = frep(document, TOUCHING, 0.25)
    edit(solid)
    panel = panels[-1]
    assert colour(panel.message) == AMBER and "not certain at 1 place" in panel.message.text()
    window.shot("uncertain_panel")
    panel.text.setPlainText("sphere(r = 3)")
    shown(panel.preview, "final", "detail")
    live(0.3)
    assert colour(panel.message) == COLOURS[True] and "certain" not in panel.message.text()
    panel.text.setPlainText("move(" + TOUCHING + ", dz = 1)")
    wait(lambda: "not certain at" in panel.message.text(), "the amber line")
    assert colour(panel.message) == AMBER
    press(Button.Apply)
    assert solid.isValid()
    wait(lambda: colour(panel.message) == AMBER and panel.message.text().endswith(solid.Certainty),
         "the solid's certainty")
    press(Button.Cancel)


def test_boxes_of_the_places_come_and_go(document):
    solid, box = frep(document, TOUCHING, 0.25), frep(document, "box(2, 2, 2)")
    solid.Placement = FreeCAD.Placement(FreeCAD.Vector(30, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90))
    box.ViewObject.Visibility = False
    FreeCADGui.SendMsgToActiveView("ViewFit")
    live(0.2)
    command, root = COMMANDS["Fieldfab_ShowUncertainPlaces"], solid.ViewObject.RootNode
    choose(box)
    assert not command.IsActive(), "nothing where all is certain"
    choose(solid)
    camera, before, height = FreeCADGui.ActiveDocument.ActiveView.getCameraNode(), root.getNumChildren(), None
    height = camera.height.getValue()
    show()
    assert root.getNumChildren() == before + 1 and solid.ViewObject.Proxy.shows_places()
    assert camera.height.getValue() < height / 10, "the place fills the view"
    ahead = FreeCADGui.ActiveDocument.ActiveView.getViewDirection() * camera.focalDistance.getValue()
    assert (FreeCAD.Vector(*camera.position.getValue().getValue()) + ahead - FreeCAD.Vector(30, 0, 0)).Length < 0.1, (
        "where the balls touch")
    FreeCADGui.Selection.clearSelection()
    picture = window.shot("uncertain_places")
    size = picture.size()
    found = sum((c := picture.pixelColor(x, y)).red() > 230 and 120 < c.green() < 190 and c.blue() < 60
                for x in range(0, size.width()) for y in range(150, size.height() - 60, 3))
    assert found > 50, "the lines are seen through the mesh"
    choose(solid)
    show()
    assert root.getNumChildren() == before and not solid.ViewObject.Proxy.shows_places()
    show()
    solid.ViewObject.Visibility = False
    assert root.getNumChildren() == before
    show()
    assert solid.ViewObject.Visibility and solid.ViewObject.Proxy.shows_places()
    solid.Expression = "sphere(r = 3)"
    document.recompute()
    assert solid.Certainty == "certain" and root.getNumChildren() == before and not command.IsActive()


@pytest.mark.parametrize("text, state", [(TOUCHING, certainty.DOUBTFUL), ("box(4, 4, 4)", True)])
def test_the_cross_check_says_it_too(document, monkeypatch, text, state):
    solid = frep(document, text, 0.25)
    choose(solid)
    made, real = [], check_panel.CheckPanel.__init__
    monkeypatch.setattr(check_panel.CheckPanel, "__init__", lambda self, obj: made.append(self) or real(self, obj))
    FreeCADGui.runCommand("Fieldfab_CrossCheck")
    wait(lambda: made[0].report is not None, "the report")
    broken = [row for row in made[0].report.rows if not row.passed]
    assert colour(made[0].verdict) == COLOURS[False if broken else state]
    if not broken:
        assert ("not certain" in made[0].verdict.text()) == (state == certainty.DOUBTFUL)
    press(Button.Close)
