"""Certainty of a solid's mesh: whether it is proved to show the whole solid, and otherwise the places where parts may
be missing."""

import FreeCAD

from .kernel_messages import translated
from .words import tr

CERTAIN = "certain"  # the kernel's word
DOUBTFUL = "doubtful"  # the panel's state for a mesh that is valid but not certain


def doubt_of(mesh):
    """Returns a line that describes where a new mesh is not certain, or "" for a certain mesh. A mesh without a
    certainty consists of the solid's exact faces and counts as certain."""
    certainty = getattr(mesh, "certainty", None)
    return "" if certainty is None or certainty.certain else str(certainty)


def put(obj, mesh):
    """Stores the certainty of a solid's new mesh in its properties."""
    obj.Certainty = doubt_of(mesh) or CERTAIN
    places = mesh.certainty.places if obj.Certainty != CERTAIN else []
    obj.UncertainPlaces = [FreeCAD.Vector(*corner) for place in places for corner in (place[:3], place[3:])]


def is_uncertain(obj):
    """Returns whether an object's mesh may lack parts. False also if this is unknown."""
    return getattr(obj, "Certainty", "") not in ("", CERTAIN)


def uncertain_places(obj):
    """Returns the boxes in which parts may be missing, as [(lower, upper)] corners in the solid's own coordinates, the
    largest box first."""
    corners = getattr(obj, "UncertainPlaces", None) or []
    return list(zip(corners[::2], corners[1::2]))


def with_doubt(words, doubt):
    """Returns the status line of a panel and its state. `words`: the status of a valid solid. If its mesh is not
    certain, the line gives the reason."""
    if not doubt:
        return words, True
    return words + "\n" + tr("The mesh is {certainty}").format(certainty=translated(doubt)), DOUBTFUL
