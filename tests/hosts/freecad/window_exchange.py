"""Runs inside FreeCAD's window: solids as plain meshes and as Part shapes, with their placements, colours and
visibility."""

import FreeCAD
import FreeCADGui
import ImportGui
import pytest
import window
from window import live, press

from fieldfab_workbench import files, kernel, mistakes, preferences, shape_files, shapes
from fieldfab_workbench.objects import frep_solid
from fieldfab_workbench.objects import solid as solids
from fieldfab_workbench.shim import QtCore, QtWidgets

RED = (0.8, 0.2, 0.1, 0.0)


@pytest.fixture
def solid():
    FreeCADGui.activateWorkbench("FieldfabWorkbench")
    document = FreeCAD.newDocument()
    live(0.2)
    made = solids.create(frep_solid.FrepSolid, document)
    made.Expression, made.VoxelSize = "difference(box(20, 20, 20), cylinder(r = 5, h = 30))", 1
    made.Placement = FreeCAD.Placement(FreeCAD.Vector(5, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 45))
    document.recompute()
    made.ViewObject.ShapeColor = RED
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(made)
    yield made
    for name in FreeCAD.listDocuments():
        FreeCAD.closeDocument(name)


@pytest.mark.parametrize("command, kind",
                         [("Fieldfab_ToMesh", "Mesh::Feature"), ("Fieldfab_ToPartShape", "Part::FeaturePython")])
def test_conversions_keep_place_and_colour_and_are_one_step(solid, command, kind):
    document, steps = solid.Document, solid.Document.UndoCount
    FreeCADGui.runCommand(command)
    live(0.2)
    made = document.Objects[-1]
    assert made.TypeId == kind and made.isValid() and document.UndoCount == steps + 1
    assert made.ViewObject.ShapeColor == pytest.approx(RED, abs=0.01) and made.Placement == solid.Placement
    assert made.ViewObject.Visibility and not solid.ViewObject.Visibility
    bounds, own = (made.Mesh if hasattr(made, "Mesh") else made.Shape).BoundBox, solid.Mesh.BoundBox
    assert bounds.XLength == pytest.approx(own.XLength, abs=0.05) and bounds.Center.distanceToPoint(own.Center) < 0.05
    FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    picture = window.shot(command)
    seen = sum(c.red() > 100 > 1.5 * c.blue() for y in range(150, 560, 5) for x in range(300, 1200, 5)
               for c in [picture.pixelColor(x, y)])
    assert seen > 500, "it is seen in its colour"
    document.undo()
    assert document.Objects == [solid]


def test_colour_and_visibility_stay_through_recomputes(solid):
    solid.ViewObject.Transparency = 40
    solid.Expression = "box(10, 10, 10)"
    solid.Document.recompute()
    assert solid.ViewObject.ShapeColor == pytest.approx(RED, abs=0.01) and solid.ViewObject.Transparency == 40
    solid.ViewObject.Visibility = False
    solid.Expression = "box(10, 10, 11)"
    solid.Document.recompute()
    assert not solid.ViewObject.Visibility and solid.Volume.Value == pytest.approx(1100)


def test_a_shape_is_edited_in_its_panel(solid):
    FreeCADGui.runCommand("Fieldfab_ToPartShape")
    live(0.2)
    made = solid.Document.Objects[-1]
    FreeCADGui.ActiveDocument.setEdit(made.Name)
    live(0.3)
    labels = [w.text() for w in FreeCADGui.getMainWindow().findChildren(QtWidgets.QLabel) if w.isVisible()]
    assert "Most triangles" in labels and "Merge faces" in labels
    box = [w for w in FreeCADGui.getMainWindow().findChildren(QtWidgets.QSpinBox)
           if w.isVisible() and w.value() == 2000][0]
    box.setValue(500)
    press(QtWidgets.QDialogButtonBox.Ok)
    assert made.MostTriangles == 500 and made.isValid() and made.Shape.isValid()


