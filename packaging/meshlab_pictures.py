"""Takes the pictures of MeshLab for docs/meshlab.md, from the tests that drive its real window. Run by ./dev docs."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
FIGURES = ROOT / "docs" / "figures"
FIGURE_OF = {"meshlab-menu": "meshlab_menu", "meshlab-dialog": "meshlab_dialog", "meshlab-remesh": "meshlab_remesh",
             "meshlab-deviation": "meshlab_deviation",
             "meshlab-cancel": "meshlab_cancel"}


def take():
    """Runs the tests of MeshLab's window and copies their screenshots to the documents. Returns whether they passed."""
    with tempfile.TemporaryDirectory() as shots:
        pytest = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "tests/hosts/meshlab_window_test.py"]
        env = {**os.environ, "FIELDFAB_SHOTS": shots, "PYTHONPATH": str(ROOT / "build" / "release" / "python")}
        good = subprocess.run(pytest, cwd=ROOT, env=env).returncode == 0
        for shot, figure in FIGURE_OF.items() if good else ():
            shutil.copy(pathlib.Path(shots) / f"{shot}.png", FIGURES / f"{figure}.png")
    return good


if __name__ == "__main__":
    sys.exit(not take())
