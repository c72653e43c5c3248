# FreeCAD runs this at every start, with or without a window. Nothing is registered yet: file types come with later versions.
