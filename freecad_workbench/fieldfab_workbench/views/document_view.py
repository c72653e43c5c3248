"""View provider of objects without a shape. They add their own Coin nodes to the 3D view."""

from pivy import coin

from .solid_view import ObjectView


class DocumentView(ObjectView):
    """View provider of an object without a shape."""

    def __init__(self, view):
        super().__init__(view)
        view.DisplayMode = "Ways"

    def attach(self, view):
        super().attach(view)
        view.addDisplayMode(self.scene(), "Ways")

    def scene(self):
        """Returns the Coin node to display."""
        return coin.SoSeparator()

    def getDisplayModes(self, view):
        return ["Ways"]

    def getDefaultDisplayMode(self):
        return "Ways"

    def setDisplayMode(self, mode):
        return mode

    def claimChildren(self):
        return []
