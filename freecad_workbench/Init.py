"""FreeCAD runs this at every start, with or without a window: it learns of the files that can come and go, and of our test."""

import FreeCAD
from fieldfab_workbench import file_types

file_types.register()
FreeCAD.__unit_test__ += ["TestFieldfab"]
