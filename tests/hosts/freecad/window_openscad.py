"""Runs inside FreeCAD's window: an OpenSCAD design by File > Import, its tree, parts and colours, and cancelling."""

import math
import pathlib
import sys
import time

import FreeCAD
import FreeCADGui
import pytest
import window
from window import Heartbeat, live, press, wait
from window_life import report

from fieldfab_workbench import files, openscad_files, work
from fieldfab_workbench.objects import openscad_node
from fieldfab_workbench.objects import solid as solids
from fieldfab_workbench.panels import property_panel
from fieldfab_workbench.shim import QtCore, QtWidgets

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import openscad_designs

Button = QtWidgets.QDialogButtonBox
EXAMPLES = pathlib.Path("/usr/share/openscad/examples")

DESIGN = """$fn = 48;
difference() {
  union() {
    color("SteelBlue") hull() {
      translate([-20, 0, 0]) cylinder(h = 8, r = 9);
      translate([20, 0, 0]) cylinder(h = 8, r = 14);
    }
    color("SteelBlue") translate([20, 0, 0]) cylinder(h = 24, r1 = 12, r2 = 9);
  }
  translate([20, 0, -1]) cylinder(h = 40, r = 5);
  translate([-20, 0, -1]) linear_extrude(height = 40) offset(r = 2) square(4, center = true);
  #translate([0, 0, 6]) linear_extrude(height = 5) text("FF", size = 9, halign = "center", valign = "center");
}
%translate([20, 0, -6]) cylinder(h = 40, r = 4.5);
"""


@pytest.fixture
def design(tmp_path):
    path = tmp_path / "lever.scad"
    path.write_text(DESIGN)
    return path


@pytest.fixture
def opened(monkeypatch):
    """Collects the opened panels, newest last."""
    made, real = [], property_panel.PropertyPanel.__init__
    monkeypatch.setattr(property_panel.PropertyPanel, "__init__",
                        lambda self, obj: made.append(self) or real(self, obj))
    return made


def named(document, label):
    return document.getObjectsByLabel(label)[0]


def items(tree, wanted):
    """Returns the items of FreeCAD's tree with a given text."""
    return tree.findItems(wanted, QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive)


