"""Runs inside FreeCAD, without its window: solids of Python scripts that the document keeps. None runs unasked."""

import math
import os
import pathlib
import re
import time

import FreeCAD
import pytest

from fieldfab_workbench import files, frep_language, scripts, sources, work
from fieldfab_workbench.objects import modify, script_solid
from fieldfab_workbench.objects import solid as solids

BALL = "from fieldfab.shapes import *\nr = 5  # 1 to 9, radius\nsolid = sphere(r)\n"


def made(document, script, agree=True):
    solid = solids.create(script_solid.ScriptSolid, document)
    solid.Script, solid.VoxelSize = script, 1
    if agree:
        scripts.agree(document)
    document.recompute()
    return solid


def volume(solid):
    return solid.Volume.Value


def test_the_default_is_a_plate_with_holes(document):
    solid = made(document, script_solid.DEFAULT)
    assert solid.isValid(), solid.getStatusString()
    assert [name for name in solid.PropertiesList if solid.getGroupOfProperty(name) == "Parameters"] == [
        "count", "radius", "size"]
    assert abs(volume(solid) / (6 * math.pi * (25**2 - 7 * 9)) - 1) < 0.02
    solid.count = 3
    document.recompute()
    assert abs(volume(solid) / (6 * math.pi * (25**2 - 3 * 9)) - 1) < 0.02


def test_the_script_of_the_documents(document):
    text = (pathlib.Path(__file__).resolve().parents[3] / "docs" / "freecad.md").read_text()
    [script] = re.findall(r"^```python\n(.*?)^```", text, re.M | re.S)
    solid = made(document, script)
    assert solid.isValid() and abs(volume(solid) / (6 * math.pi * (25**2 - 7 * 9)) - 1) < 0.02
    assert (solid.count, solid.radius) == (7, 3)


def test_nothing_runs_before_the_user_has_agreed(document, tmp_path):
    ran = tmp_path / "ran"
    solid = made(document, f"open({str(ran)!r}, 'a').write('x')\n" + BALL, agree=False)
    assert not solid.isValid() and "agreed" in solid.getStatusString() and not ran.exists()
    with pytest.raises(ValueError, match="agreed"):
        solid.Proxy.text(solid)
    scripts.agree(document)
    document.recompute([solid], True)
    assert solid.isValid() and ran.read_text() == "x" and abs(volume(solid) - 523.6) < 20

    # Saved and opened by someone else: the formula is used, and nothing runs until something changes.
    document.saveAs(str(tmp_path / "kept.FCStd"))
    FreeCAD.closeDocument(document.Name)
    sources._store.clear()
    again = FreeCAD.openDocument(str(tmp_path / "kept.FCStd"))
    [solid] = again.Objects
    other = solids.create(modify.Modify, again)
    other.Operation, other.Source, other.Distance, other.VoxelSize = "Offset", solid, 1, 1
    again.recompute(None, True)
    assert solid.isValid() and other.isValid() and abs(volume(other) - 904.8) < 30 and ran.read_text() == "x"
    solid.r = 4
    again.recompute()
    assert not solid.isValid() and "agreed" in solid.getStatusString() and ran.read_text() == "x"
    assert abs(volume(solid) - 523.6) < 20, "its last mesh stays"
    scripts.agree(again)
    again.recompute([solid], True)
    assert solid.isValid() and abs(volume(solid) - 268) < 15 and ran.read_text() == "xx"
    FreeCAD.closeDocument(again.Name)
    assert not scripts.may_run(again_named("kept")), "the consent ends with the document"


class again_named:
    """A document of that name, for scripts.may_run()."""

    def __init__(self, name):
        self.Name = name


@pytest.mark.parametrize("script, told", [
    ("from fieldfab.shapes import *\n\nsolid = sphere(1 / 0)\n", "Line 3: ZeroDivisionError: division by zero"),
    ("solid = (1\n", "Line 1: "),
    ("x = 5\n", "the script makes no shape"),
    ("raise SystemExit(3)\n", "the script ended itself with 3"),
    ("import os, signal\nos.kill(os.getpid(), signal.SIGKILL)\n", "the process ended without a result"),
    ("import fieldfab\nsolid = fieldfab.parse('sphere(')\n", "Line 2: "),
])
def test_mistakes_are_told_with_their_line(document, script, told):
    solid = made(document, script)
    assert not solid.isValid() and told in solid.getStatusString(), solid.getStatusString()


def test_parameters_are_numbers_at_the_left_edge():
    script = ('"""Words\nw = 3\n"""\na = 1  # 0 to 9, side\nfor i in range(3):\n    b = 2\nc = a * 2\nx, y = 1, 2\n'
              "f = 2.5e1\nif a:\n    g = 4\ntext = 'h = 3'\n")
    found = scripts.parameters(script)
    assert {name: each.value for name, each in found.items()} == {"a": 1, "f": 25}
    assert found["a"].range == (0, 9) and found["a"].comment == "side"
    written = frep_language.with_values(script, {"a": 4, "f": 3})
    assert written == script.replace("a = 1 ", "a = 4 ").replace("f = 2.5e1", "f = 3")
    assert scripts.parameters("a = 1\nb = (") == {}


def test_several_parts_are_one_solid_and_can_be_exported(document, tmp_path):
    solid = made(document, "import fieldfab as ff\nff.part(ff.shapes.box(4, 4, 4), 'a')\n"
                           "ff.part(ff.shapes.box(2, 2, 2).translate(5, 0, 0), 'b', 'red')\n")
    assert solid.isValid() and abs(volume(solid) - 72) < 0.5
    files.export([solid], str(tmp_path / "out.frep"))
    assert "box" in (tmp_path / "out.frep").read_text() or "max" in (tmp_path / "out.frep").read_text()


def test_a_script_without_end_is_stopped(document):
    began, task = time.monotonic(), work.Task(
        lambda progress: scripts.formula_of("import time\ntime.sleep(600)\n", progress))
    task.start()
    time.sleep(0.5)
    task.cancel()
    task.join(5)
    assert isinstance(task.error, work.Cancelled) and time.monotonic() - began < 3
    children = [name for name in os.listdir("/proc") if name.isdigit() and os.path.exists(f"/proc/{name}/stat")
                and "fieldfab.script" in open(f"/proc/{name}/cmdline").read()
                and open(f"/proc/{name}/stat").read().rpartition(")")[2].split()[1] == str(os.getpid())]
    assert children == []
