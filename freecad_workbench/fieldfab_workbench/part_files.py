"""Import of models: formulas and meshes. A model with several parts becomes a group with an object for each part, with
names and colours."""

import os
import pathlib

import FreeCAD

from . import kernel, work
from .importing import cancelled, one_step
from .kernel_messages import translated
from .objects import file_part, frep_solid
from .objects.solid import create
from .parts import names_of, opened_by
from .words import tr


def insert(filename, docname, name):
    """Adds a model to the named document, or to a new one if it does not exist. Returns its solid, or the group of its
    parts. A formula with a single solid that opens no other files is imported as text; other objects follow the file.
    Raises ValueError with a line for the user, and then leaves the document unchanged."""
    fieldfab, filename = kernel.load(), os.path.abspath(filename)
    try:
        title = tr("Reading {name}").format(name=os.path.basename(filename))
        model = work.run(lambda progress: fieldfab.open_model(filename, progress), title)
        text = _own_text(filename, model)
    except (fieldfab.Error, OSError, UnicodeError) as error:
        raise ValueError(str(error) if isinstance(error, fieldfab.Error) else f"{filename}: {error}") from None
    except work.Cancelled:
        raise cancelled(filename) from None
    for note in model.notes:
        FreeCAD.Console.PrintWarning(translated(note) + "\n")
    if text is not None:
        return add(filename, docname, name, frep_solid.FrepSolid, [(*model.parts[0][1:], {"Expression": text})])
    opened, several = opened_by(model, filename), len(model.parts) > 1
    return add(filename, docname, name, file_part.FilePart, [
        (own, colour, {"File": filename, "Opened": opened, "Part": addressed if several else ""})
        for addressed, (_, own, colour) in zip(names_of(model), model.parts)])


def _own_text(filename, model):
    """Returns the text of a formula with a single solid that opens no other files, otherwise None. Raises OSError,
    UnicodeError."""
    if len(model.parts) > 1 or len(model.files) > 1 or model.parts[0][0].kind != "f-rep":
        return None
    if filename.lower().endswith(".vm"):
        return model.parts[0][0].math()
    return pathlib.Path(filename).read_text(encoding="utf-8")


def add(filename, docname, name, kind, parts):
    """Adds solids of a class in one undo step; `parts` has (name or None, colour or None, {property: value}) of each.
    Several parts go into a group with the given name. Returns the group or the single solid. Raises ValueError as
    insert() does."""
    with one_step(filename, docname, name) as (document, made):
        group = document.addObject("App::DocumentObjectGroup", "Parts") if len(parts) > 1 else None
        if group is not None:
            made.append(group)
            group.Label = name
        for own, colour, values in parts:
            obj = create(kind, document)
            made.append(obj)
            obj.Label = own or name
            for property_name, value in values.items():
                setattr(obj, property_name, value)
            if colour and FreeCAD.GuiUp:
                obj.ViewObject.ShapeColor = tuple(int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5))
            if group is not None:
                group.addObject(obj)
            try:
                obj.Proxy.make_mesh(obj)
            except ValueError:
                pass  # the next recompute marks the object with its error; the other parts remain valid
    return group or obj
