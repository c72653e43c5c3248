"""Handles for the numbers of a .frep text: where the surface moves when a number changes, which way, and how far.

A point of the surface f(x, p) = 0 moves along its normal by v = -(df/dp) / |grad f| mm for each unit of the number p.
Points that all move like a translation, v = n . d, are moved by the number: the handle is in their middle, along d.
Otherwise the number is a size, and the handle is on the face that moves fastest."""

import dataclasses
import typing

import numpy as np

from . import _core

POINTS = 6000  # of the surface
CELLS = 48  # of the mesh that they lie on, along its longest side
STEP = 2e-3  # change of a number, relative to its size, that shows how the surface moves
STILL = 0.05  # of the greatest speed: what is slower does not move
SEEN = 1e-3  # of the diagonal: what moves by less when a number doubles has no handle
FITS = 0.03  # share of the squared speeds that a translation may leave unexplained
FACING = 0.95  # least cosine of a normal and the direction of a face
FAST = 0.75  # of the greatest speed of a face
ALIKE = 0.7  # share of the best face's squared speeds: the first of faces that are about as good
NEAR = 0.1  # of the diagonal: extent of the part of a face that has the handle
AXES = np.array([[1, 0, 0], [0, 0, 1], [0, 1, 0], [-1, 0, 0], [0, 0, -1], [0, -1, 0]], float)  # preferred ones first


class Number(typing.NamedTuple):
    """A number in a text. Offset and length count bytes of UTF-8 and include a minus sign."""

    offset: int
    length: int
    value: float
    name: str = ""  # of a parameter


@dataclasses.dataclass(frozen=True)
class Handle:
    """A number's arrow: it is `at` (mm) now, and moves along the unit vector `along` by `rate` mm for each unit that
    the number grows. `index`: of the number among numbers()."""

    index: int
    number: Number
    at: tuple
    along: tuple
    rate: float


def numbers(text):
    """Returns the plain numbers of a .frep text in order, except those in the options of open()."""
    data, found, opened = text.encode(), [], 0
    parameters = {each.value_offset + each.value_length: each for each in _core.language.parameters(data)}
    tokens = [t for t in _core.language.tokens(data) if t.kind != "comment"]
    words = [data[t.offset:t.offset + t.length] for t in tokens]
    for i, token in enumerate(tokens):
        if opened or (words[i] == b"(" and i and words[i - 1] == b"open"):
            opened += {b"(": 1, b")": -1}.get(words[i], 0)
        elif token.kind == "number":
            end, start = token.offset + token.length, token.offset
            negative = (i and words[i - 1] == b"-" and tokens[i - 1].offset == start - 1
                        and (i == 1 or (tokens[i - 2].kind == "sign" and words[i - 2] != b")")))
            start -= 1 if negative else 0
            named = parameters.get(end)
            found.append(Number(start, end - start, float(data[start:end]), named.name if named else ""))
    return found


def with_number(text, number, value):
    """Returns the text with another value for one of its numbers, in the fewest digits that are exact."""
    data = text.encode()
    return (data[:number.offset] + written(value).encode() + data[number.offset + number.length:]).decode()


def written(value):
    """Returns a number as texts have it."""
    return repr(float(value)).removesuffix(".0")


def handles(text, folder=None, progress=None):
    """Returns the Handles of a .frep text's solid, for those of its numbers that move the surface. Raises
    fieldfab.Error if the text has mistakes or its solid cannot be meshed. `progress`: as of fieldfab.mesh()."""
    solid = _core.parse(text, folder)
    points = _surface(_core.mesh(solid, voxel=solid.default_voxel(None, CELLS), features=False, exact=False, depth=0,
                                 progress=progress))
    if not len(points):
        return []
    values, gradients = map(np.asarray, solid.gradients(points))
    slopes = np.linalg.norm(gradients, axis=1)
    sound = np.isfinite(slopes) & (slopes > 1e-6)
    points, slopes, values = points[sound], slopes[sound], values[sound]
    if not len(points):
        return []
    normals, diagonal, made = gradients[sound] / slopes[:, None], np.linalg.norm(np.ptp(points, axis=0)), []
    every = numbers(text)
    for tried, number in enumerate(every):
        if progress and not progress(tried / len(every), ""):
            break
        step = STEP * max(abs(number.value), 0.01 * diagonal)
        try:
            ends = [np.asarray(_core.parse(with_number(text, number, number.value + way), folder).values(points))
                    for way in (step, -step)]
        except _core.Error:  # not every number may change a little: the count of an array
            continue
        way = _way(number, points, normals, _speeds(ends, values, step * slopes), diagonal)
        if way:
            made.append(Handle(tried, number, *way))
    return made


