"""What the user prefers, kept where FreeCAD keeps such things (Edit > Preferences > Fieldfab shows preferences.ui)."""

import FreeCAD

PATH = "User parameter:BaseApp/Preferences/Mod/Fieldfab"
STANDARD_COLOUR = 0x6B9EDBFF


def _group():
    return FreeCAD.ParamGet(PATH)


def threads():
    """Threads of the kernel; 0: as many as there are cores."""
    return max(0, _group().GetInt("Threads", 0))


def cells():
    """Smallest cells along a solid's longest side where its VoxelSize is 0; 0: as many as the kernel takes."""
    wanted = _group().GetInt("Cells", 0)
    return min(4096, max(8, wanted)) if wanted else 0


def colour():
    """Of new solids: red, green and blue from 0 to 1."""
    packed = _group().GetUnsigned("Colour", STANDARD_COLOUR)
    return tuple((packed >> shift & 255) / 255 for shift in (24, 16, 8))
