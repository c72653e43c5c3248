"""View providers of CAM set-ups, tools and operations: their entries in the tree, and the stock in the 3D view."""

from pivy import coin

from ..objects import cam_setup
from .document_view import DocumentView

STOCK_COLOUR = (0.55, 0.45, 0.30)


class SetupView(DocumentView):
    """Shows the edges of the stock's box."""

    def scene(self):
        root, colour, style = coin.SoSeparator(), coin.SoBaseColor(), coin.SoDrawStyle()
        colour.rgb = STOCK_COLOUR
        style.lineWidth, style.linePattern = 1, 0x00FF
        self.corners = coin.SoCoordinate3()
        edges = coin.SoIndexedLineSet()
        edges.coordIndex.setValues(0, 24,
                                   [0, 1, 3, 2, 0, -1, 4, 5, 7, 6, 4, -1, 0, 4, -1, 1, 5, -1, 2, 6, -1, 3, 7, -1])
        pick = coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE
        for node in (pick, colour, style, self.corners, edges):
            root.addChild(node)
        self.show_stock()
        return root

    def show_stock(self):
        try:
            lower, upper = cam_setup.stock_box(self.Object)
        except (ValueError, AttributeError):  # no part yet, or the properties are not restored yet
            self.corners.point.deleteValues(0)
            return
        self.corners.point.setValues(0, 8, [(x, y, z) for x in (lower.x, upper.x) for y in (lower.y, upper.y)
                                            for z in (lower.z, upper.z)])

    def updateData(self, obj, name):
        if (hasattr(self, "corners") and name in ("Part", "StockFrom", "Margin", "Top", "Thickness", "StockLower",
                                                  "StockUpper", "StockObject", "Machine")):
            self.show_stock()

    def claimChildren(self):
        return [*self.Object.Tools, *self.Object.Operations, *cam_setup.programs_of(self.Object)]

    def onDelete(self, view, subelements):
        """Deletes the set-up's tools, operations and programs, too."""
        for child in self.claimChildren():
            view.Object.Document.removeObject(child.Name)
        return True


class ToolView(DocumentView):
    pass


class OperationView(DocumentView):
    def updateData(self, obj, name):
        if name == "Active":
            obj.ViewObject.signalChangeIcon()
