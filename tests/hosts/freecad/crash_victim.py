"""Run by freecadcmd, and killed by the test: recomputes and saves the document FIELDFAB_DOCUMENT in a loop, and prints
each step before it begins."""

import os

import FreeCAD

document = FreeCAD.openDocument(os.environ["FIELDFAB_DOCUMENT"])
ball = document.getObject("FrepSolid")
number = 0
while True:
    number += 1
    ball.radius = 5 + number % 7
    print("making", ball.radius, flush=True)
    document.recompute()
    print("saving", ball.radius, flush=True)
    document.save()
    print("saved", ball.radius, flush=True)
