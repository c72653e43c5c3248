"""Where the build is, for the tests of the command, of Python and of FreeCAD."""

import os
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("FIELDFAB_BUILD", ROOT / "build" / "release"))
COMMAND = BUILD / "bin" / "fieldfab"
DATA = ROOT / "tests" / "data"
sys.path.insert(0, str(BUILD / "python"))
