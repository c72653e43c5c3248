"""The types of files that come in and go out. FreeCAD is told of them at its start, before their readers are loaded."""

import FreeCAD

VOLUMES = ("raw", "vol", "vgi", "tif", "tiff", "mha", "mhd", "nrrd", "nhdr", "nii", "nii.gz", "gz", "dcm", "dicom",
           "ima", "vdb")
SLICES = ("tif", "tiff", "png")
TEXTS = ("frep", "math", "vm")
DESIGNS = ("scad", "csg")
MESHES = ("stl", "ply", "off", "obj", "3mf")
MODULE = "fieldfab_workbench.files"


def register():
    """Tells FreeCAD of them, at its start."""

    def pattern(extensions):
        return " ".join(f"*.{extension}" for extension in extensions)

    FreeCAD.addImportType(f"CT volume ({pattern(VOLUMES)})", MODULE)
    FreeCAD.addImportType(f"F-rep ({pattern(TEXTS)})", MODULE)
    FreeCAD.addImportType("Distance field (*.asdf)", MODULE)
    FreeCAD.addImportType(f"OpenSCAD design by Fieldfab ({pattern(DESIGNS)})", MODULE)
    FreeCAD.addExportType("Distance field (*.asdf)", MODULE)
    FreeCAD.addExportType("F-rep (*.frep *.math *.vm)", MODULE)
    FreeCAD.addExportType("OpenVDB level set (*.vdb)", MODULE)
    FreeCAD.addExportType(f"Mesh by Fieldfab ({pattern(MESHES)})", MODULE)
