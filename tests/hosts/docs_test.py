"""README.md, CONTRIBUTING.md, docs/*.md and the code in docstrings of Python. Each command is run as written. The
output of each Python session is compared. Each model, job, set-up and script is read. All named options, files and
headings must exist.

GIVEN makes files that a document only names (part.scad, scan.nrrd). PLACEHOLDERS replaces words in capitals."""

import ast
import contextlib
import fnmatch
import importlib
import inspect
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import time

import numpy as np
import pytest
from conftest import BUILD, COMMAND, ROOT
from documents import COMMAND_IN_PROSE, DOCUMENTS, NAME_OF_VERB, code_of
from freecad_host import screen
from programs import lacks, need

import fieldfab as ff
from fieldfab import koko_script

SHOTS = os.environ.get("FIELDFAB_SHOTS")  # a folder for pictures of the windows
SECONDS = 120  # for a command

# Commands that are not run here, with the reason.
NOT_RUN = {
    "./dev test": "runs this very test",
    "./dev check": "may run this very test; tests/check_test.py and reach_test.py try what it chooses",
    "./dev demo": "takes minutes",
    "./dev build": "takes minutes",
    "./dev test --full": "runs this very test",
    "./dev release": "builds packages; release_test.py tries its checks",
    "/usr/bin/python3 packaging/release.py --set 0.2.0": "writes into the tree; release_test.py does it in another one",
    "/usr/bin/python3 packaging/release.py --date 2026-12-24":
        "writes into the tree; release_test.py does it in another one",
    "git commit -a": "writes into the repository",
    "git tag -a v0.2.0 -F out/release/tag.txt": "writes into the repository; release_test.py does it in another one",
    "./dev package": "takes minutes; ./dev newcomer tries what it makes",
    "./dev newcomer": "takes minutes, and a Debian of its own",
    "./dev newcomer trixie": "takes minutes, and a Debian of its own",
    "./dev on bookworm test": "takes more than an hour, and a Debian of its own",
    "./dev on trixie test": "takes more than an hour, and a Debian of its own",
    "./dev on forky test": "takes more than an hour, and a Debian of its own",
    "apt install ./out/packages/*.deb": "writes into the system; ./dev newcomer does it in a bare Debian",
    "apt purge '*fieldfab*'": "writes into the system; ./dev newcomer does it in a bare Debian",
    "cmake -S . -B build": "hosts/sdk_test.py builds docs/install.md's project against a folder of its own",
    "cmake --build build": "hosts/sdk_test.py builds docs/install.md's project against a folder of its own",
    "cmake --install build/release --prefix FOLDER": "hosts/sdk_test.py does it",
    "/usr/bin/python3 -m venv --system-site-packages env": "hosts/sdk_test.py does it in a copy of the source tree",
    "env/bin/pip install --no-build-isolation .": "hosts/sdk_test.py does it in a copy of the source tree",
    "env/bin/fieldfab mesh examples/bracket.frep -o bracket.stl": "hosts/sdk_test.py does it there",
    "./dev bench": "takes more than ten minutes",
    "./dev docs": "takes minutes, and writes the documents that are tested; hosts/site_test.py makes the site",
    "./dev lint": "takes minutes; text_test.py runs its checks of the text",
    "./dev lint --changed": ".ci/run does it before this test",
    "./dev dearest": "tests/dearest_test.py lists a build's files",
    "./dev dearest --write": "writes into the tree; tests/dearest_test.py lists a build's files",
    "./dev format": "writes into the sources",
    "cmake --preset release": "./dev test does it before this test",
    "cmake --build build/release -- fieldfab_command unit_volume": "./dev test builds all, before this test",
    "cmake --build build/release -- fieldfab_command": "./dev test builds all, before this test",
    "ctest --test-dir build/release -R Volume": "./dev test runs all, before this test",
    'PYTHONPATH=build/release/python /usr/bin/python3 -m pytest tests/hosts/cam_test.py -k "machine and my_router"':
        "the module of this build has no such machine; the job with the machine's file is run",
    "./dev install-meshlab": "writes into the system, as root",
    "build/release/bin/simulation_figures": "takes minutes",
    "build/release/bin/volume_figures FOLDER large": "takes minutes and gigabytes",
    "haproxy -f fabserver.cfg": "runs until it is stopped; hosts/web_balancer_test.py does it",
    "ffmpeg -i FOLDER/frame_%04d.png film.mp4": "ffmpeg is none of Fieldfab's packages",
}

