"""Helpers for tests of task panels in FreeCAD's window: a document, the opened panels, the visible picture."""

import FreeCADGui
import pytest
import window
from window import live, wait

from fieldfab_workbench.objects import frep_solid
from fieldfab_workbench.objects import solid as solids
from fieldfab_workbench.panels import gallery
from fieldfab_workbench.panels.edit_panel import EditPanel
from fieldfab_workbench.shim import QtCore, QtGui, QtWidgets

Button = QtWidgets.QDialogButtonBox
PART = "size = 20\nhole = 11  # radius\ndifference(box(size, size, size), sphere(r = hole))"


@pytest.fixture
def document(document):
    yield document
    for left in QtWidgets.QApplication.topLevelWidgets():
        if isinstance(left, gallery.Gallery):
            left.close()


@pytest.fixture
def panels(monkeypatch):
    """Collects the panels that are opened, newest last."""
    opened, real = [], EditPanel.__init__

    def remember(self, obj, title):
        real(self, obj, title)
        opened.append(self)

    monkeypatch.setattr(EditPanel, "__init__", remember)
    return opened


def document_tree():
    """Returns the tree of documents."""
    [tree] = [tree for tree in FreeCADGui.getMainWindow().findChildren(QtWidgets.QTreeWidget)
              if tree.headerItem().text(0).startswith("Labels")]
    return tree


def frep(document, text, voxel=0.5):
    solid = solids.create(frep_solid.FrepSolid, document)
    solid.Expression, solid.VoxelSize = text, voxel
    document.recompute()
    FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    live(0.2)
    return solid


def edit(obj):
    FreeCADGui.ActiveDocument.setEdit(obj.Name)
    live(0.3)


def shown(preview, *stages):
    wait(lambda: preview.stage in stages and not preview._waiting, f"the preview to be {stages}")


def key(widget, text="", code=0, modifiers=QtCore.Qt.NoModifier):
    for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        QtWidgets.QApplication.sendEvent(widget, QtGui.QKeyEvent(kind, code, modifiers, text))


def silhouette(name):
    """Returns the number of pixels of the 3D view in the solid's hue; saves a screenshot."""
    picture = window.shot(name, panel=False).convertToFormat(QtGui.QImage.Format_RGB32)
    view = FreeCADGui.getMainWindow().findChild(QtWidgets.QMdiArea)
    corner = view.mapTo(FreeCADGui.getMainWindow(), QtCore.QPoint(0, 0))
    count = 0
    for y in range(corner.y(), corner.y() + view.height() - 40, 4):
        for x in range(corner.x(), corner.x() + view.width() - 160, 4):
            c = picture.pixelColor(x, y)
            count += c.blue() > c.red() + 40 and c.green() > c.red() + 10
    return count