def _surface(mesh):
    """Returns points on a mesh, shape (POINTS, 3), spread half over its area and half over its triangles, since small
    features have many."""
    corners = np.asarray(mesh.vertices)[np.asarray(mesh.triangles)]
    if not len(corners):
        return np.empty((0, 3))
    sides = corners[:, 1:] - corners[:, :1]
    areas = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1)
    share = np.cumsum(areas / areas.sum() + (areas > 0) / np.count_nonzero(areas))
    i = np.arange(POINTS)
    triangle = np.searchsorted(share, (i + 0.5) / POINTS * share[-1])
    u, v = (0.5 + i * 0.7548776662466927) % 1, (0.5 + i * 0.5698402909980532) % 1  # Roberts' R2 sequence
    folded = u + v > 1
    u, v = np.where(folded, 1 - u, u), np.where(folded, 1 - v, v)
    return corners[triangle, 0] + u[:, None] * sides[triangle, 0] + v[:, None] * sides[triangle, 1]


def _speeds(ends, values, steps):
    """Returns the speeds of points whose value changes by `steps` while they move 1 mm; NaN where the speed changes
    suddenly, as near an edge. `ends`: the values after a step forwards and backwards."""
    grown, shrunk = (values - ends[0]) / steps, (ends[1] - values) / steps
    mean, change = (grown + shrunk) / 2, np.abs(grown - shrunk)
    with np.errstate(invalid="ignore"):
        return np.where(change < 0.1 * np.nanmax(np.abs(mean), initial=0) + 1e-9, mean, np.nan)


def _way(number, points, normals, speeds, diagonal):
    """Returns place, direction and rate of a handle, or None if the surface does not move."""
    sound = np.isfinite(speeds)
    points, normals, speeds = points[sound], normals[sound], speeds[sound]
    fastest = np.abs(speeds).max(initial=0)
    if not fastest * max(abs(number.value), 1) > SEEN * diagonal:
        return None
    moving = np.abs(speeds) > STILL * fastest
    points, normals, speeds = points[moving], normals[moving], speeds[moving]
    move = np.linalg.lstsq(normals, speeds, rcond=1e-3)[0]
    if np.sum((speeds - normals @ move) ** 2) < FITS * np.sum(speeds**2):
        move = np.where(np.abs(move) < 0.02 * np.abs(move).max(), 0, move)
        rate = np.linalg.norm(move)
        return (_vector((points.min(axis=0) + points.max(axis=0)) / 2), _vector(move / rate), float(rate))
    return _on_face(points, normals, speeds, diagonal)


def _on_face(points, normals, speeds, diagonal):
    faces = []  # (sum of squared speeds, points, direction)
    for way in (*AXES, normals[np.argmax(np.abs(speeds))]):
        facing = normals @ way > FACING
        if facing.any():
            facing &= np.abs(speeds) > FAST * np.abs(speeds[facing]).max()
            faces.append((np.sum(speeds[facing] ** 2), facing, way))
    best = max(face[0] for face in faces)  # there is one: the fastest point's normal is a direction
    chosen, direction = next(face[1:] for face in faces if face[0] > ALIKE * best)
    points, speeds = points[chosen], speeds[chosen]
    # In the middle of the face, if there is one; otherwise, as for holes here and there, at a point near the middle.
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    nearest = points[np.argmin(np.linalg.norm(points - middle, axis=1))]
    near = np.linalg.norm(points - nearest, axis=1) < NEAR * diagonal
    at = middle if np.linalg.norm(middle - nearest) < NEAR * diagonal else nearest
    at = at + direction * ((nearest - at) @ direction)  # on the surface, not within its curve
    rate = speeds[near].mean()
    return (_vector(at), _vector(direction * np.sign(rate)), float(abs(rate))) if rate else None


def _vector(array):
    return tuple(float(each) for each in array)
