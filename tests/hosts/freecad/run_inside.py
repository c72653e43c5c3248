"""Run by freecadcmd, or by FreeCAD's window: runs the pytest file FIELDFAB_INSIDE there and writes its output to
FIELDFAB_RESULT."""

import contextlib
import io
import json
import os
import re
import sys


def main():
    import pytest

    sys.path.insert(0, os.path.dirname(os.environ["FIELDFAB_INSIDE"]))
    said, code = io.StringIO(), -1
    try:
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            code = int(pytest.main([os.environ["FIELDFAB_INSIDE"], "-q", "-p", "no:cacheprovider", "-p",
                                    "shared_fixtures", "--tb=short", "--durations=3",
                                    *os.environ.get("FIELDFAB_PYTEST", "").split()]))
    except BaseException as error:
        said.write(repr(error))
    with open(os.environ["FIELDFAB_RESULT"], "w") as file:
        # Removes FreeCAD's progress lines.
        json.dump({"code": code, "said": re.sub(r"[^\n]*\(\d+ %\)[^\n]*\n?", "", said.getvalue())}, file)
    os._exit(0)  # no questions about unsaved documents


import FreeCAD

if FreeCAD.GuiUp:
    try:
        from PySide2 import QtCore
    except ImportError:
        from PySide6 import QtCore
    QtCore.QTimer.singleShot(1500, main)
else:
    main()