# Commands that open a window, with a pattern of its title.
WINDOWS = {r"\./dev freecad\b": "^FreeCAD", r"\./dev meshlab\b": "^MeshLab", r"\S*fieldfab edit\b": "Fieldfab$"}

SERVES = r"\S*fieldfab serve\b(?!.*--help)"  # runs until it is stopped

# Replacements of words in capitals.
PLACEHOLDERS = {
    "VERB": ["build", "mesh", "render", "check", "info", "convert", "edit", "cam", "simulate", "openscad", "serve"],
    "JOB.toml": ["examples/cam/pcb_modela.toml"],
    "PROGRAM": ["part.ngc"],
    "SETUP.toml": ["part.toml"],
    "MODEL": ["part.frep"],
}

JOB = """machine = "linuxcnc"
input.model = "part.frep"
stock.margin = 5
tool = [{ number = 1, diameter = 3, flute = 12, length = 30 }]
operation = [{ type = "profile", tool = 1 }]
"""


def copy_of(source):
    return lambda path: shutil.copy(ROOT / source, path)


def text(words):
    return lambda path: path.write_text(words)


def scan(path):
    """Writes a scan of a ball of 9 mm, with 12 bits and a blurred surface (the scans of tests/data have 8 bits)."""
    z, y, x = np.mgrid[-12:12.1:0.5, -12:12.1:0.5, -12:12.1:0.5]
    densities = np.round(1000 / (1 + np.exp((np.sqrt(x**2 + y**2 + z**2) - 9) / 0.3))).astype("<i2")
    head = ("NRRD0004\ntype: short\ndimension: 3\nsizes: 49 49 49\nspacings: 0.5 0.5 0.5\nendian: little\n"
            "encoding: raw\n\n")
    path.write_bytes(head.encode() + densities.tobytes())


def mesh(path):
    ff.mesh(ff.parse("sphere(10) | move(box(8, 8, 8), 9)"), voxel=0.5).save(path)


def program(path):
    give("part.toml", path.parent)
    subprocess.run([COMMAND, "cam", "part.toml", "-o", path], cwd=path.parent, check=True)


def job(path):
    give("part.frep", path.parent)
    path.write_text(JOB)


# Makers of files that a command names and no earlier command has written.
GIVEN = {
    "part.scad": copy_of("tests/data/openscad/knurl.scad"),
    "knob.scad": text(
        "use <fieldfab.scad>\nsmooth_union(r = 2, voxel = 1) { cylinder(h = 4, r = 16); cylinder(h = 18, r = 9); }\n"),
    "bracket.frep": text("move(box(30, 30, 8), dz = -5)\n"),
    "part.frep": text("box(20, 12, 4)\n"),
    "part.toml": job,
    "part.ngc": program,
    "scan.nrrd": scan,
    "part.ply": mesh,
}


def give(name, folder):
    if not (folder / name).exists():
        GIVEN[name](folder / name)


def given_in(words):
    return [name for name in GIVEN if re.search(rf"(?<![\w./-]){re.escape(name)}\b", words)]


# Folders and processes of a document's commands


