"""`python3 -m fieldfab --version`, and the command `fieldfab` where pip has installed it."""

import os
import pathlib
import sys

from . import __version__


def command():
    """Becomes the command that lies in the module's folder."""
    program = pathlib.Path(__file__).parent / "bin" / "fieldfab"
    os.execv(program, [str(program), *sys.argv[1:]])


if __name__ == "__main__":
    if sys.argv[1:] != ["--version"]:
        sys.exit("usage: python3 -m fieldfab --version (the command fieldfab does the rest; "
                 "see the package's help for Python)")
    print(__version__)
