"""External files and folders of a document. The document stores each absolute path and the path relative to its own
folder, so that both can move together. A property NAME has a hidden companion NAMEBeside for the relative path."""

import os

import FreeCAD

NAMES = ("File", "Folder")
OUTPUT = 8 | 16  # changes neither cause a recompute nor touch the object
HIDDEN = 4


def path_of(obj, name):
    """Returns the path: relative to the document if the file exists there, otherwise the absolute path. "" if none is
    set."""
    folder, beside = os.path.dirname(obj.Document.FileName), getattr(obj, f"{name}Beside")
    path = os.path.join(folder, beside) if folder and beside else ""
    return os.path.normpath(path) if path and os.path.exists(path) else getattr(obj, name)


def forget(obj, name):
    """Drops the relative path. To be called after the user has chosen another path."""
    if f"{name}Beside" in obj.PropertiesList:
        setattr(obj, f"{name}Beside", "")


class _Places:
    """Observer that updates the relative paths whenever a document is saved."""

    def slotStartSaveDocument(self, document, filename):
        folder = os.path.dirname(os.path.abspath(filename))
        for obj in document.Objects:
            for name in NAMES:
                if f"{name}Beside" in obj.PropertiesList:
                    path = path_of(obj, name)
                    if path and os.path.exists(path) and os.path.splitdrive(path)[0] == os.path.splitdrive(folder)[0]:
                        setattr(obj, f"{name}Beside", os.path.relpath(path, folder))


_places = _Places()
FreeCAD.addDocumentObserver(_places)