@pytest.fixture(scope="module")
def folders(tmp_path_factory):
    """Returns for each document a folder like the source tree, which commands may write into. The document's commands
    run there in their order."""
    made = {}

    def folder_of(document):
        if document not in made:
            made[document] = folder = tmp_path_factory.mktemp("tree")
            for each in ROOT.iterdir():
                if each.name not in ("build", "out", "cam", "examples", "dev", ".git"):
                    (folder / each.name).symlink_to(each)
            shutil.copy(ROOT / "dev", folder / "dev")  # it works in its own folder
            shutil.copytree(ROOT / "examples", folder / "examples", ignore=shutil.ignore_patterns("fieldfab-cache"))
            shutil.copytree(ROOT / "cam", folder / "cam")
            (folder / "build").mkdir()
            (folder / "build" / "release").symlink_to(BUILD)
            (folder / "home" / "bin").mkdir(parents=True)
            (folder / "home" / "bin" / "cmake").write_text("#!/bin/sh\n")  # ./dev builds first; the build exists
            (folder / "home" / "bin" / "cmake").chmod(0o755)
            (folder / "home" / "bin" / "python3").symlink_to("/usr/bin/python3")  # another one may precede it in PATH
        return made[document]

    return folder_of


def environment(folder, **more):
    kept = {k: v for k, v in os.environ.items() if not k.startswith(("XDG_", "PYTHON", "QT", "DISPLAY", "WAYLAND"))}
    cache = os.environ.get("XDG_CACHE_HOME", os.path.expanduser("~/.cache"))
    return {"FIELDFAB_CACHE": f"{cache}/fieldfab", **kept, "HOME": str(folder / "home"),
            "XDG_RUNTIME_DIR": str(folder / "home"), "LIBGL_ALWAYS_SOFTWARE": "1",
            # A folder of its own: pytest removes old ones at its end, which takes minutes where runs were killed.
            "FIELDFAB_BUILD": str(BUILD), "PYTEST_ADDOPTS": "-p no:cacheprovider", "PYTEST_DEBUG_TEMPROOT": str(folder),
            "PATH": os.pathsep.join(map(str, (folder / "home" / "bin", BUILD / "bin", os.environ["PATH"]))), **more}


@contextlib.contextmanager
def started(command, folder, **more):
    """Context manager of a running command and its output file; ends the command and its children."""
    log = folder / "home" / "said"
    log.parent.mkdir(exist_ok=True)
    with open(log, "w") as file:
        process = subprocess.Popen(["bash", "-c", command], cwd=folder, env=environment(folder, **more),
                                   stdin=subprocess.DEVNULL, stdout=file,
                                   stderr=subprocess.STDOUT, start_new_session=True)
    try:
        yield process, log
    finally:
        for asked in (signal.SIGTERM, signal.SIGKILL):  # on SIGTERM the command ends its children itself
            with contextlib.suppress(ProcessLookupError, subprocess.TimeoutExpired):
                os.killpg(process.pid, asked)
                process.wait(5)


def run(command, folder, **more):
    """Runs a command. Returns its output; asserts success and the existence of its output files."""
    for name in given_in(command):
        give(name, folder)
    outputs = [folder / name for name in re.findall(r" (?:-o|--picture|--sheet|--report|--histogram) (\S+)", command)]
    for path in outputs:
        path.unlink(missing_ok=True)
    with started(command, folder, **more) as (process, log):
        try:
            code = process.wait(SECONDS)
        except subprocess.TimeoutExpired:
            code = "no end"
        said = log.read_text(errors="replace")
    assert code == 0, f"{command}: {code}\n{said[-3000:]}"
    assert [path.name for path in outputs if not path.exists()] == [], said
    return said


def forms(command):
    """Returns a command with and without its bracketed parts, and with all replacements of its capitals."""
    found = ([command] if "[-" not in command else [re.sub(r" \[-[^]]*\]", "", command),
                                                    re.sub(r"\[(-[^]]*)\]", r"\1", command)])
    for name, values in PLACEHOLDERS.items():
        if name in command.split() or f"[-{name}" in command or f" {name}]" in command:
            found = [re.sub(rf"(?<= ){re.escape(name)}(?= |$)", value, each) for each in found for value in values]
    return list(dict.fromkeys(found))


def opens_a_window(command):
    return next((title for pattern, title in WINDOWS.items() if re.match(pattern, command)), None)


