"""FreeCAD's own milling workbench under one set of names: Path in 0.20 (PathScripts.*), CAM later (Path.Main.*, Path.Tool.*). Tried with
0.20.2; the later names follow FreeCAD's sources."""

import importlib


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


def utilities():
    return _first("PathScripts.PathUtil", "Path.Base.Util")


def post(name):
    """The post processor's module: export(objects, filename, arguments)."""
    return _first(f"PathScripts.post.{name}_post", f"Path.Post.scripts.{name}_post")


def is_job(obj):
    """Whether a document object is a Path job."""
    return all(hasattr(obj, name) for name in ("PostProcessor", "Operations", "Stock", "Tools"))
