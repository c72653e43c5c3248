"""What proxies of objects without a shape have in common, and those whose properties are settings of the kernel's workflow."""


class DocumentObject:
    """A proxy that keeps nothing of its own in the document."""

    NAME = "Object"

    def __init__(self, obj):
        obj.Proxy = self
        self.add_properties(obj)

    def add_properties(self, obj):
        """Adds what is missing; also called for documents of earlier versions."""

    @staticmethod
    def add(obj, kind, name, group, words, value=None, mode=0):
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
    """An object with a property for each setting of some stages. A setting counts as given once somebody has changed it (or drives it by an
    expression); all others follow their defaults. The names of those given are kept in the hidden property Given."""

    _settling = False

    def stages(self, obj):
        """[workflow.Stage] whose settings the object has."""
        raise NotImplementedError

    def settings(self, obj):
        return [setting for stage in self.stages(obj) for setting in stage.settings]

    def default(self, obj, setting):
        """What holds where nothing is given; None: it follows from other things."""
        return setting.default

    def settle(self, obj):
        """Gives the object the properties of its settings and no others, and shows those that matter."""
        if self._settling:
            return
        self._settling = True
        try:
            self.add(obj, "StringList", "Given", "Result", "The settings that are given; the others follow their defaults", mode=4)
            wanted = {setting.property: (stage, setting) for stage in self.stages(obj) for setting in stage.settings}
            kept = {}
            for name in self._own(obj):
                if name not in wanted or not self._is_for(obj, name, wanted[name][1]):
                    if name in obj.Given and name in wanted and obj.getTypeIdOfProperty(name) == wanted[name][1].property_type:
                        kept[name] = wanted[name][1].read(obj)
                    obj.removeProperty(name)
            for name, (stage, setting) in wanted.items():
                if name not in obj.PropertiesList:
                    obj.addProperty(setting.property_type, name, f"Setting: {stage.title}", setting.words)
                    if setting.choices:
                        setattr(obj, name, setting.choices)
                    if name in kept and not setting.problem(kept[name]):
                        setting.write(obj, kept[name])
                    else:
                        obj.Given = [other for other in obj.Given if other != name]
                if name not in obj.Given:
                    setting.write(obj, self.default(obj, setting))
            obj.Given = [name for name in obj.Given if name in wanted]
            self._show_what_matters(obj)
        finally:
            self._settling = False

    @staticmethod
    def _is_for(obj, name, setting):
        """Whether a property is that of a setting; another operation may have one of the same name that means something else."""
        return (obj.getTypeIdOfProperty(name) == setting.property_type and obj.getDocumentationOfProperty(name) == setting.words
                and (not setting.choices or obj.getEnumerationsOfProperty(name) == setting.choices))

    @staticmethod
    def _own(obj):
        return [name for name in obj.PropertiesList if obj.getGroupOfProperty(name).startswith("Setting: ")]

    def _show_what_matters(self, obj):
        effective = self.effective(obj)
        for setting in self.settings(obj):
            if setting.name in effective:
                obj.setEditorMode(setting.property, 0 if setting.matters(effective) else 2)

    def onChanged(self, obj, name):
        """Notes that a setting is given now, unless the change is ours, or of a document that is opened or goes back in its history."""
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
        """{name: value} of what is given and matters."""
        effective = self.effective(obj)
        return {s.name: s.read(obj) for s in self.settings(obj) if s.property in obj.Given and s.matters(effective)}

    def effective(self, obj):
        """{name: value} of all settings."""
        given, there = set(obj.Given), set(obj.PropertiesList)
        return {s.name: s.read(obj) if s.property in given else self.default(obj, s) for s in self.settings(obj) if s.property in there}

    def problems(self, obj):
        """{name: what is wrong} of the values given."""
        given = self.given(obj)
        found = {s.name: s.problem(given[s.name]) for s in self.settings(obj) if s.name in given}
        return {name: words for name, words in found.items() if words}

    def check(self, obj):
        """Raises ValueError for the first value that cannot be."""
        for name, words in self.problems(obj).items():
            raise ValueError(f"{obj.Label}: {name} {words}")

    def onDocumentRestored(self, obj):
        super().onDocumentRestored(obj)
        self.settle(obj)
