"""Display of a solid's mesh coloured by its deviations, instead of its own colour."""

from ..words import tr
from .legend import ReachLegend


class DeviationView:
    """Adds the coloured mesh under the object's placement; `close()` restores the view."""

    def __init__(self, obj, surface, reach):
        """`surface`: MeshBytes in the object's own coordinates; `reach`: the end of the colour scale, mm."""
        self._parent, self._switch = obj.ViewObject.RootNode, obj.ViewObject.SwitchNode
        self._own = self._switch.whichChild.getValue()
        self._node = surface.node()
        self._parent.addChild(self._node)
        self._switch.whichChild = -1
        self._legend = ReachLegend(tr("Deviation, {unit}"), reach)

    def close(self):
        self._parent.removeChild(self._node)
        self._switch.whichChild = self._own
        self._legend.close()
