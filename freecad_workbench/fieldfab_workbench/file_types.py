"""File types for import and export, from the kernel's table of formats. FreeCAD loads this module at its start."""

import functools
import json
import os

import FreeCAD

from . import kernel, preferences

SLICES = ("tif", "tiff", "png")  # extensions of the slices of a stack
MODULE = "fieldfab_workbench.files"
SHAPE_MODULE = "fieldfab_workbench.shape_files"
# FreeCAD's filters of the formats of Part shapes, and its exporters of each.
SHAPE_FILTERS = {"STEP with colors (*.step *.stp)": ("Import", "ImportGui"), "IGES format (*.iges *.igs)": ("Part",),
                 "BREP format (*.brep *.brp)": ("Part",)}


@functools.cache
def table():
    """Returns the kernel's table, fieldfab.formats(). Loading the kernel takes 0.1 s at FreeCAD's start, so the table
    is cached in the preferences until the kernel's file changes. Raises ImportError if there is no kernel."""
    kept, stamp = FreeCAD.ParamGet(preferences.PATH), kernel.stamp()
    if not stamp or kept.GetString("FormatsOf") != stamp:
        kept.SetString("Formats", json.dumps(kernel.load().formats()))
        kept.SetString("FormatsOf", stamp)
    return json.loads(kept.GetString("Formats"))


def extensions(*kinds, **wanted):
    """Returns the extensions, without dots, of all formats of these kinds with the wanted values of `reads`, `writes`
    and `parts`."""
    rows = [row
            for row in table() if row["kind"] in kinds and all(row[name] == value for name, value in wanted.items())]
    return tuple(extension[1:] for row in rows for extension in row["extensions"])


def format_of(filename):
    """Returns the row of the table for a file name, by its longest matching extension, or None."""
    name = os.path.basename(filename).lower()
    fitting = [(extension, row) for row in table() for extension in row["extensions"] if name.endswith(extension)]
    return max(fitting, key=lambda each: len(each[0]))[1] if fitting else None


def pattern(endings):
    """Returns the extensions as a pattern for a file dialog, such as "*.stl *.ply"."""
    return " ".join(f"*.{ending}" for ending in endings)


def register():
    """Registers the file types with FreeCAD at its start. Without a kernel it registers none, and FreeCAD still
    starts."""
    try:
        volumes = extensions("volume", reads=True)
    except ImportError as error:
        FreeCAD.Console.PrintWarning(f"Fieldfab: {error}\n")
        return
    # FreeCAD compares only the part after the last dot.
    volumes = dict.fromkeys([*volumes, *(ending.rsplit(".", 1)[1] for ending in volumes if "." in ending)])
    FreeCAD.addImportType(f"CT volume ({pattern(volumes)})", MODULE)
    FreeCAD.addImportType(f"F-rep ({pattern(extensions('formula', reads=True))})", MODULE)
    FreeCAD.addImportType(f"Distance field ({pattern(extensions('distances', reads=True))})", MODULE)
    FreeCAD.addImportType(f"OpenSCAD design by Fieldfab ({pattern(extensions('design', reads=True))})", MODULE)
    # FreeCAD itself reads all other meshes.
    FreeCAD.addImportType(f"Parts by Fieldfab ({pattern(extensions('mesh', reads=True, parts=True))})", MODULE)
    FreeCAD.addExportType(f"Distance field ({pattern(extensions('distances', writes=True))})", MODULE)
    FreeCAD.addExportType(f"F-rep ({pattern(extensions('formula', reads=True, writes=True))})", MODULE)
    FreeCAD.addExportType("OpenVDB level set (*.vdb)", MODULE)
    FreeCAD.addExportType(f"Mesh by Fieldfab ({pattern(extensions('mesh', writes=True))})", MODULE)


def take_over_shapes():
    """Makes shape_files the exporter of Part's formats, in place of FreeCAD's exporters, which leave out meshes."""
    for name, modules in SHAPE_FILTERS.items():
        for module in modules:
            FreeCAD.changeExportModule(name, module, SHAPE_MODULE)
