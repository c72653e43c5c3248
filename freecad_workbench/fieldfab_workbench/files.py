"""File > Open, Import, Export, and files dropped on the window. FreeCAD calls `open`, `insert` and `export` here.

Models are imported as parametric objects. Export computes the output from these objects, not from the mesh on the
screen. Scripts (.py) are not imported here: commands/scans.py runs them after the user has confirmed it."""

import functools
import os

import FreeCAD

from . import kernel, openscad_files, part_files, preferences, work
from .file_types import SLICES, extensions, format_of
from .mistakes import Stopped, in_a_line
from .objects.file_part import FilePart
from .objects.frep_solid import FrepSolid
from .objects.scan import Scan
from .objects.solid import create, is_solid, source_of
from .openscad import OpenScadSource, faces_together
from .sources import with_cell
from .words import tr


_for_the_user = functools.partial(in_a_line, dialog=True)


def open(filename):  # the name that FreeCAD calls
    """Returns a new document with the file's solid."""
    return insert(filename, "")


@_for_the_user
def insert(filename, docname):
    """Adds the file's solid to the named document, or to a new one if it does not exist. Several parts become a group.
    In the window a scan opens its panel and computes nothing before OK. Returns the object. Raises ValueError with a
    line for the user, and then adds nothing."""
    format = format_of(filename)
    kind = "volume" if _ending(filename) in SLICES or os.path.isdir(filename) else format and format["kind"]
    if kind in ("design", "formula", "mesh"):
        made = (openscad_files if kind == "design" else part_files).insert(filename, docname, name_of(filename))
        if FreeCAD.GuiUp:
            show_all(made.Document)
        return made
    if kind not in ("volume", "distances"):
        raise ValueError(
            tr("{filename}: Fieldfab reads no .{ending} files").format(filename=filename, ending=_ending(filename)))
    path = whole_stack(os.path.abspath(filename))
    name = name_of(path)
    if docname in FreeCAD.listDocuments():
        document = FreeCAD.getDocument(docname)
    else:
        document = FreeCAD.newDocument(docname or name)
        document.Label = docname or name
    return add(document, Scan, name, File=path)


def add(document, kind, label, **values):
    """Adds a solid of a class with property values, in one undo step."""
    began = not document.HasPendingTransaction
    if began:
        document.openTransaction(tr("Import {label}").format(label=label))
    obj = create(kind, document)
    obj.Label = label
    for name, value in values.items():
        setattr(obj, name, value)
    if FreeCAD.GuiUp and kind.NAME == "Scan" and _edited(obj):
        return obj
    document.recompute([obj])
    if began:
        document.commitTransaction()
    if FreeCAD.GuiUp:
        show_all(document)
    return obj


def _edited(obj):
    """Opens the panel of a new object, unless another panel is open. The panel continues the undo step, which would
    otherwise end with FreeCAD's command."""
    import FreeCADGui

    if FreeCADGui.Control.activeDialog():
        return False
    FreeCADGui.getDocument(obj.Document.Name).setEdit(obj.Name)
    return True


def show_all(document):
    """Fits the view to the whole document."""
    import FreeCADGui

    view = FreeCADGui.getDocument(document.Name).activeView()
    if view is not None and hasattr(view, "viewIsometric"):
        view.viewIsometric()
        view.fitAll()


@_for_the_user
def export(objects, filename):
    """Writes the solids of the objects, in document coordinates. If the format supports parts, each object becomes a
    part with its name and colour; otherwise all are united. The file is written whole or not at all. Raises
    ValueError."""
    ending, format = _ending(filename), format_of(filename)
    objects = list(dict.fromkeys(_bounding(objects)))
    if not objects:
        raise ValueError(tr("{filename}: none of the selected objects bounds a solid").format(filename=filename))
    if ending in extensions("formula", reads=True, writes=True):
        write = _writer_of_text
    elif ending in ("vdb", *extensions("distances", "mesh", writes=True)):
        write = _writer_of_parts if format["kind"] == "mesh" and format["parts"] else _writer_of_all
    else:
        raise ValueError(tr("{filename}: Fieldfab writes no .{ending} files").format(filename=filename, ending=ending))
    fieldfab = kernel.load()
    try:
        work.run(write(objects, filename, ending), tr("Writing {filename}").format(filename=os.path.basename(filename)))
    except fieldfab.Error as error:
        raise ValueError(str(error)) from None
    except work.Cancelled:
        raise Stopped(tr("{filename}: cancelled, not written").format(filename=filename)) from None


def _bounding(objects):
    """Returns the objects that bound a solid, including those in groups."""
    for obj in objects:
        if hasattr(obj, "Mesh") or hasattr(obj, "Shape"):
            yield obj
        elif hasattr(obj, "Group"):
            yield from _bounding(obj.Group)


def _writer_of_parts(objects, filename, ending):
    """Returns a function of a progress that writes each object's own mesh as a part. The function does not access the
    document."""
    wanted = [(source_of(obj), _settings_of(obj), obj.Label, _colour_of(obj)) for obj in objects]

    def write(progress):
        parts = [(source.mesh(progress, **settings), label, colour(progress))
                 for source, settings, label, colour in wanted]
        kernel.load().save_parts(parts, filename, progress)

    return write


