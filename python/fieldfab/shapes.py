"""Shapes and what is done with them, as expressions (lengths in mm, angles in radians)."""

from ._core import shapes as _shapes

globals().update({name: value for name, value in vars(_shapes).items() if not name.startswith("_")})
__all__ = [name for name in vars(_shapes) if not name.startswith("_")]
