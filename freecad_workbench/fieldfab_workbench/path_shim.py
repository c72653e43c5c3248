"""Uniform names for FreeCAD's own milling workbench: Path in 0.20 (PathScripts.*), CAM in later versions (Path.Main.*,
Path.Tool.*). Tested with 0.20.2; the later names follow FreeCAD's sources."""

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
    """Context in which FreeCAD's tool bits are made without separate undo steps, which they otherwise get in its
    window."""
    module = bits()
    before = module.Factory
    if hasattr(module, "ToolBitFactory"):
        module.Factory = module.ToolBitFactory()
    try:
        yield
    finally:
        module.Factory = before


def show_job(job):
    """Gives a new job FreeCAD's view provider, if there is a window."""
    if FreeCAD.GuiUp:
        job.ViewObject.Proxy = _first("PathScripts.PathJobGui", "Path.Main.Gui.Job").ViewProvider(job.ViewObject)
        job.ViewObject.addExtension("Gui::ViewProviderGroupExtensionPython")
        job.ViewObject.Proxy.deleteOnReject = False


def utilities():
    return _first("PathScripts.PathUtil", "Path.Base.Util")


def post(name):
    """Returns the module of a post processor. Its function is export(objects, filename, arguments)."""
    return _first(f"PathScripts.post.{name}_post", f"Path.Post.scripts.{name}_post")


def is_job(obj):
    """Returns whether a document object is a Path job."""
    return all(hasattr(obj, name) for name in ("PostProcessor", "Operations", "Stock", "Tools"))
