"""File > Export to the formats of Part: STEP, IGES and BREP. FreeCAD's own exporters leave out meshes; here they are
converted to Part shapes first, in the window after a question.

FreeCAD calls `export` here, since file_types.py names this module as the exporter of these formats."""

import functools
import importlib
import os
import tempfile

import FreeCAD

from . import work
from .mistakes import Stopped, in_a_line
from .objects.part_shape import shape_of_object
from .words import tr

EXPORTERS = {"step": "Import", "stp": "Import", "iges": "Part", "igs": "Part", "brep": "Part", "brp": "Part"}


def own_exporter(filename):
    """Returns FreeCAD's exporter module for a file name. Raises ValueError for other formats."""
    ending = os.path.splitext(filename)[1][1:].lower()
    if ending not in EXPORTERS:
        raise ValueError(tr("{filename}: Fieldfab writes no .{ending} files").format(filename=filename, ending=ending))
    name = EXPORTERS[ending]
    return importlib.import_module("ImportGui" if name == "Import" and FreeCAD.GuiUp else name)


def exportOptions(filename):  # the name that FreeCAD calls
    """Returns the options that FreeCAD's own dialog asks for."""
    asked = getattr(own_exporter(filename), "exportOptions", None)
    return asked(filename) if asked else {}


@functools.partial(in_a_line, dialog=True)
def export(objects, filename, options=None):
    """Writes objects in document coordinates with FreeCAD's exporter; solids and meshes as Part shapes. With a window,
    asks first. The file is written whole or not at all. Raises ValueError."""
    write = functools.partial(_write, own_exporter(filename), options)
    meshes = [obj for obj in _leaves(objects) if hasattr(obj, "Mesh") and obj.Mesh.CountFacets]
    if not meshes:
        return write(objects, filename)
    if not _agreed(meshes, filename):
        raise Stopped(tr("{filename}: cancelled, not written").format(filename=filename))
    chosen, before = [*meshes, *(obj for obj in _leaves(objects) if hasattr(obj, "Shape"))], FreeCAD.ActiveDocument
    scratch = FreeCAD.newDocument("FieldfabExport", "FieldfabExport", True, True)
    try:
        made = [_converted(scratch, obj) for obj in chosen]
        with tempfile.TemporaryDirectory(dir=os.path.dirname(os.path.abspath(filename))) as folder:
            path = os.path.join(folder, os.path.basename(filename))
            write(made, path)
            os.replace(path, filename)
    except work.Cancelled:
        raise Stopped(tr("{filename}: cancelled, not written").format(filename=filename)) from None
    finally:
        FreeCAD.closeDocument(scratch.Name)
        if before is not None:
            FreeCAD.setActiveDocument(before.Name)


def _write(exporter, options, objects, filename):
    if options:
        exporter.export(objects, filename, options)
    else:
        exporter.export(objects, filename)


def _leaves(objects):
    """Returns the objects, with those of groups and parts in place of these."""
    found = []
    for obj in objects:
        groups = obj.isDerivedFrom("App::DocumentObjectGroup") or obj.isDerivedFrom("App::Part")
        found += _leaves(obj.Group) if groups else [obj]
    return list(dict.fromkeys(found))


def _converted(document, source):
    """Returns a new object with the Part shape of an object in document coordinates, and its name and colour. FreeCAD
    drops the placement of a single object, so the shape has none."""
    made = document.addObject("Part::Feature", source.Name)
    made.Label = source.Label
    shape = shape_of_object(source, source.Label) if hasattr(source, "Mesh") else source.Shape.copy()
    shape.Placement = FreeCAD.Placement()
    shape.transformShape(source.getGlobalPlacement().toMatrix(), True)
    made.Shape = shape
    if FreeCAD.GuiUp:
        made.ViewObject.ShapeColor = source.ViewObject.ShapeColor
        made.ViewObject.Transparency = source.ViewObject.Transparency
    return made


def _agreed(meshes, filename):
    """Returns whether the user agrees to a conversion; without a window, tells of it."""
    names = ", ".join(obj.Label for obj in meshes)
    format = os.path.splitext(filename)[1][1:].upper()
    if not FreeCAD.GuiUp:
        told = tr("{format} files hold no meshes: {names} is converted to a Part shape").format(
            format=format, names=names)
        FreeCAD.Console.PrintMessage(f"Fieldfab: {told}\n")
        return True
    import FreeCADGui

    from .shim import QtWidgets  # Qt may be missing without a window

    words = tr("{format} files hold no meshes. Convert {names} to a Part shape and write that?").format(
        format=format, names=names)
    box = QtWidgets.QMessageBox
    return box.question(FreeCADGui.getMainWindow(), "Fieldfab", words, box.Yes | box.No, box.Yes) == box.Yes
