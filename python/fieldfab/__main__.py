"""`python3 -m fieldfab --version`."""

import sys

from . import __version__

if sys.argv[1:] != ["--version"]:
    sys.exit("usage: python3 -m fieldfab --version (the command fieldfab does the rest; "
             "see the package's help for Python)")
print(__version__)
