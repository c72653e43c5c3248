"""Preview of a scan in the 3D view while its panel is open: a coarse surface and the box of the crop, instead of the
object's mesh."""

from pivy import coin

from .coin_mesh import box_node, frame_node


class ScanPreview:
    """Adds the preview under the object's placement. `close()` restores the view."""

    def __init__(self, obj):
        # Kept, since the object may be deleted before close().
        self._parent, self._switch = obj.ViewObject.RootNode, obj.ViewObject.SwitchNode
        self._root, self._frame, self._surface, self._box = (coin.SoSeparator() for _ in range(4))
        for part in (self._frame, self._surface, self._box):
            self._root.addChild(part)
        self._parent.addChild(self._root)
        self._shown = None
        self._own = self._switch.whichChild.getValue()

    def show_surface(self, surface):
        """Shows MeshBytes in lattice coordinates, mm from the first sample."""
        self._surface.removeAllChildren()
        if surface.count:
            self._surface.addChild(surface.node())
        self._switch.whichChild = -1

    def show_box(self, volume, lower, upper):
        """Shows the box of a volume's crop, in lattice coordinates. Moves the whole preview to the volume's position in
        its file."""
        shown = (volume, *lower, *upper)
        if shown == self._shown:
            return  # each change redraws the view
        self._shown = shown
        self._root.replaceChild(0, frame_node(volume.origin, volume.axes))
        self._box.removeAllChildren()
        self._box.addChild(box_node(lower, upper))

    def close(self):
        self._parent.removeChild(self._root)
        self._switch.whichChild = self._own
