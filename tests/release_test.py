"""Releases: the versions of this tree agree, and each check of packaging/release.py fails where it should.

The checks run in small git repositories. Their packages are real .deb files, which a stand-in for ./dev package copies
to out/packages."""

import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

import pytest
import release as script

ROOT = pathlib.Path(__file__).resolve().parent.parent
VERSION, DATE = "7.8.9", "2026-11-27"
CHANGELOG = f"""# Changelog

## {VERSION} (not released)

### Meshes

- Meshes of plates, as [docs/meshes.md](docs/meshes.md) and [a paper](https://example.org/paper) describe, with
  numbers as `width = 20  # 5 to 40` in *one* line.
- `a * b` is a product, `c * d` too.

### CAM

- A mill.

## 7.8.0, 2026-01-02

- The first one.
"""
TAG = f"""Fieldfab {VERSION}

Released on {DATE}.

Meshes
------

- Meshes of plates, as docs/meshes.md and a paper
  (https://example.org/paper) describe, with numbers as
  `width = 20  # 5 to 40` in one line.
- `a * b` is a product, `c * d` too.

CAM
---

- A mill.
"""
CHECKS = ["tree", "branch", "changelog", "versions", "tag", "tests", "packages"]
ENVIRONMENT = {**{key: value for key, value in os.environ.items() if not key.startswith("GIT_")},
               "GIT_CONFIG_GLOBAL": "/dev/null", "GIT_CONFIG_NOSYSTEM": "1",
               **{f"GIT_{who}_{what}": value for who in ("AUTHOR", "COMMITTER")
                  for what, value in (("NAME", "A maker"), ("EMAIL", "maker@example.org"))}}


def run(*words, folder, code=0):
    done = subprocess.run([str(word) for word in words], cwd=folder, env=ENVIRONMENT, capture_output=True, text=True,
                          stdin=subprocess.DEVNULL)
    assert done.returncode == code, f"{words}: {done.returncode}\n{done.stdout}{done.stderr}"
    assert "Traceback" not in done.stderr
    return done.stdout


def release_py(folder, *options, code=0):
    return run(sys.executable, folder / "packaging" / "release.py", *options, folder=folder, code=code)


def commit(folder):
    run("git", "add", "-A", folder=folder)
    run("git", "commit", "-q", "-m", "A step", folder=folder)


def record(folder, **other):
    """Writes what ./dev test --full writes, or that with other values."""
    (folder / "build").mkdir(exist_ok=True)
    head = run("git", "rev-parse", "HEAD", folder=folder).strip()
    (folder / "build" / "tested.json").write_text(
        json.dumps({"commit": head, "date": DATE, "kind": "full", "passed": True, **other}))


def change(folder, name, old, new):
    text = (folder / name).read_text()
    assert old in text
    (folder / name).write_text(text.replace(old, new, 1))


@pytest.fixture(scope="module")
def debs(tmp_path_factory):
    """Returns a folder with the packages of debian/control, which are empty."""
    folder = tmp_path_factory.mktemp("debs")
    for name in re.findall(r"(?m)^Package: (\S+)", (ROOT / "debian" / "control").read_text()):
        (folder / name / "DEBIAN").mkdir(parents=True)
        (folder / name / "DEBIAN" / "control").write_text(
            f"Package: {name}\nVersion: {VERSION}\nArchitecture: all\nMaintainer: A <a@example.org>\n"
            "Description: a test\n")
        run("dpkg-deb", "--build", "--root-owner-group", name, f"{name}.deb", folder=folder)
        shutil.rmtree(folder / name)
    return folder


