"""FreeCAD runs this at every start, with or without a window. It registers the types of files that can be imported and
exported, and the workbench's test."""

import FreeCAD
from fieldfab_workbench import file_types

file_types.register()
FreeCAD.__unit_test__ += ["TestFieldfab"]
