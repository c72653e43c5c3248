"""Programs of other people that tests call, and that not every Debian has."""

import platform
import re
import shutil

import pytest
from conftest import ROOT

PACKAGES = {"openscad": "openscad", "rs274": "linuxcnc-uspace"}
LIST = ROOT / "packaging" / "debian-packages.txt"


def lacks(program):
    """Whether this Debian has no package with the program: `name [releases]` in the list of packages."""
    release = platform.freedesktop_os_release().get("VERSION_CODENAME", "sid")
    line = re.search(rf"^{PACKAGES[program]}( \[(.*)\])?$", LIST.read_text(), re.M)
    return bool(line[1]) and release not in line[2].split()


def need(program):
    """Skips the test where this Debian lacks the program."""
    if lacks(program):
        pytest.skip(f"{program}: this Debian has no package {PACKAGES[program]}")
    assert shutil.which(program), f"{program} is missing: ./dev setup installs {PACKAGES[program]}"
