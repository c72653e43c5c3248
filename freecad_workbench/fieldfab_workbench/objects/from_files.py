"""Solids made from files outside of the document."""

from .. import openscad
from . import outside
from .solid import Solid


class FromFiles(Solid):
    """A solid that follows files: changed files are read again at the next recompute."""

    def files(self, obj):
        """Returns the paths of its input files."""
        raise NotImplementedError

    def add_outside(self, obj, name, group, words):
        """Adds a property for an external file or folder."""
        self.add(obj, "File" if name == "File" else "Path", name, group, words)
        mode = outside.HIDDEN | outside.OUTPUT
        self.add(obj, "String", f"{name}Beside", "Result",
                 "The same path, relative to the document's folder", mode=mode)
        self.add(obj, "StringList", "Stamps", "Result",
                 "Sizes and modification times of the files it was made from", mode=mode)

    def onChanged(self, obj, name):
        if name in outside.NAMES and not obj.Document.Restoring and not obj.Document.Transacting:
            outside.forget(obj, name)

    def mustExecute(self, obj):
        """Returns whether a file has changed since the last recompute."""
        return bool(getattr(obj, "Stamps", None)) and obj.Stamps != self.stamps(obj)

    def execute(self, obj):
        super().execute(obj)
        if "Stamps" in obj.PropertiesList:
            obj.Stamps = self.stamps(obj)

    def stamps(self, obj):
        """Returns the stamp of each file, or "missing"."""
        stamps = []
        for path in self.files(obj):
            try:
                stamps.append(openscad.stamp(path, obj.Label))
            except ValueError:
                stamps.append("missing")
        return stamps
