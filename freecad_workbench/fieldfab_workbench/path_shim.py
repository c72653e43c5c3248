"""FreeCAD's own milling workbench under one set of names: Path in 0.20 (PathScripts.*), CAM later (Path.Main.*,
Path.Tool.*). Tried with 0.20.2; the later names follow FreeCAD's sources."""

import contextlib
import importlib

import FreeCAD


def _first(*names):
    for name in names:
        try:
            return importlib.import_module(name)
        except ImportError:
            pass
    raise ImportError(f"FreeCAD's Path workbench has none of {', '.join(names)}")


def jobs():
    return _first("PathScripts.PathJob", "Path.Main.Job")


def stocks():
    return _first("PathScripts.PathStock", "Path.Main.Stock")


def controllers():
    return _first("PathScripts.PathToolController", "Path.Tool.Controller")


def bits():
    return _first("PathScripts.PathToolBit", "Path.Tool.Bit")


@contextlib.contextmanager
def in_one_step():
    """While it lasts, FreeCAD's tool bits are made without undo steps of their own, which they have in its window."""
    module = bits()
    before = module.Factory
    if hasattr(module, "ToolBitFactory"):
        module.Factory = module.ToolBitFactory()
    try:
        yield
    finally:
        module.Factory = before


def show_job(job):
    """Gives a new job FreeCAD's own place in the tree and panel, where there is a window."""
    if FreeCAD.GuiUp:
        job.ViewObject.Proxy = _first("PathScripts.PathJobGui", "Path.Main.Gui.Job").ViewProvider(job.ViewObject)
        job.ViewObject.addExtension("Gui::ViewProviderGroupExtensionPython")
        job.ViewObject.Proxy.deleteOnReject = False


def utilities():
    return _first("PathScripts.PathUtil", "Path.Base.Util")


def post(name):
    """The post processor's module: export(objects, filename, arguments)."""
    return _first(f"PathScripts.post.{name}_post", f"Path.Post.scripts.{name}_post")


def is_job(obj):
    """Whether a document object is a Path job."""
    return all(hasattr(obj, name) for name in ("PostProcessor", "Operations", "Stock", "Tools"))
