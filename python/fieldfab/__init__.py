"""Fieldfab: solids from formulas, as distance fields, watertight meshes and pictures.

    import fieldfab as ff
    part = ff.shapes.rounded_box(20, 10, 5, 1)
    ff.mesh(part, voxel=0.1).save("part.stl")
"""

import sys

from . import _core
from ._core import *  # the module is the package's whole interface
from ._core import Error, __version__, cam, language, shapes, stock

__all__ = [name for name in vars(_core) if not name.startswith("_")]
sys.modules[__name__ + ".shapes"] = shapes  # for `from fieldfab.shapes import sphere`
sys.modules[__name__ + ".cam"] = cam
sys.modules[__name__ + ".language"] = language
sys.modules[__name__ + ".stock"] = stock
