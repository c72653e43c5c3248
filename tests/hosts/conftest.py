"""Finds the build for the tests of the command, of Python and of FreeCAD."""

import os
import pathlib
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("FIELDFAB_BUILD", ROOT / "build" / "release"))
COMMAND = BUILD / "bin" / "fieldfab"
DATA = ROOT / "tests" / "data"
sys.path.insert(0, str(BUILD / "python"))


@pytest.hookimpl(tryfirst=True)  # before xdist looks at the groups, also where the command names a file
def pytest_collection_modifyitems(items):
    """Assigns all tests of a file to one pytest worker, since its fixtures are slow. Tests in FreeCAD are distributed
    individually, since each starts its own FreeCAD."""
    for item in items:
        if item.path.name != "freecad_inside_test.py":
            item.add_marker(pytest.mark.xdist_group(item.path.stem))
