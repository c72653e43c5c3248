"""Thickness of walls and gaps in a plane outline. Needs no window."""

import dataclasses

import numpy as np

ON_IT = 1e-9  # mm: a point so near to an outline is on it


@dataclasses.dataclass
class Chord:
    """A straight line from outline to outline. `solid`: whether it is in the material."""

    start: tuple
    end: tuple
    solid: bool

    @property
    def length(self):
        return float(np.hypot(*np.subtract(self.end, self.start)))


def chord_at(segments, point):
    """Returns the Chord from the place of an outline that is nearest to a point, through that point, to the other side:
    the thickness of the wall there, or the width of the gap. Of a point on the outline, the wall's. None if there is no
    other side. `segments`: (n, 4) array of x, y of both ends of each piece of a closed outline."""
    if not len(segments):
        return None
    index, foot, away = _nearest(segments, point)
    along = segments[index, 2:] - segments[index, :2]
    across = np.array((-along[1], along[0])) / np.hypot(*along)
    ways = [(point - foot) / away] if away > ON_IT else [across, -across]
    found = [_through(segments, foot, way) for way in ways]
    return next((each for each in found if each and (each.solid or away > ON_IT)), None)


def _through(segments, foot, way):
    """Returns the Chord that begins at a place of the outline, in a direction."""
    starts, along = segments[:, :2] - foot, segments[:, 2:] - segments[:, :2]
    ends = starts + along
    side_a, side_b = (way[0] * each[:, 1] - way[1] * each[:, 0] for each in (starts, ends))
    crosses = (side_a > 0) != (side_b > 0)  # the ends of a piece are on different sides of the way
    share = side_a[crosses] / (side_a[crosses] - side_b[crosses])
    at = (starts[crosses] + share[:, None] * along[crosses]) @ way
    beyond = at[at > 1e-6 * max(1.0, np.abs(segments).max())]  # without the foot's own piece
    if not len(beyond):
        return None
    return Chord(tuple(foot), tuple(foot + beyond.min() * way), len(beyond) % 2 == 1)


def _nearest(segments, point):
    starts, along = segments[:, :2], segments[:, 2:] - segments[:, :2]
    squared = np.maximum((along**2).sum(axis=1), 1e-300)
    share = np.clip(((point - starts) * along).sum(axis=1) / squared, 0, 1)
    places = starts + share[:, None] * along
    away = np.hypot(*(places - point).T)
    least = int(np.argmin(away))
    return least, places[least], float(away[least])


def nearest_on(segments, point):
    """Returns the point of an outline that is nearest to a point, and its distance."""
    _, place, away = _nearest(segments, point)
    return tuple(place), away
