"""The workbench's translations: complete, up to date with the sources, and equal in the edited and the compiled
files."""

import importlib.util
import string

import pytest
from conftest import ROOT
try:
    from PySide2 import QtCore
except ImportError:
    from PySide6 import QtCore

FOLDER = ROOT / "freecad_workbench" / "resources" / "translations"
FILES = sorted(FOLDER.glob("fieldfab_*.ts"))


@pytest.fixture(scope="module")
def update():
    specification = importlib.util.spec_from_file_location("update", FOLDER / "update.py")
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def placeholders(text):
    """Returns the parts that a translation must keep: names in braces with their formats, file patterns,
    accelerators."""
    names = sorted(f"{name}!{conversion}:{form}" for _, name, form, conversion in string.Formatter().parse(text)
                   if name is not None)
    patterns = sorted(word.strip("();") for word in text.replace(";", " ").split() if "*." in word or "(*" in word)
    return names, patterns, text.count("&"), text.count("\n"), text[:1].isspace(), text[-1:].isspace()


def test_there_is_german():
    assert FOLDER / "fieldfab_de.ts" in FILES


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_every_text_of_the_sources_is_translated_and_no_other(update, path):
    known, wanted = update.translations(path), update.collected()
    assert list(known) == wanted, "run ./dev translations"
    assert [each for each, translation in known.items() if not translation] == []
    assert path.read_text(encoding="utf-8") == update.written(path.stem.split("_", 1)[1], wanted, known)


def test_templates_of_messages_are_listed(update):
    listed = [text for context, text in update.collected() if context == "Kernel: message"]
    assert update.MESSAGES.read_text(encoding="utf-8").splitlines() == listed, "run ./dev translations"
    for text in ("cannot be read: {0}", "{0}: there is nothing left to cut", "'open' has no option '{0}'{1}",
                 "; did you mean '{0}'?", "has '[' without ']'", "has '{{' without '}}'", "sharpening edges",
                 "clockwise", "G76 with Q{0}: the slant is between 0 and 80 degrees", "the smallest cells",
                 "as a math string this expression would be larger than 64 MB, since shared parts are repeated; "
                 "write .vm or .frep"):
        assert text in listed, text


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_what_is_filled_in_is_filled_in_every_translation(update, path):
    different = [(text, translation) for (_, text), translation in update.translations(path).items()
                 if placeholders(text) != placeholders(translation)]
    assert different == []


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_freecad_reads_what_the_translator_wrote(update, path):
    translator = QtCore.QTranslator()
    assert translator.load(str(path.with_suffix(".qm")))
    known = update.translations(path)
    different = {each: read for each in known if (read := translator.translate(*each)) != known[each]}
    assert different == {}, "run ./dev translations"


def test_no_text_is_formatted_before_it_is_translated(update):
    """tr(f"...") would look up the formatted text, which has no translation."""
    wrong = []
    for path in sorted(update.PACKAGE.rglob("*.py")):
        for node in update.ast.walk(update.ast.parse(path.read_text(encoding="utf-8"))):
            if (isinstance(node, update.ast.Call) and getattr(node.func, "id", "") == "tr"
                    and isinstance(node.args[0], (update.ast.JoinedStr, update.ast.BinOp))):
                wrong.append(f"{path.name}:{node.lineno}")
    assert wrong == []
