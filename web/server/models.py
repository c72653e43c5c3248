"""Models of texts, in a worker. The most recent ones are cached, since a rotating view requests the same model
repeatedly."""

import collections
import os
import re
import tempfile

import fieldfab as ff

KEPT = 6
FORMULAS = {"math": ff.parse_math, "vm": ff.parse_vm}
SCRIPTS = ("py", "ko", "scad")
# Formats without references to other files, which could be anywhere.
OPENED = (".frep", ".math", ".vm", ".asdf", ".stl", ".ply", ".off", ".obj", ".3mf", ".nii", ".nii.gz", ".vdb", ".tif",
          ".tiff")


class Mistakes(Exception):
    """Raised for an invalid text. `places`: a dict per error with message, line, column, offset and length (UTF-16
    units)."""

    def __init__(self, message, places=()):
        super().__init__(message)
        self.places = list(places)


class Model:
    """A solid, its parts and, computed on first use, its bounds."""

    def __init__(self, parts):
        self.parts = parts
        self.solid = parts[0][0]
        for solid, _, _ in parts[1:]:
            self.solid = self.solid | solid
        self.coloured = parts if any(colour for _, _, colour in parts) else ()
        self._bounds = self._flat = None

    @property
    def placed(self):
        return self._bounds is not None

    def _place(self):
        if self._bounds is None:
            bounds = self.solid.bounds(flat=True)
            self._flat = bounds is not None and bounds[2] == bounds[5]
            if bounds is None:
                raise Mistakes("there is nothing to show: the solid is empty, or it is unbounded along x or y")
            grown = max(bounds[3] - bounds[0], bounds[4] - bounds[1]) / 64
            low, high = [each - grown for each in bounds[:3]], [each + grown for each in bounds[3:]]
            if self._flat:
                low[2] = high[2] = 0.0
            self._bounds = (*low, *high)

    @property
    def bounds(self):
        """Returns bounds with a margin; z is 0 for a flat solid."""
        self._place()
        return self._bounds

    @property
    def flat(self):
        self._place()
        return self._flat


def utf16(data, offset):
    """Converts a byte offset in UTF-8 to UTF-16 units, as JavaScript counts."""
    return len(data[:offset].decode("utf-8", "replace").encode("utf-16-le")) // 2


def place_of(data, found):
    start = utf16(data, found.offset)
    before = data[: found.offset].rpartition(b"\n")[2]
    return {"message": found.message, "line": found.line, "column": 1 + utf16(before, len(before)), "offset": start,
            "length": utf16(data, found.offset + found.length) - start}


def parameters_of(text):
    data = text.encode()
    return [{"name": each.name, "value": each.value, "range": each.range, "comment": each.comment,
             "offset": utf16(data, each.value_offset),
             "length": each.value_length} for each in ff.language.parameters(text)]


def refuse_files_elsewhere(text, root, folder=None, seen=()):
    """Raises Mistakes if a text of `folder` opens a file outside `root`, or a file of a format that can refer to other
    files."""
    folder = folder or root
    tokens, data = ff.language.tokens(text), text.encode()
    words = [data[each.offset : each.offset + each.length] for each in tokens]
    read = [(each, word) for each, word in zip(tokens, words) if each.kind != "comment"]
    for i, (token, word) in enumerate(read):
        if token.kind != "name" or word != b"open":
            continue
        following = read[i + 1 : i + 3]
        name = (following[1][1] if len(following) == 2 and following[0][1] == b"(" and following[1][0].kind == "string"
                else b"\\")
        place = {"line": token.line, "column": token.column, "offset": utf16(data, token.offset), "length": 4}
        if b"\\" in name:
            raise Mistakes("open() takes the plain name of a file here",
                           [{"message": "open() takes the plain name of a file here", **place}])
        name = name[1:-1].decode("utf-8", "replace")
        path = os.path.realpath(os.path.join(folder, name))
        message = ""
        if os.path.commonpath([path, root]) != root:
            message = f"'{name}' is not in the folder of the documents"
        elif not path.lower().endswith(OPENED):
            message = f"'{name}': a file of this format cannot be opened from the page"
        elif not os.path.isfile(path):
            message = f"'{name}': there is no such file in the folder of the documents"
        if message:
            raise Mistakes(message, [{"message": message, **place}])
        if path.endswith(".frep") and path not in seen:
            with open(path, encoding="utf-8", errors="replace") as file:
                refuse_files_elsewhere(file.read(), root, os.path.dirname(path), (*seen, path))


def mistakes_of(text, folder, error):
    places = [place_of(text.encode(), each) for each in ff.language.diagnostics(text, folder)]
    return Mistakes(places[0]["message"] if places else str(error), places)


def read_frep(text, values, folder):
    folder = os.path.realpath(folder)
    try:
        refuse_files_elsewhere(text, folder)
        return ff.parse_parts(ff.language.with_values(text, values) if values else text, folder)
    except ff.Error as error:
        raise mistakes_of(text, folder, error) from None


def run_script(text, language):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, f"model.{language}")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return [(ff.run_model(path), None, None)]


def make(text, language, values, folder):
    if language == "frep":
        parts = read_frep(text, values, folder)
    else:
        try:
            parts = run_script(text, language) if language in SCRIPTS else [(FORMULAS[language](text), None, None)]
        except ff.Error as error:
            raise Mistakes(str(error)) from None
    if not parts:
        raise Mistakes("the text has no solid yet")
    return Model(parts)


BINS = 256


def scan_told(path):
    """Returns facts about a scan for the choice of its threshold."""
    volume = ff.Volume.open(path)
    counts, edges = volume.histogram()
    step = -(-len(counts) // BINS)
    counts = [sum(counts[i : i + step]) for i in range(0, len(counts), step)]
    return {"size": volume.size, "spacing": volume.spacing, "type": volume.type, "counts": counts, "from": edges[0],
            "to": edges[0] + step * len(counts) * (edges[1] - edges[0]),
            "halfway": volume.threshold(), "otsu": volume.threshold("otsu")}


OPENING = re.compile(r'\bopen\s*\(\s*"([^"]*)"')


def opened_files(request):
    """Returns names, sizes and times of the files that a text opens; None if these may open others."""
    found = []
    for name in OPENING.findall(request["text"]):
        path = os.path.join(request["folder"], name)
        if name.lower().endswith(".frep") or not os.path.isfile(path):
            return None
        state = os.stat(path)
        found.append((name, state.st_size, state.st_mtime_ns))
    return found


class Models:
    """Cache of the models of recent texts."""

    def __init__(self):
        self._kept = collections.OrderedDict()

    def of(self, request):
        made = lambda: make(request["text"], request["language"], request["values"],
                            request["folder"])
        opened = opened_files(request)
        if opened is None:
            return made()
        key = (request["text"], request["language"], tuple(sorted(request["values"].items())), *opened)
        if key not in self._kept:
            self._kept[key] = made()
            if len(self._kept) > KEPT:
                self._kept.popitem(last=False)
        self._kept.move_to_end(key)
        return self._kept[key]
