"""Fieldfab inside FreeCAD."""
