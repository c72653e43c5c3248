"""Pictures of tools, drawn from their sizes: cutter, shank and holder from the side."""

import math

from ..shim import QtCore, QtGui

CUTTER, SHANK, HOLDER, LINE = "#8fa9c4", "#c9ced4", "#5d6670", "#39424d"
UNKNOWN_FLUTE, UNKNOWN_LENGTH = 3, 5  # in diameters, where the tool does not tell


def outline(tool):
    """Returns the right half of the cutting part: points (distance from the axis, height above the tip), upwards."""
    radius, shape = tool["diameter"] / 2, tool.get("shape", "flat")
    corner = radius if shape == "ball" else tool.get("corner_radius", 0) if shape in ("bull", "tapered") else 0
    if shape in ("v", "drill"):
        tip, slope = tool.get("tip_diameter", 0) / 2, math.tan(math.radians(tool.get("angle", 60) / 2)) or 1e-3
        return [(tip, 0), (radius, (radius - tip) / slope)]
    arc = [(math.sin(math.radians(t)), 1 - math.cos(math.radians(t))) for t in range(0, 91, 6)]
    if shape == "tapered":
        half = math.radians(tool.get("angle", 10) / 2)
        arc = [(x, y) for x, y in arc if y <= 1 - math.sin(half)] + [(math.cos(half), 1 - math.sin(half))]
        (x, y), slope = arc[-1], math.tan(half) or 1e-3
        return [(corner * a, corner * b) for a, b in arc] + [(radius, corner * y + max(0, radius - corner * x) / slope)]
    return [(radius - corner + corner * a, corner * b) for a, b in arc] if corner else [(radius, 0)]


def parts(tool):
    """Returns (colour, points of the right half) of the tool's parts, from the tip upwards, mm."""
    cutter, diameter = outline(tool), tool["diameter"]
    top = max(cutter[-1][1], tool.get("flute") or min(UNKNOWN_FLUTE * diameter, tool.get("length") or 1e9))
    end, shank = max(top, tool.get("length") or UNKNOWN_LENGTH * diameter), (tool.get("shank") or diameter) / 2
    made = [(CUTTER, [*cutter, (diameter / 2, top)])]
    if end > top:
        made.append((SHANK, [(shank, top), (shank, end)]))
    if tool.get("holder_diameter"):
        holder = tool["holder_diameter"] / 2
        made.append((HOLDER, [(holder, end), (holder, end + (tool.get("holder_length") or tool["holder_diameter"]))]))
    return made


def picture(tool, size):
    """Returns a QPixmap of `size` x `size` pixels; tools of different sizes all fill it."""
    drawn, made = QtGui.QPixmap(size, size), parts(tool)
    drawn.fill(QtCore.Qt.transparent)
    height = made[-1][1][-1][1]
    width = 2 * max(x for _, points in made for x, _ in points)
    scale = 0.92 * size / max(height, width)
    painter = QtGui.QPainter(drawn)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    painter.setPen(QtGui.QPen(QtGui.QColor(LINE), max(1, size / 64)))
    for colour, points in made:
        both = [(x, y) for x, y in points] + [(-x, y) for x, y in points[::-1]]
        painter.setBrush(QtGui.QColor(colour))
        painter.drawPolygon(QtGui.QPolygonF([QtCore.QPointF(size / 2 + scale * x, 0.96 * size - scale * y)
                                             for x, y in both]))
    painter.end()
    return drawn


def icon(tool, size=48):
    return QtGui.QIcon(picture(tool, size))
