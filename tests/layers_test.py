"""Permitted includes: core <- field <- {frep, volume, mesh, asdf} <- contour <- solid <- {render, check} <- {cam,
openscad} <- {cli, python} <- hosts.

openscad_import is below the command and the Python module, unlike the other hosts: it makes Fields of .scad and .csg
files, so that every verb and FreeCAD read these as models. The kernel does not depend on it; it provides a larger table
of formats (openscad::all_formats()).

In cam: base <- {gcode, stock} <- plan <- machine <- job <- simulate, but plan does not include gcode. The same holds
for the rooms' private headers, which no file outside of cam includes.

The FreeCAD workbench in Python: base <- brep <- objects <- files <- views <- panels <- commands <- start. Neither the
workbench nor the Python module has an import cycle, imports inside functions included."""

import ast
import graphlib
import pathlib
import re
import sys
import zipfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)

SOURCES = {"frep", "volume", "mesh", "asdf"}
BELOW = {"core": set(), "field": {"core"}}
BELOW.update({part: {"core", "field"} for part in SOURCES})
BELOW["contour"] = {"core", "field", "mesh"}
BELOW["solid"] = {"core", "field", "contour"} | SOURCES
BELOW["render"] = {"core", "field"}
BELOW["check"] = {"core", "field", "contour", "solid"} | SOURCES
BELOW["cam"] = set(BELOW)
BELOW["openscad"] = set(BELOW) - {"cam", "check"}
BELOW["cli"] = BELOW["python"] = BELOW["meshlab_filter"] = set(BELOW)
# The rooms of cam, the lowest first.
CAM = {"base": set(), "gcode": {"base"}, "stock": {"base"}, "plan": {"base", "stock"}}
CAM["machine"] = set(CAM)
CAM["job"] = set(CAM)
CAM["simulate"] = set(CAM)
# Rooms that know Fields only, such as the renderers, so that a new source of shape needs no change there.
HEAVY = ("CGAL/", "openvdb/", "OpenMesh/", "itk", "asmjit/", "zip.h", "expat.h")
HEAVY_ALLOWED = {"kernel/include/fieldfab/mesh/openmesh.h"}  # an optional header
OF_MESHLAB = ("host", "meshlab_2020", "meshlab_2022")  # folders of meshlab_filter/src that may include its headers

# The workbench's layers, the lowest first. A folder of the package is a layer; of the modules beside the folders, FILES
# are the layer files and all others base.
LAYERS = ("base", "brep", "objects", "files", "views", "panels", "commands", "start")
FILES = ("files", "importing", "openscad_files", "part_files", "path_jobs", "shape_files")
PACKAGE = "fieldfab_workbench"
# Modules of web/server that run in worker processes; they do not import the server.
WORKER_SIDE = {"limits", "worker", "models", "pictures", "archives", "files", "machining", "frames", "launch", "png",
               "remote"}


def room_of(path):
    parts = path.parts
    if parts[:2] == ("kernel", "src"):
        return parts[2]
    if parts[:3] == ("kernel", "include", "fieldfab"):
        return parts[3]
    return "openscad" if parts[0] == "openscad_import" else parts[0]


def cam_room_of(parts):
    """Returns the room of a public or private file of cam; "" for files outside of rooms."""
    parts = parts[4:] if parts[:4] == ("cam", "include", "fieldfab", "cam") else parts[1:]
    return parts[0] if len(parts) == 2 and parts[0] in CAM else ""


def cam_violation(path, name):
    """Returns the violation by an include in cam, or of a header of cam; "" for a permitted one."""
    included = pathlib.PurePosixPath(name).parts
    if included[:2] == ("fieldfab", "cam"):
        other = included[2] if len(included) == 4 and included[2] in CAM else ""
        if not other:
            return f"{path}: no room of cam has the header {name}"
    elif included[0] in CAM and len(included) == 2:
        other = included[0]
        if path.parts[0] != "cam" or "include" in path.parts:
            return f"{path}: {name} is a private header of cam"
    else:
        return ""
    if path.parts[0] != "cam":
        return ""
    room = cam_room_of(path.parts)
    return ("" if other == room or other in CAM.get(room, ())
            else f"{path}: {room or 'no room'} must not include {other} ({name})")


def is_of_meshlab(name):
    """Whether a header belongs to MeshLab, VCG or Qt."""
    return name.startswith(("common/", "vcg/", "wrap/", "Q")) and not name.startswith("Qu")


def violations(path, text):
    """Returns the forbidden includes of a file at `path` (relative to the root)."""
    room, found = room_of(path), []
    for name in INCLUDE.findall(text):
        if name.startswith("fieldfab/"):
            other = name.split("/")[1]
            if other != room and other not in BELOW.get(room, set()):
                found.append(f"{path}: {room} must not include {other} ({name})")
        if wrong := cam_violation(path, name):
            found.append(wrong)
        if (path.suffix == ".h" and "include" in path.parts and str(path) not in HEAVY_ALLOWED
                and name.startswith(HEAVY)):
            found.append(f"{path}: the heavy header {name} belongs into a .cpp file")
        if room == "meshlab_filter" and path.parts[2] not in OF_MESHLAB and is_of_meshlab(name):
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