def test_file_import(document, design, opened):
    """Uses the file dialog: file name, file type, Open."""

    def choose():
        dialog = QtWidgets.QApplication.activeModalWidget()
        assert isinstance(dialog, QtWidgets.QFileDialog)
        dialog.selectNameFilter(next(kind for kind in dialog.nameFilters()
                                     if kind.startswith("OpenSCAD design by Fieldfab")))
        dialog.findChild(QtWidgets.QLineEdit, "fileNameEdit").setText(str(design))
        dialog.findChild(Button).button(Button.Open).click()

    QtCore.QTimer.singleShot(500, choose)
    FreeCADGui.runCommand("Std_Import")
    wait(lambda: document.Objects and not document.HasPendingTransaction, "the import")
    root = named(document, "lever")
    assert root.isValid() and root.Operation == "Difference" and document.UndoCount == 1
    seen = [obj for obj in document.Objects if obj.ViewObject.Visibility]
    shown = next(obj for obj in seen if obj != root)
    assert len(seen) == 2 and shown.ViewObject.Transparency == openscad_files.TRANSPARENCY and shown.Node == "cylinder"
    blue = (0x46 / 255, 0x82 / 255, 0xB4 / 255)
    assert (root.ViewObject.ShapeColor[:3] == pytest.approx(blue, abs=0.01)
            and named(document, "hull").ViewObject.ShapeColor[:3] == pytest.approx(blue, abs=0.01))
    tinted = [obj for obj in document.Objects
              if obj.ViewObject.ShapeColor[:3] == pytest.approx(openscad_files.TINT, abs=0.01)]
    assert [obj.Node for obj in tinted] == ["linear_extrude"] and tinted[0] in root.Sources
    volume = root.Volume.Value
    reference, _, _ = openscad_designs.theirs(design, design.with_suffix(".off"))
    assert volume == pytest.approx(openscad_designs.volume(*openscad_designs.read_off(reference)), rel=2e-3)

    # The window's tree, expanded to the hull's cylinders; one of them is edited in its panel.
    trees = FreeCADGui.getMainWindow().findChildren(QtWidgets.QTreeWidget)
    wait(lambda: any(items(tree, "lever") for tree in trees), what="the tree, which FreeCAD fills when it has time")
    tree = next(tree for tree in trees if items(tree, "lever"))
    tree.expandAll()
    live(0.3)
    parts = items(tree, "lever")[0]
    assert [parts.child(i).text(0) for i in range(parts.childCount())] == [source.Label for source in root.Sources]
    hull = items(tree, "hull")[0]
    assert hull.parent().text(0) == root.Sources[0].Label and hull.childCount() == 2
    end = next(obj for obj in named(document, "hull").Sources if obj.TopRadius.Value == 14)
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(end)
    end.ViewObject.Proxy.doubleClicked(end.ViewObject)
    live(0.5)
    labels = [label.text() for label in FreeCADGui.getMainWindow().findChildren(QtWidgets.QLabel) if label.isVisible()]
    assert {"Height", "Bottom radius", "Top radius", "Fn"} <= set(labels)
    form = opened[-1].rows
    for row in range(form.rowCount()):
        if form.itemAt(row, QtWidgets.QFormLayout.LabelRole).widget().text() in ("Bottom radius", "Top radius"):
            form.itemAt(row, QtWidgets.QFormLayout.FieldRole).widget().setProperty("rawValue", 18.0)
    wait(lambda: opened[-1].preview.stage in ("final", "detail"), what="the preview of a part that is hidden")
    press(Button.Ok)
    assert end.TopRadius.Value == end.BottomRadius.Value == 18 and end.Mesh.CountFacets == 0
    assert root.isValid() and root.Volume.Value > volume + 8 * math.pi * (18**2 - 14**2) * 0.6
    FreeCADGui.ActiveDocument.ActiveView.viewTrimetric()  # isometric: walls as bright as floors
    FreeCADGui.SendMsgToActiveView("ViewFit")
    FreeCADGui.Selection.clearSelection()
    hidden = [dock for dock in FreeCADGui.getMainWindow().findChildren(QtWidgets.QDockWidget)
              if dock.isVisible() and dock.objectName() != "Combo View"]
    for dock in hidden:
        dock.hide()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(end)
    live(0.3)
    tree.scrollToTop()
    live(0.5)
    window.shot("openscad")
    for dock in hidden:
        dock.show()
    document.undo()
    document.undo()
    assert not document.Objects


def test_a_part_that_is_shown_gets_its_mesh(document, design):
    root = files.insert(str(design), document.Name)
    part = named(document, "hull")
    assert part.Mesh.CountFacets == 0
    steps = document.UndoCount
    part.ViewObject.Visibility = True
    wait(lambda: part.Mesh.CountFacets > 0, what="its mesh")
    assert (part.Volume.Value > 5000 and document.UndoCount == steps + 1 and root.isValid()
            and "Touched" not in root.State + part.State)
    part.ViewObject.Visibility = False
    part.Sources[0].Height = 16
    document.recompute()
    stale = part.Volume.Value
    part.ViewObject.Visibility = True
    wait(lambda: part.Volume.Value != stale, what="its new mesh")


CORNER = ("difference() { cube(size = [10, 10, 10]); "
          "multmatrix([[1, 0, 0, 5], [0, 1, 0, 5], [0, 0, 1, 5], [0, 0, 0, 1]]) { cube(size = [10, 10, 10]); } }")


