"""FreeCAD runs this at its start, with or without a window."""

import FreeCAD

FreeCAD.__unit_test__ += ["TestFieldfab"]
