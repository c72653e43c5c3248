"""View provider of solids: icon, colour, children in the tree, and task panel."""

import FreeCAD
import FreeCADGui

from .. import preferences, registry
from ..certainty import uncertain_places
from ..icons import icon
from ..shim import QtCore
from ..words import tr
from .uncertain_places import UncertainPlaces


class ObjectView:
    """View provider of any Fieldfab object: its icon, and its panel on a double click."""

    def __init__(self, view):
        view.Proxy = self

    def attach(self, view):
        self.Object = view.Object

    def getIcon(self):
        return icon(self.Object.Proxy.icon_name(self.Object))

    def setEdit(self, view, mode=0):
        FreeCADGui.Control.showDialog(registry.panel_for(view.Object))
        return True

    def unsetEdit(self, view, mode=0):
        FreeCADGui.Control.closeDialog()
        return True

    def doubleClicked(self, view):
        view.Document.setEdit(view.Object.Name)
        return True

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads


class SolidView(ObjectView):
    """View provider of a Solid."""

    def __init__(self, view):
        super().__init__(view)
        view.ShapeColor = preferences.colour()
        view.Lighting = "Two side"
        view.CreaseAngle = 30.0  # degrees; smooth shading except at sharp edges

    def attach(self, view):
        from .look import Look  # needs numpy and Coin

        super().attach(view)
        if not hasattr(view, "SharpEdges"):  # documents of earlier versions have none
            view.addProperty("App::PropertyBool", "SharpEdges", "Object Style", "Draw lines along sharp edges")
            view.SharpEdges = True
        self._look = Look(view)

    def _show_edges(self, view):
        self._look.show(view.Object.Mesh if view.SharpEdges else None)

    def updateData(self, obj, name):
        if name == "Mesh":
            self._show_edges(obj.ViewObject)
        elif name == "Operation":
            obj.ViewObject.signalChangeIcon()
        elif name == "UncertainPlaces" and self.shows_places():
            self.show_places(obj)

    _look = None  # before attach()
    # UncertainPlaces while they are displayed.
    _places = None

    def shows_places(self):
        return self._places is not None

    def show_places(self, obj):
        """Shows the current uncertain places, if there are any."""
        self.hide_places()
        if uncertain_places(obj) and obj.ViewObject.Visibility:
            self._places = UncertainPlaces(obj)

    def hide_places(self):
        if self._places is not None:
            self._places.close()
            self._places = None

    def onChanged(self, view, name):
        if name == "SharpEdges" and self._look is not None:
            self._show_edges(view)
        if name == "Visibility" and not view.Visibility:
            self.hide_places()
        if (name == "Visibility" and view.Visibility and self.made_when_shown(view.Object)
                and not view.Object.Document.Restoring):
            make_mesh_later(view.Object)

    @staticmethod
    def made_when_shown(obj):
        simulated = getattr(obj.Proxy, "NAME", "") == "Simulation"
        return bool(obj.MadeFrom) and not obj.Proxy.edited if simulated else getattr(obj, "OnlyWhenShown", False)

    def claimChildren(self):
        return sources_of(self.Object)

    def onDelete(self, view, subelements):
        """Shows the solid's sources again."""
        for source in sources_of(view.Object):
            source.ViewObject.Visibility = True
        return True


def make_mesh_later(obj):
    """Makes the mesh of a solid that becomes visible, if its mesh was postponed. Runs after the change of visibility is
    complete."""
    document, name = obj.Document.Name, obj.Name

    def make():
        found = FreeCAD.listDocuments().get(document)
        shown = found and found.getObject(name)
        if not shown or not shown.Visibility or found.Recomputing:
            return
        began = False
        try:
            if shown.Proxy.has_its_mesh(shown):
                return
            began = not found.HasPendingTransaction
            if began:
                found.openTransaction(tr("Show {label}").format(label=shown.Label))
            shown.Proxy.execute(shown)
            shown.purgeTouched()
        except ValueError as error:
            FreeCAD.Console.PrintError(f"{error}\n")
        if began:
            found.commitTransaction()

    QtCore.QTimer.singleShot(0, make)


def sources_of(obj):
    """Returns the objects from which a solid is made."""
    listed = list(getattr(obj, "Sources", None) or [])
    return listed or [source for source in [getattr(obj, "Source", None)] if source is not None]
