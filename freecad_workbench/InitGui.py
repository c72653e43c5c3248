"""Registers the workbench. FreeCAD runs this module when its window opens."""

import FreeCADGui


class FieldfabWorkbench(FreeCADGui.Workbench):
    """Solids from formulas and scans."""

    def __init__(self):
        import os

        import fieldfab_workbench

        icons = os.path.join(os.path.dirname(os.path.dirname(fieldfab_workbench.__file__)), "icons")
        self.__class__.Icon = os.path.join(icons, "fieldfab.svg")
        self.__class__.MenuText = "Fieldfab"
        self.__class__.ToolTip = "Solids from formulas and scans, machined and simulated"

    def Initialize(self):
        import os

        import fieldfab_workbench

        folder = os.path.dirname(os.path.dirname(fieldfab_workbench.__file__))
        FreeCADGui.addIconPath(os.path.join(folder, "icons"))
        FreeCADGui.addPreferencePage(os.path.join(folder, "resources", "preferences.ui"), "Fieldfab")
        from fieldfab_workbench import commands

        for title, names, toolbar in commands.register():
            if toolbar:
                self.appendToolbar(title, names)
            self.appendMenu("Fieldfab" if title == "Fieldfab" else ["Fieldfab", title], names)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


def _translate():
    """Loads the translations at FreeCAD's start, because every workbench shows objects and their properties."""
    import os

    import fieldfab_workbench

    folder = os.path.dirname(os.path.dirname(fieldfab_workbench.__file__))
    FreeCADGui.addLanguagePath(os.path.join(folder, "resources", "translations"))
    FreeCADGui.updateLocale()


def _fill_registry():
    """Fills the registry with functions that import views and panels on first use. These need numpy and Coin, which
    would slow FreeCAD's start."""
    from fieldfab_workbench import registry

    def views():
        from fieldfab_workbench.views.kinds import VIEWS

        return VIEWS

    def panels():
        from fieldfab_workbench.panels.kinds import PANELS

        return PANELS

    registry.fill(views, panels)


def _export_shapes():
    """Takes over the export to STEP, IGES and BREP once all workbenches have registered theirs."""
    from fieldfab_workbench import file_types
    from fieldfab_workbench.shim import QtCore

    file_types.take_over_shapes()
    QtCore.QTimer.singleShot(0, file_types.take_over_shapes)


_translate()
_fill_registry()
_export_shapes()
FreeCADGui.addWorkbench(FieldfabWorkbench())