@pytest.fixture(scope="module")
def prepared(tmp_path_factory):
    """Returns a repository whose files come from this tree, with another CHANGELOG.md, ready for a release."""
    folder = tmp_path_factory.mktemp("prepared") / "tree"
    places = [script.SOURCE, *script.COPIES, *script.COPIES_WITHOUT_PATCH]
    for name in {name for name, _ in places} | {"packaging/release.py", "debian/control", ".gitignore"}:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, folder / name)
    (folder / "CHANGELOG.md").write_text(CHANGELOG)
    run("git", "init", "-q", "-b", "main", folder=folder)
    release_py(folder, "--set", VERSION, "--date", DATE)
    commit(folder)
    record(folder)
    return folder


@pytest.fixture
def tree(prepared, tmp_path):
    return shutil.copytree(prepared, tmp_path / "tree")


@pytest.fixture
def package_command(debs):
    """Returns a function that makes the stand-in for ./dev package, with shell commands after its own."""
    return lambda more="true": "sh -c " + shlex.quote(
        f"mkdir -p out/packages && cp {shlex.quote(str(debs))}/*.deb out/packages && {more}")


def results(said):
    """Returns the result of each check by its name."""
    return {found[2]: found[1] for found in re.finditer(r"(?m)^(ok|missing|not checked) (\w+): ", said)}


# This tree


def test_versions_of_the_tree_agree():
    assert script.disagreements() == []


def test_the_changelog_has_the_form_of_contributing():
    newest = script.sections((ROOT / "CHANGELOG.md").read_text())[0]
    assert newest["version"] == script.version()
    kinds = [kind for kind, _ in script.entries(newest["lines"])]
    assert kinds[:1] in ([], ["heading"]) and ("heading", "heading") not in set(zip(kinds, kinds[1:]))


def test_setup_py_reads_the_version_of_cmake():
    pattern = re.search(r'(?m)^VERSION = re\.search\(r"(.*?)",', (ROOT / "setup.py").read_text())[1]
    assert re.search(pattern, (ROOT / "CMakeLists.txt").read_text())[1] == script.version()


# The checks


def test_a_whole_release_gets_its_text_and_git_makes_the_tag_of_it(tree, package_command):
    said = release_py(tree, "--package-command", package_command())
    assert results(said) == dict.fromkeys(CHECKS, "ok")
    assert list(results(said)) == CHECKS
    assert (tree / "out" / "release" / "tag.txt").read_text() == TAG
    command = said.splitlines()[-1]
    assert command == f"git tag -a v{VERSION} -F out/release/tag.txt"
    assert run("git", "tag", folder=tree) == ""  # it tags nothing itself
    run(*command.split(), folder=tree)
    assert run("git", "tag", "--list", "--format=%(contents)", f"v{VERSION}", folder=tree).rstrip("\n") + "\n" == TAG


def untracked(tree):
    (tree / "note.txt").write_text("a note\n")


def other_branch(tree):
    run("git", "switch", "-q", "-c", "other", folder=tree)


def detached(tree):
    run("git", "switch", "-q", "--detach", folder=tree)


def tagged(tree):
    run("git", "tag", f"v{VERSION}", folder=tree)


def committed(*replacement):
    def made(tree):
        change(tree, *replacement)
        commit(tree)
        record(tree)
    return made


def without_record(tree):
    (tree / "build" / "tested.json").unlink()


def with_record(words):
    return lambda tree: (tree / "build" / "tested.json").write_text(words)


def recorded(**other):
    return lambda tree: record(tree, **other)


def another_commit(tree):
    (tree / "note.txt").write_text("a note\n")
    commit(tree)


SECTION = f"## {VERSION}, {DATE}"