COMMANDS = [each for document in DOCUMENTS for each in document.commands]
FIRST = {each.command: each for each in COMMANDS[::-1]}
# Commands that only read the source tree, or open a window, run once for all documents.
TO_RUN = [each for each in COMMANDS if each.command not in NOT_RUN
          and (FIRST[each.command] is each
               or not (opens_a_window(each.command) or re.match(r"fieldfab \w+ examples/", each.command)))]
BLOCKS = [block for document in DOCUMENTS for block in document.blocks]
SPANS = [span for document in DOCUMENTS for span in document.spans]


def each_of(places):
    return pytest.mark.parametrize("place", places, ids=lambda place: place.name)


@each_of([each for each in TO_RUN if not opens_a_window(each.command) and not re.match(SERVES, each.command)
          # README's others run in their order, where an OpenSCAD that is not there skips one without a word.
          and (each.document != "README.md" or each.command.startswith("./dev ") or ".scad" in each.text)])
def test_command(place, folders):
    folder = folders(place.document)
    if ".scad" in place.text:
        need("openscad")
    if place.session:
        (folder / "session").write_text(place.session)
        for name in given_in(place.session):
            give(name, folder)
        run(f"{place.command} -m doctest session", folder)
        return
    for command in forms(place.text):
        run(command, folder)


def window_on(screen, title):
    """Returns the width of the largest window with that title, or 0."""
    search = ["xdotool", "search", "--onlyvisible", "--name", title, "getwindowgeometry", "--shell", "%@"]
    said = subprocess.run(search, env={**os.environ, "DISPLAY": screen}, capture_output=True, text=True).stdout
    return max(map(int, re.findall(r"WIDTH=(\d+)", said)), default=0)


@each_of([each for each in TO_RUN if opens_a_window(each.command)])
def test_command_opens_its_window(place, folders, screen):
    folder, end = folders(place.document), time.monotonic() + SECONDS
    [command] = forms(place.text)
    for name in given_in(command):
        give(name, folder)
    with started(command, folder, DISPLAY=screen) as (process, log):
        while window_on(screen, opens_a_window(command)) < 500:  # splash screens and messages are smaller
            assert process.poll() is None and time.monotonic() < end, log.read_text(errors="replace")[-3000:]
            time.sleep(0.2)
        time.sleep(2)
        assert process.poll() is None, log.read_text(errors="replace")[-3000:]
        if SHOTS:
            time.sleep(3)
            shot = os.path.join(SHOTS, f"{place.name.replace('/', '_').replace(':', '_')}.png")
            subprocess.run(["import", "-window", "root", shot], env={**os.environ, "DISPLAY": screen}, check=True)
        assert "Traceback" not in log.read_text(errors="replace")


@each_of([each for each in TO_RUN if re.match(SERVES, each.command)])
def test_command_serves(place, folders):
    """It prints its address and opens it in the browser (here: true)."""
    for command in forms(place.text):
        with started(command, folders(place.document), BROWSER="true") as (process, log):
            end = time.monotonic() + SECONDS
            while "fabserver: http://" not in log.read_text():
                assert process.poll() is None and time.monotonic() < end, log.read_text()
                time.sleep(0.1)


# What ./dev demo builds (build_demo there).
DEMO = ["bin/fieldfab", "lib", "python", "web"]


