"""How much of a large family of cases a test tries: for C++ tests see tests/family.h."""

import os


def sample_or_all(sample, everything):
    """Chooses between a small sample, always the same, and the whole family, which ./dev test --full tries: it sets
    FIELDFAB_FULL."""
    return everything if os.environ.get("FIELDFAB_FULL") else sample