@pytest.mark.parametrize("step, check, words", [
    (untracked, "tree", "not in the commit: note.txt"),
    (lambda tree: change(tree, "CHANGELOG.md", "A mill", "Two mills"), "tree", "CHANGELOG.md"),
    (other_branch, "branch", "the branch is other, not main"),
    (detached, "branch", "the branch is none, not main"),
    (committed("CHANGELOG.md", SECTION, f"## {VERSION} (not released)"), "changelog", "has no date"),
    (committed("CHANGELOG.md", SECTION, f"{SECTION}\n\n## 7.8.8, 2026-02-03"), "changelog", "has no entry"),
    (committed("docs/install.md", "find_package(Fieldfab 7.8 ", "find_package(Fieldfab 7.7 "), "versions",
     "docs/install.md has 7.7, not 7.8"),
    (committed("debian/changelog", f"({VERSION})", "(7.8.8)"), "versions", "debian/changelog has 7.8.8, not 7.8.9"),
    (committed("freecad_workbench/package.xml", f"<version>{VERSION}<", "<version>7.8.8<"), "versions", "package.xml"),
    (committed("freecad_workbench/package.xml", f"<date>{DATE}<", "<date>2026-11-26<"), "versions",
     f"freecad_workbench/package.xml is of 2026-11-26, not of {DATE}"),
    (committed("debian/changelog", "27 Nov 2026", "26 Nov 2026"), "versions", "debian/changelog is of 2026-11-26"),
    (tagged, "tag", f"v{VERSION} is there already"),
    (without_record, "tests", "build/tested.json is not there: ./dev test --full writes it"),
    (with_record("{"), "tests", "is no record of tests"),
    (with_record('{"commit": "1"}'), "tests", "is no record of tests"),
    (with_record("[]"), "tests", "is no record of tests"),
    (recorded(passed=False), "tests", f"the last tests (full) of {DATE} at"),
    (recorded(passed="false"), "tests", "failed"),
    (recorded(kind="quick"), "tests", "passed, but were not full"),
    (recorded(commit="0" * 40), "tests", f"of {DATE} at 000000000000 passed, but this commit is"),
    (another_commit, "tests", "passed, but this commit is"),
])
def test_a_check_that_fails_is_named_and_no_text_is_left(tree, package_command, step, check, words):
    (tree / "out" / "release").mkdir(parents=True)
    (tree / "out" / "release" / "tag.txt").write_text("of an earlier run\n")
    step(tree)
    said = release_py(tree, "--package-command", package_command(), code=1)
    assert results(said) == {name: "missing" if name == check else "ok" for name in CHECKS}
    [line] = [each for each in said.splitlines() if each.startswith("missing")]
    assert words in line
    assert not (tree / "out" / "release" / "tag.txt").exists() and "git tag" not in said


def test_a_version_without_a_section_is_missing_everywhere(tree, package_command):
    committed("CMakeLists.txt", f"VERSION {VERSION}", "VERSION 7.9.0")(tree)
    said = release_py(tree, "--package-command", package_command(), code=1)
    assert {name for name, result in results(said).items() if result == "missing"} == {
        "changelog", "versions", "packages"}
    assert "the newest section of CHANGELOG.md is of 7.8.9, not of 7.9.0" in said


@pytest.mark.parametrize("more, words", [
    ("echo 'E: no-manual-page'; exit 2", "ended with 2: E: no-manual-page"),
    ("rm out/packages/fieldfab.deb", "debian/control has fieldfab 7.8.9"),
    ("echo text >out/packages/fieldfab.deb", "fieldfab.deb is no Debian package"),
    ("rm out/packages/*", "made no package"),
    ("echo note >note.txt", "has changed the tree: note.txt"),
    ("git commit -q --allow-empty -m 'A step'", "has changed the tree: another commit"),
])
def test_packages_that_are_not_whole_are_refused(tree, package_command, more, words):
    said = release_py(tree, "--package-command", package_command(more), code=1)
    assert results(said)["packages"] == "missing"
    assert words in said.splitlines()[-1]


def test_packages_of_an_earlier_build_do_not_count(tree, package_command):
    release_py(tree, "--package-command", package_command())
    assert "true made no package" in release_py(tree, "--package-command", "true", code=1)
    assert "missing packages: none-such: No such file" in release_py(tree, "--package-command", "none-such", code=1)


def test_warnings_of_lintian_are_counted(tree, package_command):
    said = release_py(tree, "--package-command", package_command("echo 'W: fieldfab: a-tag'"))
    assert "warnings of lintian: 1" in said


