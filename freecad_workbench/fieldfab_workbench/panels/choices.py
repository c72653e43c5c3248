"""Boxes of choices: what is seen is in the user's language, what is kept (currentData, itemData) is not."""

from ..words import tr


def offer(box, values, current):
    """Gives a QComboBox these values and no others, and chooses one of them."""
    box.clear()
    for value in values:
        box.addItem(tr(value), value)
    box.setCurrentIndex(box.findData(current))
