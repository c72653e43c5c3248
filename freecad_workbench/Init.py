"""Registers file types for import and export, and the workbench's test. FreeCAD runs this module at every start, with
or without a window."""

import FreeCAD
from fieldfab_workbench import file_types

file_types.register()
file_types.take_over_shapes()
FreeCAD.__unit_test__ += ["TestFieldfab"]
