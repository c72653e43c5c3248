"""Model files with one or several parts as sources of solids. Nothing here accesses a document."""

import os

from . import kernel
from .openscad import stamp
from .sources import Source, kept


class PartSource(Source):
    """The solid of a model file, or of one of its parts. `opened`: the files that the model opens, relative to its
    folder, as last read. `model`: the fieldfab.Model, if it was just read. Raises ValueError if the file is missing."""

    def __init__(self, path, part, opened, label, model=None):
        self.path, self.part = path, part
        others = [os.path.join(os.path.dirname(path), file) for file in opened]
        stamps = [(file, stamp(file, label)) for file in others if os.path.exists(file)]
        self._content = repr((path, stamp(path, label), stamps))
        super().__init__(("part", part, self._content), None)
        if model is not None:
            kept(("model", self._content), lambda: model)

    def model(self, progress=None):
        """Returns the fieldfab.Model, which all parts of a file share. Raises fieldfab.Error."""
        return kept(("model", self._content), lambda: kernel.load().open_model(self.path, progress))

    def field(self, progress=None):
        return kept(("field", self.digest), lambda: self._part(self.model(progress))[0])

    def colour(self, progress=None):
        """Returns the colour as "#rrggbb", or None. Raises fieldfab.Error."""
        return self._part(self.model(progress))[1]

    def _part(self, model):
        """Returns (solid, colour). Raises fieldfab.Error."""
        if not self.part:
            return model.united(), model.parts[0][2] if len(model.parts) == 1 else None
        for name, (solid, _, colour) in zip(names_of(model), model.parts):
            if name == self.part:
                return solid, colour
        return model.part(self.part), None  # its error suggests similar names


def names_of(model):
    """Returns the names of all parts of a fieldfab.Model. An unnamed part is named by its number: "#1"."""
    return [name or f"#{number}" for number, (_, name, _) in enumerate(model.parts, 1)]


def opened_by(model, path):
    """Returns the files that a fieldfab.Model opens in addition to its own, relative to its folder."""
    folder, own = os.path.dirname(path), os.path.realpath(path)
    return [os.path.relpath(file, folder) for file in map(str, model.files) if os.path.realpath(file) != own]
