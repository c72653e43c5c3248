"""User preferences, stored in FreeCAD's parameters. Edit > Preferences > Fieldfab shows preferences.ui."""

import FreeCAD

PATH = "User parameter:BaseApp/Preferences/Mod/Fieldfab"
STANDARD_COLOUR = 0x6B9EDBFF


def _group():
    return FreeCAD.ParamGet(PATH)


def threads():
    """Returns the number of kernel threads; 0: the number of cores."""
    return max(0, _group().GetInt("Threads", 0))


def cells():
    """Returns the number of smallest cells along a solid's longest side, for solids with a VoxelSize of 0; 0: the
    kernel's default."""
    wanted = _group().GetInt("Cells", 0)
    return min(4096, max(8, wanted)) if wanted else 0


def colour():
    """Returns the colour of new solids: red, green and blue from 0 to 1."""
    packed = _group().GetUnsigned("Colour", STANDARD_COLOUR)
    return tuple((packed >> shift & 255) / 255 for shift in (24, 16, 8))
