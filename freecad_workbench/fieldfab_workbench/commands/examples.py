"""Commands that open example documents. Each opens as a new document, so that the installed files stay unchanged."""

import os
import shutil

import FreeCAD
import FreeCADGui

from ..words import tr
from .command import Command

HERE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
FOLDER = os.path.join(HERE, "resources", "examples")
START_PAGE = "User parameter:BaseApp/Preferences/Mod/Start"
BETWEEN = ";;"  # separates folders in ShowCustomFolder, since FreeCAD 0.19


def documents():
    """Returns the files of all examples."""
    return [os.path.join(FOLDER, name) for name in sorted(os.listdir(FOLDER)) if name.endswith(".FCStd")]


def open_copy(path):
    """Returns a new document with a file's contents. Saving it asks for a file name."""
    document = FreeCAD.openDocument(path)
    document.FileName = ""
    FreeCADGui.SendMsgToActiveView("ViewFit")
    return document


class Example(Command):
    """Opens the example in a file."""

    def __init__(self, file, *texts):
        super().__init__(*texts)
        self.path = os.path.join(FOLDER, file)

    def Activated(self):
        open_copy(self.path)


def copies():
    """Returns the folder for the user's own copies of the examples. It may not exist."""
    return os.path.join(FreeCAD.getUserAppDataDir(), "Fieldfab examples")


def folders_of_start_page():
    """Returns the custom folders whose files FreeCAD's start page shows in addition to its own."""
    return [folder
            for folder in FreeCAD.ParamGet(START_PAGE).GetString("ShowCustomFolder", "").split(BETWEEN) if folder]


class OnStartPage(Command):
    """Copies the examples to the user's folder and adds it to FreeCAD's start page, or removes the folder from the
    page. Leaves other folders unchanged."""

    def __init__(self, *texts):
        super().__init__(*texts)
        self.told["Checkable"] = copies() in folders_of_start_page()

    def IsActive(self):
        return True

    def Activated(self, wanted):
        others = [folder for folder in folders_of_start_page() if folder != copies()]
        if wanted:
            os.makedirs(copies(), exist_ok=True)
            for path in documents():
                if not os.path.exists(os.path.join(copies(), os.path.basename(path))):
                    shutil.copy(path, copies())
        FreeCAD.ParamGet(START_PAGE).SetString("ShowCustomFolder",
                                               BETWEEN.join([*others, copies()] if wanted else others))
        FreeCADGui.getMainWindow().statusBar().showMessage(
            tr("FreeCAD's start page is updated when it is opened the next time"), 10000)


TITLE = "Examples"
COMMANDS = {
    "Fieldfab_ExampleBracket": Example(
        "bracket.FCStd", "FrepSolid", "Bracket with parameters",
        "Open a bracket whose measures are parameters, as a new document",
        "Opens a copy of an example: an angle bracket of .frep text. Its measures are properties; "
        "a double-click on it shows text and sliders."),
    "Fieldfab_ExampleLattice": Example(
        "lattice.FCStd", "LatticeInfill", "Knob filled with a gyroid",
        "Open a knob that is filled with a lattice, as a new document",
        "Opens a copy of an example: a knob of .frep text, and a solid made of it by Lattice infill. "
        "Change the wall or the lattice by a double-click."),
    "Fieldfab_ExampleMachining": Example(
        "machining.FCStd", "CamSetup", "Knob milled in five axes",
        "Open a CAM job with a planned five-axis program, as a new document",
        "Opens a copy of an example: a knob, a set-up that clears it and finishes it with a ball cutter that tilts "
        "with the surface, and the planned program. A double-click on the set-up shows its stages."),
    "Separator_Examples": None,
    "Fieldfab_ExamplesOnStartPage": OnStartPage(
        "ShapeGallery", "Show on the start page",
        "Show copies of the examples on FreeCAD's start page, or remove them",
        "Copies the examples into your own folder of FreeCAD and shows this folder on the start page, besides the "
        "folders that you have chosen there. A second press takes the folder from the page again; the copies stay."),
}
