"""Picture of a scan's panel in the 3D view: a coarse surface and the box of the crop, in place of the object's own
mesh."""

from pivy import coin

from .coin_mesh import box_node, frame_node


class ScanPreview:
    """Under the object's own placement. `close()` leaves the view as it was."""

    def __init__(self, obj):
        # The object itself may be gone at the end.
        self._parent, self._switch = obj.ViewObject.RootNode, obj.ViewObject.SwitchNode
        self._root, self._frame, self._surface, self._box = (coin.SoSeparator() for _ in range(4))
        for part in (self._frame, self._surface, self._box):
            self._root.addChild(part)
        self._parent.addChild(self._root)
        self._shown = None
        self._own = self._switch.whichChild.getValue()

    def show_surface(self, surface):
        """MeshBytes in lattice coordinates, mm from the first sample."""
        self._surface.removeAllChildren()
        if surface.count:
            self._surface.addChild(surface.node())
        self._switch.whichChild = -1

    def show_box(self, volume, lower, upper):
        """Sets the box of the crop of a volume, in lattice coordinates. All that is shown gets the place that the
        volume's file says."""
        shown = (volume, *lower, *upper)
        if shown == self._shown:
            return  # each change draws the view anew
        self._shown = shown
        self._root.replaceChild(0, frame_node(volume.origin, volume.axes))
        self._box.removeAllChildren()
        self._box.addChild(box_node(lower, upper))

    def close(self):
        self._parent.removeChild(self._root)
        self._switch.whichChild = self._own
