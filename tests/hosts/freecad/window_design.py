"""Runs inside FreeCAD's window: the editor of f-rep solids, the sliders, the gallery."""

import FreeCADGui
import pytest
import window
from panels import PART, Button, document, edit, frep, key, panels, shown, silhouette
from window import live, press

from fieldfab_workbench import kernel
from fieldfab_workbench.panels import gallery
from fieldfab_workbench.panels.frep_editor import COLOURS
from fieldfab_workbench.shim import QtCore, QtGui, QtWidgets


def colour_at(editor, line, column):
    block = editor.document().findBlockByNumber(line)
    return next((r.format.foreground().color().name() for r in block.layout().formats()
                 if r.start <= column < r.start + r.length), None)


# The editor.
def test_colours_numbers_and_all_mistakes_in_their_places(document, panels):
    solid = frep(document, PART)
    edit(solid)
    editor = panels[-1].text
    editor.setPlainText(
        'size = 20  # outer\npart = box(size, size, size)\ndifference(part, spheer(r = 4 + x)) | text("a")')
    live(0.3)
    assert (colour_at(editor, 0, 0) == COLOURS["variable"] and colour_at(editor, 0, 7) == COLOURS["number"]
            and colour_at(editor, 0, 12) == COLOURS["comment"])
    assert colour_at(editor, 1, 7) == COLOURS["function"] and colour_at(editor, 2, 11) == COLOURS["variable"]
    assert colour_at(editor, 2, 32) == COLOURS["constant"] and colour_at(editor, 2, 44) == COLOURS["string"]
    mark, = editor.extraSelections()
    assert mark.cursor.selectedText() == "spheer" and mark.cursor.blockNumber() == 2
    assert mark.format.underlineStyle() == QtGui.QTextCharFormat.WaveUnderline
    assert panels[-1].message.text() == "Line 3: unknown function 'spheer'; did you mean 'sphere'?"
    picture = editor.numbers.grab().toImage()
    assert any(picture.pixelColor(2, y).red() > 180 and picture.pixelColor(2, y).green() < 80
               for y in range(picture.height())), "the line is marked, too"
    window.shot("mistake")
    editor.setPlainText("# 😀 ½\na = box(q)  # 😀\nb = a * a\nsphere(r = @ | b")
    live(0.3)
    assert [m.cursor.selectedText() for m in editor.extraSelections()] == ["q", "@"]
    assert panels[-1].message.text() == "Line 2: unknown name 'q' (and 1 more)"
    assert (colour_at(editor, 1, 4) == COLOURS["function"] and colour_at(editor, 0, 0) == COLOURS["comment"]
            and colour_at(editor, 1, 7) is None)
    window.shot("mistakes")
    editor.setPlainText("sphere(r = 4")
    live(0.2)
    assert editor.extraSelections()[0].cursor.selectedText() == "4", "what is missing at the end is marked before it"
    editor.setPlainText("sphere(r = 4)")
    live(0.2)
    assert not editor.extraSelections() and not editor.message and "Line" not in panels[-1].message.text()
    press(Button.Cancel)
    assert solid.Expression == PART


def test_completion_and_tooltips(document, panels):
    edit(frep(document, "sphere(r = 4)"))
    editor = panels[-1].text
    editor.setPlainText("roundness = 2\n")
    editor.moveCursor(QtGui.QTextCursor.End)
    for letter in "rou":
        key(editor, letter)
    live(0.2)
    popup = editor.popup.popup()
    offered = [popup.model().index(i, 0).data() for i in range(popup.model().rowCount())]
    assert (popup.isVisible() and offered == ["rounded_box(dx = 1, dy = 1, dz = 1, r = 0.1)",
                                              "rounded_rectangle(dx = 1, dy = 1, r = 0.1)", "roundness"])
    window.shot("completion")
    key(popup, code=QtCore.Qt.Key_Return)
    live(0.1)
    assert (editor.toPlainText() == "roundness = 2\nrounded_box()"
            and editor.textCursor().positionInBlock() == len("rounded_box("))
    key(editor, code=QtCore.Qt.Key_Space, modifiers=QtCore.Qt.ControlModifier)
    live(0.1)
    assert popup.isVisible() and popup.model().rowCount() > 90
    popup.hide()
    cursor = QtGui.QTextCursor(editor.document().findBlockByNumber(1))
    cursor.movePosition(QtGui.QTextCursor.Right, QtGui.QTextCursor.MoveAnchor, 3)
    said = editor.help_at(cursor)
    assert "rounded_box(dx = 1" in said and "edges and corners rounded by r" in said
    for letter in "dy":
        key(editor, letter)
    live(0.1)
    assert popup.isVisible() and popup.currentIndex().data() == "dy = 1", "a parameter by its name"
    window.shot("arguments")
    key(popup, code=QtCore.Qt.Key_Return)
    assert editor.toPlainText() == "roundness = 2\nrounded_box(dy = )"
    press(Button.Cancel)


