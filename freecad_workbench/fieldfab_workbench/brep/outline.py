"""Outlines of the regions of a mesh: corners, chains of mesh edges between corners, and loops of chains."""

from dataclasses import dataclass, field

import numpy as np


@dataclass
class Chain:
    """A path of mesh vertices between two regions: `left` of its direction and `right`. Closed if it begins and ends
    with the same vertex."""

    vertices: list
    left: int
    right: int


@dataclass
class Outline:
    """`chains`; `loops[region]`: lists of (chain index, forward); `corners`: mesh vertices where chains end, with the
    regions around each."""

    chains: list = field(default_factory=list)
    loops: dict = field(default_factory=dict)
    corners: dict = field(default_factory=dict)


def outline_of(triangles, neighbours, labels, pinned=()):
    """Returns the Outline of the regions. `pinned`: vertices that are corners if they are on a boundary."""
    beside = labels[neighbours]
    own = np.broadcast_to(labels[:, None], beside.shape)
    rows, sides = np.nonzero(beside != own)
    starts, ends = triangles[rows, sides], triangles[rows, (sides + 1) % 3]
    halves = {(int(a), int(b)): (int(t), int(i)) for a, b, t, i in zip(starts, ends, rows, sides)}
    around = {}
    for (a, b), (t, _) in halves.items():
        around.setdefault(a, []).append(int(labels[t]))
    result = Outline(corners={v: set(regions) for v, regions in around.items()
                              if len(regions) > 2 or v in pinned})
    following = {half: _next(half, place, triangles, neighbours, halves) for half, place in halves.items()}
    reversed_ = {}  # the first half-edge of each chain's other direction
    for loop in _cycles(following):
        region = int(labels[halves[loop[0]][0]])
        chains = _in_chains(loop, region, halves, labels, neighbours, result, reversed_)
        result.loops.setdefault(region, []).append(chains)
    return result


def _next(half, place, triangles, neighbours, halves):
    """Returns the half-edge that follows on the boundary of the same region."""
    triangle, side = place
    turn = half[1]
    while True:
        side = (side + 1) % 3
        after = turn, int(triangles[triangle, (side + 1) % 3])
        if after in halves:
            return after
        triangle = neighbours[triangle, side]
        side = int(np.flatnonzero(triangles[triangle] == after[1])[0])


def _cycles(following):
    left = dict(following)
    while left:
        first = next(iter(left))
        loop, at = [], first
        while at in left:
            loop.append(at)
            at = left.pop(at)
        yield loop


def _in_chains(loop, region, halves, labels, neighbours, outline, reversed_):
    """Returns a loop of half-edges as a list of (chain index, forward); adds new chains."""
    begins = [i for i, (a, _) in enumerate(loop) if a in outline.corners]
    if not begins:
        begins = [min(range(len(loop)), key=lambda i: loop[i][0])]  # the same vertex from either side
    loop = loop[begins[0]:] + loop[:begins[0]]
    begins = [i - begins[0] for i in begins] + [len(loop)]
    used = []
    for i, j in zip(begins, begins[1:]):
        vertices = [loop[i][0], *(b for _, b in loop[i:j])]
        known = reversed_.get((vertices[0], vertices[1]))
        if known is None:
            triangle, side = halves[loop[i]]
            reversed_[vertices[-1], vertices[-2]] = len(outline.chains)
            used.append((len(outline.chains), True))
            outline.chains.append(Chain(vertices, region, int(labels[neighbours[triangle, side]])))
        else:
            used.append((known, False))
    return used
