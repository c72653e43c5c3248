"""Files and folders that stay outside of the document. The document remembers their path and their path relative to its
own folder, so that both can move together. A property NAME has a hidden companion NAMEBeside."""

import os

import FreeCAD

NAMES = ("File", "Folder")
OUTPUT = 8 | 16  # neither a reason to recompute nor a change of the object
HIDDEN = 4


def path_of(obj, name):
    """Where it is: beside the document if it was there and still is, else where it was. "" where none is named."""
    folder, beside = os.path.dirname(obj.Document.FileName), getattr(obj, f"{name}Beside")
    path = os.path.join(folder, beside) if folder and beside else ""
    return os.path.normpath(path) if path and os.path.exists(path) else getattr(obj, name)


def forget(obj, name):
    """To be called when somebody says that it is elsewhere."""
    if f"{name}Beside" in obj.PropertiesList:
        setattr(obj, f"{name}Beside", "")


class _Places:
    """Remembers, whenever a document is saved, where its files are from there."""

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
