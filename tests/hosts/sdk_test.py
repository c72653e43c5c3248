"""The libraries after installation: the installed tree is moved, and examples/cpp are built against it."""

import os
import re
import shutil
import subprocess
import urllib.parse
import urllib.request

import pytest

from conftest import BUILD, DATA, ROOT
from documents import DOCUMENTS


def run(*command, **more):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, **more)
    assert done.returncode == 0, f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}"
    return done.stdout


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """Installs into one folder, and moves the result. Returns its path."""
    folder = tmp_path_factory.mktemp("sdk")
    run("cmake", "--install", BUILD, "--prefix", folder / "first")
    (folder / "first").rename(folder / "prefix")
    return folder / "prefix"


@pytest.fixture(scope="module")
def examples(installed):
    source, build = installed.parent / "source", installed.parent / "build"
    shutil.copytree(ROOT / "examples" / "cpp", source)
    run("cmake", "-S", source, "-B", build, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={installed}")
    run("cmake", "--build", build)
    return build


def test_a_formula_becomes_a_mesh(examples, tmp_path):
    said = run(examples / "formula_to_mesh", "sphere(r = 7) & box(10, 10, 10)", tmp_path / "ball.stl")
    triangles = int(said.split()[0])
    assert "10.00 x 10.00 x 10.00 mm" in said and (tmp_path / "ball.stl").stat().st_size == 84 + 50 * triangles


def test_a_scan_becomes_a_distance_field(examples, installed, tmp_path):
    said = run(examples / "scan_to_asdf", DATA / "ct" / "cthead", tmp_path / "head.asdf")
    assert int(said.split()[0]) > 1000
    assert "asdf" in run(installed / "bin" / "fieldfab", "info", tmp_path / "head.asdf")


def test_a_medical_file_is_read_by_the_part_that_is_loaded_for_it(examples, installed, tmp_path):
    """ITK and OpenVDB are used by separate libraries, in the folder of the others."""
    run(installed / "bin" / "fieldfab", "convert", DATA / "ct" / "cthead", "-o", tmp_path / "head.nrrd")
    run(installed / "bin" / "fieldfab", "convert", tmp_path / "head.nrrd", "-o", tmp_path / "head.vdb")
    assert int(run(examples / "scan_to_asdf", tmp_path / "head.nrrd", tmp_path / "head.asdf").split()[0]) > 1000


def test_a_program_is_simulated(examples, tmp_path):
    (tmp_path / "setup.toml").write_text(
        'cell = 0.5\n[stock]\nlower = [0, 0, -5]\nupper = [20, 20, 0]\n[[tool]]\nnumber = 1\nshape = "flat"\n'
        'diameter = 4\nflute = 10\n')
    (tmp_path / "slot.ngc").write_text("G21 G90 T1 M6 S9000 M3\nG0 Z5\nG0 X-5 Y10\nG0 Z-2\nG1 X25 F300\nG0 Z5\nM2\n")
    said = run(examples / "simulate_program", tmp_path / "setup.toml", tmp_path / "slot.ngc", tmp_path / "slot.stl")
    assert 4 * 2 * 20 <= float(said.split()[0]) <= (4 + 0.5) * 2 * 20, "the slot, as wide as the cutter to a cell"
    assert (tmp_path / "slot.stl").exists()


def test_pkg_config_knows_it(installed, tmp_path):
    folder = {**os.environ, "PKG_CONFIG_PATH": str(installed / "lib" / "pkgconfig")}
    options = run("pkg-config", "--cflags", "--libs", "fieldfab", env=folder).split()
    (tmp_path / "box.cpp").write_text(
        '#include "fieldfab/core/geometry.h"\nint main() { return fieldfab::hull({{0, 0, 0}, {1, 1, 1}}, {{2, 2, 2}, '
        '{3, 3, 3}}).size().x() == 3 ? 0 : 1; }\n')
    run("c++", tmp_path / "box.cpp", "-o", tmp_path / "box", *options, f"-Wl,-rpath,{installed / 'lib'}")
    run(tmp_path / "box")


def test_what_programs_link_to_are_the_libraries_alone(examples):
    needed = [line.split("[")[1].rstrip("]") for line in run("readelf", "-d", examples / "formula_to_mesh").splitlines()
              if "(NEEDED)" in line]
    assert "libfieldfab.so.0" in needed
    assert [name
            for name in needed if any(heavy in name for heavy in ("ITK", "openvdb", "OpenMesh", "asmjit", "tbb"))] == []


def test_the_libraries_show_their_own_names_alone(installed):
    for library in ("libfieldfab.so", "libfieldfab_cam.so", "libfieldfab_openscad.so"):
        lines = run("nm", "-D", "--defined-only", installed / "lib" / library).splitlines()
        shown = [line.split()[-1] for line in lines]
        assert len(shown) > 100 and [name for name in shown if "fieldfab" not in name] == []


def test_a_command_that_needs_neither_loads_neither_itk_nor_openvdb(installed):
    loaded = run("ldd", installed / "bin" / "fieldfab")
    assert "libfieldfab.so.0" in loaded and "ITK" not in loaded and "openvdb" not in loaded


def test_a_part_that_is_missing_is_named(installed, tmp_path):
    prefix = tmp_path / "prefix"
    shutil.copytree(installed, prefix, symlinks=True)
    part = next(prefix.glob("lib/fieldfab-*/openvdb.so"))
    part.unlink()
    done = subprocess.run([prefix / "bin" / "fieldfab", "check", ROOT / "examples" / "pawn.frep"], capture_output=True,
                          text=True)
    assert done.returncode == 2 and f"{part}: cannot open shared object file" in done.stderr
    run(prefix / "bin" / "fieldfab", "info", ROOT / "examples" / "pawn.frep")


def test_the_project_that_the_document_shows(installed, tmp_path):
    blocks = {block.language: block.text for document in DOCUMENTS if document.name == "docs/install.md"
              for block in document.blocks}
    (tmp_path / "CMakeLists.txt").write_text(blocks["cmake"])
    (tmp_path / "ball.cpp").write_text(blocks["cpp"])
    run("cmake", "-S", ".", "-B", "build", f"-DCMAKE_PREFIX_PATH={installed}", cwd=tmp_path)
    run("cmake", "--build", "build", cwd=tmp_path)
    run(tmp_path / "build" / "ball", cwd=tmp_path)
    assert (tmp_path / "ball.stl").stat().st_size > 1000


def without_this_build():
    return {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}


def test_python_finds_what_it_needs_beside_itself(installed):
    folder = installed / "lib" / "python3" / "dist-packages"
    assert run("/usr/bin/python3", "-m", "fieldfab", "--version",
               env={**without_this_build(), "PYTHONPATH": str(folder)}) == run(
                   installed / "bin" / "fieldfab", "--version")
    said = run("/usr/bin/python3", "-c",
               "import fieldfab as ff; print(ff.__file__, ff.check(ff.shapes.sphere(5)).passed)",
               env={**without_this_build(), "PYTHONPATH": str(folder)})
    assert said == f"{folder / 'fieldfab' / '__init__.py'} True\n"


def test_the_command_runs_scripts_with_the_module_that_is_installed_with_it(installed, tmp_path):
    (tmp_path / "ball.py").write_text("import fieldfab as ff\nassert ff.__file__.startswith({!r})\n"
                                      "shape = ff.shapes.sphere(5)\n".format(str(installed)))
    run(installed / "bin" / "fieldfab", "info", tmp_path / "ball.py", env=without_this_build())


def test_a_browser_gets_the_page_of_the_installed_server(installed, tmp_path):
    assert_serves(installed / "bin" / "fieldfab", tmp_path)


def assert_serves(command, folder):
    server = subprocess.Popen([command, "serve", "--no-browser", "--port", "0", folder], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, env=without_this_build())
    try:
        said = server.stdout.readline()
        address = re.search(r"http://\S+", said)
        assert address, said
        page = urllib.request.urlopen(address[0]).read().decode()
        script = re.search(r'<script [^>]*src="([^"]+)"', page)[1]
        assert urllib.request.urlopen(urllib.parse.urljoin(address[0], script)).status == 200
    finally:
        server.terminate()
        server.wait(30)


def test_pip_installs_the_source_tree(tmp_path):
    """The commands of docs/install.md, in a copy of the files that git knows."""
    source = tmp_path / "source"
    names = [name for name in run("git", "-C", ROOT, "ls-files", "-z", "--cached", "--others",
                                  "--exclude-standard").split("\0") if name and (ROOT / name).exists()]
    for name in names:
        (source / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, source / name)
    commands = next(block.text for document in DOCUMENTS if document.name == "docs/install.md"
                    for block in document.blocks if "pip install" in block.text)
    for command in commands.splitlines():
        run(*command.split(), cwd=source, env=without_this_build())
    assert (source / "bracket.stl").stat().st_size > 1000
    written = {path.name for path in source.iterdir()} - {name.split("/")[0] for name in names}
    assert written == {"build", "env", "bracket.stl"}
    program = source / "env" / "bin" / "fieldfab"
    (tmp_path / "ball.py").write_text("import fieldfab as ff\nassert ff.__file__.startswith({!r}), ff.__file__\n"
                                      "shape = ff.shapes.sphere(5)\n".format(str(source / "env")))
    run(program, "info", tmp_path / "ball.py", env=without_this_build())
    run(program, "check", ROOT / "examples" / "pawn.frep", env=without_this_build())  # by the part with OpenVDB
    assert run(source / "env" / "bin" / "python", "-m", "fieldfab", "--version",
               env=without_this_build()) == run(program, "--version", env=without_this_build())
    assert_serves(program, tmp_path)


def test_the_workbench_and_the_plugins_are_where_their_hosts_look(installed):
    workbench = installed / "share" / "freecad" / "Mod" / "Fieldfab"
    assert {"Init.py", "InitGui.py", "package.xml", "icons", "resources",
            "fieldfab_workbench"} <= {path.name for path in workbench.iterdir()}
    assert not list(workbench.rglob("*.pyc"))
    assert {path.name for path in (installed / "lib" / "meshlab" / "plugins").iterdir()} == {
        "libfieldfab_files.so", "libfieldfab_filters.so"}


def test_the_completion_and_the_manual_follow_the_command(installed, tmp_path):
    run("/usr/bin/python3", ROOT / "packaging" / "make_man.py", installed / "bin" / "fieldfab", tmp_path / "fieldfab.1")
    assert subprocess.run(["man", "--warnings", "-l", tmp_path / "fieldfab.1"], capture_output=True, text=True,
                          env={**os.environ, "MANPAGER": "cat"}).stderr == ""
    assert ".SS simulate" in (tmp_path / "fieldfab.1").read_text()
    completion = installed / "share" / "bash-completion" / "completions" / "fieldfab"
    asked = (f'source {completion}; COMP_WORDS=(fieldfab "$@"); COMP_CWORD=$#; '
             f'_fieldfab {installed / "bin" / "fieldfab"}; echo "${{COMPREPLY[*]}}"')
    assert run("bash", "-c", asked, "bash", "sim").strip() == "simulate"
    assert "--voxel" in run("bash", "-c", asked, "bash", "mesh", "--v").split()


def test_thumbnails(installed, tmp_path):
    """A desktop may choose any extension for a thumbnail."""
    run(installed / "libexec" / "fieldfab" / "thumbnailer", ROOT / "examples" / "pawn.frep", tmp_path / "thumbnail.XYZ",
        "128",
        env={**os.environ, "PATH": f"{installed / 'bin'}:{os.environ['PATH']}"})
    assert (tmp_path / "thumbnail.XYZ").read_bytes().startswith(b"\x89PNG")
