"""Widths of kokopelli's letters, in units of the height of a capital letter."""

GAP = 0.1  # between letters
LINE = 1.55  # from line to line
DESCENTS = {**dict.fromkeys("gjpqy", 0.375), **dict.fromkeys("()", 0.2), ",": 0.15, ";": 0.075}  # below the base line
WIDTHS = {letter: width for width, letters in {
    0.1: "'!", 0.15: "il.:;", 0.175: ",", 0.3: 'j1"()', 0.385: "r", 0.4: "ft", 0.45: "-", 0.48: "c", 0.4875: "s",
    0.5: "Ik4", 0.525: "bd",
    0.55: "eghJnoSpquxy236890+/? ", 0.57: "C", 0.575: "BPR", 0.58: "a", 0.6: "DEFGHKLmNOQTUVvZz78", 0.65: "5", 0.7: "0",
    0.8: "AMWwXY"}.items() for letter in letters}
OTHER = 0.6  # width of a letter that kokopelli lacks


def width_of(line):
    """Returns the width of a line of text."""
    return sum(WIDTHS.get(letter, OTHER) + GAP for letter in line) - GAP if line else 0.0
