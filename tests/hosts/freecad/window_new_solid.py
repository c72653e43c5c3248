"""Runs inside FreeCAD's window: a new f-rep solid, typed from the first moment on."""

import time

import FreeCADGui
import window
from panels import Button, QtWidgets, document, panels, silhouette  # noqa: F401
from pointer import click, type_text
from window import live, press, wait

from fieldfab_workbench import work


def test_the_editor_is_open_at_once_and_no_typing_is_lost(document, panels, monkeypatch):  # noqa: F811
    waited, real = [], work.run
    monkeypatch.setattr(work, "run", lambda function, title: waited.append(title) or real(function, title))
    began = time.monotonic()
    FreeCADGui.runCommand("Fieldfab_NewFrepSolid")
    panel = panels[-1]
    assert not waited and time.monotonic() - began < 3, "nothing is computed before the panel is there"
    live(0.3)
    click(panel.text.viewport())
    QtWidgets.QApplication.processEvents()
    panel.text.selectAll()
    type_text("sphere(r = 7)")
    wait(lambda: panel.text.toPlainText() == "sphere(r = 7)", 5, "what was typed")
    assert not [box for box in QtWidgets.QApplication.topLevelWidgets() if isinstance(box, QtWidgets.QProgressDialog) and box.isVisible()]
    wait(lambda: panel.preview.stage == "final", 30, "the solid")
    assert silhouette("new_solid") > 100, "it is in the picture"
    window.shot("new_solid_panel")
    press(Button.Ok)
    [solid] = document.Objects
    assert solid.isValid() and abs(solid.Volume.Value - 1436.8) < 15 and document.UndoCount == 1