def test_parts_come_in_and_go_out_in_their_colours(tmp_path):
    path = tmp_path / "assembly.frep"
    path.write_text('part(sphere(8), "ball", "gold")\npart(move(box(12, 12, 12), 20, 0, 0), "block", "#2050a0")\n'
                    'part(move(torus(6, 2), -20, 0, 0), "ring")')
    FreeCADGui.activateWorkbench("FieldfabWorkbench")
    document = FreeCAD.newDocument()
    try:
        live(0.2)
        group = files.insert(str(path), document.Name)
        ball, block, ring = group.Group
        assert (document.UndoCount == 1
                and (group.Label, ball.Label, block.Label, ring.Label) == ("assembly", "ball", "block", "ring"))
        assert ball.ViewObject.ShapeColor[:3] == pytest.approx((1, 215 / 255, 0), abs=0.01)
        assert ring.ViewObject.ShapeColor[:3] == pytest.approx(preferences.colour(), abs=0.01)
        live(0.5)
        picture = window.shot("parts")
        seen = sum(c.red() > 1.5 * c.blue() and c.green() > 1.2 * c.blue() for y in range(150, 700, 5)
                   for x in range(300, 1300, 5) for c in [picture.pixelColor(x, y)])
        assert seen > 100, "the ball is gold"
        block.ViewObject.ShapeColor = (0.0, 1.0, 0.0, 0.0)
        files.export([group], str(tmp_path / "out.3mf"))
        colours = [colour for _, _, colour in kernel.load().load_parts(tmp_path / "out.3mf")]
        assert colours == ["#ffd700", "#00ff00", None], "as they are seen, and none for the colour that all solids have"
        FreeCADGui.ActiveDocument.setEdit(ball.Name)
        live(0.3)
        assert "Part" in [w.text() for w in FreeCADGui.getMainWindow().findChildren(QtWidgets.QLabel) if w.isVisible()]
        press(QtWidgets.QDialogButtonBox.Cancel)
        document.undo()
        assert not document.Objects
    finally:
        FreeCAD.closeDocument(document.Name)


@pytest.mark.parametrize("answer", ["Yes", "No"])
def test_export_to_step_offers_a_conversion(solid, tmp_path, answer):
    """By the module that FreeCAD's own Export calls for this filter."""
    assert FreeCAD.getExportType("step") == ["fieldfab_workbench.shape_files"]
    path, seen = tmp_path / "plate.step", []

    def press_it():
        for box in QtWidgets.QApplication.topLevelWidgets():
            if isinstance(box, QtWidgets.QMessageBox) and box.isVisible():
                seen.append(box.text())
                box.button(getattr(QtWidgets.QMessageBox, answer)).click()

    timer = QtCore.QTimer()
    timer.timeout.connect(press_it)
    timer.start(100)
    steps = solid.Document.UndoCount
    try:
        shape_files.export([solid], str(path))
    except mistakes.Mistake as error:
        assert answer == "No" and "not written" in str(error)
    timer.stop()
    assert len(seen) == 1 and "STEP" in seen[0] and solid.Label in seen[0]
    assert path.exists() == (answer == "Yes") and solid.Document.UndoCount == steps
    assert FreeCAD.ActiveDocument == solid.Document
    if answer == "Yes":
        again = FreeCAD.newDocument()
        ImportGui.insert(str(path), again.Name)
        [made] = [obj for obj in again.Objects if hasattr(obj, "Shape") and obj.Shape.Solids]
        assert made.Label == solid.Label and len(made.Shape.Faces) == 7
        # FreeCAD 1.x sets the fourth number of the colour to 1 where something is not transparent.
        assert made.ViewObject.ShapeColor[:3] == pytest.approx(RED[:3], abs=0.01) and not made.ViewObject.Transparency
        live(0.3)
        FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
        FreeCADGui.SendMsgToActiveView("ViewFit")
        window.shot("step")


def test_the_bracket_as_a_part_shape(document):
    made = solids.create(frep_solid.FrepSolid, document)
    made.Expression = [shape for shape in shapes.designs() if shape.name == "bracket"][0].text
    document.recompute()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(made)
    FreeCADGui.runCommand("Fieldfab_ToPartShape")
    live(0.3)
    shape = document.Objects[-1]
    assert shape.isValid() and shape.Faces < 100 and "cylindrical" in shape.Kinds
    FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    window.shot("bracket_shape")
