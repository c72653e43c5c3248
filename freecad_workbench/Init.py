"""FreeCAD runs this at every start, with or without a window: it learns of the files that can come and go."""

from fieldfab_workbench import files

files.register()
