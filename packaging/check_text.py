"""Checks the text of the tree: spelling, columns, tables and links. `./dev lint` runs it, and so does
tests/text_test.py.

- Spelling: codespell over sources and documents; packaging/spelling.txt lists the exceptions (symbols of
  algorithms, words of other languages, misspellings for tests).
- Columns: lines of sources, and lines of documents outside of tables, have at most 120 columns. A source line may
  be longer if one word of it, such as an address, does not fit.
- Tables: each row has as many cells as the first one. Fences of code are closed.
- Links: a link within the tree leads to an existing file and, if it has an anchor, to a heading of that file.

Prints one line per finding, FILE:LINE: WHAT, and exits with 1 if there is one.
"""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
COLUMNS = 120
SPELLED = ("*.md", "*.h", "*.cpp", "*.inl", "*.py", "*.toml", "*.frep", "dev")
SOURCES = ("*.py", "*.ts", "*.tsx", "*.cpp", "*.h", "*.inl")
GENERATED = "freecad_workbench/resources/translations/fieldfab_"


def tracked(*patterns):
    """Returns the tracked files that match, relative to the root."""
    listed = subprocess.run(["git", "ls-files", "--", *patterns], cwd=ROOT, capture_output=True, text=True, check=True)
    return [name for name in listed.stdout.splitlines() if (ROOT / name).exists()]


def lines_of(name):
    return (ROOT / name).read_text(encoding="utf-8").split("\n")


def spelling(names):
    """Returns codespell's findings."""
    names = [name for name in names if not name.startswith(("tests/data/", "tests/fuzz/corpus/"))]
    if not names:
        return []
    command = ["codespell", "--ignore-words", str(ROOT / "packaging" / "spelling.txt"), *names]
    said = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    if said.returncode not in (0, 64, 65):  # 65: there are findings
        raise RuntimeError(f"codespell: {said.stderr.strip()}")
    return said.stdout.splitlines()


def prose(name):
    """Yields number and text of each line outside of code; the text is None for a fence without an end."""
    fence, blank = None, True
    for number, line in enumerate(lines_of(name), 1):
        if line.startswith("```"):
            fence = None if fence else number
        elif not fence and not (line.startswith("    ") and blank):
            yield number, line
        blank = not line.strip() or (blank and line.startswith("    "))
    if fence:
        yield fence, None


def columns_of_source(name):
    """Returns findings about lines that are too wide, unless one word with the line's indentation is too wide."""
    return [f"{name}:{number}: {len(line)} columns" for number, line in enumerate(lines_of(name), 1)
            if len(line) > COLUMNS and len(line) - len(line.lstrip()) + max(map(len, line.split())) <= COLUMNS]


def cells(row):
    """Returns the number of cells of a table's row. A bar with a backslash is part of a cell; a bar in code separates
    cells."""
    return len(row.replace(r"\|", "").strip().strip("|").split("|"))


def form_of_document(name):
    """Returns findings about columns, rows of tables and fences of a document."""
    found = [f"{name}:{number}: {len(line)} columns" for number, line in enumerate(lines_of(name), 1)
             if len(line) > COLUMNS and not line.startswith("|")]
    wanted = 0
    for number, line in prose(name):
        if line is None:
            found.append(f"{name}:{number}: a fence of code is not closed")
        elif line.startswith("|"):
            wanted = wanted or cells(line)
            if cells(line) != wanted:
                found.append(f"{name}:{number}: a row has {cells(line)} cells, the first one has {wanted}")
        else:
            wanted = 0
    return found


def anchor(heading):
    """Returns the anchor that GitHub gives a heading."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def anchors_of(name):
    return {anchor(line.lstrip("# ")) for _, line in prose(name) if line and line.startswith("#")}


def links(name):
    """Returns findings about links of a document without a target in the tree."""
    found = []
    for number, line in prose(name):
        for link in re.findall(r"\]\(([^)\s]+)\)", line or ""):
            if re.match(r"\w+:", link):
                continue
            path, _, place = link.partition("#")
            target = (ROOT / name).parent / path if path else ROOT / name
            if not target.exists():
                found.append(f"{name}:{number}: {link} is not there")
            elif place and place not in anchors_of(target.resolve().relative_to(ROOT)):
                found.append(f"{name}:{number}: {link}: there is no such heading")
    return found


def findings():
    """Returns all findings, a line each."""
    documents = tracked("*.md")
    found = spelling(tracked(*SPELLED))
    for name in tracked(*SOURCES):
        if not name.startswith(GENERATED):
            found += columns_of_source(name)
    for name in documents:
        if not name.startswith("tests/data/"):
            found += form_of_document(name) + links(name)
    return found


if __name__ == "__main__":
    found = findings()
    print("\n".join(found) if found else "text: spelling, columns, tables and links are in order")
    sys.exit(1 if found else 0)
