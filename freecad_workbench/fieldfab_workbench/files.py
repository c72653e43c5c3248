"""File > Open, Import and Export, and dropping files on the window: FreeCAD calls `open`, `insert` and `export` here.

Models come in as parametric objects; what goes out is made anew from them, never cut down to the mesh on the screen.
Scripts (.py) do not come in here: commands/scans.py runs them, once their user has said so."""

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


def open(filename):  # noqa: A001: the name that FreeCAD calls
    """A new document with the file's solid."""
    return insert(filename, "")


@_for_the_user
def insert(filename, docname):
    """Adds the file's solid to a document, or to a new one where none has that name; several parts become a group. In
    the window a scan opens its panel, and nothing is computed before OK. Returns the object. Raises ValueError with a
    line for the user; then nothing is added."""
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
    """A solid of a class, with values, in one undo step."""
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
    """Opens the panel of a new object, unless another is open. The panel continues the undo step, which would otherwise
    end with FreeCAD's command."""
    import FreeCADGui

    if FreeCADGui.Control.activeDialog():
        return False
    FreeCADGui.getDocument(obj.Document.Name).setEdit(obj.Name)
    return True


def show_all(document):
    """Brings all of a document into view."""
    import FreeCADGui

    view = FreeCADGui.getDocument(document.Name).activeView()
    if view is not None and hasattr(view, "viewIsometric"):
        view.viewIsometric()
        view.fitAll()


@_for_the_user
def export(objects, filename):
    """Writes what the objects bound, where they are in the document: each as a part with its name and colour where the
    format keeps parts, else all united. The file is written whole or not at all. Raises ValueError."""
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
    """Those that bound a solid, and those in groups."""
    for obj in objects:
        if hasattr(obj, "Mesh") or hasattr(obj, "Shape"):
            yield obj
        elif hasattr(obj, "Group"):
            yield from _bounding(obj.Group)


def _writer_of_parts(objects, filename, ending):
    """A function of a progress that writes each object's own mesh; it does not look at the document."""
    wanted = [(source_of(obj), _settings_of(obj), obj.Label, _colour_of(obj)) for obj in objects]

    def write(progress):
        parts = [(source.mesh(progress, **settings), label, colour(progress))
                 for source, settings, label, colour in wanted]
        kernel.load().save_parts(parts, filename, progress)

    return write


def _writer_of_text(objects, filename, ending):
    """A function of a progress that writes formulas, in .frep text a part each, else united; it does not look at the
    document. Raises ValueError for an object that has none."""
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
    """A function of a progress that writes all objects as one; it does not look at the document."""
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
    """The folder of a slice that alone is no volume; else the path as it is."""
    if _ending(path) not in SLICES or not os.path.isfile(path):
        return path
    try:
        kernel.load().Volume.open(path)
        return path
    except kernel.load().Error:
        return os.path.dirname(path)


def _designs(objects):
    """[(source, placement)] where all are whole solids of OpenSCAD's, else nothing."""
    if not all(is_solid(obj) and obj.AutoBounds for obj in objects):
        return []
    designs = [(obj.Proxy.source(obj), _placement(obj)) for obj in objects]
    return designs if all(isinstance(source, OpenScadSource) for source, _ in designs) else []


def _settings_of(obj):
    """How finely an object asks to be made where it is in the document: settings of sources.Source.mesh()."""
    settings = obj.Proxy.mesh_settings(obj) if is_solid(obj) else {}
    if not _placement(obj).isIdentity():
        settings.pop("bounds", None)  # they are its own coordinates'
    return settings


def _finest(fields, asked):
    """The finest of settings, for all fields united."""
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
    """A function of a progress that tells the colour of an object, three numbers from 0 to 255 or words; None for that
    which all solids have. In the window it is what is seen, else that of the file."""
    if FreeCAD.GuiUp:
        seen = obj.ViewObject.ShapeColor[:3]
        plain = is_solid(obj) and all(abs(a - b) < 1 / 512 for a, b in zip(seen, preferences.colour()))
        return lambda progress: None if plain else [255 * part for part in seen]
    source = obj.Proxy.source(obj) if isinstance(getattr(obj, "Proxy", None), FilePart) else None
    return lambda progress: source and source.colour(progress)


def _placement(obj):
    return obj.getGlobalPlacement() if hasattr(obj, "getGlobalPlacement") else obj.Placement


def _moved(expression, placement):
    """An expression where a placement puts its solid: coordinates are taken back."""
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
    """What to call the solid of a file or folder."""
    name = os.path.basename(os.path.normpath(filename))
    return (name[: -len(_ending(filename)) - 1] if _ending(filename) else name) or "Solid"
