"""Combo boxes that display values in the user's language and store them untranslated (currentData, itemData)."""

from ..words import tr


def offer(box, values, current):
    """Replaces the values of a QComboBox and selects the current one."""
    box.clear()
    for value in values:
        box.addItem(tr(value), value)
    box.setCurrentIndex(box.findData(current))
