"""Import of several objects as one undo step, or none at all."""

import contextlib

import FreeCAD

from . import work
from .mistakes import Stopped
from .words import tr


@contextlib.contextmanager
def one_step(filename, docname, name):
    """Yields the document of that name (a new one if it does not exist) and a list for the added objects. Removes these
    objects on ValueError or work.Cancelled, and then raises ValueError with a line for the user."""
    there = docname in FreeCAD.listDocuments()
    document, made = FreeCAD.getDocument(docname) if there else FreeCAD.newDocument(docname or name), []
    began = not document.HasPendingTransaction
    if began:
        document.openTransaction(tr("Import {label}").format(label=name))
    try:
        yield document, made
        document.recompute()
        if began:
            document.commitTransaction()
    except (ValueError, work.Cancelled) as error:
        for obj in reversed(made):
            document.removeObject(obj.Name)
        if began:
            document.abortTransaction()
        stopped = isinstance(error, work.Cancelled)
        raise (cancelled(filename) if stopped else ValueError(f"{filename}: {error}")) from None
    finally:
        if not there and not document.Objects:
            FreeCAD.closeDocument(document.Name)
        elif not there:
            document.Label = docname or name


def cancelled(filename):
    return Stopped(tr("{filename}: cancelled; nothing was added").format(filename=filename))