def test_without_a_kernel_the_editor_opens(document, panels, monkeypatch):
    def missing():
        raise ImportError("Fieldfab's kernel is not built")

    solid = frep(document, PART)
    monkeypatch.setattr(kernel, "load", missing)
    edit(solid)
    editor = panels[-1].text
    assert editor.toPlainText() == PART and colour_at(editor, 0, 0) is None and not editor.extraSelections()
    assert panels[-1].message.text() == "Fieldfab's kernel is not built"
    key(editor, "b")
    key(editor, "o")
    assert not editor.popup.popup().isVisible() and editor.help_at(editor.textCursor()) == ""
    monkeypatch.undo()
    press(Button.Cancel)


# Sliders.
def test_sliders_drive_the_properties_and_the_picture(document, panels):
    solid = frep(document, PART)
    whole = silhouette("before")
    edit(solid)
    panel = panels[-1]
    assert list(panel.rows) == ["size", "hole"] and panel.preview.stage == ""
    row = panel.rows["size"]
    row.slider.setValue(row.slider.value() // 2)
    assert row.box.value() == pytest.approx(10, abs=0.2)
    panel.rows["hole"].box.setValue(5.5)
    shown(panel.preview, "final", "detail")
    assert solid.size == row.value() and solid.hole == 5.5
    half = silhouette("half_the_size")
    assert half == pytest.approx(whole / 4, rel=0.15)
    wanted = row.value()
    press(Button.Ok)
    assert solid.size == wanted and solid.hole == 5.5 and solid.isValid()
    assert silhouette("after_ok") == pytest.approx(half, rel=0.1)
    document.undo()
    assert solid.size == 20 and solid.hole == 11, "one step"
    document.recompute()
    assert silhouette("after_undo") == pytest.approx(whole, rel=0.05)


def test_a_comment_tells_the_range_of_a_slider(document, panels):
    edit(frep(document, "r = 4  # 2 to 6, radius\nsphere(r)"))
    row = panels[-1].rows["r"]
    assert (row.low, row.high) == (2, 6) and row.toolTip().startswith("radius\n")
    panels[-1].text.setPlainText("r = 4  # 3 to 5\nsphere(r)")
    live(0.2)
    assert (panels[-1].rows["r"].low, panels[-1].rows["r"].high) == (3, 5)
    press(Button.Cancel)


def test_a_slider_grows(document, panels):
    edit(frep(document, "r = 4\nsphere(r)"))
    row = panels[-1].rows["r"]
    assert (row.low, row.high) == (0, 10)
    row.slider.setValue(row.slider.maximum())
    row.slider.sliderReleased.emit()
    assert row.value() == 10 and row.high == 20 and row.slider.value() == row.slider.maximum() // 2
    row.box.setValue(-3)
    assert row.low == -10 and row.value() == -3
    press(Button.Cancel)


# The gallery.
def opened_gallery():
    found = [w for w in QtWidgets.QApplication.topLevelWidgets() if isinstance(w, gallery.Gallery) and w.isVisible()]
    assert len(found) == 1
    return found[0]


def names(shapes):
    return [shapes.pictures.item(i).text() for i in range(shapes.pictures.count())]


def test_a_shape_of_the_gallery_becomes_a_solid(document, panels):
    FreeCADGui.runCommand("Fieldfab_ShapeGallery")
    live(0.3)
    shapes = opened_gallery()
    assert (len(names(shapes)) > 90
            and all(not shapes.pictures.item(i).icon().isNull() for i in range(shapes.pictures.count())))
    window.shot("gallery")
    shapes.search.setText("rounded box edges")
    assert names(shapes) == ["rounded box"] and list(shapes.boxes) == ["dx", "dy", "dz", "r"]
    shapes.boxes["dx"].setValue(12)
    shapes.button.click()
    live(0.5)
    solid = document.Objects[-1]
    assert solid.isValid() and solid.dx == 12 and FreeCADGui.Control.activeDialog()
    assert list(panels[-1].rows) == ["dx", "dy", "dz", "r"]
    shown(panels[-1].preview, "final", "detail")
    window.shot("from_gallery")
    press(Button.Apply)
    assert solid.Mesh.BoundBox.XLength == pytest.approx(12, abs=0.1)
    press(Button.Cancel)
    assert not document.Objects


def test_a_shape_goes_to_the_cursor(document, panels):
    edit(frep(document, "sphere(r = 4) | "[:-3]))
    panel = panels[-1]
    panel.text.moveCursor(QtGui.QTextCursor.End)
    panel.text.insert(" | ")
    panel._open_gallery()
    live(0.3)
    shapes = opened_gallery()
    shapes.groups.setCurrentRow(1)
    shapes.pictures.setCurrentRow(names(shapes).index("torus"))
    shapes.boxes["R"].setValue(6)
    shapes.button.click()
    shapes.close()
    live(0.3)
    assert panel.text.toPlainText() == "sphere(r = 4) | torus(R = 6, r = 1.5)" and not panel.text.mistakes
    press(Button.Ok)
