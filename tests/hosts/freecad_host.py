"""FreeCAD for tests, with and without a window: a separate home folder, a screen, and tests that run inside it."""

import json
import os
import pathlib
import signal
import subprocess

import pytest
from conftest import ROOT

HERE = pathlib.Path(__file__).resolve().parent
TIMEOUT = 150


@pytest.fixture
def home(tmp_path):
    """A home folder with the workbench installed and the start page switched off. The camera of FreeCAD 1.x, which
    turns for half a second, turns at once: tests look through it."""
    data = tmp_path / ".local" / "share" / "FreeCAD"
    (data / "Mod").mkdir(parents=True)
    (data / "Mod" / "Fieldfab").symlink_to(ROOT / "freecad_workbench")
    config = tmp_path / ".config" / "FreeCAD"
    config.mkdir(parents=True)
    (config / "user.cfg").write_text(
        """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters><FCParamGroup Name="Root"><FCParamGroup Name="BaseApp"><FCParamGroup Name="Preferences">
<FCParamGroup Name="General">
<FCText Name="AutoloadModule">FieldfabWorkbench</FCText><FCBool Name="ShowSplasher" Value="0"/>
</FCParamGroup>
<FCParamGroup Name="View"><FCBool Name="UseNavigationAnimations" Value="0"/></FCParamGroup>
<FCParamGroup Name="Mod"><FCParamGroup Name="Start">
<FCBool Name="ShowOnStartup" Value="0"/><FCBool Name="closeStart" Value="1"/>
</FCParamGroup></FCParamGroup>
</FCParamGroup></FCParamGroup></FCParamGroup></FCParameters>
"""
    )
    return tmp_path


def environment(home, **more):
    kept = {k: v for k, v in os.environ.items() if not k.startswith(("XDG_", "PYTHON"))}
    return {**kept, "HOME": str(home), "FIELDFAB_RESULT": str(home / "result.json"), "QTWEBENGINE_DISABLE_SANDBOX": "1",
            "LIBGL_ALWAYS_SOFTWARE": "1", "PYTEST_DEBUG_TEMPROOT": str(home),
            # FreeCAD 1.1 asks whether to copy the folders of an older version, unless it is told where they are.
            "FREECAD_USER_DATA": str(home / ".local" / "share" / "FreeCAD"), **more}


@pytest.fixture
def screen():
    """Starts an X server; yields its DISPLAY."""
    read, write = os.pipe()
    # An X server resets itself whenever its last client leaves, and turns away who comes meanwhile: xdotool, which
    # looks for a window from time to time, would now and then end FreeCAD at its start.
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1400x860x24", "-nolisten", "tcp",
                               "-noreset"], pass_fds=[write], stderr=subprocess.DEVNULL)
    os.close(write)
    yield ":" + os.read(read, 16).decode().strip()
    server.kill()
    server.wait()


def run_inside(home, file, screen=None, timeout=900, **more):
    """Runs a pytest file inside FreeCAD, in its window if there is a screen. Asserts that at least one test ran and
    that all passed. Environment: FIELDFAB_PYTEST has further options of pytest (-k ...); FIELDFAB_SHOTS names a folder
    for screenshots."""
    where = {"DISPLAY": screen} if screen else {"QT_QPA_PLATFORM": "offscreen"}
    env = environment(home, FIELDFAB_INSIDE=str(file), **where, **more)
    freecad = subprocess.Popen(["freecad" if screen else "freecadcmd", str(HERE / "freecad" / "run_inside.py")],
                               env=env, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               stdin=subprocess.DEVNULL, start_new_session=True)
    try:
        said = freecad.communicate(timeout=timeout)[0].decode(errors="replace")
    except subprocess.TimeoutExpired:
        os.killpg(freecad.pid, signal.SIGKILL)
        said = freecad.communicate()[0].decode(errors="replace")
    left = home / "result.json"
    crash = said.find("Fatal Python error")  # the newest calls come first
    told = said[crash:crash + 3000] if crash >= 0 else said[-3000:]
    assert left.exists(), f"FreeCAD ended with {freecad.returncode} and no result:\n{told}"
    result = json.loads(left.read_text())
    print(result["said"])
    assert result["code"] == 0 and " passed" in result["said"] and " skipped" not in result["said"]
