"""Commands that make solids from scans and other files."""

import os

import FreeCAD
import FreeCADGui

from ..kernel_messages import translated
from .. import files, kernel, part_files, scripts, work
from ..file_types import SLICES, extensions, pattern
from ..objects.frep_solid import FrepSolid
from ..objects.scan import Scan
from ..shim import QtWidgets
from ..words import tr
from .command import Command


class ImportScan(Command):
    def Activated(self):
        patterns = pattern(dict.fromkeys((*extensions("volume", "distances", reads=True), *SLICES)))
        path = QtWidgets.QFileDialog.getOpenFileName(
            FreeCADGui.getMainWindow(), tr("Import scan: a volume, or any slice of a stack"), "",
            tr("Volumes and slices ({patterns});;All files (*)").format(patterns=patterns))[0]
        if path:
            add_scan(path)


def add_scan(path):
    """Adds a scan and opens its panel. The source is a file, the stack that a slice belongs to, or a folder."""
    stack = files.whole_stack(path)
    return files.add(FreeCAD.ActiveDocument or FreeCAD.newDocument(), Scan, files.name_of(stack), File=stack)


class RunScript(Command):
    def Activated(self):
        window = FreeCADGui.getMainWindow()
        patterns = pattern(extensions("script"))
        path = QtWidgets.QFileDialog.getOpenFileName(window, self.title, "",
                                                     tr("Scripts ({patterns})").format(patterns=patterns))[0]
        buttons = QtWidgets.QMessageBox
        asked = tr("Run {path}?\n\nA script can do on this computer whatever you can: "
                   "read, change and delete your files. Run it only if you trust whoever wrote it.").format(path=path)
        if path and buttons.question(window, self.title, asked, buttons.Yes | buttons.No, buttons.No) == buttons.Yes:
            try:
                add_script(path)
            except (ValueError, work.Cancelled) as error:
                buttons.warning(window, self.title, translated(str(error)) or tr("The script was stopped."))


def add_script(path):
    """Runs a script in a separate process and adds the solid that it makes, or a group for several parts. The document
    stores the formulas, not the script. Raises ValueError with the script's line, and work.Cancelled."""
    parts = work.run(lambda progress: _parts_of(path, progress),
                     tr("Running {path}").format(path=os.path.basename(path)))
    document = FreeCAD.ActiveDocument or FreeCAD.newDocument()
    made = part_files.add(path, document.Name, files.name_of(path), FrepSolid, parts)
    if FreeCAD.GuiUp:
        files.show_all(document)
    return made


def _parts_of(path, progress):
    """Returns [(name, colour, {property: value})] for part_files.add()."""
    fieldfab = kernel.load()
    try:
        return [(name, colour, {"Expression": solid.math()})
                for solid, name, colour in fieldfab.parse_parts(scripts.run_file(path, progress))]
    except scripts.ScriptError as error:
        raise ValueError(f"{path}{f':{error.line}' if error.line else ''}: {error.words}") from None
    except fieldfab.Error as error:
        raise ValueError(f"{path}: {error}") from None


TITLE = "Scans"
COMMANDS = {
    "Fieldfab_ImportScan": ImportScan(
        "ImportScan", "Import scan", "Make a solid from a CT volume: a file, or any slice of a stack",
        "Asks for a CT volume's file, or any slice of a stack, and makes a solid of it. The panel shows the "
        "histogram and asks for the threshold, the crop and the clean-up; the whole volume is computed only at OK."),
    "Fieldfab_RunScript": RunScript(
        "RunScript", "Run script", "Run a script that makes solids, after asking, and keep their formulas",
        "Asks for a Python script or one of kokopelli, and whether it may run, since it can do whatever you can. "
        "The document keeps the formula of each part that it makes, not the script."),
}
