"""Run by freecadcmd after crashes: opens each document of FIELDFAB_DOCUMENTS and writes its contents, as JSON, to
FIELDFAB_RESULT."""

import json
import os

import FreeCAD


def look(path):
    try:
        document = FreeCAD.openDocument(path)
        ball = document.getObject("FrepSolid")
        before = ball.MadeFrom
        seen = {"radius": ball.radius, "triangles": ball.Triangles, "facets": ball.Mesh.CountFacets,
                "closed": ball.Mesh.isSolid(), "volume": ball.Volume.Value, "measured": ball.Mesh.Volume}
        document.recompute()
        seen.update(valid=ball.isValid(), recomputed=ball.MadeFrom != before)
        FreeCAD.closeDocument(document.Name)
        return seen
    except Exception as error:
        return {"error": repr(error)}


told = {path: look(path) for path in os.environ["FIELDFAB_DOCUMENTS"].split(os.pathsep)}
with open(os.environ["FIELDFAB_RESULT"], "w") as file:
    json.dump(told, file)
os._exit(0)