def test_faces_are_seen_while_a_part_is_edited(document, tmp_path, opened):
    """The preview first shows a coarse contour, since the time for exact faces is unknown. Later it shows the faces at
    once, if they were quick."""
    (tmp_path / "corner.csg").write_text(CORNER)
    root = files.insert(str(tmp_path / "corner.csg"), document.Name)
    assert root.Triangles == 24 and root.Volume.Value == 875
    block = root.Sources[0]
    block.ViewObject.Proxy.doubleClicked(block.ViewObject)
    live(0.5)
    panel, seen = opened[-1], []
    row = next(row for row in range(panel.rows.rowCount())
               if panel.rows.itemAt(row, QtWidgets.QFormLayout.LabelRole).widget().text() == "Length")
    box = panel.rows.itemAt(row, QtWidgets.QFormLayout.FieldRole).widget()
    for length in (12.0, 13.0):
        panel.preview.stage = ""
        box.setProperty("rawValue", length)
        wait(lambda: panel.preview.stage == "coarse", what="the first picture")
        seen.append(panel.preview._refinement.faces_first)  # `exact` may be true already: that of the next picture
        wait(lambda: panel.preview.stage == "final", what="the last picture")
        assert panel.preview._refinement.exact and panel.preview._refinement.triangles == 12
        said = [label.text() for label in panel.form.findChildren(QtWidgets.QLabel)]
        assert "Final mesh" in said and not any("cells" in text for text in said)
    assert seen == [False, True]
    FreeCADGui.ActiveDocument.ActiveView.viewTrimetric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    window.shot("openscad_faces")
    camera = FreeCADGui.ActiveDocument.ActiveView.getCameraNode()
    camera.height = camera.height.getValue() / 8
    live(1.0)
    assert panel.preview.stage == "final", "nothing is finer where one looks closely"
    press(Button.Ok)
    assert root.isValid() and root.Volume.Value == 1300 - 8 * 5 * 5 and root.Triangles < 50


def test_faces_can_be_cancelled(document, tmp_path):
    """Exact faces are computed in the background; cancellation takes effect between two joins."""
    (tmp_path / "corner.csg").write_text(CORNER)
    root = files.insert(str(tmp_path / "corner.csg"), document.Name)
    block = root.Sources[0]
    pressed = []

    def cancel():
        dialogs = [each for each in QtWidgets.QApplication.topLevelWidgets()
                   if isinstance(each, QtWidgets.QProgressDialog) and each.isVisible()]
        if dialogs and "joining solids" in dialogs[0].labelText():
            pressed.append(time.monotonic())
            dialogs[0].cancel()
        else:
            QtCore.QTimer.singleShot(20, cancel)

    row = "union() {" + "".join(f"multmatrix([[1, 0, 0, {i % 9}], [0, 1, 0, {i // 9}], [0, 0, 1, 0.1], "
                                f"[0, 0, 0, 1]]) {{ sphere($fn = 40, r = 3); }}" for i in range(60)) + "}"
    text = solids.create(openscad_node.OpenScadText, document)
    text.Text, text.OnlyWhenShown, text.Visibility = row, True, False
    root.Sources = [block, text]
    QtCore.QTimer.singleShot(20, cancel)
    with Heartbeat() as beat:
        document.recompute([root])
    assert pressed and time.monotonic() - pressed[0] < 2 and beat.longest < 1, beat.gaps[-3:]
    assert not root.isValid() and root.Volume.Value == 875 and root.Triangles == 24, "it is still what it was"


def test_text_has_a_panel(document, tmp_path, opened):
    (tmp_path / "odd.csg").write_text("cube(size = [inf, 1, 1]); cube(size = [4, 4, 4]);")
    root = files.insert(str(tmp_path / "odd.csg"), document.Name)
    text = next(obj for obj in root.Sources if obj.Proxy.NAME == "OpenScadText")
    text.ViewObject.Proxy.doubleClicked(text.ViewObject)
    live(0.3)
    box = next(box for box in opened[-1].form.findChildren(QtWidgets.QPlainTextEdit))
    assert "inf" in box.toPlainText()
    box.setPlainText("cube(size = [1, 1, 9]);")
    press(Button.Ok)
    assert text.Text == "cube(size = [1, 1, 9]);" and root.Volume.Value == pytest.approx(64 + 5, rel=1e-3)


