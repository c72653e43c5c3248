"""Runs inside FreeCAD's window: playback of a simulation, and its events."""

import math
import time

import FreeCADGui
import numpy as np
import pytest
from simulating import (DEEP_LINE, PROGRAM, RAPID_LINE, ROOT, Button, document, opened, simulated,
                        view_pixels)
from window import Heartbeat, live, press, wait

from fieldfab_workbench.objects import simulation
from fieldfab_workbench.objects import solid as solids
from fieldfab_workbench.shim import QtCore, QtGui, QtWidgets


def test_a_program_is_simulated_played_and_judged(document, opened, tmp_path):
    steps = document.UndoCount
    panel = simulated(document, opened, tmp_path)
    obj, playback = panel.obj, panel.playback
    assert obj.isValid() and obj.Contacts == 1 and obj.Gouges >= 1, obj.Verdict
    at_end = view_pixels(panel, "simulation_deviation")
    # The gouge is red, the legend is visible, the tool is above.
    red = (at_end[..., 0] > 120) & (at_end[..., 0] > at_end[..., 1] + 60) & (at_end[..., 0] > at_end[..., 2] + 60)
    assert red.sum() > 300 and playback.legend.isVisible()
    steel = [playback.view.pixel_of(np.array(playback._moment["tip"]) + [0, 0, h]) for h in (0, 40)]
    assert abs(steel[0][0] - steel[1][0]) < 2 < steel[1][1] - steel[0][1]

    # Without the tool the picture differs at its position.
    playback.see_tool.click()
    playback.see_holder.click()
    live(0.3)
    without = view_pixels(panel, "simulation_without_tool")
    x, y = (playback.view.pixel_of(np.array(playback._moment["tip"]) + [0, 0, 6]))
    row, column = without.shape[0] - int(y), int(x)
    assert np.abs(at_end - without)[row - 4 : row + 4, column - 4 : column + 4].mean() > 20
    playback.see_tool.click()
    playback.see_holder.click()

    # At the start the block is uncut; pictures, numbers and lines change during playback.
    playback.buttons["first"].click()
    wait(lambda: playback.player.idle)
    begin = view_pixels(panel, "simulation_begin")
    assert (not playback.legend.isVisible() and "-12.000" in playback.axes["X"].text()
            and 4 <= playback.program.line() <= 6)
    assert np.abs(begin - at_end).max(axis=2).mean() > 1
    playback.speed.setCurrentIndex(playback.speed.findText("5\N{MULTIPLICATION SIGN}"))
    shown, began = playback.shown, time.monotonic()
    worked = time.thread_time()
    with Heartbeat() as beat:
        playback.buttons["play"].click()
        # It plays by the clock: on a busy machine fewer pictures must not mean that the end is reached.
        wait(lambda: time.monotonic() - began > 2.5 or playback.seconds > 0.4 * playback.player.length)
        playback.buttons["play"].click()
    rate = (playback.shown - shown) / (time.monotonic() - began)
    worked = (time.thread_time() - worked) / max(1, playback.shown - shown)
    print(f"played with {rate:.1f} frames a second, the window answered within {1000 * beat.longest:.0f} ms, "
          f"{1000 * worked:.0f} ms of its own time a frame")
    wait(lambda: playback.player.idle)
    live(0.2)
    middle = view_pixels(panel, "simulation_middle")
    assert 4 < playback.program.line() < 28 and np.abs(middle - begin).max(axis=2).mean() > 0.5
    # In processor time of the thread, since the machine is shared; 20 pictures per second allow 50 ms each.
    assert rate > 2 and worked < 0.05 and beat.longest < 1
    press(Button.Ok)
    assert (document.UndoCount == steps + 1 and not FreeCADGui.Control.activeDialog() and obj.ViewObject.Visibility
            and obj.isValid())


