"""File > Open, Import and Export, and dropping files on the window: FreeCAD calls `open`, `insert` and `export` here.

Models come in as parametric objects; what goes out is made anew from them, never cut down to the mesh on the screen. Scripts (.py) do not
come in here: commands/scans.py runs them, once their user has said so."""

import os
import pathlib

import FreeCAD

from . import kernel, openscad_files, work
from .file_types import DESIGNS, MESHES, SLICES, TEXTS, VOLUMES
from .objects.frep_solid import FrepSolid
from .objects.scan import Scan
from .objects.solid import create, is_solid, source_of
from .openscad import OpenScadSource, faces_together
from .words import tr


def open(filename):  # noqa: A001: the name that FreeCAD calls
    """A new document with the file's solid."""
    return insert(filename, "")


def insert(filename, docname):
    """Adds the file's solid to a document, a new one where there is none of that name; in the window a scan's panel opens, and nothing is
    computed before its OK. Returns the object. Raises ValueError with a line for the user, and then adds nothing."""
    ending = _ending(filename)
    if ending in DESIGNS:
        made = openscad_files.insert(filename, docname, name_of(filename))
        if FreeCAD.GuiUp:
            _show_all(made.Document)
        return made
    if ending in TEXTS:
        kind, values = FrepSolid, {"Expression": _text_of(filename)}
    elif ending == "asdf" or ending in VOLUMES or ending in SLICES or os.path.isdir(filename):
        kind, values = Scan, {"File": whole_stack(os.path.abspath(filename))}
    else:
        raise ValueError(tr("{filename}: Fieldfab reads no .{ending} files").format(filename=filename, ending=ending))
    name = name_of(values.get("File", filename))
    if docname in FreeCAD.listDocuments():
        document = FreeCAD.getDocument(docname)
    else:
        document = FreeCAD.newDocument(docname or name)
        document.Label = docname or name
    return add(document, kind, name, **values)


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
        _show_all(document)
    return obj


def _edited(obj):
    """Opens the panel of a new object, unless another is open; it goes on with the undo step, which would else end with FreeCAD's command."""
    import FreeCADGui

    if FreeCADGui.Control.activeDialog():
        return False
    FreeCADGui.getDocument(obj.Document.Name).setEdit(obj.Name)
    return True


def _show_all(document):
    import FreeCADGui

    view = FreeCADGui.getDocument(document.Name).activeView()
    if view is not None and hasattr(view, "viewIsometric"):
        view.viewIsometric()
        view.fitAll()


def export(objects, filename):
    """Writes what the objects bound, united, where they are in the document. The file is written whole or not at all. Raises ValueError."""
    ending = _ending(filename)
    objects = [obj for obj in objects if hasattr(obj, "Mesh") or hasattr(obj, "Shape")]
    if not objects:
        raise ValueError(tr("{filename}: nothing that was chosen bounds a solid").format(filename=filename))
    if ending in TEXTS:
        return _write_text(filename, _united_texts(objects, ending))
    fieldfab = kernel.load()
    sources, settings, designs = [source_of(obj) for obj in objects], _settings(objects), _designs(objects)

    def write(progress):
        if designs and ending in MESHES and (faces := faces_together(designs, progress)) is not None:
            return faces.save(filename)
        field = sources[0].field(progress)
        for source in sources[1:]:
            field = field | source.field(progress)
        if ending == "vdb":
            settings.pop("max_error", None)
            return fieldfab.write_vdb(field, filename, progress=progress, **settings)
        made = fieldfab.build(field, progress=progress, **settings) if ending == "asdf" else fieldfab.mesh(field, progress=progress, exact=False, **settings)
        return made.save(filename)

    if ending not in ("asdf", "vdb", *MESHES):
        raise ValueError(tr("{filename}: Fieldfab writes no .{ending} files").format(filename=filename, ending=ending))
    try:
        work.run(write, tr("Writing {filename}").format(filename=os.path.basename(filename)))
    except fieldfab.Error as error:
        raise ValueError(str(error)) from None
    except work.Cancelled:
        raise ValueError(tr("{filename}: cancelled, not written").format(filename=filename)) from None


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


def _settings(objects):
    """The finest resolution that any of the objects asks for."""
    asked = [obj.Proxy.mesh_settings(obj) for obj in objects if hasattr(getattr(obj, "Proxy", None), "mesh_settings")]
    for obj in objects:
        source = obj.Proxy.source(obj) if hasattr(getattr(obj, "Proxy", None), "source") else None
        voxel = obj.VoxelSize.Value or source.voxel(None) if hasattr(source, "voxel") else None
        if voxel:
            asked.append({"voxel": voxel})
    finest = {name: min(values) for name in ("voxel", "max_error") if (values := [s[name] for s in asked if name in s])}
    if len(objects) == 1 and asked and "bounds" in asked[0] and objects[0].Placement.isIdentity():
        finest["bounds"] = asked[0]["bounds"]
    return finest


def _united_texts(objects, ending):
    """The objects' formulas as one text. Raises ValueError for what has none."""
    fieldfab = kernel.load()
    for obj in objects:
        if not isinstance(getattr(obj, "Proxy", None), FrepSolid):
            raise ValueError(tr("{label} has no formula: export it as .asdf or as a mesh").format(label=obj.Label))
    if ending == "frep" and len(objects) == 1 and _placement(objects[0]).isIdentity():
        return objects[0].Proxy.text(objects[0])
    united = None
    for obj in objects:
        expression = _moved(fieldfab.parse(obj.Proxy.text(obj)), _placement(obj))
        united = expression if united is None else united | expression
    if ending == "frep":
        raise ValueError(tr("one f-rep solid that was not moved can be written as .frep; .math and .vm take several, wherever they are"))
    return united.math() if ending == "math" else united.vm()


def _placement(obj):
    return obj.getGlobalPlacement() if hasattr(obj, "getGlobalPlacement") else obj.Placement


def _moved(expression, placement):
    """An expression where a placement puts its solid: coordinates are taken back."""
    if placement.isIdentity():
        return expression
    fieldfab, m = kernel.load(), placement.inverse().toMatrix()
    rows = ((m.A11, m.A12, m.A13, m.A14), (m.A21, m.A22, m.A23, m.A24), (m.A31, m.A32, m.A33, m.A34))
    return expression.map(*(a * fieldfab.X + b * fieldfab.Y + c * fieldfab.Z + d for a, b, c, d in rows))


def _text_of(filename):
    fieldfab = kernel.load()
    try:
        text = pathlib.Path(filename).read_text(encoding="utf-8")
        if _ending(filename) == "vm":
            return fieldfab.parse_vm(text).math()
        fieldfab.parse(text)
    except (OSError, UnicodeError, fieldfab.Error) as error:
        raise ValueError(f"{filename}: {error}") from None
    return text


def _write_text(filename, text):
    kernel.write_file(filename, text if text.endswith("\n") else text + "\n")


def _ending(filename):
    name = os.path.basename(filename).lower()
    return "nii.gz" if name.endswith(".nii.gz") else os.path.splitext(name)[1][1:]


def name_of(filename):
    """What to call the solid of a file or folder."""
    name = os.path.basename(os.path.normpath(filename))
    return (name[: -len(_ending(filename)) - 1] if _ending(filename) else name) or "Solid"
