"""Pictures of models, coarse first. Their background is transparent, unlike the kernel's: pages are light or dark."""

import functools
import math

import numpy as np

import fieldfab as ff

from .png import png

COARSE = 4  # width of a pixel of the coarse picture, in pixels


def turned(point, alpha, beta):
    """Rotates a point of the model into the view: x to the right, y up, z towards the eye."""
    x, y, z = point
    x, y = math.cos(alpha) * x - math.sin(alpha) * y, math.sin(alpha) * x + math.cos(alpha) * y
    return x, math.cos(beta) * y - math.sin(beta) * z, math.sin(beta) * y + math.cos(beta) * z


def turned_back(point, alpha, beta):
    x, y, z = point
    y, z = math.cos(beta) * y + math.sin(beta) * z, -math.sin(beta) * y + math.cos(beta) * z
    return math.cos(alpha) * x + math.sin(alpha) * y, -math.sin(alpha) * x + math.cos(alpha) * y, z


def eye_distance(bounds, perspective):
    """Returns the distance of the eye from the middle of the model, as the kernel's camera has it."""
    return math.dist(bounds[:3], bounds[3:]) / 2 / math.sin(perspective / 2) if perspective else math.inf


def fitting_window(model, request):
    """Returns the window that fits the model with a margin."""
    low, high = model.bounds[:3], model.bounds[3:]
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    if model.flat or request["mode"] == "bitmap":
        x, y = middle[:2]
        scale = 1.06 * max((high[0] - low[0]) / request["width"], (high[1] - low[1]) / request["height"])
    else:
        x, y, depth = turned(middle, request["alpha"], request["beta"])
        corners = [turned((a, b, c), request["alpha"], request["beta"]) for a in (low[0], high[0])
                   for b in (low[1], high[1]) for c in (low[2], high[2])]
        eye = eye_distance(model.bounds, request["perspective"])
        nearness = [1 - (p[2] - depth) / eye for p in corners]
        corners = [(x + (p[0] - x) / near, y + (p[1] - y) / near) for p, near in zip(corners, nearness)]
        scale = 1.06 * max((max(p[i] for p in corners) - min(p[i] for p in corners)) / request[side]
                           for i, side in enumerate(("width", "height")))
    half_x, half_y = scale * request["width"] / 2, scale * request["height"] / 2
    return x - half_x, y - half_y, x + half_x, y + half_y


@functools.lru_cache(8)
def sky(height):
    """Returns the colours of the kernel's background by row, taken from a picture of an empty model."""
    return ff.render(ff.Solid(1.0), "shaded", height, bounds=(0, 0, 0, 1, 1, 1),
                     window=(0, 0, 8 / height, 1)).pixels[:, :1, :].copy()


def with_alpha(pixels, background):
    alpha = np.where((pixels != background).any(axis=2), 255, 0).astype(np.uint8)
    return np.dstack([pixels * (alpha[:, :, None] > 0), alpha])


