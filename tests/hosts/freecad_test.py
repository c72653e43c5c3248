"""The workbench in the real FreeCAD, without and with its window."""

import json
import math
import os
import shutil
import signal
import subprocess
import time

import pytest

from freecad_host import HERE, TIMEOUT, environment, home, screen


def test_solid_without_window(home):
    env = environment(home, QT_QPA_PLATFORM="offscreen")
    subprocess.run(["freecadcmd", str(HERE / "freecad" / "without_window.py")], env=env, timeout=TIMEOUT,
                   capture_output=True, stdin=subprocess.DEVNULL)
    seen = json.loads((home / "result.json").read_text())
    assert "error" not in seen, seen["error"]
    assert seen["valid"] and seen["solid"] and not seen["self_intersections"]
    assert seen["volume"] == pytest.approx(4 / 3 * math.pi * 1000, rel=0.01)
    assert seen["triangles"] == seen["counted"] > 500
    assert not seen["broken_valid"] and "Invalid" in seen["broken_state"]
    assert "did you mean 'sphere'" in seen["broken_message"]
    assert seen["broken_triangles"] == seen["triangles"], "the mesh it had is kept"
    assert seen["other_valid"]
    assert seen["undone_expression"] == "sphere(r = 10)" and seen["undone_valid"]
    assert seen["math_volume"] == pytest.approx(4 / 3 * math.pi * 125, rel=0.01)
    assert seen["half_volume"] == pytest.approx(2 / 3 * math.pi * 125, rel=0.02)
    assert seen["reopened_same"]
    assert seen["reopened_volume"] == pytest.approx(12, rel=1e-3), "the region still ends at z = 0"


def test_real_window(home, screen, tmp_path):
    assert shutil.which("freecad") and shutil.which("Xvfb") and shutil.which("import")
    env = environment(home, DISPLAY=screen)
    freecad = subprocess.Popen(["freecad", str(HERE / "freecad" / "with_window.FCMacro")], env=env,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
    try:
        deadline = time.monotonic() + TIMEOUT
        while not (home / "result.json").exists():
            assert time.monotonic() < deadline, "FreeCAD's window did not get ready"
            assert freecad.poll() is None, f"FreeCAD ended with {freecad.returncode}"
            time.sleep(0.2)
        seen = json.loads((home / "result.json").read_text())
        time.sleep(1)
        shot = tmp_path / "freecad.png"
        subprocess.run(["import", "-window", "root", str(shot)], env=env, check=True, timeout=120)
        (home / "result.json.taken").touch()
        freecad.wait(timeout=120)
    finally:
        if freecad.poll() is None:
            os.killpg(freecad.pid, signal.SIGKILL)
    if "FIELDFAB_SCREENSHOT" in os.environ:
        shutil.copy(shot, os.environ["FIELDFAB_SCREENSHOT"])
    assert "error" not in seen, seen["error"]
    assert seen["workbench"] == "FieldfabWorkbench"
    assert seen["toolbar"] and any("f-rep" in text for text in seen["toolbar"])
    assert seen["valid"] and seen["triangles"] > 10000
    assert seen["panel"]
    assert seen["kept_by_ok"] == ["FrepSolid"] and seen["closed_by_ok"] and seen["undo_steps"] == 1
    assert seen["applied"] == "sphere(r = 3)" and seen["cancel_restored"]
    assert seen["made"] == 2 and seen["left_after_cancel"] == ["FrepSolid"] and seen["closed_by_cancel"]
    # The solid is blue and lit: many pixels of the 3D view must be bluish, in many shades.
    raw = subprocess.run(["convert", str(shot), "-resize", "350x215!", "-depth", "8", "rgb:-"], capture_output=True,
                         check=True).stdout
    pixels = [raw[i : i + 3] for i in range(0, len(raw), 3)]
    blue = {tuple(p) for p in pixels if p[2] > p[0] + 25 and p[2] > 60}
    assert len(blue) > 300, f"only {len(blue)} shades of the solid's colour are seen"
