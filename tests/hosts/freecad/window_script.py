"""Runs inside FreeCAD's window: the panel of a Python model."""

import FreeCADGui
import window
from panels import Button, document, edit, panels, silhouette
from pointer import click, type_text
from window import live, press, wait

from fieldfab_workbench import scripts

BALL = "from fieldfab.shapes import *\nr = 7  # 1 to 9, radius\nsolid = sphere(r)\n"


def test_a_script_is_written_beside_its_picture(document, panels, tmp_path):
    FreeCADGui.runCommand("Fieldfab_NewScriptSolid")
    panel, ran = panels[-1], tmp_path / "ran"
    panel.voxel.setValue(0.5)
    live(0.6)
    assert panel.question.isVisible() and panel.preview.stage == "", "nothing runs before the user has agreed"
    window.shot("script_question")
    click(panel.agree)
    wait(lambda: not panel.question.isVisible(), "the answer")
    wait(lambda: panel.preview.stage == "final", "the default's solid")
    assert silhouette("script") > 100 and list(panel.rows) == ["count", "radius", "size"]
    window.shot("script_panel")

    panel.rows["count"].box.setValue(3)
    wait(lambda: "count = 3 " in panel.written(), "the slider's value")
    click(panel.text.viewport())
    panel.text.selectAll()
    type_text(f"open({str(ran)!r}, 'a').close()")
    panel.text.insertPlainText("\n" + BALL)
    wait(lambda: list(panel.rows) == ["r"] and ran.exists(), "the new script's run")
    wait(lambda: panel.preview.stage == "final" and not panel.text.message, "its solid")

    panel.text.setPlainText(BALL.replace("sphere(r)", "sphere(r) + 1 / (r - r)"))
    wait(lambda: "Line 3: ZeroDivisionError" in panel.message.text(), "the mistake")
    assert [each.line for each in panel.text.mistakes] == [2]
    window.shot("script_mistake")
    panel.text.setPlainText(BALL.replace("sphere(r)", "sphere(r"))
    wait(lambda: "Line 3: " in panel.message.text() and "never closed" in panel.message.text(), "the syntax")
    panel.text.setPlainText(BALL)
    wait(lambda: panel.preview.stage == "final" and not panel.text.mistakes, "the solid again")
    press(Button.Ok)
    [solid] = document.Objects
    assert solid.isValid() and abs(solid.Volume.Value - 1436.8) < 15 and document.UndoCount == 1
    assert solid.r == 7 and solid.FormulaOf == BALL

    edit(solid)
    panels[-1].rows["r"].box.setValue(5)
    press(Button.Ok)
    assert abs(solid.Volume.Value - 523.6) < 8 and "r = 5 " in solid.FormulaOf
    document.undo()
    assert abs(solid.Volume.Value - 1436.8) < 15 and solid.FormulaOf == BALL


def test_cancel_of_a_new_script_leaves_nothing(document, panels):
    FreeCADGui.runCommand("Fieldfab_NewScriptSolid")
    live(0.3)
    press(Button.Cancel)
    assert not document.Objects and not scripts.may_run(document)


def test_ok_without_consent_tells_why(document, panels):
    FreeCADGui.runCommand("Fieldfab_NewScriptSolid")
    live(0.3)
    press(Button.Ok)
    wait(lambda: "agreed" in panels[-1].message.text(), "the reason")
    press(Button.Cancel)
