"""Solids that are made from files which stay outside of the document."""

from .. import openscad
from . import outside
from .solid import Solid


class FromFiles(Solid):
    """A solid that follows files: what has changed is read again at the next recompute."""

    def files(self, obj):
        """The paths of those that it is made from."""
        raise NotImplementedError

    def add_outside(self, obj, name, group, words):
        """A property of a file or folder that stays outside."""
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
        """Where a file has changed since."""
        return bool(getattr(obj, "Stamps", None)) and obj.Stamps != self.stamps(obj)

    def execute(self, obj):
        super().execute(obj)
        if "Stamps" in obj.PropertiesList:
            obj.Stamps = self.stamps(obj)

    def stamps(self, obj):
        """Of its files, where they are there."""
        stamps = []
        for path in self.files(obj):
            try:
                stamps.append(openscad.stamp(path, obj.Label))
            except ValueError:
                stamps.append("missing")
        return stamps
