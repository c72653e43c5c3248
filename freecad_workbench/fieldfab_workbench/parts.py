"""Files of models, of one solid or of several parts, as sources of solids. Nothing here looks at a document."""

import os

from . import kernel
from .openscad import stamp
from .sources import Source, kept


class PartSource(Source):
    """The solid of a model's file, or of one of its parts. `opened`: the files that the model opens, from its own
    folder, as its last reading has found them. `model`: the fieldfab.Model, where it has just been read. Raises
    ValueError where the file is missing."""

    def __init__(self, path, part, opened, label, model=None):
        self.path, self.part = path, part
        others = [os.path.join(os.path.dirname(path), file) for file in opened]
        stamps = [(file, stamp(file, label)) for file in others if os.path.exists(file)]
        self._content = repr((path, stamp(path, label), stamps))
        super().__init__(("part", part, self._content), None)
        if model is not None:
            kept(("model", self._content), lambda: model)

    def model(self, progress=None):
        """The fieldfab.Model, which all parts of a file share. Raises fieldfab.Error."""
        return kept(("model", self._content), lambda: kernel.load().open_model(self.path, progress))

    def field(self, progress=None):
        return kept(("field", self.digest), lambda: self._part(self.model(progress))[0])

    def colour(self, progress=None):
        """"#rrggbb", or None. Raises fieldfab.Error."""
        return self._part(self.model(progress))[1]

    def _part(self, model):
        """(solid, colour). Raises fieldfab.Error."""
        if not self.part:
            return model.united(), model.parts[0][2] if len(model.parts) == 1 else None
        for name, (solid, _, colour) in zip(names_of(model), model.parts):
            if name == self.part:
                return solid, colour
        return model.part(self.part), None  # its error tells which names are near


def names_of(model):
    """Of each part of a fieldfab.Model: its own, else its number."""
    return [name or f"#{number}" for number, (_, name, _) in enumerate(model.parts, 1)]


def opened_by(model, path):
    """The files that a fieldfab.Model opens besides its own, from its folder."""
    folder, own = os.path.dirname(path), os.path.realpath(path)
    return [os.path.relpath(file, folder) for file in map(str, model.files) if os.path.realpath(file) != own]
