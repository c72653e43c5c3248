"""Uniform names for FreeCAD's own milling workbench: Path in 0.20 (PathScripts.*), CAM in later versions (Path.Main.*,
Path.Tool.*). Tested with 0.20.2, 1.0 and 1.1."""

import contextlib
import importlib
import os

import FreeCAD


def first(*names):
    """Returns the first of some modules that there is. Raises ImportError if there is none."""
    for name in names:
        try:
            return importlib.import_module(name)
        except ImportError:
            pass
    raise ImportError(f"FreeCAD's Path workbench has none of {', '.join(names)}")


def folder():
    """Returns the folder of FreeCAD's milling workbench, with its tools."""
    mod = os.path.join(FreeCAD.getResourceDir(), "Mod")
    return next((path for path in (os.path.join(mod, name) for name in ("CAM", "Path")) if os.path.isdir(path)), None)


def operation(name):
    """Returns the module of one of its operations: Profile, PocketShape, Custom."""
    return first(f"PathScripts.Path{name}", f"Path.Op.{name}")


def jobs():
    return first("PathScripts.PathJob", "Path.Main.Job")


def stocks():
    return first("PathScripts.PathStock", "Path.Main.Stock")


def controllers():
    return first("PathScripts.PathToolController", "Path.Tool.Controller")


def bits():
    return first("PathScripts.PathToolBit", "Path.Tool.Bit")


def make_bit(document, told):
    """Makes a tool bit from the content of a .fctb file. Called in the context in_one_step()."""
    module = bits()
    if hasattr(module, "Factory"):
        return module.Factory.CreateFromAttrs(told, "ToolBit")
    return module.ToolBit.from_dict(told).attach_to_doc(document)  # since 1.1


def corner_of_bull_nose(diameter, corner_radius):
    """Returns the name and the length by which a bull nose's tool bit tells its corner."""
    if hasattr(bits(), "Factory"):
        return "FlatRadius", diameter / 2 - corner_radius
    return "CornerRadius", corner_radius  # since 1.1


@contextlib.contextmanager
def in_one_step():
    """Context in which FreeCAD's tool bits are made without separate undo steps, which they otherwise get in its
    window, up to version 1.0."""
    module = bits()
    before = getattr(module, "Factory", None)
    if hasattr(module, "ToolBitFactory"):
        module.Factory = module.ToolBitFactory()
    try:
        yield
    finally:
        if before is not None:
            module.Factory = before


def show_job(job):
    """Gives a new job FreeCAD's view provider, if there is a window."""
    if FreeCAD.GuiUp:
        job.ViewObject.Proxy = first("PathScripts.PathJobGui", "Path.Main.Gui.Job").ViewProvider(job.ViewObject)
        job.ViewObject.addExtension("Gui::ViewProviderGroupExtensionPython")
        job.ViewObject.Proxy.deleteOnReject = False


def utilities():
    return first("PathScripts.PathUtil", "Path.Base.Util")


def post(name):
    """Returns the module of a post processor. Its function is export(objects, filename, arguments)."""
    return first(f"PathScripts.post.{name}_post", f"Path.Post.scripts.{name}_post")


def is_job(obj):
    """Returns whether a document object is a Path job."""
    return all(hasattr(obj, name) for name in ("PostProcessor", "Operations", "Stock", "Tools"))
