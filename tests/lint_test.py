"""packaging/lint.py finds planted faults, and leaves pytest's fixtures alone."""

import pathlib

import lint
import pytest

ROOT = pathlib.Path(__file__).resolve().parent.parent


@pytest.fixture
def found(tmp_path, monkeypatch):
    """Returns a function that writes files of a temporary tree, {name: text}, and returns pyflakes' findings."""
    monkeypatch.setattr(lint, "ROOT", tmp_path)

    def faults(files):
        for name, text in files.items():
            (tmp_path / name).write_text(text)
        return lint.python_faults(files)

    return faults


def test_faults_are_found(found):
    assert found({"a.py": "import os\nprint(missing)\n"}) == ["a.py:1:1: 'os' imported but unused",
                                                              "a.py:2:7: undefined name 'missing'"]
    assert [each.split(":")[:2] for each in found({"b.py": "a = 1\nb = (\n"})] == [["b.py", "2"]]


def test_fixtures_are_in_use(found):
    screens = ("import pytest\n\n\n@pytest.fixture(scope='module')\ndef screen():\n    return 1\n\n\n"
               "def other():\n    pass\n")
    assert found({"screens.py": screens, "passed_on.py": "from screens import screen\n",
                  "a_test.py": "from passed_on import screen\n\n\ndef test_a(screen):\n    assert screen\n"}) == []
    assert found({"b_test.py": "from screens import other, screen\n\n\ndef test_b(screen, other):\n    pass\n"}) == [
        "b_test.py:1:1: 'screens.other' imported but unused",
        "b_test.py:4:20: redefinition of unused 'other' from line 1"]


def test_a_package_offers_what_it_imports(found):
    assert found({"__init__.py": "from os import *\nfrom re import escape\n"}) == []


def test_a_missing_npm_is_told(monkeypatch):
    monkeypatch.setattr(lint.build_page.shutil, "which", lambda name: None)
    monkeypatch.setattr(lint, "WORK", pathlib.Path("/nonexistent"))
    with pytest.raises(lint.build_page.Missing, match="no npm"):
        list(lint.findings([f"{lint.PAGE}main.ts"]))
