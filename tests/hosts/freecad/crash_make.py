"""Run by freecadcmd: makes the document FIELDFAB_DOCUMENT with a ball in it."""

import os

import FreeCAD

from fieldfab_workbench.objects import frep_solid, solid

document = FreeCAD.newDocument()
ball = solid.create(frep_solid.FrepSolid, document)
ball.Expression, ball.VoxelSize, ball.MaxError = "radius = 5\nsphere(radius)", 0.15, 0.001
document.recompute()
document.saveAs(os.environ["FIELDFAB_DOCUMENT"])
os._exit(0)