def _writer_of_text(objects, filename, ending):
    """Returns a function of a progress that writes formulas: one part for each object in .frep text, otherwise their
    union. The function does not access the document. Raises ValueError for an object without a formula."""
    for obj in objects:
        if not isinstance(getattr(obj, "Proxy", None), (FrepSolid, FilePart)):
            raise ValueError(tr("{label} has no formula: export it as .asdf or as a mesh").format(label=obj.Label))
    fieldfab, first, folder = kernel.load(), objects[0], os.path.dirname(os.path.abspath(filename))
    alone = ending == "frep" and len(objects) == 1 and _placement(first).isIdentity()
    text = first.Proxy.text(first) if alone and isinstance(first.Proxy, FrepSolid) else None
    wanted = [(obj.Proxy.source(obj), _placement(obj), obj.Label, _colour_of(obj)) for obj in objects]

    def write(progress):
        parts = [(_moved(source.field(progress), placement), label, colour(progress))
                 for source, placement, label, colour in wanted]
        if ending == "frep":
            return _write_text(filename, text or fieldfab.frep_text(parts, folder))
        united = functools.reduce(lambda a, b: a | b, [solid for solid, _, _ in parts])
        return _write_text(filename, united.math() if ending == "math" else united.vm())

    return write


def _writer_of_all(objects, filename, ending):
    """Returns a function of a progress that writes the union of all objects. The function does not access the
    document."""
    fieldfab, sources, designs = kernel.load(), [source_of(obj) for obj in objects], _designs(objects)
    asked, colours = [_settings_of(obj) for obj in objects], [_colour_of(obj) for obj in objects]

    def write(progress):
        fields = [source.field(progress) for source in sources]
        faces = faces_together(designs, progress) if designs and ending not in ("asdf", "vdb") else None
        united, settings = functools.reduce(lambda a, b: a | b, fields), _finest(fields, asked)
        if ending == "vdb":
            settings.pop("max_error", None)
            return fieldfab.write_vdb(united, filename, progress=progress, **settings)
        if ending == "asdf":
            return fieldfab.build(united, progress=progress, **settings).save(filename)
        mesh = fieldfab.mesh(united, progress=progress, exact=False, **settings) if faces is None else faces
        parts = [(field, None, colour(progress)) for field, colour in zip(fields, colours)]
        mesh.save(filename, parts if ending == "ply" else None)

    return write


def whole_stack(path):
    """Returns the folder of a slice that is not a volume by itself; otherwise the path unchanged."""
    if _ending(path) not in SLICES or not os.path.isfile(path):
        return path
    try:
        kernel.load().Volume.open(path)
        return path
    except kernel.load().Error:
        return os.path.dirname(path)


def _designs(objects):
    """Returns [(source, placement)] if all sources are whole OpenSCAD solids, otherwise []."""
    if not all(is_solid(obj) and obj.AutoBounds for obj in objects):
        return []
    designs = [(obj.Proxy.source(obj), _placement(obj)) for obj in objects]
    return designs if all(isinstance(source, OpenScadSource) for source, _ in designs) else []


def _settings_of(obj):
    """Returns the mesh settings of an object in document coordinates, as keywords of sources.Source.mesh()."""
    settings = obj.Proxy.mesh_settings(obj) if is_solid(obj) else {}
    if not _placement(obj).isIdentity():
        settings.pop("bounds", None)  # in the object's own coordinates
    return settings


def _finest(fields, asked):
    """Returns the finest of several settings, for the union of all fields."""
    if len(fields) == 1:
        return with_cell(fields[0], **asked[0])
    cells = [with_cell(field, **settings) for field, settings in zip(fields, asked)]
    own = [field.voxel for field, settings in zip(fields, cells) if "voxel" not in settings and field.voxel]
    finest = {}
    for name in ("voxel", "max_error"):
        if values := [settings[name] for settings in cells if name in settings]:
            finest[name] = min(values)
    if "voxel" in finest:
        finest["voxel"] = min([finest["voxel"], *own])
    return finest


def _colour_of(obj):
    """Returns a function of a progress that returns the colour of an object: three numbers from 0 to 255, or text. It
    returns None for the default colour of all solids. With a window it is the visible colour, otherwise the file's."""
    if FreeCAD.GuiUp:
        seen = obj.ViewObject.ShapeColor[:3]
        plain = is_solid(obj) and all(abs(a - b) < 1 / 512 for a, b in zip(seen, preferences.colour()))
        return lambda progress: None if plain else [255 * part for part in seen]
    source = obj.Proxy.source(obj) if isinstance(getattr(obj, "Proxy", None), FilePart) else None
    return lambda progress: source and source.colour(progress)


def _placement(obj):
    return obj.getGlobalPlacement() if hasattr(obj, "getGlobalPlacement") else obj.Placement


def _moved(expression, placement):
    """Returns the expression of the placed solid, by the inverse transform of its coordinates."""
    if placement.isIdentity():
        return expression
    fieldfab, m = kernel.load(), placement.inverse().toMatrix()
    rows = ((m.A11, m.A12, m.A13, m.A14), (m.A21, m.A22, m.A23, m.A24), (m.A31, m.A32, m.A33, m.A34))
    return expression.map(*(a * fieldfab.X + b * fieldfab.Y + c * fieldfab.Z + d for a, b, c, d in rows))


def _write_text(filename, text):
    kernel.write_file(filename, text if text.endswith("\n") else text + "\n")


def _ending(filename):
    name = os.path.basename(filename).lower()
    return "nii.gz" if name.endswith(".nii.gz") else os.path.splitext(name)[1][1:]


def name_of(filename):
    """Returns the name for the solid of a file or folder."""
    name = os.path.basename(os.path.normpath(filename))
    return (name[: -len(_ending(filename)) - 1] if _ending(filename) else name) or "Solid"
