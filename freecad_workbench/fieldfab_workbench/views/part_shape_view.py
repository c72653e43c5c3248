"""View provider of a Part shape of a solid."""

from .solid_view import SolidView


class PartShapeView(SolidView):
    def __init__(self, view):
        view.Proxy = self
        if view.Object.Source is not None:
            view.ShapeColor = view.Object.Source.ViewObject.ShapeColor

    def claimChildren(self):
        return []  # the solid stays at its own place in the tree