def test_readme_in_its_order_after_the_demo(folders, screen, tmp_path):
    """README's commands run in the order in which they stand where no more is built than by `./dev demo`."""
    folder = tmp_path / "tree"
    shutil.copytree(folders("README.md"), folder, symlinks=True, ignore=shutil.ignore_patterns("build", "out", "home"))
    build = folder / "build" / "release"
    for name in DEMO:
        (build / name).parent.mkdir(parents=True, exist_ok=True)
        subprocess.run(["cp", "-a", BUILD / name, build / name], check=True)
    (folder / "home" / "bin").mkdir(parents=True)
    (folder / "home" / "bin" / "python3").symlink_to("/usr/bin/python3")
    more = {"FIELDFAB_BUILD": str(build), "DISPLAY": screen, "BROWSER": "true",
            "PATH": os.pathsep.join(map(str, (folder / "home" / "bin", build / "bin", os.environ["PATH"])))}
    done = []
    [readme] = [document for document in DOCUMENTS if document.name == "README.md"]
    for place in readme.commands:
        if place.command in NOT_RUN or place.command.startswith("./dev "):
            continue
        if ".scad" in place.text and lacks("openscad"):
            continue
        if place.session:
            (folder / "session").write_text(place.session)
            for name in given_in(place.session):
                give(name, folder)
            run(f"{place.command} -m doctest session", folder, **more)
        elif opens_a_window(place.command) or re.match(SERVES, place.command):
            with started(place.command, folder, **more) as (process, log):
                end = time.monotonic() + SECONDS
                while not (window_on(screen, opens_a_window(place.command)) if opens_a_window(place.command)
                           else "fabserver: http://" in log.read_text()):
                    assert process.poll() is None and time.monotonic() < end, f"{place.command}: {log.read_text()}"
                    time.sleep(0.1)
        else:
            run(place.command, folder, **more)
        done.append(place.command.split()[1])
    assert {"serve", "edit", "mesh", "cam", "simulate"} <= set(done) and len(done) > 10


PROBE = """
import FreeCADGui
try:
    from PySide2 import QtCore
except ImportError:
    from PySide6 import QtCore
def look():
    with open("seen", "w") as file:
        file.write(FreeCADGui.activeWorkbench().name())
    if "StartWorkbench" in FreeCADGui.listWorkbenches():  # its page ends root's FreeCAD where it may not
        FreeCADGui.activateWorkbench("StartWorkbench")
    with open("left", "w") as file:
        file.write(FreeCADGui.activeWorkbench().name())
    QtCore.QTimer.singleShot(3000, FreeCADGui.getMainWindow().close)
QtCore.QTimer.singleShot(1000, look)
"""


def test_dev_freecad_has_the_workbench_chosen(folders, screen):
    """FreeCAD starts, shows its start page, saves its settings and ends. The user's own settings are unchanged."""
    folder = folders("README.md")
    (folder / "probe.py").write_text(PROBE)
    before = own_freecad(folder)
    run("./dev freecad probe.py", folder, DISPLAY=screen)
    assert (folder / "seen").read_text() == "FieldfabWorkbench"
    left = (folder / "left").read_text()
    assert left == "StartWorkbench" or not pathlib.Path("/usr/share/freecad/Mod/Start/StartPage").exists()  # in 1.x
    assert left in (folder / "build" / "freecad" / "FreeCAD" / "user.cfg").read_text()
    assert own_freecad(folder) == before


def own_freecad(folder):
    """Returns the user's settings and add-ons with their times of change."""
    return {path: path.lstat().st_mtime for name in (".config", ".local")
            for path in (folder / "home" / name).rglob("*")}


# Blocks other than commands

LANGUAGES = {"sh", "frep", "toml", "openscad", "xml", "ko"}
# Blocks of other languages, with the test that runs them.
ELSEWHERE = {
    ("docs/web.md", "javascript"): "hosts/web_page_test.py adds a node with this code",
    ("docs/web.md", "haproxy"): "hosts/web_balancer_test.py drives haproxy with it",
    ("docs/install.md", "cmake"): "hosts/sdk_test.py builds with it",
    ("docs/install.md", "cpp"): "hosts/sdk_test.py builds and runs it",
    ("docs/freecad.md", "python"): "freecad/inside_script.py makes a solid of it",
    ("docs/tutorial.md", "set"): "freecad/window_tutorial.py types it",
    ("docs/tutorial.md", "tool"): "freecad/window_tutorial.py types it",
    ("docs/architecture.md", "text"): "a drawing",
    ("docs/asdf-format.md", "text"): "formulas of a file's layout",
}


# Designs of examples/ without their titles, for which a command runs the file.
RUN_AS_FILES = {path.read_text().partition("\n")[2].strip() for path in (ROOT / "examples" / "openscad").glob("*.scad")
                if any(f"examples/openscad/{path.name}" in each.command for each in TO_RUN)}


def of_language(language):
    return each_of([block for block in BLOCKS if block.language == language and block.text not in RUN_AS_FILES])


