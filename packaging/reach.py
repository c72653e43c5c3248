"""Tells which tests a change can reach.

C++: an object reaches the files that Ninja's dependency log names for it, and the objects whose symbols it uses. A
test program is reached if one of its objects reaches a changed file. Parts that are loaded at run time are found by
the names of their entry points.

Python: a test file reaches what it imports, and the scripts, data and documents that it names; the files that it
reaches do alike.
"""

import ast
import collections
import itertools
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Where `import NAME` is looked for, beside the importing file's own folder.
MODULES = ("tests/hosts", "tests/hosts/freecad", "tests/hosts/edit", "packaging", "python", "web", "freecad_workbench")
# Files that no Python file names, and the test helpers that start what reads them.
STARTED = {"web/client/": "tests/hosts/web_server.py", "web/server/": "tests/hosts/web_server.py",
           "freecad_workbench/Init": "tests/hosts/freecad_host.py", "meshlab_filter/": "tests/hosts/meshlab_host.py"}
OF_BUILD = ("CMakeLists.txt", ".cmake", "CMakePresets.json", ".toml")  # no object names them: they reach all
INSIDE = "tests/hosts/freecad_inside_test.py"  # runs each file of freecad/ that is named inside_*.py or window_*.py


def git(*words):
    return subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()


def changed_files(commit):
    """Returns the files, relative to the tree, that were changed, added or deleted since a commit."""
    return {*git("diff", "--name-only", "--no-renames", commit), *git("ls-files", "--others", "--exclude-standard")}


def closure(start, neighbours):
    """Returns what is reached from `start`; neighbours is a dict from each node to others."""
    found, open_ones = set(start), list(start)
    while open_ones:
        for node in neighbours.get(open_ones.pop(), ()):
            if node not in found:
                found.add(node)
                open_ones.append(node)
    return found


# C++


def files_of_objects(build):
    """Returns {object: files that were read to compile it}, as Ninja's log has them. Objects are relative to the build
    folder, files of the tree to the tree."""
    found, files = {}, set()
    listed = subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True, check=True).stdout
    prefix = f"{ROOT}/"
    for line in listed.splitlines():
        if line.startswith(" "):
            file = line.strip()
            if not file.startswith("/usr/"):
                files.add(str((build / file).resolve()).removeprefix(prefix))
        elif line:
            files = found.setdefault(line.partition(": #deps")[0], set())
    return {name: files for name, files in found.items() if name.endswith(".o") and (build / name).exists()}


def users_of_objects(build, names):
    """Returns {object: objects that use its symbols, or load it by the name of its entry point}."""
    defined, used = collections.defaultdict(set), collections.defaultdict(set)
    listed = subprocess.run(["nm", "-P", "-A", *names], cwd=build, capture_output=True, text=True, check=True).stdout
    for line in listed.splitlines():
        name, symbol, kind = line.split(" ")[:3]
        (used if kind in "Uw" else defined)[symbol].add(name.removesuffix(":"))
    users = collections.defaultdict(set)
    for symbol, definers in defined.items():
        for definer in definers:
            users[definer] |= used.get(symbol, set())
    entries = {symbol.encode(): definers for symbol, definers in defined.items()
               if symbol.startswith("fieldfab_") and symbol not in used}
    for name in names if entries else ():
        text = (build / name).read_bytes()
        for entry, definers in entries.items():
            if entry in text:
                for definer in definers:
                    users[definer].add(name)
    return users


def test_programs(build, changed):
    """Returns the names of the C++ test programs that the changed files can reach. Needs a finished build."""
    files = files_of_objects(build)
    touched = set(files) if any(name.endswith(OF_BUILD) for name in changed) else {
        name for name, read in files.items() if read & changed}
    if not touched:
        return set()
    reached = closure(touched, users_of_objects(build, sorted(files)))
    programs = {re.match(r"tests/CMakeFiles/((?:unit|property|oracle)_[^/]+)\.dir/", name) for name in reached}
    return {found[1] for found in programs if found}


