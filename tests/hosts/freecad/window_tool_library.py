"""Runs inside FreeCAD's window: the user's tool library, with its pictures."""

import json
import os

import pytest
import window
from panels import Button, document, edit, frep, panels
from window import live, press

from fieldfab_workbench import tool_library
from fieldfab_workbench.objects import cam_setup, cam_tool
from fieldfab_workbench.panels import tool_picture
from fieldfab_workbench.shim import QtGui

FUSION = {"data": [
    {"type": "ball end mill", "unit": "millimeters", "description": "Kugelfräser 6", "guid": "a",
     "geometry": {"DC": 6, "LCF": 20, "LB": 40, "SFDM": 6, "NOF": 2}, "post-process": {"number": 3},
     "start-values": {"presets": [{"n": 18000, "v_f": 1200, "v_f_plunge": 300}]}}], "version": 2}


@pytest.fixture
def table(document, panels):
    made = cam_setup.create(document, frep(document, "box(30, 20, 10)"))
    for told in ({"diameter": 6, "flute": 18, "length": 35, "shank": 8, "holder_diameter": 20, "holder_length": 25},
                 {"shape": "v", "diameter": 10, "angle": 60, "flute": 9, "length": 30},
                 {"shape": "bull", "diameter": 8, "corner_radius": 2, "flute": 16},
                 {"shape": "tapered", "diameter": 6, "corner_radius": 0.5, "angle": 12, "length": 45},
                 {"shape": "drill", "diameter": 3.3, "angle": 118, "flute": 30, "length": 45}):
        cam_tool.add(made, told)
    edit(made)
    yield panels[-1].tools
    press(Button.Cancel)


def test_tools_are_kept_and_taken_into_a_job(document, table):
    assert tool_library.tools() == []
    table.open_library()
    assert "empty" in table.library.message.text()
    table.library.close()
    for row in range(5):
        table.table.setCurrentCell(row, 1)
        table.keep()
        assert not table.message.isVisible()
    table.keep()
    assert "already" in table.message.text() and len(tool_library.tools()) == 5
    table.open_library()
    library = table.library
    live(0.2)
    window.shot("tool_library")
    assert [library.list.item(i).text() for i in range(5)] == [tool.Label for tool in table.setup.Tools]
    library.list.item(1).setSelected(True)
    library.list.item(3).setSelected(True)
    library.add()
    assert len(table.setup.Tools) == 7
    new = table.setup.Tools[5]
    assert (new.Number, new.Shape, new.Diameter.Value, new.Angle.Value) == (6, "v", 10, 60)
    assert cam_tool.values_of(new) == {**cam_tool.values_of(table.setup.Tools[1]), "number": 6, "name": new.Label}
    library.list.clearSelection()
    library.list.item(0).setSelected(True)
    library.remove()
    assert len(tool_library.tools()) == 4 and tool_library.tools()[0]["shape"] == "v"
    library.close()
    window.shot("tool_table")


def test_tools_of_fusion_are_imported(document, table, tmp_path):
    file = tmp_path / "mill.json"
    file.write_text(json.dumps(FUSION))
    before = len(tool_library.tools())
    table.open_library()
    table.library.take_files([str(file), str(tmp_path / "missing.json")])
    assert "missing.json" in table.library.message.text()
    ball = tool_library.tools()[before]
    assert (ball["name"], ball["shape"], ball["diameter"], ball["flute"], ball["spindle"]) == (
        "Kugelfräser 6", "ball", 6, 20, 18000) and "number" not in ball
    table.library.add()  # what was imported is chosen
    assert table.setup.Tools[-1].Label == "Kugelfräser 6" and table.setup.Tools[-1].Feed.Value * 60 == 1200
    table.library.close()


def test_a_damaged_library_is_told_and_left_alone(document, table):
    os.makedirs(os.path.dirname(tool_library.path()), exist_ok=True)
    with open(tool_library.path(), "w", encoding="utf-8") as held:
        held.write("{ nonsense")
    table.open_library()
    assert "no tool library" in table.library.message.text()
    table.library.close()
    table.table.setCurrentCell(0, 1)
    table.keep()
    assert "no tool library" in table.message.text()
    with open(tool_library.path(), encoding="utf-8") as held:
        assert held.read() == "{ nonsense"
    os.remove(tool_library.path())


def test_pictures_have_the_shapes_of_their_tools():
    for told in ({"shape": "flat", "diameter": 6}, {"shape": "ball", "diameter": 6},
                 {"shape": "bull", "diameter": 6, "corner_radius": 1}, {"shape": "v", "diameter": 6, "angle": 90},
                 {"shape": "tapered", "diameter": 6, "corner_radius": 0.5, "angle": 10},
                 {"shape": "drill", "diameter": 6, "angle": 118}):
        points = tool_picture.outline(told)
        assert points[-1][0] == pytest.approx(3) and all(x >= 0 and y >= 0 for x, y in points)
        assert all(b[1] >= a[1] - 1e-9 for a, b in zip(points, points[1:])), told
        drawn = tool_picture.picture(told, 48).toImage()
        blue = sum(drawn.pixelColor(x, y) == QtGui.QColor(tool_picture.CUTTER) for x in range(48) for y in range(48))
        assert blue > 60, told
    assert tool_picture.outline({"shape": "v", "diameter": 6, "angle": 90})[-1] == pytest.approx((3, 3))
    assert tool_picture.outline({"shape": "ball", "diameter": 6})[-1] == pytest.approx((3, 3))
