"""The workbench's commands: one module a toolbar. Each has TITLE and COMMANDS, {name: command} in its order; None is a separator."""

import importlib

TOOLBARS = ("solids", "design", "scans", "exchange", "cam", "simulation")
MENUS = (*TOOLBARS, "examples")


def register():
    """Registers all commands; returns [(title of the menu, names in its order, whether it is a toolbar, too)]."""
    import FreeCADGui

    menus = []
    for name in MENUS:
        module = importlib.import_module(f"{__name__}.{name}")
        for command_name, command in module.COMMANDS.items():
            if command is not None:
                command.name = command_name
                FreeCADGui.addCommand(command_name, command)
        menus.append((module.TITLE, [n if c is not None else "Separator" for n, c in module.COMMANDS.items()], name in TOOLBARS))
    return menus
