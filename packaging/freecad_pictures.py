"""Takes the pictures of FreeCAD for the documents, from the tests that drive its real window. Run by ./dev docs."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
FIGURES = ROOT / "docs" / "figures"
# Figure of each screenshot of the tests. Screenshots of the tutorial keep their names.
FIGURE_OF = {
    "window_first_part": {"first_part": "tutorial/first_part"},
    "window_solids": {"difference": "freecad"},
    "window_cam": {"cam_planned": "freecad_cam"},
    "window_check": {"check": "freecad_check"},
    "window_openscad": {"openscad": "freecad_openscad"},
    "window_scan": {"scan_bone": "freecad_scan"},
    "window_simulation": {"simulation_deviation": "freecad_simulation"},
    "window_tutorial": {name: f"tutorial/{name}"
                        for name in ("bracket", "scan", "blend", "check", "plan", "playing", "deviations")},
}


def take(test):
    """Runs a test file in FreeCAD's window and copies its screenshots to the documents. Returns whether it passed."""
    with tempfile.TemporaryDirectory() as shots:
        pytest = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "tests/hosts/freecad_inside_test.py",
                  "-k", f"{test} and not {test}_"]
        # With the documents' own values, which samples make coarser.
        env = {**os.environ, "FIELDFAB_SHOTS": shots, "FIELDFAB_FULL": "1",
               "PYTHONPATH": str(ROOT / "build" / "release" / "python")}
        good = subprocess.run(pytest, cwd=ROOT, env=env).returncode == 0
        for shot, figure in FIGURE_OF[test].items() if good else ():
            (FIGURES / figure).parent.mkdir(exist_ok=True)
            shutil.copy(pathlib.Path(shots) / f"{shot}.png", FIGURES / f"{figure}.png")
    return good


if __name__ == "__main__":
    sys.exit(not all([take(test) for test in sys.argv[1:] or FIGURE_OF]))
