"""View provider of a Part shape of a solid."""

from .solid_view import ObjectView, sources_of


class PartShapeView(ObjectView):
    def __init__(self, view):
        super().__init__(view)
        if view.Object.Source is not None:
            view.ShapeColor = view.Object.Source.ViewObject.ShapeColor

    def onDelete(self, view, subelements):
        """Shows the solid again."""
        for source in sources_of(view.Object):
            source.ViewObject.Visibility = True
        return True
