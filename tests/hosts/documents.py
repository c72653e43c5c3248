"""Contents of README.md, CONTRIBUTING.md and docs/*.md: blocks by language, commands, words in backquotes, links. Also
code in docstrings."""

import re
import textwrap
import typing

from conftest import ROOT

# `fieldfab mesh` and `fieldfab build --quantum` are names, not commands.
NAME_OF_VERB = r"fieldfab ([a-z]+)((?: --[\w-]+)*)"
COMMAND_IN_PROSE = (r"(\./dev|ninja|fieldfab|freecad|freecadcmd|meshlab|meshlabserver|openscad|ffmpeg|python3) "
                    r"|build/release/bin/|[A-Z]+=\S+ ")
SHELLS = {"": "sh", "bash": "sh", "console": "sh"}


class Place(typing.NamedTuple):
    """A text with its position. `session`: the Python session below the command that starts it."""

    document: str
    line: int
    text: str
    language: str = ""
    session: str = ""

    @property
    def name(self):
        return f"{self.document}:{self.line}"

    @property
    def command(self):
        """The command without its comment, with single spaces."""
        return " ".join(re.sub(r"\s#.*", "", self.text).split())


def blocks_of(name, words):
    """Yields fenced blocks, also in lists, and indented ones, which are commands."""
    lines, n = words.splitlines(), 0
    while n < len(lines):
        start, end = n, n + 1
        if fence := re.fullmatch(r"( *)```(\w*)", lines[n]):
            start, end = n + 1, lines.index(f"{fence[1]}```", n + 1)
            yield Place(name, start + 1, textwrap.dedent("\n".join(lines[start:end])), SHELLS.get(fence[2], fence[2]))
            end += 1
        elif lines[n].startswith("    ") and not lines[n - 1].strip():
            while end < len(lines) and (lines[end].startswith("    ") or not lines[end].strip()):
                end += 1
            yield Place(name, start + 1, "\n".join(line[4:] for line in lines[start:end]), "sh")
        n = end


def commands_of(block):
    """Returns the commands of a block, one per line; a Python session belongs to the command above it."""
    words, _, session = block.text.partition(">>>")
    found = [Place(block.document, block.line + n, line) for n, line in enumerate(words.splitlines()) if line.strip()]
    return [*found[:-1], found[-1]._replace(session=f">>>{session}\n")] if session else found


class Document:
    def __init__(self, path):
        self.name, self.folder = str(path.relative_to(ROOT)), path.parent
        words = path.read_text(encoding="utf-8")
        self.blocks = list(blocks_of(self.name, words))
        lines = words.splitlines()
        for block in self.blocks:
            for n in range(block.line - 1, block.line - 1 + len(block.text.splitlines())):
                lines[n] = ""
        prose = "\n".join("" if line.lstrip().startswith("```") else line for line in lines)
        self.headings = [line.lstrip("# ") for line in prose.splitlines() if line.startswith("#")]
        at = lambda found: prose.count("\n", 0, found.start()) + 1
        self.spans = [Place(self.name, at(each), " ".join(each[1].split()))
                      for each in re.finditer(r"`([^`]+)`", prose)]
        self.links = [Place(self.name, at(each), each[1]) for each in re.finditer(r"\]\(([^)\s]+)\)", prose)]

    @property
    def commands(self):
        """Returns the commands in order, from blocks and text."""
        found = [command for block in self.blocks if block.language == "sh" for command in commands_of(block)]
        found += [span for span in self.spans
                  if re.match(COMMAND_IN_PROSE, span.text) and not re.fullmatch(NAME_OF_VERB, span.text)]
        return sorted(found, key=lambda each: each.line)


def code_of(docstring):
    """Returns the indented blocks of a docstring, cleaned of the indent of its source."""
    found = re.findall(r"(?:^    .*\n?|^\n)+", docstring, re.M)
    return [textwrap.dedent(block).strip() for block in found if block.strip()]


DOCUMENTS = [Document(path)
             for path in (ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md")))]
