"""Finds the fieldfab Python module: an installed one, or the one built beside this workbench."""

import os
import sys

from . import preferences


def load():
    """The module `fieldfab`. Raises ImportError with advice where it is not to be found."""
    try:
        import fieldfab
    except ImportError:
        here = os.path.dirname(os.path.realpath(__file__))
        built = os.path.normpath(os.path.join(here, "..", "..", "build", "release", "python"))
        if not os.path.isdir(built):
            raise ImportError(f"Fieldfab's kernel is not built: run ./dev build in {os.path.normpath(os.path.join(here, '..', '..'))}") from None
        sys.path.append(built)
        import fieldfab
    _follow_preferences(fieldfab)
    return fieldfab


def write_file(path, data):
    """Writes bytes, or text as UTF-8, whole or not at all. Raises OSError."""
    fieldfab = load()
    try:
        fieldfab.write_file(path, data)
    except fieldfab.Error as error:
        raise OSError(str(error)) from None


_threads = 0  # that the kernel was told


def _follow_preferences(fieldfab):
    global _threads
    if preferences.threads() != _threads:
        _threads = preferences.threads()
        fieldfab.set_threads(_threads or os.cpu_count())
