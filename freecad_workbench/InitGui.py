"""FreeCAD runs this when its window opens: it registers the workbench."""

import FreeCADGui


class FieldfabWorkbench(FreeCADGui.Workbench):
    """Solids from formulas."""

    def __init__(self):
        import os

        import fieldfab_workbench

        icons = os.path.join(os.path.dirname(os.path.dirname(fieldfab_workbench.__file__)), "icons")
        self.__class__.Icon = os.path.join(icons, "fieldfab.svg")
        self.__class__.MenuText = "Fieldfab"
        self.__class__.ToolTip = "Solids from formulas: f-reps and distance fields"

    def Initialize(self):
        from fieldfab_workbench import commands

        for title, names in commands.register():
            self.appendToolbar(title, names)
            self.appendMenu("Fieldfab" if title == "Fieldfab" else ["Fieldfab", title], names)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(FieldfabWorkbench())
