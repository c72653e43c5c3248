"""Commands that make solids from scans and other files."""

import os
import shutil
import subprocess
import tempfile

import FreeCAD
import FreeCADGui

from .. import files, kernel, part_files, work
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
                buttons.warning(window, self.title, str(error) or tr("The script was stopped."))


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
    python_path = os.pathsep.join([os.path.dirname(os.path.dirname(fieldfab.__file__)),
                                   os.environ.get("PYTHONPATH", "")]).rstrip(os.pathsep)
    with tempfile.TemporaryFile() as said:
        process = subprocess.Popen([shutil.which("python3") or "python3", "-m", "fieldfab.script", path],
                                   env={**os.environ, "PYTHONPATH": python_path},
                                   stdin=subprocess.DEVNULL, stdout=said, stderr=subprocess.DEVNULL)
        try:
            while process.poll() is None:
                if progress(0, "") is False:
                    raise work.Cancelled()
                try:
                    process.wait(0.05)
                except subprocess.TimeoutExpired:
                    pass
        finally:
            process.kill()
            process.wait()
        said.seek(0)
        answer = said.read().decode(errors="replace")
    if answer.startswith("ok\n"):
        try:
            return [(name, colour, {"Expression": solid.math()})
                    for solid, name, colour in fieldfab.parse_parts(answer[3:])]
        except fieldfab.Error as error:
            raise ValueError(f"{path}: {error}") from None
    _, line, message = (
        answer.split(" ", 2) if answer.startswith("error ") else ("", "0", tr("the process ended without a result")))
    raise ValueError(f"{path}{':' + line if line != '0' else ''}: {message}")


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
