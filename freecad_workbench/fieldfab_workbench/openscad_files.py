"""Import of OpenSCAD designs: .csg files directly, .scad files through the installed OpenSCAD. Adds one tree of objects
in one undo step, or none."""

import os

import FreeCAD

from . import kernel, work
from .importing import cancelled, one_step
from .kernel_messages import translated
from .objects import combine, modify, openscad_node, solid
from .openscad_tree import MOST_PARTS, Design, Part, TooLarge
from .words import tr

TINT = (1.0, 0.32, 0.32)  # colour of highlighted parts (#)
BACKGROUND, TRANSPARENCY = (0.6, 0.6, 0.65), 70  # looks of background parts (%)


def insert(filename, docname, name):
    """Adds a design to the named document, or to a new one if it does not exist. Returns the root object. Only the root
    and the design's background parts are visible. Raises ValueError with a line for the user, and then leaves the
    document unchanged."""
    fieldfab, filename = kernel.load(), os.path.abspath(filename)
    try:
        tree = work.run(lambda progress: fieldfab.read_openscad_tree(filename, progress=progress),
                        tr("Reading {name}").format(name=os.path.basename(filename)))
    except fieldfab.Error as error:
        raise ValueError(str(error)) from None
    except work.Cancelled:
        raise cancelled(filename) from None
    root, shown = _parts(tree, filename)
    if root is None:
        raise ValueError(tr("{filename}: the design is empty").format(filename=filename))
    with one_step(filename, docname, name) as (document, made):
        return _add(document, root, shown, name, made)


def _parts(tree, filename):
    """Returns (root, background parts) of a tree. A tree with too many parts becomes one part with its text."""
    folder = os.path.dirname(filename)
    try:
        design = Design(tree, folder)
        root, shown, branches = design.root, design.shown, design.branches
    except TooLarge:
        root, shown, branches = Part("design", "text", {"Text": tree[0].text(), "Folder": folder}), [], 1
    if branches:
        FreeCAD.Console.PrintMessage(tr(
                                        "{filename}: more than {most} parts; {count} branches became one object "
                                        "each, with their text").format(
                                            filename=filename, most=MOST_PARTS, count=branches) + "\n")
    return (root, shown) if tree[0].dimensions else (None, [])


def _add(document, root, shown, name, made):
    """Creates all objects, and the meshes of the visible ones. Appends the objects to `made`. Raises ValueError and
    work.Cancelled."""
    top = _create(document, root, made)
    for obj in made:
        if obj.Label == name:  # labels are unique, and the root gets the file's name
            obj.Label = f"{name} 1"
    top.Label = name
    _show(top)
    for part in shown:
        _add_shown(document, part, made)
    return top


def _add_shown(document, part, made):
    """Adds a background part. An error is only a warning, since the design does not depend on the part."""
    own = []
    try:
        obj = _create(document, part, own)
        _look(obj, BACKGROUND, TRANSPARENCY)
        _show(obj)
        made += own
    except ValueError as error:
        for obj in reversed(own):
            document.removeObject(obj.Name)
        FreeCAD.Console.PrintWarning(translated(str(error)) + "\n")
    except work.Cancelled:
        made += own
        raise


def _show(obj):
    """Makes the object's mesh and shows it. Raises ValueError and work.Cancelled."""
    obj.OnlyWhenShown, obj.Visibility = False, True
    obj.Proxy.make_mesh(obj)
    for note in getattr(obj.Proxy.source(obj), "notes", list)():
        FreeCAD.Console.PrintWarning(translated(note) + "\n")


def _create(document, part, made):
    """Creates the hidden objects of a part, children first. Returns the object of the part."""
    children = [_create(document, child, made) for child in part.children]
    kind = {"node": openscad_node.OpenScadNode, "set": combine.Combine, "scaled": modify.Modify,
            "text": openscad_node.OpenScadText}[part.make]
    obj = solid.create(kind, document, part.label)
    made.append(obj)
    obj.Label = part.label
    for name, value in part.values.items():
        setattr(obj, name, value)
    if part.make == "scaled":
        obj.Source = children[0]
    elif children:
        obj.Sources = children
    obj.Placement, obj.OnlyWhenShown, obj.Visibility = part.placement, True, False
    if part.highlight:
        _look(obj, TINT, 0)
    elif part.colour:
        _look(obj, part.colour[:3], round(100 * (1 - part.colour[3])))
    return obj


def _look(obj, colour, transparency):
    if FreeCAD.GuiUp:
        obj.ViewObject.ShapeColor, obj.ViewObject.Transparency = colour, transparency
