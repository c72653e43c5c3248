"""The workbench, tested from inside the real FreeCAD: inside_*.py without a window, window_*.py in its window."""

import pytest
from freecad_host import HERE, home, run_inside, screen
from programs import need

FOLDER = HERE / "freecad"
# Programs that a file needs.
NEEDS = {"inside_openscad": "openscad", "window_openscad": "openscad"}


def require(file):
    if file.stem in NEEDS:
        need(NEEDS[file.stem])


@pytest.mark.parametrize("file", sorted(FOLDER.glob("inside_*.py")), ids=lambda p: p.stem)
def test_without_window(home, file):
    require(file)
    run_inside(home, file)


@pytest.mark.parametrize("file", sorted(FOLDER.glob("window_*.py")), ids=lambda p: p.stem)
def test_in_the_window(home, screen, file):
    require(file)
    run_inside(home, file, screen)


def test_in_the_window_of_a_german_user(home, screen):
    """German is set in FreeCAD's preferences before its start."""
    file = home / ".config" / "FreeCAD" / "user.cfg"
    general = '<FCParamGroup Name="General">'
    file.write_text(file.read_text().replace(general, general + '<FCText Name="Language">German</FCText>'))
    run_inside(home, FOLDER / "german_from_the_start.py", screen)