def halved(pixels):
    """Averages blocks of 2 x 2 pixels; colours are weighted by their opacity."""
    pixels = pixels[: pixels.shape[0] // 2 * 2, : pixels.shape[1] // 2 * 2].astype(np.float32)
    four = (pixels[::2, ::2], pixels[1::2, ::2], pixels[::2, 1::2], pixels[1::2, 1::2])
    if pixels.ndim == 2:
        return np.rint(sum(four) / 4).astype(np.uint8)
    alpha = sum(each[:, :, 3:] for each in four)
    colours = sum(each[:, :, :3] * each[:, :, 3:] for each in four) / np.maximum(alpha, 1)
    return np.rint(np.dstack([colours, alpha / 4])).astype(np.uint8)


def cut(model, section):
    """Returns the model's solid and parts, cut at the section plane."""
    if section is None:
        return model.solid, model.coloured
    axis = {"x": ff.X, "y": ff.Y, "z": ff.Z}[section["axis"]]
    side = ff.Solid(axis - section["at"] if section["keep"] == "below" else section["at"] - axis)
    return model.solid & side, [(solid & side, name, colour) for solid, name, colour in model.coloured]


def pixels_of(model, request, window, bounds, size, progress):
    solid, parts = cut(model, request["section"])
    mode = "bitmap" if model.placed and model.flat else request["mode"]
    settings = {"mode": mode, "size": size, "window": window, "bounds": bounds, "progress": progress}
    if mode == "bitmap":
        settings["bounds"] = (*bounds[:2], request["z"], *bounds[3:5], request["z"])
        return ff.render(solid, **settings).pixels, mode, None
    image = ff.render(solid, alpha=request["alpha"], beta=request["beta"], perspective=request["perspective"],
                      parts=parts, **settings)
    if mode == "height":
        return image.pixels, mode, (image.zmin, image.zmax)
    return with_alpha(image.pixels, sky(image.height) if mode == "shaded" else np.zeros(3, np.uint8)), mode, None


def grown(bounds):
    sides = [b - a for a, b in zip(bounds[:3], bounds[3:])]
    return (*(a - side for a, side in zip(bounds[:3], sides)), *(b + side for b, side in zip(bounds[3:], sides)))


def pictures(model, request, progress):
    """Yields (head of a picture, its PNG): a coarse one on request, a fine one, and an antialiased one on request."""
    size, window, near = max(request["width"], request["height"]), request["window"], request["near"]
    if window is None or near is None or near[2] == near[5]:
        near = None
        window = window or fitting_window(model, request)
    steps = [step for step, wanted in (("coarse", request["coarse"]), ("fine", request.get("fine", True)),
                                       ("smooth", request["smooth"])) if wanted]
    for step in steps:
        # A search for bounds takes longer than a coarse picture, which uses the last bounds, enlarged.
        guessed = step == "coarse" and near is not None and not model.placed
        bounds = request["bounds"] or (grown(near) if guessed else model.bounds)
        pixels_wide = {"coarse": max(8, size // COARSE), "fine": size, "smooth": 2 * size}[step]
        pixels, mode, heights = pixels_of(model, request, window, bounds, pixels_wide, progress)
        if step == "smooth":
            if mode in ("height", "normals"):
                continue
            pixels = halved(pixels)
        told = {"quality": step, "last": step == steps[-1] and step != "coarse", "mode": mode, "window": window,
                "width": pixels.shape[1], "height": pixels.shape[0]}
        if request["bounds"]:
            told.update(bounds=bounds, flat=bounds[2] == bounds[5])
        elif not guessed:
            told.update(bounds=model.bounds, flat=model.flat)
        if heights:
            told["heights"] = heights
        yield told, png(pixels)


def pick(model, request, progress):
    """Returns the point of the model seen at a point of the picture's plane, its value and its part."""
    u, v = request["at"]
    if model.flat or request["mode"] == "bitmap":
        place = (u, v, request["z"])
    else:
        solid, _ = cut(model, request["section"])
        half = max(model.bounds[3] - model.bounds[0], model.bounds[4] - model.bounds[1]) * 1e-4
        image = ff.render(solid, "height", 9, alpha=request["alpha"], beta=request["beta"],
                          perspective=request["perspective"], bounds=model.bounds,
                          window=(u - half, v - half, u + half, v + half), progress=progress)
        height = int(image.pixels[4, 4])
        if height == 0:
            return {"place": None}
        depth = image.zmin + (height - 1) / 65534 * (image.zmax - image.zmin)
        middle = turned([(a + b) / 2 for a, b in zip(model.bounds[:3], model.bounds[3:])], request["alpha"],
                        request["beta"])
        near = 1 - (depth - middle[2]) / eye_distance(model.bounds, request["perspective"])
        place = turned_back((middle[0] + (u - middle[0]) * near, middle[1] + (v - middle[1]) * near, depth),
                            request["alpha"], request["beta"])
    value = model.solid.value(*place)
    names = ([name for _, name, _ in sorted(model.parts, key=lambda part: part[0].value(*place))]
             if len(model.parts) > 1 else [None])
    return {"place": place, "value": value if math.isfinite(value) else None, "part": names[0]}