@of_language("frep")
def test_formula(place):
    assert ff.parse_parts(place.text, ROOT / "examples" / "assembly")  # README opens its files


@of_language("ko")
def test_kokopelli_script(place, tmp_path):
    (tmp_path / "design.ko").write_text(place.text)
    assert koko_script.parts(str(tmp_path / "design.ko"))


@of_language("toml")
def test_job_machine_or_setup(place, tmp_path):
    (tmp_path / "part.frep").write_text("box(1, 0.6, 0.2)\n")  # inches
    tables = set(re.findall(r"^\[+(\w+)", place.text, re.M))
    if "operation" in tables:
        (tmp_path / "job.toml").write_text(place.text)
        run(f"'{COMMAND}' cam job.toml -o job.out", tmp_path)
    elif "stock" in tables:
        give("bracket.frep", tmp_path)
        (tmp_path / "setup.toml").write_text(place.text)
        (tmp_path / "air.ngc").write_text("G21 G90 G54 T1 M6\nM3 S1000\nG1 X0 Y0 Z15 F1000\nM2\n")
        run(f"'{COMMAND}' simulate air.ngc --setup setup.toml -o part.stl", tmp_path)
    else:
        assert "text" in tables or "kinematics" in tables
        (tmp_path / "part.frep").write_text("move(box(20, 12, 4), 30, 30)\n")  # no negative coordinates
        machine = place.text
        if "text" not in tables:  # only the axes of another machine
            head = (ROOT / "cam" / "machine" / "five_axis_head.toml").read_text()
            machine = re.sub(r"^\[kinematics\].*?(?=^\[(?!\[?kinematics))", lambda _: place.text + "\n", head,
                             flags=re.M | re.S)
            assert place.text in machine
        (tmp_path / "mine.toml").write_text(machine)
        (tmp_path / "job.toml").write_text(JOB.replace("linuxcnc", "mine.toml"))
        run(f"'{COMMAND}' cam job.toml -o part.out", tmp_path)


@of_language("openscad")
def test_design(place, tmp_path):
    need("openscad")
    (tmp_path / "design.scad").write_text(place.text)
    for name in given_in(place.text):
        give(name, tmp_path)
    run(f"'{COMMAND}' openscad design.scad -o design.stl", tmp_path)


@of_language("xml")
def test_script_of_meshlab(place, tmp_path, screen):
    (tmp_path / "script.mlx").write_text(place.text)
    run(f"'{BUILD}/meshlab/meshlabserver' -i part.ply -o remeshed.ply -s script.mlx", tmp_path, DISPLAY=screen)


def test_each_block_says_what_it_is():
    assert [(block.name, block.language) for block in BLOCKS
            if block.language not in LANGUAGES and (block.document, block.language) not in ELSEWHERE] == []


def test_the_node_that_is_shown_is_one_of_the_example():
    [shown] = [block.text for block in BLOCKS if block.language == "javascript"]
    nodes = json.loads((ROOT / "web" / "examples" / "circle.json").read_text())["nodes"]
    assert shown in [node["code"].strip() for node in nodes]


# Code in docstrings: Python, or a command.


# Sources outside the package with code in docstrings, and the test that runs it.
SCRIPTS = {
    "freecad_workbench/resources/examples/make.py": "writes the tracked documents, which hosts/freecad opens",
    "freecad_workbench/resources/translations/update.py": "hosts/words_test.py compares what it collects",
    "packaging/cam_examples.py": "writes docs/cam; hosts/cam_test.py carries out the jobs",
    "packaging/lint.py": "lint_test.py plants faults for it; .ci/run runs it on all files",
    "examples/simulation/slotted_ball.py": "hosts/simulate_test.py runs the script, and simulates its program",
    "tests/bench/adaptive_figures.py": "a benchmark, which takes minutes",
    "tests/bench/certainty_figures.py": "a benchmark, which takes minutes",
    "tests/bench/speed_figures.py": "a benchmark, which takes minutes",
    "tests/bench/web_balancer.py": "a benchmark, which takes minutes",
    "tests/bench/web_drag.py": "a benchmark, which takes minutes",
    "tests/bench/web_page.py": "a benchmark of the page in a browser",
    "tests/hosts/openscad_designs.py": "the table of docs/openscad.md, which takes an hour",
    "tests/hosts/web_hostile.py": "hosts/web_test.py runs it for a shorter time",
}


