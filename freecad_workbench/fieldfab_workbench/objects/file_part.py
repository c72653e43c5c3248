"""A solid from a model file: the whole model or one of its parts."""

import os

from ..parts import PartSource, opened_by
from ..words import tr
from .from_files import FromFiles
from .outside import HIDDEN, OUTPUT, path_of
from .solid import key_of


class FilePart(FromFiles):
    """A part of .frep text or of a mesh file. The document stores the file's path and the part's name."""

    NAME = "FilePart"

    def add_own_properties(self, obj):
        self.add_outside(obj, "File", "Part", "File of the model: .frep text or a mesh")
        self.add(obj, "String", "Part", "Part", "Name of the part in the file; empty: the whole model")
        self.add(obj, "StringList", "Opened", "Result", "Files that the model opens, relative to its folder",
                 mode=HIDDEN | OUTPUT)

    def source(self, obj):
        path = path_of(obj, "File")
        if not path:
            raise ValueError(tr("{label}: choose the File of a model").format(label=obj.Label))
        return PartSource(path, obj.Part, obj.Opened, obj.Label)

    def files(self, obj):
        path = path_of(obj, "File")
        return [path, *(os.path.join(os.path.dirname(path), file) for file in obj.Opened)]

    def make_mesh(self, obj):
        before = obj.MadeFrom
        super().make_mesh(obj)
        if obj.MadeFrom != before:
            self._follow_opened(obj)

    def _follow_opened(self, obj):
        """Updates the list of opened files, which a new version of the file may change."""
        source = self.source(obj)
        model = source.model()
        opened = opened_by(model, source.path)
        if opened != obj.Opened:
            obj.Opened = opened
            obj.MadeFrom = key_of(PartSource(source.path, obj.Part, opened, obj.Label, model), self.mesh_settings(obj))
