"""Makes a solid with the installed workbench; FreeCAD runs it, with or without a window. SHOT: file of a screenshot."""

import os

import FreeCAD


def make():
    from fieldfab_workbench.objects import frep_solid, solid

    document = FreeCAD.newDocument("Newcomer")
    ball = solid.create(frep_solid.FrepSolid, document)
    ball.Expression, ball.VoxelSize = "difference(rounded_box(40, 30, 20, 4), cylinder(r = 8, h = 40))", 0.5
    document.recompute()
    assert ball.isValid(), ball.getStatusString()
    print(f"solid: {ball.Mesh.CountFacets} triangles" if hasattr(ball, "Mesh") else f"solid: {ball.Name}", flush=True)


def show():
    import FreeCADGui
    from fieldfab_workbench.shim import QtCore, QtWidgets

    def take():
        FreeCADGui.getMainWindow().screen().grabWindow(FreeCADGui.getMainWindow().winId()).save(os.environ["SHOT"])
        os._exit(0)

    def begin():
        FreeCADGui.activateWorkbench("FieldfabWorkbench")
        make()
        window = FreeCADGui.getMainWindow()
        for area in window.findChildren(QtWidgets.QMdiArea):
            area.subWindowList()[-1].showMaximized()
        FreeCADGui.activeDocument().activeView().viewIsometric()
        FreeCADGui.SendMsgToActiveView("ViewFit")
        QtCore.QTimer.singleShot(3000, take)

    QtCore.QTimer.singleShot(3000, begin)


if FreeCAD.GuiUp:
    show()
else:
    make()
