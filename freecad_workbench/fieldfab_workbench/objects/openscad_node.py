"""Nodes of an OpenSCAD design as solids: their arguments are properties, their children are links."""

import functools

from .. import openscad
from ..openscad_nodes import KINDS, values_of
from ..words import tr
from . import outside
from .from_files import FromFiles
from .solid import csg_of

LONG = 100_000  # characters; longer texts are hidden in the property editor


class OpenScadSolid(FromFiles):
    """A solid defined by OpenSCAD text."""

    def source(self, obj):
        return openscad.OpenScadSource(self.csg(obj), obj.Label)


class OpenScadNode(OpenScadSolid):
    """An OpenSCAD node such as a cube, an extrusion or a hull: any kind in openscad_nodes.KINDS."""

    NAME = "OpenScadNode"

    def add_own_properties(self, obj):
        self.add(obj, "String", "Node", "Base", "Name of the node in OpenSCAD", mode=1)  # read only
        self.add_arguments(obj)

    def onChanged(self, obj, name):
        super().onChanged(obj, name)
        if name == "Node" and not obj.Document.Restoring:
            self.add_arguments(obj)

    def add_arguments(self, obj):
        if obj.Node not in KINDS:
            return
        add, kind = functools.partial(self.add, obj), KINDS[obj.Node]
        for argument in kind.arguments:
            for (name, words), default in zip(argument.properties, argument.defaults):
                if argument.kind == "File":
                    self.add_outside(obj, name, "OpenSCAD", words)
                else:
                    add(argument.kind, name, "OpenSCAD", words, default)
        if kind.children:
            add("LinkList", "Sources", "OpenSCAD", "Children of the node, in order")

    def csg(self, obj):
        key = obj.Node
        if key not in KINDS:
            raise ValueError(tr("{label}: OpenSCAD has no '{node}'").format(label=obj.Label, node=key))
        try:
            values = values_of(key, obj)
        except ValueError as error:
            raise ValueError(f"{obj.Label}: {error}") from None
        if "file" in values:
            values["file"] = outside.path_of(obj, "File")
        files = [values["file"]] if "file" in values else []
        words = ", ".join(f"{name} = {openscad.literal(value)}" if name else openscad.literal(value)
                          for name, value in values.items())
        return openscad.node(f"{KINDS[key].name}({words})", obj.Label,
                             [self._child(obj, source) for source in getattr(obj, "Sources", [])], files)

    def files(self, obj):
        return [outside.path_of(obj, "File")]

    @staticmethod
    def _child(obj, source):
        text = csg_of(source)
        if text is None:
            raise ValueError(tr("{label}: {source} is no shape of OpenSCAD, and {node} takes no other").format(
                label=obj.Label, source=source.Label, node=obj.Node))
        return text


class OpenScadText(OpenScadSolid):
    """A design, or a branch of one, as .csg text."""

    NAME = "OpenScadText"

    def add_own_properties(self, obj):
        self.add(obj, "String", "Text", "OpenSCAD", "The solid as OpenSCAD's .csg text")
        self.add_outside(obj, "Folder", "OpenSCAD", "Folder of the files that the text names")
        self.show_what_is_short(obj)

    def onChanged(self, obj, name):
        super().onChanged(obj, name)
        if name == "Text":
            self.show_what_is_short(obj)

    @staticmethod
    def show_what_is_short(obj):
        obj.setEditorMode("Text", 2 if len(obj.Text) > LONG else 0)

    def csg(self, obj):
        return openscad.whole(obj.Text, outside.path_of(obj, "Folder"), obj.Label)

    def files(self, obj):
        return self.csg(obj).files
