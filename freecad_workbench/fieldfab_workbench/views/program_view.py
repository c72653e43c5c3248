"""Tool paths in the 3D view: rapids dashed, cuts in a colour for each operation."""

from pivy import coin

from .. import ways
from ..objects import machine_program
from .document_view import DocumentView

COLOURS = ((0.10, 0.42, 0.85), (0.10, 0.62, 0.35), (0.80, 0.40, 0.05), (0.55, 0.25, 0.70), (0.05, 0.60, 0.65),
           (0.75, 0.20, 0.45))
RAPID_COLOUR = (0.85, 0.15, 0.12)


class ProgramView(DocumentView):
    def scene(self):
        root, pick = coin.SoSeparator(), coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE  # picking among a million lines would be slow
        self.moved, self.lines = coin.SoTranslation(), coin.SoSeparator()
        for node in (pick, self.moved, self.lines):
            root.addChild(node)
        self.draw()
        return root

    def updateData(self, obj, name):
        back_in_time = obj.Document.Restoring or obj.Document.Transacting  # properties then change in any order
        if (hasattr(self, "lines")
                and (name == "MadeFrom" or back_in_time and name in ("PackedMoves", "Sections", "Zero"))):
            self.draw()

    def onChanged(self, view, name):
        if name == "Visibility" and hasattr(self, "lines") and view.Visibility and self.lines.getNumChildren() == 0:
            self.draw()

    def draw(self):
        """Draws the object's paths, or none before all properties are restored."""
        self.lines.removeAllChildren()
        obj = self.Object
        if any(not getattr(obj, name, "") for name in ("MadeFrom", "PackedMoves", "Sections")):
            return
        self.moved.translation = tuple(obj.Zero)
        last = None
        for number, (section, moves) in enumerate(machine_program.sections_of(obj)):
            points, rapid = ways.points_of(moves, last)
            self.lines.addChild(lines(*ways.runs(points, rapid, False), COLOURS[number % len(COLOURS)], 1.2))
            self.lines.addChild(lines(*ways.runs(points, rapid, True), RAPID_COLOUR, 1, 0x0F0F))
            last = moves[-1, :3] if len(moves) else last

    def claimChildren(self):
        return [obj for obj in self.Object.InList if obj.isDerivedFrom("Path::Feature")]


def lines(points, counts, colour, width, pattern=0xFFFF):
    """Returns polylines as a Coin node. `counts`: number of points of each."""
    node, base, style = coin.SoSeparator(), coin.SoBaseColor(), coin.SoDrawStyle()
    base.rgb = colour
    style.lineWidth, style.linePattern = width, pattern
    light, place, drawn = coin.SoLightModel(), coin.SoCoordinate3(), coin.SoLineSet()
    light.model = coin.SoLightModel.BASE_COLOR
    if len(points):
        place.point.setValues(0, len(points), points)
        drawn.numVertices.setValues(0, len(counts), counts)
    else:
        drawn.numVertices.setValue(0)
    for child in (light, base, style, place, drawn):
        node.addChild(child)
    return node
