"""Finds faults in the Python sources and in the page's TypeScript without running them. `./dev lint` runs it.

    lint.py [--without-page] [FILE...]

- pyflakes: unused imports and variables, undefined names.
- mypy: types. pyproject.toml has its settings, with reasons.
- tsc and eslint, from npm: the page. web/client/tsconfig.json and web/lint/eslint.config.mjs have the settings.

Checks the tracked files, or only the named ones. Prints one line per finding, FILE:LINE:COLUMN: WHAT, and exits with 1
if there is one, or if npm's packages for the page are missing. --without-page: leaves out the page.
"""

import argparse
import ast
import functools
import json
import pathlib
import re
import shutil
import subprocess
import sys

from pyflakes import checker, messages

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "web"))

import build_page

PAGE = "web/client/src/"
WORK = ROOT / "build" / "lint_page"  # eslint with its settings; below it, the page with its packages
MYPY = ["/usr/bin/mypy", "--no-error-summary", "--show-column-numbers", "--hide-error-context"]


def tracked(*patterns):
    """Returns the tracked files that match, relative to the root."""
    listed = subprocess.run(["git", "ls-files", "--", *patterns], cwd=ROOT, capture_output=True, text=True, check=True)
    return [name for name in listed.stdout.splitlines() if (ROOT / name).exists()]


# pyflakes


@functools.cache
def tree_of(path):
    return ast.parse(path.read_bytes(), str(path))


def is_fixture(decorator):
    """Whether a decorator is pytest.fixture, with or without arguments."""
    function = decorator.func if isinstance(decorator, ast.Call) else decorator
    return ast.unparse(function) in ("pytest.fixture", "fixture")


@functools.cache
def fixtures(path):
    """Returns the names of pytest's fixtures that a file defines, or imports from files beside it. pytest passes them
    to functions that have a parameter of the name, so that imports of them are in use."""
    found = {node.name for node in tree_of(path).body
             if isinstance(node, ast.FunctionDef) and any(map(is_fixture, node.decorator_list))}
    for node in tree_of(path).body:
        if isinstance(node, ast.ImportFrom) and node.module and not node.level:
            beside = path.parent / f"{node.module}.py"
            if beside.exists():
                found |= {each.name for each in node.names} & fixtures(beside)
    return found


def is_intended(message, path):
    """Whether a message of pyflakes concerns a fixture, or a name that a package's __init__.py offers to users."""
    if isinstance(message, messages.RedefinedWhileUnused):
        return message.message_args[0] in fixtures(path)
    if isinstance(message, messages.UnusedImport):
        return path.name == "__init__.py" or message.message_args[0].rpartition(".")[2] in fixtures(path)
    return isinstance(message, messages.ImportStarUsed) and path.name == "__init__.py"


def python_faults(names):
    found = []
    for name in names:
        try:
            said = checker.Checker(tree_of(ROOT / name), name).messages
        except SyntaxError as error:
            found.append(f"{name}:{error.lineno}:{error.offset}: {error.msg}")
            continue
        found += [f"{name}:{each.lineno}:{each.col + 1}: {each.message % each.message_args}"
                  for each in sorted(said, key=lambda each: each.lineno) if not is_intended(each, ROOT / name)]
    return found


# mypy


def type_faults(names):
    if not names:
        return []
    said = subprocess.run([*MYPY, *names], cwd=ROOT, capture_output=True, text=True)
    if said.returncode not in (0, 1):  # 1: there are findings
        raise RuntimeError(f"mypy: {(said.stdout + said.stderr).strip()}")
    return said.stdout.splitlines()


# The page


def prepare_page():
    """Installs npm's packages, and puts copies of the sources beside them. Raises build_page.Missing."""
    client, rules = ROOT / "web" / "client", ROOT / "web" / "lint"
    build_page.install(rules, WORK)
    build_page.install(client, WORK / "client")
    shutil.copy(rules / "eslint.config.mjs", WORK)
    shutil.copy(client / "tsconfig.json", WORK / "client")
    shutil.rmtree(WORK / "client" / "src", ignore_errors=True)
    shutil.copytree(client / "src", WORK / "client" / "src")


def page_types():
    """Returns the findings of tsc."""
    tsc = WORK / "client" / "node_modules" / ".bin" / "tsc"
    said = build_page.run([str(tsc), "--noEmit", "--pretty", "false", "-p", "."], WORK / "client")
    found = [re.sub(r"^(src/[^(]*)\((\d+),(\d+)\)", r"web/client/\1:\2:\3", line) for line in said.stdout.splitlines()]
    if said.returncode != 0 and not found:
        raise RuntimeError(f"tsc: {said.stderr.strip()}")
    return found


def page_faults(names):
    """Returns the findings of eslint."""
    eslint = WORK / "node_modules" / ".bin" / "eslint"
    said = build_page.run([str(eslint), "--format=json", *(name.removeprefix("web/") for name in names)], WORK)
    if said.returncode not in (0, 1):  # 1: there are findings
        raise RuntimeError(f"eslint: {(said.stdout + said.stderr).strip()}")
    return [f"web/{pathlib.Path(file['filePath']).relative_to(WORK)}:{each.get('line', 0)}:{each.get('column', 0)}: "
            f"{each['message']} [{each['ruleId']}]" for file in json.loads(said.stdout) for each in file["messages"]]


def is_page(name):
    return name.startswith(PAGE) and name.endswith(".ts")


def findings(names):
    """Yields the findings in files, a line each. Raises build_page.Missing."""
    python, page = [name for name in names if name.endswith(".py")], [name for name in names if is_page(name)]
    yield from python_faults(python)
    yield from type_faults(python)
    if page:
        prepare_page()
        yield from page_types()
        yield from page_faults(page)


def main():
    options = argparse.ArgumentParser(description="Finds faults in Python sources and in the page.")
    options.add_argument("--without-page", action="store_true", help="leave out the page, which needs npm")
    options.add_argument("files", nargs="*", type=pathlib.Path, metavar="FILE", help="check only these")
    given = options.parse_args()
    names = [str(each.resolve().relative_to(ROOT)) for each in given.files] or tracked("*.py", f"{PAGE}*.ts")
    checked = [name for name in names if name.endswith(".py") or is_page(name) and not given.without_page]
    for name in sorted(set(names) - set(checked)) if given.files else []:
        print(f"{name} is not checked")
    count = 0
    try:
        for count, found in enumerate(findings(checked), 1):
            print(found, flush=True)
    except build_page.Missing as reason:
        sys.exit(f"the page cannot be checked: {reason}; --without-page leaves it out")
    if count:
        sys.exit(1)
    print(f"lint: {len(checked)} files are in order" + (", the page was not checked" if given.without_page else ""))


if __name__ == "__main__":
    main()
