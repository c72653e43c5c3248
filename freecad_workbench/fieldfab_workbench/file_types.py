"""Types of files that come in and go out, by the kernel's table of formats, for FreeCAD's start."""

import functools
import json
import os

import FreeCAD

from . import kernel, preferences

SLICES = ("tif", "tiff", "png")  # of stacks
MODULE = "fieldfab_workbench.files"


@functools.cache
def table():
    """The kernel's table, fieldfab.formats(). FreeCAD's start needs it, and loading the kernel takes 0.1 s: it is kept
    with the preferences for as long as the kernel's file is the same. Raises ImportError where there is no kernel."""
    kept, stamp = FreeCAD.ParamGet(preferences.PATH), kernel.stamp()
    if not stamp or kept.GetString("FormatsOf") != stamp:
        kept.SetString("Formats", json.dumps(kernel.load().formats()))
        kept.SetString("FormatsOf", stamp)
    return json.loads(kept.GetString("Formats"))


def extensions(*kinds, **wanted):
    """The extensions, without dots, of the formats of these kinds that have these values: reads, writes, parts."""
    rows = [row
            for row in table() if row["kind"] in kinds and all(row[name] == value for name, value in wanted.items())]
    return tuple(extension[1:] for row in rows for extension in row["extensions"])


def format_of(filename):
    """The row of the table for a file's name, the longest extension that fits; None where there is none."""
    name = os.path.basename(filename).lower()
    fitting = [(extension, row) for row in table() for extension in row["extensions"] if name.endswith(extension)]
    return max(fitting, key=lambda each: len(each[0]))[1] if fitting else None


def pattern(endings):
    """Of a file dialog: "*.stl *.ply"."""
    return " ".join(f"*.{ending}" for ending in endings)


def register():
    """Registers them with FreeCAD, at its start. Without the kernel there are none, and FreeCAD starts all the same."""
    try:
        volumes = extensions("volume", reads=True)
    except ImportError as error:
        FreeCAD.Console.PrintWarning(f"Fieldfab: {error}\n")
        return
    # FreeCAD looks for what follows the last dot.
    volumes = dict.fromkeys([*volumes, *(ending.rsplit(".", 1)[1] for ending in volumes if "." in ending)])
    FreeCAD.addImportType(f"CT volume ({pattern(volumes)})", MODULE)
    FreeCAD.addImportType(f"F-rep ({pattern(extensions('formula', reads=True))})", MODULE)
    FreeCAD.addImportType(f"Distance field ({pattern(extensions('distances', reads=True))})", MODULE)
    FreeCAD.addImportType(f"OpenSCAD design by Fieldfab ({pattern(extensions('design', reads=True))})", MODULE)
    # Other meshes FreeCAD reads itself.
    FreeCAD.addImportType(f"Parts by Fieldfab ({pattern(extensions('mesh', reads=True, parts=True))})", MODULE)
    FreeCAD.addExportType(f"Distance field ({pattern(extensions('distances', writes=True))})", MODULE)
    FreeCAD.addExportType(f"F-rep ({pattern(extensions('formula', reads=True, writes=True))})", MODULE)
    FreeCAD.addExportType("OpenVDB level set (*.vdb)", MODULE)
    FreeCAD.addExportType(f"Mesh by Fieldfab ({pattern(extensions('mesh', writes=True))})", MODULE)
