"""How worker processes are started."""

import os
import sys


def worker_command(memory):
    """Returns the words and the environment of a worker process with a limit of memory, bytes.

    It finds modules where this process does, although the current folder may have changed since a relative PYTHONPATH
    was given. -P: a user's json.py in the current folder does not replace Python's."""
    words = [sys.executable, "-P", "-m", f"{__package__}.worker", str(memory)]
    package = os.path.dirname(os.path.abspath(sys.modules["fieldfab"].__file__))
    paths = [os.path.dirname(package), *filter(None, [os.environ.get("PYTHONPATH")])]
    return words, {**os.environ, "PYTHONPATH": os.pathsep.join(paths)}
