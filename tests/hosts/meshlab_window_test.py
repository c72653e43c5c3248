"""Fieldfab's filters in the real MeshLab window, driven by keys under Xvfb. FIELDFAB_SHOTS names a folder for
screenshots."""

import os
import pathlib
import re
import time

import pytest
from freecad_host import screen
from meshlab_host import (
    APPLIED, DEVIATION, REMESH, REPORT, VERSION, Window, figure_eight, sphere, with_holes, write_ply,
)

SHOTS = os.environ.get("FIELDFAB_SHOTS")


@pytest.fixture
def shot(tmp_path):
    """Returns a function that takes a screenshot, in FIELDFAB_SHOTS if that is set."""
    return lambda window, name: window.picture(pathlib.Path(SHOTS or tmp_path) / f"{name}.png")


@pytest.fixture
def open_window(tmp_path, screen):
    windows = []

    def start(*files):
        windows.append(Window(tmp_path, screen, *files))
        return windows[-1]

    yield start
    for window in windows:
        window.close()


def test_menu_dialog_and_result(tmp_path, open_window, shot):
    window = open_window(write_ply(tmp_path / "holes.ply", *with_holes(sphere(60), radius=4)))
    window.keys("alt+l", "Down", "Down", "Down", "Down", "Right",
                *["Down"] * (12 if VERSION.startswith("2020") else 10))
    shot(window, "meshlab-menu")
    window.keys("Escape", "Escape", "Escape")
    assert window.open_filter(REMESH)
    window.fill_in([(7, "0.8")])  # Apply, Close, Help, gap in %, gap, edges, voxel in %, voxel
    window.aside()
    shot(window, "meshlab-dialog")
    window.apply()
    window.wait_for(APPLIED + REMESH)
    at_08 = int(re.search(r"LOG: 2 (\d+) triangles", window.said())[1])
    time.sleep(1)
    shot(window, "meshlab-remesh")
    window.open_filter(REPORT)  # of the new layer
    window.wait_for("It is a valid solid")
    assert "layer 'holes.ply' is open: " in window.said()
    window.open_filter(REMESH)  # now with the new layer's defaults
    window.apply()
    window.wait_for(APPLIED + REMESH, times=2)
    by_default = int(re.findall(r"LOG: 2 (\d+) triangles, ", window.said())[-1])
    assert by_default > 1.5 * at_08  # 0.46 mm instead of the typed 0.8


def test_deviation_in_colour(tmp_path, open_window, shot):
    window = open_window(write_ply(tmp_path / "measured.ply", *sphere(96)))
    window.open_filter(DEVIATION)
    window.aside()
    # Apply, Close, Help, range in %, range, formula, layer, reference (layer or formula)
    window.fill_in([(7, "Down"), (5, "move(sphere(20), 0.8, 0, 0.3)")])
    window.apply()
    window.wait_for(APPLIED + DEVIATION)
    time.sleep(1)
    shot(window, "meshlab-deviation")
    most = float(re.search(r"most ([-\d.e]+) mm", window.said())[1])
    assert most == pytest.approx((0.8**2 + 0.3**2) ** 0.5, abs=0.03)


@pytest.mark.parametrize("way", ["escape", "button"])
def test_cancel_leaves_the_window_and_the_layer(tmp_path, open_window, shot, way):
    window = open_window(write_ply(tmp_path / "eight.ply", *figure_eight()))
    assert window.open_filter(REMESH)
    window.aside()
    window.fill_in([(7, "0.2"), (5, "Down")])  # keep: sharp edges of 23,000 small triangles take minutes
    began = time.time()
    window.apply()
    time.sleep(2)
    assert "Applied" not in window.said(), "too fast to be cancelled"
    shot(window, "meshlab-cancel")
    cancelled = time.time()
    if way == "escape":
        window.keys("Escape")
    else:
        window.click(1345, 848)  # Cancel, at the right end of the status bar
    window.wait_for("Cancelled; the layers are as they were", 20)
    assert time.time() - cancelled < 10 and cancelled - began > 1.5
    time.sleep(1)
    window.keys("Return")  # the message
    window.open_filter(REPORT)
    window.wait_for("Validity of 'eight.ply': 23040 triangles, 11520 vertices", 30)