def docstrings_of(path):
    """Yields line and text of each docstring of a source."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)):
            # A module's is not indented: cleaning would take the indent of code from it.
            if words := ast.get_docstring(node, clean=not isinstance(node, ast.Module)):
                yield getattr(node, "lineno", 1), words


def docstrings():
    """Yields module, line and text of each docstring, of the package's sources and of compiled modules."""
    for path in sorted((ROOT / "python" / "fieldfab").glob("*.py")):
        module = "fieldfab" if path.stem == "__init__" else f"fieldfab.{path.stem}"
        yield from ((module, line, words) for line, words in docstrings_of(path))
    for module in ("fieldfab._core", "fieldfab.language", "fieldfab.cam", "fieldfab.stock"):
        for name, each in inspect.getmembers(importlib.import_module(module)):
            members = inspect.getmembers(each) if inspect.isclass(each) else []
            for described in [each, *(member for key, member in members if not key.startswith("__"))]:
                yield f"{module}.{name}", 1, inspect.getdoc(described) or ""


DOCSTRINGS = list(docstrings())
CODE = [(module, line, code) for module, line, words in DOCSTRINGS for code in code_of(words)]


def test_docstrings_are_found():
    assert {"fieldfab._core.Solid", "fieldfab.cam.Job", "fieldfab.pcb"} <= {module for module, _, _ in DOCSTRINGS}
    assert {"fieldfab", "fieldfab.kokopelli", "fieldfab.kokopelli_pcb", "fieldfab.pcb", "fieldfab.bricks",
            "fieldfab.python2"} == {module for module, _, _ in CODE}


@pytest.mark.parametrize("module, code",
                         [pytest.param(module, code, id=f"{module}:{line}") for module, line, code in CODE])
def test_code_of_a_docstring(module, code, folders, tmp_path, monkeypatch):
    if re.match(COMMAND_IN_PROSE, code):
        run(code, folders("docstrings"), PYTHONPATH=str(BUILD / "python"))
        return
    monkeypatch.chdir(tmp_path)
    exec(compile(code, module, "exec"), {})


def test_code_in_docstrings_of_other_sources_is_listed():
    folders = [ROOT / name
               for name in ("examples", "freecad_workbench", "openscad_import", "packaging", "tests", "web")]
    sources = [path for folder in folders for path in folder.rglob("*.py")
               if not {"data", "node_modules", "fieldfab-cache"} & set(path.relative_to(ROOT).parts)]
    with_code = {str(path.relative_to(ROOT)) for path in sources for _, words in docstrings_of(path) if code_of(words)}
    assert len(sources) > 100 and with_code == set(SCRIPTS)


def test_public_headers_show_no_code():
    """The programs of examples/cpp are the examples of C++: hosts/sdk_test.py builds and runs them."""
    headers = [path for folder in ("kernel", "cam", "openscad_import")
               for path in (ROOT / folder / "include").rglob("*.h")]
    code = re.compile(r"^\s*///? {4,}\S|[@\\](code|snippet|verbatim)\b|```", re.M)
    assert len(headers) > 50 and [path.name for path in headers if code.search(path.read_text(encoding="utf-8"))] == []


# README's first screen.


def test_the_first_screen_is_short_and_shows_what_it_is():
    """All words above the second heading count, including code."""
    screen = (ROOT / "README.md").read_text(encoding="utf-8").split("\n## ")[0]
    assert len(screen.split()) <= 150
    assert "It is for people who" in screen and "](docs/figures/" in screen and "```frep" in screen


# The lists above, and other names


