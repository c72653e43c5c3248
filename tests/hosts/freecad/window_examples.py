"""Runs inside FreeCAD's window: the example documents, and FreeCAD's start page."""

import hashlib
import importlib.util
import os
import zipfile

import FreeCAD
import FreeCADGui
import pytest
from window import live, shot

from fieldfab_workbench.commands import examples
from fieldfab_workbench.shim import QtGui

FILES = examples.documents()


def digest(path):
    with open(path, "rb") as file:
        return hashlib.sha1(file.read()).hexdigest()


def test_every_example_has_a_command_and_a_picture():
    FreeCADGui.activateWorkbench("FieldfabWorkbench")
    assert ([command.path for command in examples.COMMANDS.values() if isinstance(command, examples.Example)] == FILES
            and len(FILES) == 3)
    for path in FILES:
        assert os.path.getsize(path) < 450_000
        with zipfile.ZipFile(path) as held:
            assert held.namelist()[0] == "Document.xml"  # required by FreeCAD's start page
            picture = QtGui.QImage.fromData(held.read("thumbnails/Thumbnail.png"))
        assert (picture.width() == 256
                and len({picture.pixel(x, y) for x in range(0, 256, 8) for y in range(0, 256, 8)}) > 40)


@pytest.mark.parametrize("name",
                         [name for name, command in examples.COMMANDS.items() if isinstance(command, examples.Example)])
def test_it_opens_as_a_new_document_with_its_meshes_and_recomputes(name):
    path = examples.COMMANDS[name].path
    before = digest(path)
    FreeCADGui.runCommand(name)
    document = FreeCAD.ActiveDocument
    try:
        assert document.FileName == ""
        meshes = {obj.Name: obj.Mesh.CountFacets for obj in document.Objects if hasattr(obj, "Mesh")}
        programs = {obj.Name: obj.MadeFrom for obj in document.Objects if obj.Proxy.NAME == "MachineProgram"}
        assert meshes and all(meshes.values()) and all(programs.values()) and bool(programs) == ("machining" in path)
        live(0.3)
        shot(f"example_{document.Label}")
        for obj in document.Objects:
            obj.touch()
            if hasattr(obj, "MadeFrom"):
                obj.MadeFrom = ""  # forces a recomputation
        document.recompute()
        assert [obj.Label for obj in document.Objects if not obj.isValid()] == []
        assert {obj.Name: obj.Mesh.CountFacets for obj in document.Objects if hasattr(obj, "Mesh")} == meshes
        assert {name: document.getObject(name).MadeFrom for name in programs} == programs
        assert digest(path) == before
    finally:
        FreeCAD.closeDocument(document.Name)


def test_the_start_page_shows_copies_besides_the_users_own_folders(tmp_path, monkeypatch):
    group = FreeCAD.ParamGet(examples.START_PAGE)
    before = group.GetString("ShowCustomFolder", "")
    group.SetString("ShowCustomFolder", f"{tmp_path}")
    command = examples.COMMANDS["Fieldfab_ExamplesOnStartPage"]
    command.Activated(1)
    command.Activated(1)
    assert group.GetString("ShowCustomFolder") == f"{tmp_path};;{examples.copies()}"
    assert [digest(os.path.join(examples.copies(), os.path.basename(path)))
            for path in FILES] == [digest(path) for path in FILES]
    if importlib.util.find_spec("StartPage"):  # FreeCAD 1.x has no function that returns its page's text
        page = importlib.import_module("StartPage.StartPage").handle()
        assert ("Fieldfab examples" in page and all(os.path.basename(path) in page for path in FILES)
                and tmp_path.name in page)
    command.Activated(0)
    assert group.GetString("ShowCustomFolder") == f"{tmp_path}"
    group.SetString("ShowCustomFolder", before)
