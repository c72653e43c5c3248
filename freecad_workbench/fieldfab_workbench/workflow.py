"""Settings of the kernel's workflow and machines (Keeter 6.1) as properties of document objects. Forms are generated
from them."""

import functools
import math
import re

from . import kernel, units
from .words import CHOICE, kernel_name, kernel_text, marked, titled, tr

FOLLOWS = marked("automatic")  # shown for a default that depends on other values


class Setting:
    """One setting as declared by the kernel: name, help, unit, kind (flag, number, text), default (None: it depends on
    other values), lower, upper, lower_open, whole, choices, needs, needs_values."""

    def __init__(self, declared):
        self.__dict__.update(declared)
        self.property = _words_joined(self.name)
        self.unit = {"1/min": "rpm"}.get(self.unit, self.unit)  # displayed unit, with the same numbers
        # The property's documentation.
        self.words = f"{self.help[:1].upper()}{self.help[1:]}" + (f" ({self.unit})" if self.unit else "")

    @property
    def label(self):
        return kernel_name(self.name)

    @property
    def tip(self):
        return units.in_words(kernel_text(self.help))

    @property
    def property_type(self):
        if self.kind != "number":
            return "App::Property" + ("Bool" if self.kind == "flag" else "Enumeration" if self.choices else "String")
        if self.whole:
            return "App::PropertyIntegerConstraint"
        by_unit = {"mm": "Distance", "mm/min": "Speed", "degrees": "Angle"}
        return "App::Property" + by_unit.get(self.unit, "FloatConstraint")

    @property
    def factor(self):
        """Factor from the setting's number to the property's: FreeCAD stores speeds in mm/s."""
        return 1 / 60 if self.unit == "mm/min" else 1

    def write(self, obj, value):
        """Writes the setting's value to the property. None is for a default that depends on other values."""
        if self.kind == "number":
            value = 0 if value is None else value * self.factor
            value = int(round(value)) if self.whole else float(value)
            if self.property_type.endswith("Constraint"):
                value = (value, *self._limits(), 1 if self.whole else 0.1)
        setattr(obj, self.property, value)

    def _limits(self):
        largest = 10**6
        numbers = (-largest if self.lower is None else self.lower, largest if self.upper is None else self.upper)
        return tuple(int(n) if self.whole else float(n) for n in numbers)

    def read(self, obj):
        value = getattr(obj, self.property)
        return getattr(value, "Value", value) / self.factor if self.kind == "number" else value

    def problem(self, value):
        """Returns a short message for an invalid value, "" for a valid one."""
        unit = "" if self.unit == "diameters" else self.unit
        if self.kind == "number":
            if not math.isfinite(value):
                return tr("must be finite")
            if self.whole and value != round(value):
                return tr("must be a whole number")
            if self.lower is not None and (value < self.lower or (self.lower_open and value == self.lower)):
                return (tr("must be above {limit}") if self.lower_open else tr("must be at least {limit}")).format(
                    limit=units.told(self.lower, unit, 6))
            if self.upper is not None and value > self.upper:
                return tr("must be at most {limit}").format(limit=units.told(self.upper, unit, 6))
        elif self.choices and value not in self.choices:
            return tr("must be one of {choices}").format(choices=", ".join(map(self.shown, self.choices)))
        return ""

    def matters(self, values):
        """Returns whether the setting applies, given the values of other settings, {name: value}."""
        if not self.needs or self.needs not in values:
            return True
        value = values[self.needs]
        return value in self.needs_values if self.needs_values else bool(value)

    def shown(self, value):
        """Formats a value with its unit for the user."""
        if value is None:
            return tr(FOLLOWS)
        if self.kind == "flag":
            return tr("yes") if value else tr("no")
        if self.kind == "number":
            return units.told(value, self.unit, 6)
        return tr(value, CHOICE) if self.choices else value


class Stage:
    """A step of the workflow: name, help, input, output and settings."""

    def __init__(self, name, words, settings):
        self.name, self.help, self.settings = name, words, [Setting(s) for s in settings]
        self.title = titled(name)  # stored with properties

    @property
    def label(self):
        return kernel_name(self.name)

    @property
    def tip(self):
        return kernel_text(self.help)


JOINING = "moves"  # the stage that joins the paths of an operation


@functools.lru_cache(maxsize=None)
def operation_names():
    return tuple(s["name"] for s in kernel.load().cam.stages() if s["operation"])


@functools.lru_cache(maxsize=None)
def _operations():
    """Returns {operation: the stages from a solid to its moves}."""
    cam = kernel.load().cam
    by_name, found = {s["name"]: s for s in cam.stages()}, {}
    for operation in operation_names():
        stages = [Stage(name, by_name[name]["help"], by_name[name]["settings"])
                  for name in cam.chain("solid", operation)]
        found[operation] = (*stages, Stage(JOINING, "how the paths are joined to moves", cam.joining_settings()))
    _share_properties({operation: [s for stage in stages for s in stage.settings]
                       for operation, stages in found.items()})
    return found


def _share_properties(groups):
    """Lets settings with the same name share a property, whose documentation then covers all of them. Settings of
    another type get a property of their own, named after their group. `groups`: {name: [Setting]}."""
    types, shared = {}, {}
    for name, settings in groups.items():
        for setting in settings:
            if types.setdefault(setting.property, setting.property_type) != setting.property_type:
                setting.property = _words_joined(name) + setting.property
            alike = shared.setdefault(setting.property, [])
            alike.append(setting)
    for alike in shared.values():
        words = " / ".join(dict.fromkeys(setting.words for setting in alike))
        for setting in alike:
            setting.words = words


def _words_joined(name):
    return "".join(word.capitalize() for word in re.split(r"[_ ]", name))


def stages_of(operation):
    """Returns the stages from a solid to the moves of an operation, in order."""
    return _operations()[operation]


def settings_of(operation):
    return [setting for stage in stages_of(operation) for setting in stage.settings]


@functools.lru_cache(maxsize=None)
def machines():
    """Returns {id: name} of all machines that come with Fieldfab."""
    return dict(kernel.load().cam.machines())


@functools.lru_cache(maxsize=None)
def _machines_told():
    cam, found = kernel.load().cam, {}
    for identifier in machines():
        found[identifier] = dict(cam.machine(identifier))
        found[identifier]["settings"] = [Setting(s) for s in found[identifier]["settings"]]
    _share_properties({identifier: told["settings"] for identifier, told in found.items()})
    return found


def machine(identifier):
    """Returns a machine's description (fieldfab.cam.machine), with its settings as Settings."""
    return _machines_told()[identifier]


@functools.lru_cache(maxsize=100)
def cutting_values(identifier, material, diameter, flutes, spindle):
    """Returns the values of a tool that follow from the chip load of a material (fieldfab.cam.cutting_values)."""
    return kernel.load().cam.cutting_values(identifier, material, diameter, flutes, spindle)


@functools.lru_cache(maxsize=None)
def machine_stage(identifier):
    told = machine(identifier)
    stage = Stage("machine", told["description"], [])
    stage.settings = told["settings"]
    return stage
