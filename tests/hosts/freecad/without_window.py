"""Run by freecadcmd: the f-rep solid without a window. Writes its results, as JSON, to the file named by
FIELDFAB_RESULT."""

import json
import os
import traceback

import FreeCAD

seen = {}
try:
    from fieldfab_workbench.objects import frep_solid, solid as solids

    document = FreeCAD.newDocument("test")
    document.UndoMode = 1
    other = document.addObject("Mesh::Feature", "Other")
    solid = solids.create(frep_solid.FrepSolid, document)
    solid.Expression = "sphere(r = 10)"
    solid.VoxelSize = "0.5 mm"
    document.recompute()
    seen["valid"] = solid.isValid()
    seen["volume"] = solid.Volume.Value
    seen["triangles"] = solid.Mesh.CountFacets
    seen["counted"] = solid.Triangles
    seen["solid"] = solid.Mesh.isSolid()
    seen["self_intersections"] = solid.Mesh.hasSelfIntersections()

    document.openTransaction("break it")
    solid.Expression = "spheer(r = 10)"
    document.recompute()
    seen["broken_valid"] = solid.isValid()
    seen["broken_state"] = list(solid.State)
    seen["broken_message"] = solid.getStatusString()
    seen["broken_triangles"] = solid.Mesh.CountFacets
    seen["other_valid"] = other.isValid()
    document.commitTransaction()
    document.undo()
    document.recompute()
    seen["undone_expression"] = solid.Expression
    seen["undone_valid"] = solid.isValid()

    solid.Expression = "-r++qXqYqZf5"  # a prefix math string is accepted, too
    document.recompute()
    seen["math_volume"] = solid.Volume.Value
    solid.AutoBounds = False
    solid.Lower = FreeCAD.Vector(-10, -10, -10)
    solid.Upper = FreeCAD.Vector(10, 10, 0)
    document.recompute()
    seen["half_volume"] = solid.Volume.Value

    path = os.path.join(os.path.dirname(os.environ["FIELDFAB_RESULT"]), "saved.FCStd")
    document.saveAs(path)
    triangles = solid.Mesh.CountFacets
    FreeCAD.closeDocument("test")
    again = FreeCAD.openDocument(path)
    solid = again.getObject("FrepSolid")
    seen["reopened_same"] = solid.Mesh.CountFacets == triangles
    solid.Expression = "box(2, 3, 4)"
    again.recompute()
    seen["reopened_volume"] = solid.Volume.Value
except Exception:
    seen["error"] = traceback.format_exc()
with open(os.environ["FIELDFAB_RESULT"], "w") as file:
    json.dump(seen, file)
