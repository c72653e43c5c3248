"""packaging/reach.py: which tests a change can reach, in small trees and in this one."""

import pathlib
import subprocess

import pytest
import reach


@pytest.fixture
def tests_of():
    """Returns a function from a tree, {file: text}, and changed files to the Python tests that they reach."""
    def reached(files, *changed):
        return reach.python_tests(set(changed), set(files), files.get)

    return reached


@pytest.fixture
def tree(monkeypatch, tmp_path):
    """An empty folder in place of the tree, and a function that writes files there."""
    monkeypatch.setattr(reach, "ROOT", tmp_path)

    def write(files):
        for name, text in files.items():
            path = tmp_path / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return files

    return write


def test_imports_are_followed(tree, tests_of):
    files = tree({"python/fieldfab/__init__.py": "from .shapes import ball\n",
                  "python/fieldfab/shapes.py": "from . import words\nball = 1\n",
                  "python/fieldfab/words.py": "", "python/fieldfab/other.py": "",
                  "tests/hosts/helper.py": "import fieldfab\n",
                  "tests/hosts/ball_test.py": "from helper import anything\n",
                  "tests/hosts/box_test.py": "import fieldfab.other as other\n"})
    assert tests_of(files, "python/fieldfab/words.py") == {"tests/hosts/ball_test.py"}
    assert tests_of(files, "python/fieldfab/other.py") == {"tests/hosts/box_test.py"}
    assert tests_of(files, "tests/hosts/ball_test.py") == {"tests/hosts/ball_test.py"}
    assert tests_of(files, "tests/hosts/box_test.py", "python/fieldfab/shapes.py") == {
        "tests/hosts/ball_test.py", "tests/hosts/box_test.py"}


def test_names_in_texts_are_followed(tree, tests_of):
    files = tree({"packaging/demo.py": "", "tests/data/heads/1.tif": "", "docs/limits.md": "", "docs/other.md": "",
                  "tests/hosts/demo_test.py": "run(ROOT / 'packaging' / 'demo.py')\n",
                  "tests/hosts/heads_test.py": "DATA = ROOT / 'data/heads'\n",
                  "tests/hosts/limits_test.py": "read(ROOT / 'docs' / 'limits.md')\n",
                  "tests/hosts/docs_test.py": '"""Reads packaging/demo.py, not really."""\nall(ROOT / "docs")\n'})
    assert tests_of(files, "packaging/demo.py") == {"tests/hosts/demo_test.py"}
    assert tests_of(files, "tests/data/heads/1.tif") == {"tests/hosts/heads_test.py"}
    assert tests_of(files, "docs/limits.md") == {"tests/hosts/docs_test.py", "tests/hosts/limits_test.py"}
    assert tests_of(files, "docs/other.md") == {"tests/hosts/docs_test.py"}


def test_tests_within_freecad_are_reached_one_by_one(tree, tests_of):
    files = tree({"tests/hosts/freecad_host.py": "", "freecad_workbench/InitGui.py": "",
                  "tests/hosts/freecad_inside_test.py": "from freecad_host import home\n",
                  "tests/hosts/freecad/window.py": "", "tests/hosts/freecad/inside_cam.py": "",
                  "tests/hosts/freecad/window_cam.py": "import window\n"})
    inside = "tests/hosts/freecad_inside_test.py"
    assert tests_of(files, "tests/hosts/freecad/window.py") == {f"{inside}::test_in_the_window[window_cam]"}
    assert tests_of(files, "tests/hosts/freecad/inside_cam.py") == {f"{inside}::test_without_window[inside_cam]"}
    assert tests_of(files, "freecad_workbench/InitGui.py", "tests/hosts/freecad/window.py") == {inside}


SOURCES = {
    "a.h": "int a();\n", "a.cpp": '#include "a.h"\nint a() { return 1; }\n',
    "b.h": "int b();\n", "b.cpp": '#include "a.h"\n#include "b.h"\nint b() { return a() + 1; }\n',
    "part.cpp": 'extern "C" int fieldfab_part() { return 7; }\n',
    "load.cpp": 'const char* load() { return "fieldfab_part"; }\n',
    "tests/unit_a.cpp": '#include "../a.h"\nint main() { return a(); }\n',
    "tests/unit_b.cpp": '#include "../b.h"\nint main() { return b(); }\n',
    "tests/unit_load.cpp": "const char* load();\nint main() { return *load(); }\n",
}


def test_objects_are_reached_by_headers_symbols_and_entry_points(tree, tmp_path):
    tree(SOURCES)
    build = tmp_path / "build"
    objects = {name: f"tests/CMakeFiles/{pathlib.Path(name).stem}.dir/x.o" if name.startswith("tests/")
               else f"CMakeFiles/kernel.dir/{name}.o" for name in SOURCES if name.endswith(".cpp")}
    rules = "rule cc\n command = g++ -MD -MF $out.d -c $in -o $out\n depfile = $out.d\n deps = gcc\n"
    build.mkdir()
    (build / "build.ninja").write_text(rules + "".join(f"build {made}: cc {tmp_path / name}\n"
                                                       for name, made in objects.items()))
    subprocess.run(["ninja", "-C", build], check=True, capture_output=True)
    expected = {"a.cpp": {"unit_a", "unit_b"}, "a.h": {"unit_a", "unit_b"}, "b.cpp": {"unit_b"}, "b.h": {"unit_b"},
                "part.cpp": {"unit_load"}, "load.cpp": {"unit_load"}, "tests/unit_a.cpp": {"unit_a"},
                "README.md": set()}
    for name, programs in expected.items():
        assert reach.test_programs(build, {name}) == programs, name
