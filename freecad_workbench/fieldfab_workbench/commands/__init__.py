"""The workbench's commands: one module for each toolbar. Each module has TITLE and COMMANDS, {name: command} in the
toolbar's order, with None for a separator."""

import FreeCADGui

from . import cam, design, examples, exchange, scans, simulation, solids

TOOLBARS = (solids, design, scans, exchange, cam, simulation)
MENUS = (*TOOLBARS, examples)


def register():
    """Registers all commands. Returns a list of (menu title, names in order, whether the menu is also a toolbar)."""
    menus = []
    for module in MENUS:
        for command_name, command in module.COMMANDS.items():
            if command is not None:
                command.name = command_name
                FreeCADGui.addCommand(command_name, command)
        names = [n if c is not None else "Separator" for n, c in module.COMMANDS.items()]
        menus.append((module.TITLE, names, module in TOOLBARS))
    return menus
