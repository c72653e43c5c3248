"""The site of ./dev docs: Doxygen and Sphinx build it without a warning, and its internal links resolve."""

import os
import subprocess

import make_site
from conftest import BUILD, ROOT


def test_the_site_is_made_without_a_warning():
    done = subprocess.run(["/usr/bin/python3", ROOT / "packaging" / "make_site.py"],
                          env={**os.environ, "FIELDFAB_BUILD": str(BUILD)},
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "warning" not in done.stdout + done.stderr
    for page, words in [("docs/contouring.html", "self-intersections"), ("packaging/site/python.html", "fieldfab.pcb"),
                        ("cpp/classfieldfab_1_1Field.html", "restrict_all"),
                        ("cpp/index.html", "usage: simulate_program"), ("searchindex.js", "dexel")]:
        assert words in (make_site.SITE / page).read_text(encoding="utf-8"), page


def test_a_link_that_leads_nowhere_is_found(tmp_path, monkeypatch):
    monkeypatch.setattr(make_site, "SITE", tmp_path)
    (tmp_path / "a.html").write_text(
        '<a href="b.html#x">b</a> <a href="#here">c</a> <img src="c.png"> <a href="https://example.org">d</a>')
    assert make_site.broken() == ["a.html: b.html", "a.html: c.png"]
    (tmp_path / "b.html").write_text("")
    assert make_site.broken() == ["a.html: c.png"]
