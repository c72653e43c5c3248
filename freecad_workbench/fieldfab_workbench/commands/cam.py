"""Commands for machining: set-ups, operations, plans and their results. Modules that need numpy are imported inside
functions, because the workbench must load quickly."""

import os
import re
import tempfile
import webbrowser

import FreeCAD
import FreeCADGui

from ..kernel_messages import translated
from .. import path_shim
from ..objects import cam_operation, cam_setup, cam_tool
from ..shim import QtWidgets
from ..words import tr
from .command import Command
from .solids import selected


def chosen_setup():
    """Returns the selected set-up, or the set-up to which a selected object belongs; otherwise the document's set-up if
    there is exactly one; otherwise None."""
    for obj in FreeCADGui.Selection.getSelection():
        for candidate in (obj, getattr(obj, "Setup", None), cam_setup.setup_of(obj),
                          getattr(getattr(obj, "Program", None), "Setup", None)):
            if candidate is not None and cam_setup.is_setup(candidate):
                return candidate
    every = [obj for obj in FreeCAD.ActiveDocument.Objects if cam_setup.is_setup(obj)] if FreeCAD.ActiveDocument else []
    return every[0] if len(every) == 1 else None


def chosen_program():
    """Returns the selected program, otherwise the first planned program of the chosen set-up, otherwise None."""
    for obj in FreeCADGui.Selection.getSelection():
        if getattr(getattr(obj, "Proxy", None), "NAME", "") == "MachineProgram":
            return obj
    setup = chosen_setup()
    return next((program for program in cam_setup.programs_of(setup) if program.MadeFrom), None) if setup else None


class NewSetup(Command):
    def ready(self):
        return bool(selected())

    def Activated(self):
        document, part = FreeCAD.ActiveDocument, selected()[0]
        document.openTransaction(self.title)
        setup = cam_setup.create(document, part)
        cam_tool.add(setup, {"diameter": 3})
        cam_operation.add(setup, "rough")
        document.recompute([setup])
        FreeCADGui.Selection.clearSelection()  # the selection colour would hide the part's own
        FreeCADGui.ActiveDocument.setEdit(setup.Name)


class AddOperation(Command):
    def ready(self):
        return chosen_setup() is not None

    def Activated(self):
        setup = chosen_setup()
        setup.Document.openTransaction(self.title)
        operation = cam_operation.add(setup, "finish" if setup.Operations else "rough")
        setup.Document.recompute([operation])
        FreeCADGui.ActiveDocument.setEdit(operation.Name)


class Plan(Command):
    def ready(self):
        return chosen_setup() is not None

    def Activated(self):
        from ..objects import machine_program  # needs numpy

        setup = chosen_setup()
        document = setup.Document
        document.openTransaction(self.title)
        program = next(iter(cam_setup.programs_of(setup)), None) or machine_program.create(setup)
        program.touch()
        document.recompute([program])
        document.commitTransaction()
        message = tr("{label}: about {time}").format(label=program.Label, time=machine_program.clock(program.Seconds))
        message = message if program.isValid() else program.getStatusString()
        FreeCADGui.getMainWindow().statusBar().showMessage(message, 10000)


class _OfProgram(Command):
    """A command for a planned program."""

    def ready(self):
        return chosen_program() is not None


class WriteMachineFile(_OfProgram):
    def Activated(self):
        from ..objects import machine_program  # needs numpy
        from ..panels.program_preview import ProgramPreview  # needs numpy, too

        program = chosen_program()
        text = machine_program.machine_file(program).decode("utf-8", "replace")
        about = tr("About {time}").format(time=machine_program.clock(program.Seconds))
        self.preview = ProgramPreview(program.Label, text, about, FreeCADGui.getMainWindow())
        self.preview.accepted.connect(lambda: self.save(program))
        self.preview.open()

    def save(self, program):
        """Asks for a file name and writes the program."""
        suggested = os.path.join(os.path.dirname(program.Document.FileName), file_name(program))
        kinds = f"{program.Setup.Machine} (*{program.Extension})"
        path, kind = QtWidgets.QFileDialog.getSaveFileName(FreeCADGui.getMainWindow(), self.title, suggested, kinds)
        if path:
            write(program, path)


