"""The workbench's commands: one module a toolbar. Each has TITLE and COMMANDS, {name: command} in its order; None is a separator."""

import importlib

TOOLBARS = ("solids", "cam")


def register():
    """Registers all commands; returns [(title of the toolbar, names in its order)]."""
    import FreeCADGui

    bars = []
    for name in TOOLBARS:
        module = importlib.import_module(f"{__name__}.{name}")
        for command_name, command in module.COMMANDS.items():
            if command is not None:
                FreeCADGui.addCommand(command_name, command)
        bars.append((module.TITLE, [n if c is not None else "Separator" for n, c in module.COMMANDS.items()]))
    return bars
