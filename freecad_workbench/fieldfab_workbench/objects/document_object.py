"""Base classes of all proxies, and of those whose properties are settings of the kernel's workflow."""

from .. import registry
from ..mistakes import in_a_line


class DocumentObject:
    """A proxy without state of its own in the document. Errors of execute() that concern the user become one line in
    FreeCAD's report view."""

    NAME = "Object"

    def __init_subclass__(cls, **more):
        super().__init_subclass__(**more)
        if "execute" in vars(cls):
            cls.execute = in_a_line(cls.execute)

    def __init__(self, obj):
        obj.Proxy = self
        self.add_properties(obj)

    def add_properties(self, obj):
        """Adds missing properties. Also called for documents of earlier versions."""

    @staticmethod
    def add(obj, kind, name, group, words, value=None, mode=0):
        """Adds a property unless the object has it already, as in a document of an earlier version."""
        if name in obj.PropertiesList:
            return
        obj.addProperty(f"App::Property{kind}", name, group, words, mode)
        if value is not None:
            setattr(obj, name, value)

    @staticmethod
    def add_choice(obj, name, group, words, choices):
        if name not in obj.PropertiesList:
            obj.addProperty("App::PropertyEnumeration", name, group, words)
            setattr(obj, name, list(choices))

    def icon_name(self, obj):
        """Returns the name of the icon in the tree."""
        return self.NAME

    def execute(self, obj):
        pass

    def onDocumentRestored(self, obj):
        self.add_properties(obj)

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads


class WithSettings(DocumentObject):
    """An object with a property for each setting of some stages. A setting counts as given once a user has changed it
    or has set an expression for it; all others follow their defaults. The hidden property Given stores the names of the
    given settings."""

    _settling = False

    def stages(self, obj):
        """Returns the workflow.Stage objects whose settings the object has."""
        raise NotImplementedError

    def settings(self, obj):
        return [setting for stage in self.stages(obj) for setting in stage.settings]

    def default(self, obj, setting):
        """Returns the default of a setting, or None if it depends on other values."""
        return setting.default

    def settle(self, obj):
        """Adds the properties of the object's settings and shows those that apply. Properties of other types of
        operation stay, hidden, for two reasons: FreeCAD's undo loses a property that is removed and added in one step,
        and the given values remain available if the user returns to the type."""
        if self._settling:
            return
        self._settling = True
        try:
            self.add(obj, "StringList", "Given", "Result",
                     "Settings that have a value of their own; the others have their defaults", mode=4)
            for stage in self.stages(obj):
                for setting in stage.settings:
                    self._settle(obj, stage, setting)
            self._show_what_matters(obj)
        finally:
            self._settling = False

    def _settle(self, obj, stage, setting):
        name = setting.property
        if name not in obj.PropertiesList:
            obj.addProperty(setting.property_type, name, f"Setting: {stage.title}", setting.words)
        if setting.choices and obj.getEnumerationsOfProperty(name) != setting.choices:
            before = getattr(obj, name) if name in obj.Given else None
            setattr(obj, name, setting.choices)
            if before in setting.choices:
                setattr(obj, name, before)
            else:
                obj.Given = [other for other in obj.Given if other != name]
        if name not in obj.Given:
            setting.write(obj, self.default(obj, setting))

    @staticmethod
    def _own(obj):
        return [name for name in obj.PropertiesList if obj.getGroupOfProperty(name).startswith("Setting: ")]

    def _show_what_matters(self, obj):
        effective = self.effective(obj)
        shown = {setting.property for setting in self.settings(obj) if setting.matters(effective)}
        for name in self._own(obj):
            obj.setEditorMode(name, 0 if name in shown else 2)

    def onChanged(self, obj, name):
        """Marks a setting as given. Ignores changes made by the proxy itself, and those of opening, undo and redo."""
        if self._settling or "Given" not in obj.PropertiesList or obj.Document.Restoring or obj.Document.Transacting:
            return
        if name in self._own(obj):
            if name not in obj.Given:
                obj.Given = [*obj.Given, name]
            self._show_what_matters(obj)

    def give(self, obj, setting, value):
        """Gives a setting a value, or with None its default."""
        if value is None:
            obj.Given = [name for name in obj.Given if name != setting.property]
            self.settle(obj)
        else:
            setting.write(obj, value)
            self.onChanged(obj, setting.property)

    def given(self, obj):
        """Returns {name: value} of the given settings that apply."""
        effective = self.effective(obj)
        return {s.name: s.read(obj) for s in self.settings(obj) if s.property in obj.Given and s.matters(effective)}

    def effective(self, obj):
        """Returns {name: value} of all settings."""
        given, there = set(obj.Given), set(obj.PropertiesList)
        return {s.name: s.read(obj) if s.property in given else self.default(obj, s)
                for s in self.settings(obj) if s.property in there}

    def problems(self, obj):
        """Returns {name: message} for the invalid values among the given ones."""
        given = self.given(obj)
        found = {s.name: s.problem(given[s.name]) for s in self.settings(obj) if s.name in given}
        return {name: words for name, words in found.items() if words}

    def check(self, obj):
        """Raises ValueError for the first invalid value."""
        for name, words in self.problems(obj).items():
            raise ValueError(f"{obj.Label}: {name} {words}")

    def onDocumentRestored(self, obj):
        super().onDocumentRestored(obj)
        self.settle(obj)
        self._settling = True  # documents store values, but not their limits
        for setting in self.settings(obj):
            setting.write(obj, setting.read(obj))
        self._settling = False
        obj.purgeTouched()


def create_object(kind, document, label):
    """Adds an object without a shape, with a proxy of the given class; computes nothing yet."""
    obj = document.addObject("App::FeaturePython", kind.NAME)
    kind(obj)
    obj.Label = label
    registry.add_view(obj)
    return obj
