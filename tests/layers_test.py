"""Who may include whom: core <- field <- {frep, volume, mesh, asdf} <- model <- {render, check} <- {cam, openscad} <- {cli, python} <- hosts.

openscad_import is below the command and the Python module, unlike the other hosts: it makes Fields of .scad and .csg files, which are
models like any other, so that every verb and FreeCAD read them. Nothing in the kernel knows it; it brings its reader by add_model_reader()."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)

SOURCES = {"frep", "volume", "mesh", "asdf"}
BELOW = {"core": set(), "field": {"core"}}
BELOW.update({part: {"core", "field"} for part in SOURCES})
BELOW["model"] = {"core", "field"} | SOURCES
BELOW["render"] = {"core", "field"}
BELOW["check"] = {"core", "field", "model"} | SOURCES
BELOW["cam"] = set(BELOW)
BELOW["openscad"] = set(BELOW) - {"cam", "check"}
BELOW["cli"] = BELOW["python"] = BELOW["meshlab_filter"] = set(BELOW)
# FIELD-only rooms: the renderers, so that a new source of shape needs no change there.
HEAVY = ("CGAL/", "openvdb/", "OpenMesh/", "itk", "asmjit/", "zip.h", "expat.h")
HEAVY_ALLOWED = {"kernel/include/fieldfab/mesh/openmesh.h"}  # for those who ask for it by name


def room_of(path):
    parts = path.parts
    if parts[:2] == ("kernel", "src"):
        return parts[2]
    if parts[:3] == ("kernel", "include", "fieldfab"):
        return parts[3]
    return "openscad" if parts[0] == "openscad_import" else parts[0]


def is_of_meshlab(name):
    """Headers of MeshLab, VCG or Qt."""
    return name.startswith(("common/", "vcg/", "wrap/", "Q")) and not name.startswith("Qu")


def violations(path, text):
    """What a file at `path` (relative to the root) includes that it must not."""
    room, found = room_of(path), []
    for name in INCLUDE.findall(text):
        if name.startswith("fieldfab/"):
            other = name.split("/")[1]
            if other != room and other not in BELOW.get(room, set()):
                found.append(f"{path}: {room} must not include {other} ({name})")
        if path.suffix == ".h" and "include" in path.parts and str(path) not in HEAVY_ALLOWED and name.startswith(HEAVY):
            found.append(f"{path}: the heavy header {name} belongs into a .cpp file")
        if room == "meshlab_filter" and path.parts[2] != "meshlab_2020" and is_of_meshlab(name):
            found.append(f"{path}: {name} belongs into the folder of MeshLab's interface")
    return found


def files():
    for folder in ("kernel", "cam", "openscad_import", "cli", "python", "meshlab_filter"):
        for pattern in ("*.h", "*.cpp", "*.inl"):
            yield from (ROOT / folder).rglob(pattern)


def test_includes_go_downwards():
    checked = list(files())
    assert len(checked) > 40
    assert [v for f in checked for v in violations(f.relative_to(ROOT), f.read_text())] == []


def test_planted_violations_are_caught():
    path = pathlib.PurePosixPath
    assert violations(path("kernel/src/core/a.cpp"), '#include "fieldfab/field/field.h"')
    assert violations(path("kernel/src/mesh/a.cpp"), '#include "fieldfab/asdf/asdf.h"')
    assert violations(path("kernel/src/render/a.cpp"), '#include "fieldfab/frep/text.h"')
    assert violations(path("kernel/include/fieldfab/mesh/a.h"), "#include <CGAL/Kernel.h>")
    assert violations(path("meshlab_filter/src/filters/a.cpp"), "#include <common/interfaces.h>")
    assert violations(path("meshlab_filter/src/a.h"), "#include <QString>")
    assert not violations(path("meshlab_filter/src/meshlab_2020/a.cpp"), "#include <QString>")
    assert not violations(path("kernel/src/check/a.cpp"), "#include <CGAL/Kernel.h>")
    assert not violations(path("cli/a.cpp"), '#include "fieldfab/render/render.h"')
