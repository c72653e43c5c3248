"""Document objects. They need no FreeCAD window."""