def test_events_lines_and_clicks_find_each_other(document, opened, tmp_path):
    panel = simulated(document, opened, tmp_path)
    playback, events = panel.playback, panel.playback.events
    assert ([events.topLevelItem(i).text(0).split(":")[0] for i in range(2)] == ["rapid contact", "gouge"]
            and events.topLevelItem(0).text(1) == str(RAPID_LINE))
    events.itemClicked.emit(events.topLevelItem(0), 0)
    wait(lambda: playback.player.idle)
    live(0.3)
    view_pixels(panel, "simulation_event")
    assert playback.program.line() == RAPID_LINE == playback.line.value() and not playback.legend.isVisible()
    place = events.events[0]["place"]
    width, height = playback.view.view.getSize()
    assert math.dist(playback.view.pixel_of(place), (width / 2, height / 2)) < 3, "it is in the middle"
    assert math.dist(playback._moment["tip"], (18, 0, -2)) < 1e-3 and playback.scene.mark.whichChild.getValue() == 0

    # Deviations show the gouge.
    deep = events.findItems(str(DEEP_LINE), QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive, 1)
    events.itemClicked.emit(deep[0], 0)
    wait(lambda: playback.player.idle)
    live(0.2)
    assert playback.legend.isVisible() and playback.program.line() == DEEP_LINE

    # A line of the text, and of the box.
    playback.line.setValue(8)
    wait(lambda: playback.player.idle)
    assert playback.program.line() == 8 and math.dist(playback._moment["tip"][:2], (-12, -8)) < 30
    playback.program.clicked.emit(playback.program.model().index(6, 0))
    wait(lambda: playback.player.idle)
    live(0.1)
    assert math.dist(playback._moment["tip"], (12, -12, -3)) < 1e-3 and playback.line.value() == 7

    # A click on the floor of the pocket selects the row that cut it.
    playback.buttons["last"].click()
    wait(lambda: playback.player.idle)
    live(0.2)
    for place, line in (((-4, -10, -3), 7), ((-8, 8.5, -3), PROGRAM.split("\n").index("G1 Y8 F900") + 3)):
        x, y = playback.view.pixel_of(place)
        widget = playback.view.widget().viewport()
        scale = playback.view.view.getSize()[0] / widget.width()  # screen pixels per Qt pixel
        at = QtCore.QPoint(round(x / scale), round(widget.height() - y / scale))
        for kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonRelease):
            buttons = QtCore.Qt.LeftButton if kind == QtCore.QEvent.MouseButtonPress else QtCore.Qt.NoButton
            QtWidgets.QApplication.sendEvent(widget, QtGui.QMouseEvent(
                kind, at, QtCore.Qt.LeftButton, buttons, QtCore.Qt.NoModifier))
        live(0.2)
        view_pixels(panel, f"simulation_click_{line}")
        assert f"this place was cut by line {line} " in panel.message.text() and playback.program.line() == line
    press(Button.Cancel)
    assert len(document.Objects) == 1


def test_five_axes_are_shown_turning(document, opened, tmp_path):
    import gzip

    program = tmp_path / "knob.ngc"
    program.write_bytes(gzip.decompress((ROOT / "docs/cam/knob_five_axis.ngc.gz").read_bytes()))
    obj = solids.create(simulation.Simulation, document)
    obj.ProgramFile, obj.SetupFile, obj.Cell = str(program), str(ROOT / "examples/cam/knob_five_axis.toml"), 0.6
    document.recompute()
    assert obj.isValid(), obj.getStatusString()
    FreeCADGui.ActiveDocument.setEdit(obj.Name)
    panel = opened[-1]
    playback = panel.playback
    wait(lambda: playback.shown > 0 and playback.player.idle)
    assert list(playback.axes) == list(panel.run.simulation.axes) and len(playback.axes) == 5
    # A time with an inclined tool.
    times = np.linspace(0, playback.player.length, 200)
    leaning = [t for t in times if playback.player.at(t)["axis"][2] < 0.9]
    playback.go_to(leaning[len(leaning) // 2])
    wait(lambda: playback.player.idle)
    still = view_pixels(panel, "simulation_five_axes")
    playback.turning.click()
    live(0.3)
    turned = view_pixels(panel, "simulation_five_axes_turned")
    assert np.abs(still - turned).max(axis=2).mean() > 1
    # In machine coordinates the tool is vertical.
    assert playback._matrix()[:3, :3] @ playback._moment["axis"] == pytest.approx([0, 0, 1], abs=1e-6)
    press(Button.Cancel)