def test_lists_name_what_documents_have():
    commands = {each.command for each in COMMANDS}
    assert [command for command in NOT_RUN if command not in commands] == []
    assert [pattern for pattern in WINDOWS if not any(re.match(pattern, command) for command in commands)] == []
    assert [name for name in PLACEHOLDERS if not any(re.search(rf"\b{name}\b", command) for command in commands)] == []
    words = [block.text for block in BLOCKS] + [each for place in TO_RUN
                                                for each in (*forms(place.text), place.session)]
    named = {name for each in words for name in given_in(each)}
    assert [name for name in GIVEN if name not in named] == []
    assert set(ELSEWHERE) <= {(block.document, block.language) for block in BLOCKS}


@pytest.fixture(scope="module")
def options():
    """Returns the options of each verb from its help; the key None has those of all programs."""
    told = (lambda *words, **more: set(
        re.findall(r"--[a-z][\w-]+", subprocess.run(words, capture_output=True, text=True, check=True, **more).stdout)))
    found = {verb: told(COMMAND, verb, "--help") | told(COMMAND, "--help") for verb in PLACEHOLDERS["VERB"]}
    bricks = told("/usr/bin/python3", "-m", "fieldfab.bricks", "--help",
                  env={**os.environ, "PYTHONPATH": str(BUILD / "python")})
    developer = told(ROOT / "dev", "--help") | told("/usr/bin/python3", ROOT / "packaging" / "dearest.py", "--help")
    return {**found, None: set.union(bricks, developer, *found.values())}


def test_options_exist(options):
    missing = []
    for span in SPANS:
        verb = re.match(r"fieldfab (\w+)", span.text)
        known = options.get(verb[1] if verb and verb[1] != "VERB" else None, ())
        missing += [(span.name, option) for option in re.findall(r"(?<!\S)--[a-z][\w-]+", span.text)
                    if option not in known]
    assert missing == []


def test_named_verbs_exist():
    named = {(span.name, found[1]) for span in SPANS if (found := re.fullmatch(NAME_OF_VERB, span.text))}
    assert named and [each for each in named if each[1] not in PLACEHOLDERS["VERB"]] == []


def test_links_lead_somewhere():
    anchor = lambda heading: re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
    headings = {str(document.folder / document.name.split("/")[-1]): {anchor(each) for each in document.headings}
                for document in DOCUMENTS}
    wrong = []
    for document in DOCUMENTS:
        for link in document.links:
            if link.text.startswith("http"):
                continue
            path, _, place = link.text.partition("#")
            target = (document.folder / path).resolve() if path else ROOT / document.name
            if not target.exists() or (place and place not in headings[str(target)]):
                wrong.append((link.name, link.text))
    assert wrong == []


def test_the_tutorial_shows_the_pictures_that_its_walks_take():
    shown = re.findall(r"figures/tutorial/(\w+)\.png", (ROOT / "docs" / "tutorial.md").read_text())
    walks = [ROOT / "tests" / "hosts" / "freecad" / f"window_{name}.py" for name in ("first_part", "tutorial")]
    taken = [name for walk in walks for name in re.findall(r'window\.shot\("(\w+)"\)', walk.read_text())]
    assert sorted(shown) == sorted(taken)
    assert sorted(shown) == sorted(file.stem for file in (ROOT / "docs" / "figures" / "tutorial").iterdir())


def test_files_of_the_tree_exist():
    """Paths may be relative to any folder, such as `frep/tape.cpp`."""
    known = {str(path.relative_to(ROOT)) for top in ROOT.iterdir() if top.name not in ("build", "out", ".git")
             for path in [top, *top.rglob("*")]}
    ends = {path[n:] for path in known for n in range(len(path)) if n == 0 or path[n - 1] == "/"}
    wrong = []
    for document in DOCUMENTS:
        for span in document.spans:
            if re.fullmatch(r"[\w./-]+\.(cpp|h|inl|py)|(tests|docs|examples|cam|kernel|packaging|cli|python)/[\w./-]*",
                            span.text):
                if "NAME" not in span.text and not fnmatch.filter(ends, span.text.rstrip("/").replace("...", "*")):
                    wrong.append((span.name, span.text))
    assert wrong == []
