"""Certainty of a solid's mesh: whether it is proved that the mesh shows all of the solid, else where parts may be
missing."""

import FreeCAD

from .words import tr

CERTAIN = "certain"  # as the kernel says it
DOUBTFUL = "doubtful"  # of a state that is neither good nor bad: valid, but not certain


def doubt_of(mesh):
    """Returns a line that says where a mesh that was just made is not certain; "" where it is. A mesh without certainty
    is one of the solid's own faces."""
    certainty = getattr(mesh, "certainty", None)
    return "" if certainty is None or certainty.certain else str(certainty)


def put(obj, mesh):
    """Notes in a solid how certain its new mesh is."""
    obj.Certainty = doubt_of(mesh) or CERTAIN
    places = mesh.certainty.places if obj.Certainty != CERTAIN else []
    obj.UncertainPlaces = [FreeCAD.Vector(*corner) for place in places for corner in (place[:3], place[3:])]


def is_uncertain(obj):
    """Whether an object's mesh may lack parts; False where that is not known, too."""
    return getattr(obj, "Certainty", "") not in ("", CERTAIN)


def uncertain_places(obj):
    """Corners of the boxes in which parts may be missing: [(lower, upper)] in the solid's own coordinates, the largest
    first."""
    corners = getattr(obj, "UncertainPlaces", None) or []
    return list(zip(corners[::2], corners[1::2]))


def with_doubt(words, doubt):
    """Returns the line of a panel and its state. `words`: what is said of a valid solid; where its mesh is not certain,
    the line says why."""
    return (words + "\n" + tr("The mesh is {certainty}").format(certainty=doubt), DOUBTFUL) if doubt else (words, True)
