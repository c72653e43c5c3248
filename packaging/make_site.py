"""Builds the site of ./dev docs in out/site: pages and Python reference by Sphinx, C++ reference by Doxygen.

A warning of either program and a broken link between pages are errors.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parent.parent
SITE = ROOT / "out" / "site"
START = '<!DOCTYPE html><meta http-equiv="refresh" content="0; url=packaging/site/index.html"><title>Fieldfab</title>\n'


def made():
    """Builds the site from scratch. Raises CalledProcessError for a warning."""
    shutil.rmtree(SITE, ignore_errors=True)
    SITE.mkdir(parents=True)
    subprocess.run(["doxygen", "packaging/site/Doxyfile"], cwd=ROOT, check=True)
    command = ["sphinx-build", "-q", "-W", "--keep-going", "-b", "html", "-d", "out/site-cache", "-c", "packaging/site",
               ".", "out/site"]
    subprocess.run(command, cwd=ROOT, check=True)
    (SITE / "index.html").write_text(START)


def broken():
    """Returns the links of Sphinx's pages to missing files, a line each."""
    found = []
    for page in SITE.rglob("*.html"):
        if SITE / "cpp" in page.parents:  # Doxygen checks its own links
            continue
        for link in re.findall(r'(?:href|src)="([^"#?]+)', page.read_text(encoding="utf-8")):
            if not re.match(r"\w+:|//", link) and not (page.parent / urllib.parse.unquote(link)).exists():
                found.append(f"{page.relative_to(SITE)}: {link}")
    return found


if __name__ == "__main__":
    made()
    lost = broken()
    print("\n".join(lost) if lost else f"site: {SITE / 'index.html'}")
    sys.exit(1 if lost else 0)
