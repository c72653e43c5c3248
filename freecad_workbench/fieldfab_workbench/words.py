"""Translation of texts for users: every such text goes through `tr`. FreeCAD loads the translations
(resources/translations, made by its update.py); without them texts are English. Texts that are compared or stored are
never translated."""

import FreeCAD

CONTEXT = "Fieldfab"
KERNEL = "Kernel"  # context of what the kernel says of its operations, settings and machines
CHOICE = "Kernel: choice"  # context of the values that the kernel's settings can have
PROPERTY = "App::Property"  # context in which FreeCAD's property editor translates names and descriptions of properties


def tr(text, context=CONTEXT):
    """Returns a text in the user's language. Numbers and names are inserted afterwards: tr("{count}
    tools").format(count=3)."""
    return FreeCAD.Qt.translate(context, text)


def marked(texts):
    """Returns the texts (one, a tuple, or the keys of a dictionary) unchanged. update.py collects them; tr() translates
    them when they are displayed."""
    return texts


def described(name, words, *more):
    """Returns the name and the description of a property unchanged. update.py collects them, too."""
    return (name, words, *more)


def titled(name):
    """Returns one of the kernel's names with a capital and spaces, in English."""
    return name[:1].upper() + name[1:].replace("_", " ")


def kernel_name(name):
    """Returns the name of one of the kernel's operations or settings as users read it: rest_least is "Rest least"."""
    translated = tr(name, KERNEL)
    return translated if translated != name else titled(name)


def kernel_text(text):
    """Returns the kernel's description of an operation, a setting or a machine as users read it."""
    translated = tr(text, KERNEL)
    return translated[:1].upper() + translated[1:]


def property_label(name):
    """Returns the label of a property in a form: KeepOriginal is "Keep original". FreeCAD shows, and translates, "Keep
    Original"."""
    shown = "".join(f" {c}" if c.isupper() else c for c in name).strip()
    translated = tr(shown, PROPERTY)
    return translated if translated != shown else shown[:1] + shown[1:].lower()