def test_the_architecture_has_every_room():
    told = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    folders = [folder for part in ("kernel/src", "cam") for folder in sorted((ROOT / part).iterdir())]
    rooms = {str(folder.relative_to(ROOT)).removeprefix("kernel/src/")
             for folder in folders if list(folder.glob("*.cpp"))}
    rooms |= {path.parent.name for path in ROOT.glob("*/CMakeLists.txt")} - {"kernel", "cam", "tests", "build"}
    assert [room
            for room in sorted(rooms) if f"`{room.removeprefix('cam/')}`" not in told and f"/{room}`" not in told] == []


def test_planted_violations_are_caught():
    path = pathlib.PurePosixPath
    assert violations(path("kernel/src/core/a.cpp"), '#include "fieldfab/field/field.h"')
    assert violations(path("kernel/src/mesh/a.cpp"), '#include "fieldfab/asdf/asdf.h"')
    assert violations(path("kernel/src/render/a.cpp"), '#include "fieldfab/frep/text.h"')
    assert violations(path("kernel/include/fieldfab/mesh/a.h"), "#include <CGAL/Kernel.h>")
    assert violations(path("meshlab_filter/src/filters/a.cpp"), "#include <common/interfaces.h>")
    assert violations(path("meshlab_filter/src/a.h"), "#include <QString>")
    assert not violations(path("meshlab_filter/src/host/a.cpp"), "#include <QString>")
    assert not violations(path("kernel/src/check/a.cpp"), "#include <CGAL/Kernel.h>")
    assert not violations(path("cli/a.cpp"), '#include "fieldfab/render/render.h"')


def test_every_file_of_cam_lies_in_a_room():
    sources = [file.relative_to(ROOT) for file in files() if file.is_relative_to(ROOT / "cam")]
    assert {cam_room_of(path.parts) for path in sources} == set(CAM)


def test_planted_violations_of_cam_are_caught():
    path = pathlib.PurePosixPath
    public, private = "cam/include/fieldfab/cam", "cam"
    for room, other in (("base", "plan"), ("gcode", "stock"), ("stock", "gcode"), ("plan", "gcode"),
                        ("plan", "machine"),
                        ("stock", "simulate"), ("machine", "job"), ("job", "simulate")):
        for folder in (public, private):
            assert violations(path(f"{folder}/{room}/a.h"), f'#include "fieldfab/cam/{other}/a.h"'), (room, other)
        assert violations(path(f"{private}/{room}/a.cpp"), f'#include "{other}/a.h"'), (room, other)
        assert not violations(path(f"{private}/simulate/a.cpp"), f'#include "{other}/a.h"')
    assert violations(path(f"{public}/job/a.h"), '#include "base/toml_table.h"')
    assert violations(path("cam/job/a.cpp"), '#include "fieldfab/cam/tool.h"')
    assert violations(path("cam/a.cpp"), '#include "fieldfab/cam/base/tool.h"')
    assert violations(path("cli/a.cpp"), '#include "base/toml_table.h"')
    assert not violations(path("cli/a.cpp"), '#include "fieldfab/cam/simulate/simulate.h"')


def layer_of(module):
    """Returns the layer of a module of the workbench; entry points of FreeCAD and scripts are in the highest."""
    first, *rest = module.split(".")
    if first != PACKAGE:
        return "start"
    room = rest[0] if rest else "base"
    return "files" if room in FILES else room if room in LAYERS else "base"


def python_sources(folder):
    """Returns {name of a module: its text} of all Python files below a folder."""
    paths = {file.relative_to(folder).with_suffix("").parts: file for file in folder.rglob("*.py")}
    return {".".join(name[:-1] if name[-1] == "__init__" else name): file.read_text() for name, file in paths.items()}


