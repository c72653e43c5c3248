"""`fieldfab edit` in a real window on a screen (Xvfb)."""

import json
import os
import pathlib
import shutil
import subprocess

from conftest import BUILD, COMMAND

HERE = pathlib.Path(__file__).resolve().parent


def on_a_screen(*words, **more):
    return subprocess.run(["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", *map(str, words)], capture_output=True,
                          text=True, stdin=subprocess.DEVNULL, **more)


def test_window_follows_its_file(tmp_path):
    model, shot = tmp_path / "model.frep", tmp_path / "edit.png"
    model.write_text("smooth_union(box(10, 10, 4), sphere(4), 1)\n")
    environment = {**os.environ, "PYTHONPATH": str(BUILD / "python"), "QT_QPA_PLATFORM": "xcb"}
    done = on_a_screen("/usr/bin/python3", HERE / "edit" / "drive.py", model, shot, env=environment, timeout=200)
    assert done.returncode == 0, done.stdout + done.stderr
    seen = json.loads(done.stdout.splitlines()[-1])
    assert seen["coarse_first"] and seen["changed_by_save"] > 0.05
    assert [seen[name] for name in ("exact", "exact_after_save", "exact_after_zoom", "exact_after_turn",
                                    "exact_flat")] == [0] * 5, seen
    assert 0.5 < seen["zoomed"] < 0.7
    assert "unknown function 'spheer'; did you mean 'sphere'?" in seen["message"] and ":1:29:" in seen["message"]
    assert seen["message"].splitlines()[1].startswith("model.frep:2:5: unknown name 'q'"), "the mistakes below, too"
    assert seen["kept_below_message"] and seen["error_gone"] and seen["flat_mode"] == "bitmap"
    assert "No such file" in seen["missing"]
    assert seen["slid"] == 8 and seen["untouched"] and seen["no_sliders"]
    assert seen["written"] == "size = 8  # 4 to 12, ½\nbox(size, size, size)\n"
    if "FIELDFAB_EDIT_SCREENSHOT" in os.environ:
        shutil.copy(shot, os.environ["FIELDFAB_EDIT_SCREENSHOT"])
        for name in ("-error.png", "-sliders.png"):
            shutil.copy(str(shot).replace(".png", name), os.environ["FIELDFAB_EDIT_SCREENSHOT"].replace(".png", name))


def test_command_opens_the_window(tmp_path):
    """The command itself, with a script; the test closes its window."""
    model = tmp_path / "model.py"
    model.write_text("from fieldfab.shapes import sphere\nsolid = sphere(5)\n(open(__file__ + '.ran', 'w')).close()\n")
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    shell = (f"'{COMMAND}' edit '{model}' & window=$!; for i in $(seq 100); do [ -e '{model}.ran' ] && break; "
             f"sleep 0.2; done; sleep 1; kill -0 $window && kill $window; [ -e '{model}.ran' ]")
    done = on_a_screen("bash", "-c", shell, env=environment, timeout=60)
    assert done.returncode == 0, done.stdout + done.stderr


def test_without_a_screen(tmp_path):
    model = tmp_path / "model.frep"
    model.write_text("sphere(5)\n")
    environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")}
    done = subprocess.run([COMMAND, "edit", model], capture_output=True, text=True, env=environment)
    assert done.returncode == 2 and "no screen" in done.stderr
