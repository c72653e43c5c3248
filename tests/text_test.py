"""Spelling, columns, tables and links of sources and documents: the findings of packaging/check_text.py, which ./dev
lint runs, too."""

import pathlib

import check_text
import pytest

ROOT = pathlib.Path(__file__).resolve().parent.parent


def test_the_text_of_the_tree_is_in_order():
    assert check_text.findings() == []


@pytest.fixture
def page(tmp_path, monkeypatch):
    """Returns a function that writes a page of a temporary tree and returns its name."""
    monkeypatch.setattr(check_text, "ROOT", tmp_path)
    (tmp_path / "packaging").mkdir()
    (tmp_path / "packaging" / "spelling.txt").write_text("")

    def made(text, name="page.md"):
        (tmp_path / name).write_text(text)
        return name

    return made


def test_a_misspelled_word_is_found(page):
    word = "rec" + "ieve"  # split, so that this file has no misspelling
    assert word in check_text.spelling([page(f"We {word} it.\n")])[0]


def test_a_wide_line_is_found_but_not_in_tables(page):
    wide = "word " * 30
    for text in (f"{wide}\n", f"{wide}\n\n| {wide} |\n|---|\n", f"{wide}\n\n```sh\nls\n```\n"):
        assert check_text.form_of_document(page(text)) == [f"page.md:1: {len(wide)} columns"]
    assert check_text.form_of_document(page(f"```sh\n{wide}\n```\n")) == [f"page.md:2: {len(wide)} columns"]


def test_a_wide_line_of_a_source_is_found_unless_a_word_leaves_no_room(page):
    wide = "/// " + "word " * 30
    assert check_text.columns_of_source(page(f"int a;\n{wide}\n", "a.h")) == [f"a.h:2: {len(wide)} columns"]
    assert check_text.columns_of_source(page("# https://" + "a" * 110 + "\n", "a.py")) == []
    assert check_text.columns_of_source(page("a" * 60 + " = " + "b" * 60 + "\n", "a.py")) != []


def test_a_row_with_another_number_of_cells_is_found(page):
    assert check_text.form_of_document(page("| a | b |\n|---|---|\n| `a|b` | c |\n")) == [
        "page.md:3: a row has 3 cells, the first one has 2"]
    assert check_text.form_of_document(page("| a | b |\n|---|---|\n| `a\\|b` | c |\n")) == []


def test_an_open_fence_is_found(page):
    assert check_text.form_of_document(page("```sh\nls\n")) == ["page.md:1: a fence of code is not closed"]


def test_links_that_lead_nowhere_are_found(page):
    page("# One heading\n", "other.md")
    text = "[a](other.md#one-heading) [b](https://example.org) [c](missing.md)\n[d](other.md#another) [e](#none)\n"
    assert [each.split(": ", 1)[1] for each in check_text.links(page(text))] == [
        "missing.md is not there", "other.md#another: there is no such heading", "#none: there is no such heading"]