# Python


def module_file(name, importer, known):
    """Returns the file of a dotted module name, relative to the tree, or None for what is not of this tree."""
    path = name.replace(".", "/")
    for folder in (str(pathlib.PurePath(importer).parent), *MODULES):
        for file in (f"{folder}/{path}.py", f"{folder}/{path}/__init__.py"):
            if file in known:
                return file
    return None


def imports_of(file, tree, known):
    """Yields the files of the tree that a Python file imports."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names = [each.name for each in node.names]
        elif isinstance(node, ast.ImportFrom):
            base = node.module or ""
            if node.level:
                package = pathlib.PurePath(file).parents[node.level - 1]
                names = [".".join([*package.parts, *base.split(".")]).strip(".")]
                names += [f"{names[0]}.{each.name}" for each in node.names]
                paths = [name.replace(".", "/") for name in names]
                yield from {f"{path}{end}" for path in paths for end in (".py", "/__init__.py")} & known
                continue
            names = [base, *(f"{base}.{each.name}" for each in node.names)]
        else:
            continue
        for name in names:
            if found := module_file(name, file, known):
                yield found


def texts_of(tree):
    """Yields the string constants of a Python file but its docstrings."""
    docstrings = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in docstrings:
            yield node.value


def files_of_tests(known, read):
    """Returns {file: files that it imports or names} for the Python files among the known ones. A text in a Python file
    names a file by its name, and all files of a folder by the folder's name: of one at the tree's top only if it names
    none of them by its own name. `read` returns a file's text."""
    python = {file for file in known if file.endswith((".py", ".FCMacro"))}
    by_name, by_folder = collections.defaultdict(set), collections.defaultdict(set)
    for file in itertools.filterfalse(is_test, known):  # a test that is named is none that is used
        path = pathlib.PurePath(file)
        by_name[path.name].add(file)
        if file not in python:
            by_folder[path.parent.name].add(file)
    found = {}
    for file in python:
        try:
            tree = ast.parse(read(file))
        except SyntaxError:  # lint tells of it
            tree = ast.Module([], [])
        words = set(re.findall(r"[\w.-]+", " ".join(texts_of(tree))))
        named = set().union(*(by_name[word] for word in words & by_name.keys()))
        for word in words & by_folder.keys():
            named |= {each for each in by_folder[word] if "/" in str(pathlib.PurePath(each).parent)}
            if not named & by_folder[word]:
                named |= by_folder[word]
        found[file] = (named | set(imports_of(file, tree, python))) - {file}
    return found


def is_test(file):
    return file.startswith("tests/") and file.endswith("_test.py")


def is_inside(file):
    return re.fullmatch(r"tests/hosts/freecad/(inside|window)_\w+\.py", file) is not None


def python_tests(changed, known=None, read=None):
    """Returns the Python tests that the changed files can reach, as pytest's arguments: files, and for those that run
    within FreeCAD single tests of freecad_inside_test.py."""
    known = known or set(git("ls-files", "--cached", "--others", "--exclude-standard")) | changed
    read = read or (lambda file: (ROOT / file).read_text(encoding="utf-8") if (ROOT / file).exists() else "")
    users = collections.defaultdict(set)
    for file, reached in files_of_tests(known, read).items():
        for each in reached:
            users[each].add(file)
    for start, helper in STARTED.items():
        for file in changed:
            if file.startswith(start):
                users[file].add(helper)
    reached = closure(changed, users)
    tests = {file for file in reached if is_test(file)}
    if INSIDE not in tests:
        for file in filter(is_inside, reached):
            stem = pathlib.PurePath(file).stem
            where = "without_window" if stem.startswith("inside_") else "in_the_window"
            tests.add(f"{INSIDE}::test_{where}[{stem}]")
    return {test for test in tests if (ROOT / test.partition("::")[0]).exists()}
