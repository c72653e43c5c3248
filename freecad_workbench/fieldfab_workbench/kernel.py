"""Finds the `fieldfab` Python module: an installed one, or the one built beside this workbench."""

import glob
import importlib.util
import os
import sys

from . import preferences

HERE = os.path.dirname(os.path.realpath(__file__))
BUILT = os.path.normpath(os.path.join(HERE, "..", "..", "build", "release", "python"))


def load():
    """Returns the module `fieldfab`. Raises ImportError with advice if it is not found."""
    try:
        import fieldfab
    except ImportError:
        if not os.path.isdir(BUILT):
            raise ImportError("Fieldfab's kernel is not built: "
                              f"run ./dev build in {os.path.normpath(os.path.join(HERE, '..', '..'))}") from None
        sys.path.append(BUILT)
        import fieldfab
    _follow_preferences(fieldfab)
    return fieldfab


def stamp():
    """Returns path, size and modification time of the module's file without loading it, or "" if only load() can find
    it."""
    found = importlib.util.find_spec("fieldfab")
    folders = list(found.submodule_search_locations or []) if found else [os.path.join(BUILT, "fieldfab")]
    for path in (path for folder in folders for path in sorted(glob.glob(os.path.join(glob.escape(folder), "_core*")))):
        seen = os.stat(path)
        return f"{path} {seen.st_size} {seen.st_mtime_ns}"
    return ""


def write_file(path, data):
    """Writes bytes, or text as UTF-8, whole or not at all. Raises OSError."""
    fieldfab = load()
    try:
        fieldfab.write_file(path, data)
    except fieldfab.Error as error:
        raise OSError(str(error)) from None


_threads = 0  # number of threads last set in the kernel


def _follow_preferences(fieldfab):
    global _threads
    if preferences.threads() != _threads:
        _threads = preferences.threads()
        fieldfab.set_threads(_threads or os.cpu_count())