@pytest.mark.parametrize("stage", ["Reading", "slow"])
def test_a_cancelled_import_leaves_the_document_as_it_was(document, tmp_path, stage):
    """Cancel in the progress dialog, while OpenSCAD runs and while the solid is computed."""
    pressed, design = [], tmp_path / "slow.scad"
    loop = "x = [for (i = [0 : 9999]) [for (k = [0 : 4999]) i * k][0]];" if stage == "Reading" else ""
    design.write_text(loop + "for (i = [0 : 99]) translate([i % 9, floor(i / 9), 0.1]) sphere($fn = 40, r = 3);")

    def cancel():
        dialogs = [each for each in QtWidgets.QApplication.topLevelWidgets()
                   if isinstance(each, QtWidgets.QProgressDialog) and each.isVisible()]
        if dialogs and dialogs[0].labelText().startswith(stage):
            pressed.append(dialogs[0].labelText())
            dialogs[0].cancel()
        else:
            QtCore.QTimer.singleShot(50, cancel)

    QtCore.QTimer.singleShot(50, cancel)
    with Heartbeat() as beat, pytest.raises(ValueError, match="cancelled; nothing was added"):
        files.insert(str(design), document.Name)
    assert pressed and beat.longest < 3, beat.gaps[-3:]
    assert not document.Objects and not document.HasPendingTransaction and document.UndoCount == 0


def test_work_is_beside_the_window(document, monkeypatch):
    """OpenSCAD and the kernel run in a background thread."""
    ran = []
    monkeypatch.setattr(work, "run", lambda function, title, real=work.run: ran.append(title) or real(function, title))
    files.insert(str(EXAMPLES / "Old" / "example006.scad"), document.Name)
    assert ran[0] == "Reading example006.scad" and len(ran) == 2


def test_a_tree_of_three_hundred_parts(document, tmp_path):
    """The maximal number of parts is created and changed in short time."""
    row = "\n".join(f"multmatrix([[1, 0, 0, {2 * i}], [0, 1, 0, 0], [0, 0, 1, 0], "
                    f"[0, 0, 0, 1]]) {{ cube(size = [1, 1, {1 + i / 100}]); }}" for i in range(290))
    (tmp_path / "row.csg").write_text(row)
    began = time.monotonic()
    root = files.insert(str(tmp_path / "row.csg"), document.Name)
    imported = time.monotonic() - began
    assert len(root.Sources) == 290
    began = time.monotonic()
    root.Sources[7].Length = 1.5
    document.recompute()
    print(f"300 parts: imported in {imported:.2f} s, changed in {time.monotonic() - began:.2f} s")
    assert root.isValid() and imported < 20


def dialogs():
    return [box for box in QtWidgets.QApplication.topLevelWidgets()
            if isinstance(box, QtWidgets.QMessageBox) and box.isVisible()]


def test_a_design_with_a_syntax_error_says_so_in_a_dialog(report, tmp_path):
    """By File > Import."""
    design = tmp_path / "wrong.scad"
    design.write_text("cube([1, 2, 3]);\nsphere(r = ;\n")
    FreeCAD.newDocument()
    live(0.2)

    def choose():
        dialog = QtWidgets.QApplication.activeModalWidget()
        dialog.selectNameFilter(next(kind for kind in dialog.nameFilters()
                                     if kind.startswith("OpenSCAD design by Fieldfab")))
        dialog.findChild(QtWidgets.QLineEdit, "fileNameEdit").setText(str(design))
        dialog.findChild(QtWidgets.QDialogButtonBox).button(QtWidgets.QDialogButtonBox.Open).click()

    QtCore.QTimer.singleShot(500, choose)
    FreeCADGui.runCommand("Std_Import")
    wait(dialogs, "the dialog")
    [box] = dialogs()
    window.shot("mistake_scad")
    assert "line 2" in box.text() and "syntax error" in box.text().lower(), box.text()
    box.button(QtWidgets.QMessageBox.Ok).click()
    said = report().splitlines()
    assert len(said) == 1 and "Fieldfab: " in said[0], said
