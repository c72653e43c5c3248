"""Python scripts that make solids: which documents may run theirs, and running them in a process of their own."""

import ast
import hashlib
import os
import re
import shutil
import subprocess
import tempfile

import FreeCAD

from . import frep_language, kernel, work
from .sources import kept
from .words import tr


class ScriptError(ValueError):
    """A script that made no solid. `line`: of the script, from 1; 0: unknown. `words`: what is wrong there."""

    def __init__(self, line, words):
        super().__init__(tr("Line {line}: {words}").format(line=line, words=words) if line else words)
        self.line, self.words = line, words


# Consent. A script can do whatever the user can, so that those of a document run only after the user has agreed, for as
# long as the document is open.
_agreed = set()  # names of documents


def may_run(document):
    return document.Name in _agreed


def agree(document):
    _agreed.add(document.Name)


class _Closed:
    """Observer that forgets the consent for a document which is closed."""

    def slotDeletedDocument(self, document):
        _agreed.discard(document.Name)


_closed = _Closed()
FreeCAD.addDocumentObserver(_closed)


# Running.
def formula_of(script, progress=None):
    """Runs the text of a script and returns .frep text of what it made. Raises ScriptError, and work.Cancelled. The
    results of recent scripts are kept."""
    def run():
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "script.py")
            with open(path, "w", encoding="utf-8", errors="replace") as file:
                file.write(script)
            return run_file(path, progress or (lambda fraction, message: True))

    return kept(("formula", hashlib.sha1(script.encode("utf-8", "replace")).hexdigest()), run)


def run_file(path, progress):
    """Runs a script's file and returns .frep text of what it made. Raises ScriptError, and work.Cancelled."""
    folder = os.path.dirname(os.path.dirname(kernel.load().__file__))
    python_path = os.pathsep.join([folder, os.environ.get("PYTHONPATH", "")]).rstrip(os.pathsep)
    with tempfile.TemporaryFile() as said:
        process = subprocess.Popen([shutil.which("python3") or "python3", "-m", "fieldfab.script", path],
                                   env={**os.environ, "PYTHONPATH": python_path},
                                   stdin=subprocess.DEVNULL, stdout=said, stderr=subprocess.DEVNULL)
        try:
            while process.poll() is None:
                if progress(0, "") is False:
                    raise work.Cancelled()
                try:
                    process.wait(0.05)
                except subprocess.TimeoutExpired:
                    pass
        finally:
            process.kill()
            process.wait()
        said.seek(0)
        answer = said.read().decode(errors="replace")
    if answer.startswith("ok\n"):
        return answer[3:]
    if not answer.startswith("error "):
        raise ScriptError(0, tr("the process ended without a result"))
    _, line, words = answer.split(" ", 2)
    raise ScriptError(int(line), words)


# Their text.
def parameters(script):
    """Returns the named numbers of a script in order, as frep_language.parameters() does: those that a statement of its
    own at the script's left edge assigns. Of a script with a mistake in its syntax, none."""
    try:
        tree = ast.parse(script)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return {}
    assigned = {target.id for each in tree.body if isinstance(each, ast.Assign)
                for target in each.targets if isinstance(target, ast.Name)}
    return {name: each for name, each in frep_language.parameters(script).items() if name in assigned
            and re.search(rf"^{re.escape(name)} *=", script, re.MULTILINE)}


def mistake(script):
    """Returns the first mistake in the syntax of a script, as a ScriptError, or None."""
    try:
        ast.parse(script)
    except SyntaxError as error:
        return ScriptError(error.lineno or 0, error.msg)
    except (ValueError, RecursionError, MemoryError) as error:
        return ScriptError(0, str(error) or tr("the script is too deep"))
    return None