def file_name(program):
    """Returns the default file name: the part's label without characters that file systems reject. If several set-ups
    make the part, the set-up's label follows."""
    part = program.Setup.Part
    others = [obj for obj in program.Document.Objects
              if cam_setup.is_setup(obj) and obj != program.Setup and obj.Part == part]
    name = " ".join(filter(None, [part.Label if part else "", program.Setup.Label if others or not part else ""]))
    return re.sub(r'[\\/:*?"<>|\x00-\x1f]+', "_", name).strip(" .") + program.Extension


def write(program, path):
    """Writes the machine's file. Reports success in the status bar and an error in a dialog."""
    from ..objects import machine_program  # needs numpy

    window = FreeCADGui.getMainWindow()
    try:
        machine_program.write_machine_file(program, path)
    except (ValueError, OSError) as error:
        QtWidgets.QMessageBox.warning(window, "Fieldfab", translated(str(error)))
    else:
        window.statusBar().showMessage(tr("{path} is written").format(path=path), 10000)


class SetupSheet(_OfProgram):
    def Activated(self):
        from ..objects import machine_program  # needs numpy

        path = os.path.join(tempfile.mkdtemp(prefix="fieldfab_"), "setup.html")
        machine_program.write_setup_sheet(chosen_program(), path)
        webbrowser.open(f"file://{path}")


class ToPath(_OfProgram):
    def Activated(self):
        from .. import path_jobs  # needs numpy

        program = chosen_program()
        document = program.Document
        job = next((obj for obj in [*FreeCADGui.Selection.getSelection(), *document.Objects] if path_shim.is_job(obj)),
                   None)
        document.openTransaction(self.title)
        try:
            path_jobs.to_job(program, job)
        except (ValueError, ImportError) as error:
            document.abortTransaction()
            QtWidgets.QMessageBox.warning(FreeCADGui.getMainWindow(), "Fieldfab", translated(str(error)))
            return
        document.recompute()
        document.commitTransaction()
        program.ViewObject.Visibility = False


TITLE = "CAM"
COMMANDS = {
    "Fieldfab_NewCamSetup": NewSetup(
        "CamSetup", "New CAM job", "Machine the selected solid: stock, tools, operations and a machine",
        "Adds a job that machines the selected solid, mesh, Part object or body. The panel asks for the stock, the "
        "tools, the operations in order and the machine, and plans all paths in the background."),
    "Fieldfab_AddOperation": AddOperation(
        "CamOperation", "Add operation", "Add an operation to the CAM job",
        "Adds an operation, such as roughing or finishing, at the end of the selected job, or of the document's "
        "only one. The panel asks for the kind of operation, the tool and the settings of each stage; empty "
        "settings have their defaults."),
    "Fieldfab_Plan": Plan(
        "Plan", "Plan", "Plan all paths of the CAM job",
        "Plans the machine program of the selected job, or of the document's only one, with a progress box. "
        "A plan that fails or is cancelled keeps the last good one."),
    "Separator_Cam": None,
    "Fieldfab_WriteMachineFile": WriteMachineFile(
        "WriteMachineFile", "Post process", "Show the program in the machine's format, and save it",
        "Shows the planned program of the selected job in the machine's format, such as G-code, with line numbers. "
        "Save asks for the file name; the default is the part's name."),
    "Fieldfab_SetupSheet": SetupSheet(
        "SetupSheet", "Set-up sheet", "Show the page for the machine operator",
        "Opens the set-up sheet of the planned program in the browser: "
        "stock, zero, tools, times and pictures, ready to be printed."),
    "Fieldfab_ToPath": ToPath(
        "ToPath", "To Path job",
        "Add the program's operations to a job of FreeCAD's Path workbench",
        "Puts the planned operations as paths into a job of FreeCAD's Path workbench: into the selected or the first "
        "one of the document, else into a new one with the set-up's stock and tools. The paths follow the program."),
}
