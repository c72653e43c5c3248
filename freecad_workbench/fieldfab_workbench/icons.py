"""Icon files."""

import os

FOLDER = os.path.join(os.path.dirname(os.path.dirname(os.path.realpath(__file__))), "icons")


def icon(name):
    """Returns the file of an icon: "Linear array" is LinearArray.svg."""
    return os.path.join(FOLDER, "".join(word[:1].upper() + word[1:] for word in name.split()) + ".svg")
