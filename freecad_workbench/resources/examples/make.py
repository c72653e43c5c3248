"""Makes the example documents beside this file. FreeCAD's window runs it, since pictures of documents need one:

    ./dev examples
"""

import base64
import os
import re
import sys
import tempfile
import zipfile

import FreeCAD
import FreeCADGui

from fieldfab_workbench.shim import QtCore, QtGui

HERE = os.path.dirname(os.path.abspath(__file__))
DESIGNS = os.path.join(HERE, "..", "..", "..", "examples")

BRACKET = """# an angle bracket: two plates, a filleted corner, four screw holes. mm
width = 30
length = 40
height = 40
thick = 5
corner = 6
hole = 5.2
plate(w, h, t) = rounded_box(w, h, t, 1.2)
base = move(plate(length, width, thick), dz = thick / 2)
wall = move(rotate_y(plate(height, width, thick), 90), dx = (thick - length) / 2, dz = height / 2)
bore(px, py) = move(cylinder(r = hole / 2, h = 4 * thick), px, py, thick / 2)
side(py, pz) = move(rotate_y(cylinder(r = hole / 2, h = 4 * thick), 90), (thick - length) / 2, py, pz)
inside = smooth_union(base, wall, corner)
difference(inside, bore(length / 4, width / 4), bore(length / 4, -width / 4),
           side(width / 4, 0.75 * height), side(-width / 4, 0.75 * height))
"""
KNOB = """# a knob with grips around it. mm
size = 20
tall = 10
grips = 7
body = smooth_intersection(cylinder(r = size / 2, h = 2 * tall), move(sphere(r = size), dz = -size + tall), 3)
grip = move(cylinder(r = size / 10, h = 3 * tall), dx = 0.55 * size)
difference(intersection(body, move(box(2 * size, 2 * size, 2 * tall), dz = tall)), array_polar(grip, grips))
"""


def _solid(document, kind, label, voxel=0.0, **properties):
    from fieldfab_workbench.objects import solid

    made = solid.create(kind, document)
    made.Label, made.VoxelSize = label, voxel
    for name, value in properties.items():
        setattr(made, name, value)
    document.recompute()
    assert made.isValid(), made.getStatusString()
    return made


def bracket(document):
    """A solid of text with parameters."""
    from fieldfab_workbench.objects.frep_solid import FrepSolid

    _solid(document, FrepSolid, "Bracket", 1, Expression=BRACKET, MaxError=0.05)


def lattice(document):
    """A solid made of another one: a wall, seen through here, and a gyroid inside."""
    from fieldfab_workbench.objects.frep_solid import FrepSolid
    from fieldfab_workbench.objects.modify import Modify

    knob = _solid(document, FrepSolid, "Knob", 1.4, Expression=KNOB, MaxError=0.15)
    filled = _solid(document, Modify, "Filled knob", 1.15, Operation="Lattice infill", Source=knob, Wall=1.6, Period=12,
                    Strut=1.6, MaxError=0.18)
    knob.ViewObject.Visibility = False
    filled.ViewObject.Transparency = 55


def machining(document):
    """A set-up with a planned program: cleared in three axes, finished by a ball that leans along the surface."""
    from fieldfab_workbench.objects import cam_operation, cam_setup, cam_tool, machine_program
    from fieldfab_workbench.objects.frep_solid import FrepSolid

    with open(os.path.join(DESIGNS, "cam", "knob.frep"), encoding="utf-8") as file:
        knob = _solid(document, FrepSolid, "Knob on a plate", 2.2, MaxError=0.2, Expression=file.read())
    setup = cam_setup.create(document, knob)
    setup.Machine, setup.Margin, setup.Top = "five_axis_ac", 1, 1
    holder = {"holder_diameter": 40, "holder_length": 50}
    mill = cam_tool.add(setup, {"name": "8 mm end mill", "diameter": 8, "flute": 24, "length": 45, **holder})
    ball = cam_tool.add(setup, {"name": "6 mm ball", "shape": "ball", "diameter": 6, "flute": 12, "length": 35,
                                **holder})
    for kind, tool, settings in (("rough", mill, {"stepdown": 6, "bottom": 0}),
                                 ("finish", ball, {"lean": True, "pattern": "spiral", "scallop": 0.4, "bottom": 0})):
        operation = cam_operation.add(setup, kind, tool)
        for setting in operation.Proxy.settings(operation):
            if setting.name in settings:
                operation.Proxy.give(operation, setting, settings[setting.name])
    program = machine_program.create(setup)
    document.recompute()
    assert program.isValid() and program.MadeFrom, program.getStatusString()
    sheet = re.sub(r"(?<=base64,)[\w+/=]+", _smaller, machine_program.setup_sheet(program).decode())
    program.PackedSheet = machine_program.packed(sheet.encode())


def _smaller(picture):
    """Returns a picture of the set-up sheet at half its size, in base64. `picture`: a match of the original."""
    data = QtCore.QByteArray()
    buffer = QtCore.QBuffer(data)
    image = QtGui.QImage.fromData(base64.b64decode(picture[0]))
    image.scaledToWidth(image.width() // 2, QtCore.Qt.SmoothTransformation).save(buffer, "PNG")
    return base64.b64encode(data.data()).decode()


def _with_picture(path, picture):
    """Stores a thumbnail for FreeCAD's start page in a saved document. Without a graphics card, FreeCAD's own thumbnail
    shows only its logo."""
    with zipfile.ZipFile(path) as saved:
        held = {name: saved.read(name) for name in saved.namelist()}
    with open(picture, "rb") as file:
        held["thumbnails/Thumbnail.png"] = file.read()
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as made:
        for name, data in held.items():
            made.writestr(name, data)


def main(folder):
    for make in (bracket, lattice, machining):
        document = FreeCAD.newDocument(make.__name__)
        make(document)
        document.Comment = make.__doc__
        FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
        FreeCADGui.SendMsgToActiveView("ViewFit")
        FreeCADGui.updateGui()
        path = os.path.join(folder, f"{make.__name__}.FCStd")
        if os.path.exists(path):
            os.remove(path)
        document.saveAs(path)
        picture = os.path.join(tempfile.mkdtemp(), "picture.png")
        FreeCADGui.ActiveDocument.ActiveView.saveImage(picture, 256, 256, "Current")
        _with_picture(path, picture)
        print(f"{path}: {os.path.getsize(path)} bytes", flush=True)
        FreeCAD.closeDocument(document.Name)


def run():
    try:
        main(os.environ["FIELDFAB_EXAMPLES"])
    except BaseException as error:
        print(f"the examples were not made: {error!r}", file=sys.stderr, flush=True)
        os._exit(1)
    os._exit(0)


if os.environ.get("FIELDFAB_EXAMPLES"):
    QtCore.QTimer.singleShot(1500, run)  # when the window is open: views cannot be drawn earlier
