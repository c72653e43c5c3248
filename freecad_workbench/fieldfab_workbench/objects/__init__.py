"""The document objects. Nothing here needs FreeCAD's window."""