def test_packages_that_are_left_out_are_no_release(tree):
    said = release_py(tree, "--skip-packages", code=1)
    assert results(said) == {**dict.fromkeys(CHECKS, "ok"), "packages": "not checked"}
    assert not (tree / "out" / "release" / "tag.txt").exists()


# The form of CHANGELOG.md


@pytest.mark.parametrize("old, new, words", [
    ("# Changelog\n", "# Changes\n", "CHANGELOG.md:1:"),
    (SECTION, f"## {VERSION}", "CHANGELOG.md:3:"),
    (SECTION, f"## v{VERSION}, {DATE}", "CHANGELOG.md:3:"),
    (SECTION, f"## {VERSION}, 2026-02-30", "2026-02-30 is no date"),
    ("## 7.8.0,", "## 7.10.0,", "7.10.0 is below 7.8.9; the newest is first"),
    ("- A mill.", "A mill.", "CHANGELOG.md:13: this is no heading, entry or continuation"),
    ("- A mill.", "  A mill.", "CHANGELOG.md:13: this is no heading, entry or continuation"),
])
def test_another_form_is_refused_with_its_line(tree, old, new, words):
    change(tree, "CHANGELOG.md", old, new)
    [line] = [each for each in release_py(tree, "--skip-packages", code=1).splitlines() if " changelog: " in each]
    assert line.startswith("missing") and words in line


# --set and --date


def texts(tree):
    return {name: (tree / name).read_text()
            for name, _ in [script.SOURCE, *script.COPIES, *script.COPIES_WITHOUT_PATCH]}


def test_a_version_after_a_release_begins_a_section(tree):
    before = texts(tree)
    release_py(tree, "--set", "7.10.0")
    after = texts(tree)
    assert all(after[name] != before[name] for name in before)
    assert after["CHANGELOG.md"] == before["CHANGELOG.md"].replace(SECTION, f"## 7.10.0 (not released)\n\n{SECTION}")
    assert after["debian/changelog"].startswith("fieldfab (7.10.0) unstable; urgency=medium\n")
    assert after["debian/changelog"].endswith(before["debian/changelog"])
    assert run("dpkg-parsechangelog", "-S", "Version", folder=tree) == "7.10.0\n"
    assert "find_package(Fieldfab 7.10 REQUIRED)" in after["docs/install.md"]
    assert "ok versions" in release_py(tree, "--skip-packages", code=1)


def test_a_version_before_its_release_is_renamed(tree):
    release_py(tree, "--set", "7.9.0")
    release_py(tree, "--set", "8.0.0")
    after = texts(tree)
    assert re.findall(r"(?m)^## (.*)", after["CHANGELOG.md"]) == [
        "8.0.0 (not released)", f"{VERSION}, {DATE}", "7.8.0, 2026-01-02"]
    assert re.findall(r"(?m)^fieldfab \((.*?)\)", after["debian/changelog"])[:2] == ["8.0.0", VERSION]


def test_the_same_version_and_date_change_no_file(tree):
    assert release_py(tree, "--set", VERSION, "--date", DATE) == ""
    assert run("git", "status", "--porcelain", folder=tree) == ""


@pytest.mark.parametrize("options, code", [
    (["--set", "7.8.8"], 1), (["--set", "7.8"], 2), (["--set", "07.8.10"], 2), (["--set"], 2),
    (["--date", "2026-02-30"], 1), (["--set", "7.8.10", "--date", "soon"], 1),
])
def test_a_wrong_version_or_date_changes_no_file(tree, options, code):
    release_py(tree, *options, code=code)
    assert run("git", "status", "--porcelain", folder=tree) == ""


def test_a_tagged_version_keeps_its_date(tree):
    tagged(tree)
    release_py(tree, "--set", VERSION, code=1)
    release_py(tree, "--date", "2026-11-28", code=1)
    assert run("git", "status", "--porcelain", folder=tree) == ""