def python_imports(module, sources):
    """Returns [(line, other module, whether the import is inside a function)] for imports from `sources`."""
    tree, found = ast.parse(sources[module]), []
    functions = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
    deferred = {node for function in functions for node in ast.walk(function)}
    is_package = any(other.startswith(f"{module}.") for other in sources)
    package = module.split(".") if is_package else module.split(".")[:-1]
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names = [(alias.name, alias.name) for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            start = package[: len(package) - node.level + 1] if node.level else []
            start = ".".join([*start, *([node.module] if node.module else [])])
            names = [(f"{start}.{alias.name}", start) for alias in node.names]
        else:
            continue
        others = {name if name in sources else of for name, of in names} & sources.keys() - {module}
        found += [(node.lineno, other, node in deferred) for other in sorted(others)]
    return found


def python_cycle(sources):
    """Returns the modules of an import cycle, the first one repeated at the end; empty without a cycle."""
    graph = {module: {other for _, other, _ in python_imports(module, sources)} for module in sources}
    try:
        graphlib.TopologicalSorter(graph).prepare()
    except graphlib.CycleError as error:
        return error.args[1]
    return []


def python_violations(sources):
    """Returns upward imports of the workbench, and imports inside functions without a comment with the reason."""
    found = []
    for module, text in sources.items():
        layer, lines = layer_of(module), text.splitlines()
        for line, other, deferred in python_imports(module, sources):
            if LAYERS.index(layer_of(other)) > LAYERS.index(layer):
                found.append(f"{module}:{line}: {layer} must not import {layer_of(other)} ({other})")
            if deferred and layer != "start" and "#" not in lines[line - 1]:
                found.append(f"{module}:{line}: {other} is imported inside a function, and no comment says why")
    return found


def test_the_workbench_imports_downwards():
    sources = python_sources(ROOT / "freecad_workbench")
    assert {layer_of(module) for module in sources} == set(LAYERS)
    assert sum(bool(python_imports(module, sources)) for module in sources) > 60
    assert python_violations(sources) == []
    assert python_cycle(sources) == []
    assert python_imports(f"{PACKAGE}.registry", sources) == []


def test_the_python_module_has_no_import_cycle():
    sources = python_sources(ROOT / "python")
    assert python_imports("fieldfab.edit", sources)
    assert python_cycle(sources) == []


def test_the_web_server_knows_the_module_only():
    """web/server is installed as fieldfab.serve. It imports the standard library, aiohttp, NumPy, Dask and fieldfab, in
    layers. No other part of the project imports it."""
    sources = python_sources(ROOT / "web" / "server")
    assert len(sources) > 10 and python_cycle({f"serve.{name}": text for name, text in sources.items()}) == []
    allowed = sys.stdlib_module_names | {"aiohttp", "distributed", "fieldfab", "numpy"}
    for name, text in sources.items():
        for node in ast.walk(ast.parse(text)):
            names = ([alias.name for alias in node.names] if isinstance(node, ast.Import)
                     else [node.module] if isinstance(node, ast.ImportFrom) and not node.level else [])
            assert [each for each in names if each.split(".")[0] not in allowed] == [], name
            if isinstance(node, ast.ImportFrom) and node.level and name in WORKER_SIDE:
                known = {node.module} if node.module else {alias.name for alias in node.names}
                assert known <= WORKER_SIDE, name
    others = [path for folder in ("python", "freecad_workbench") for path in (ROOT / folder).rglob("*.py")
              if "fieldfab.serve" in path.read_text()]
    assert others == []


def test_saved_documents_find_their_classes():
    """Proxies and view providers are restored by the names of their modules and classes."""
    sources, named = python_sources(ROOT / "freecad_workbench"), set()
    for path in (ROOT / "freecad_workbench" / "resources" / "examples").glob("*.FCStd"):
        with zipfile.ZipFile(path) as document:
            for name in ("Document.xml", "GuiDocument.xml"):
                named |= set(re.findall(rb'module="(\S+)" class="(\S+)"', document.read(name)))
    assert len(named) > 8
    assert [each for each in named if f"class {each[1].decode()}(" not in sources[each[0].decode()]] == []


def planted(**texts):
    """Returns sources of a small workbench. `texts`: by module, views_a for views/a.py; the other modules are empty."""
    names = ("a", "objects.a", "views.a", "panels.a", "files")
    sources = {PACKAGE: "", **{f"{PACKAGE}.{name}": "" for name in (*names, "objects", "views", "panels")}}
    return {**sources, **{f"{PACKAGE}.{name.replace('_', '.')}": text for name, text in texts.items()}}


def test_planted_violations_of_the_workbench_are_caught():
    upwards = {
        "a": "from .objects.a import b",
        "objects_a": "from .. import files",
        "files": "from .views import a",
        "views_a": "from ..panels import a",
    }
    for name, text in upwards.items():
        assert len(python_violations(planted(**{name: text}))) == 1, text
        assert len(python_violations(planted(**{name: f"def f():\n    {text}  # a reason"}))) == 1, text
    downwards = f"import {PACKAGE}.views.a\nfrom {PACKAGE} import a, files\nfrom ..objects.a import b"
    assert python_violations(planted(panels_a=downwards)) == []
    assert len(python_violations(planted(views_a="def f():\n    from .. import a"))) == 1
    assert python_violations(planted(views_a="def f():\n    from .. import a  # it needs numpy")) == []


def test_planted_cycles_are_caught():
    assert python_cycle(planted(objects_a="from ..a import b")) == []
    assert python_cycle(planted(objects_a="from ..a import b", a="def f():\n    from .objects import a"))
    assert python_cycle(planted(objects="from . import a", objects_a="from . import b"))


def test_files_of_cam_stay_short():
    """At most 450 lines: what is longer has two subjects."""
    lengths = {str(file.relative_to(ROOT)): len(file.read_text().splitlines())
               for file in files() if file.is_relative_to(ROOT / "cam")}
    assert {name: lines for name, lines in lengths.items() if lines > 450} == {}
