"""Checks whether this commit is fit for a release, and writes the text of its tag. `./dev release` runs it.

The version stands in CMakeLists.txt: project(fieldfab VERSION ...). CMake and setup.py read it there. COPIES are
places that a tool reads without CMake; `--set X.Y.Z` writes all of them. The date of a release stands in CHANGELOG.md;
`--date YYYY-MM-DD` writes it and its copies.

Each check prints one line: ok, missing, or not checked. If all are ok, out/release/tag.txt has the text of the tag,
and the last line is the command that makes the tag. The program makes and pushes no tag itself. It exits with 1 if a
check failed or was left out, and with 2 if its arguments are wrong.
"""

import argparse
import datetime
import email.utils
import json
import pathlib
import re
import shlex
import subprocess
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parent.parent
PACKAGES = pathlib.Path("out/packages")
TAG_TEXT = pathlib.Path("out/release/tag.txt")
PACKAGE_LOG = pathlib.Path("out/release/packages.log")
TESTED = pathlib.Path("build/tested.json")  # written by ./dev test --full
CHANGELOG = "CHANGELOG.md"
DEBIAN = "debian/changelog"
FREECAD = "freecad_workbench/package.xml"

# Files and patterns whose group 2 is the version, the source first; a pattern without patch level takes X.Y only.
SOURCE = ("CMakeLists.txt", r"(?m)^(project\(fieldfab VERSION )([^ )]+)()")
COPIES = [
    (DEBIAN, r"\A(fieldfab \()([^)]+)()"),  # dpkg reads it before anything is built
    (FREECAD, r"(<version>)([^<]*)(</version>)"),  # FreeCAD reads the source folder through a link
    (CHANGELOG, r"(?m)^(## )([^ ,\n]+)()"),  # the newest section
]
COPIES_WITHOUT_PATCH = [(name, r"(?m)^(find_package\(Fieldfab )(\S+)()") for name in
                        ("docs/install.md", "examples/cpp/CMakeLists.txt")]
HEADING = r"## (?P<version>\d+\.\d+\.\d+)(?: \(not released\)|, (?P<date>\d{4}-\d\d-\d\d))"


class Refusal(Exception):
    """A reason against a release, or against a change of the version."""


def read(name):
    return (ROOT / name).read_text(encoding="utf-8")


def git(*words):
    done = subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True)
    if done.returncode != 0:
        raise Refusal(f"git {words[0]}: {done.stderr.strip()}")
    return done.stdout.rstrip("\n")


def found(name, pattern, text=None):
    """Returns the match of a place's pattern in its file, or in a text."""
    match = re.search(pattern, read(name) if text is None else text)
    if match is None:
        raise Refusal(f"{name} states no version: {pattern} does not match")
    return match


def version():
    return found(*SOURCE)[2]


def without_patch(number):
    return ".".join(number.split(".")[:2])


def disagreements():
    """Returns the places whose version is not the one of CMakeLists.txt, a line each."""
    number = version()
    wrong = [] if re.fullmatch(r"\d+\.\d+\.\d+", number) else [f"{SOURCE[0]} has {number}, which is not X.Y.Z"]
    for places, wanted in ((COPIES, number), (COPIES_WITHOUT_PATCH, without_patch(number))):
        for name, pattern in places:
            stated = found(name, pattern)[2]
            if stated != wanted:
                wrong.append(f"{name} has {stated}, not {wanted}")
    return wrong


# CHANGELOG.md


def sections(text):
    """Returns the sections of CHANGELOG.md, the newest first: dictionaries of version, date (None if not released),
    and lines. Throws where a line has another form than CONTRIBUTING.md states."""
    lines = text.split("\n")
    if lines[:2] != ["# Changelog", ""]:
        raise Refusal(f'{CHANGELOG}:1: the file begins with "# Changelog" and an empty line')
    made, open_entry = [], False
    for number, line in enumerate(lines[2:], 3):
        where = f"{CHANGELOG}:{number}"
        open_entry = line.startswith("- ") or (open_entry and line.startswith("  "))
        if line.startswith("## "):
            heading = re.fullmatch(HEADING, line)
            if heading is None:
                raise Refusal(f'{where}: "{line}" is neither "## X.Y.Z (not released)" nor "## X.Y.Z, YYYY-MM-DD"')
            if heading["date"]:
                day(heading["date"])
            if made and numbers(heading["version"]) >= numbers(made[-1]["version"]):
                raise Refusal(f"{where}: {heading['version']} is below {made[-1]['version']}; the newest is first")
            section: dict = heading.groupdict()
            section["lines"] = []
            made.append(section)
        elif not made and line or not re.match(r"### \S|- \S|  \S|$" if open_entry else r"### \S|$", line):
            raise Refusal(f"{where}: this is no heading, entry or continuation of an entry: {line[:60]}")
        elif made:
            made[-1]["lines"].append(line)
    if not made:
        raise Refusal(f"{CHANGELOG} has no section")
    return made


def numbers(number):
    return tuple(map(int, number.split(".")))


def day(words):
    try:
        return datetime.date.fromisoformat(words)
    except ValueError:
        raise Refusal(f"{words} is no date of the form YYYY-MM-DD") from None


def entries(lines):
    """Yields "heading" or "entry", and the text on one line, for each heading and entry of a section."""
    held = None
    for line in [*lines, ""]:
        if held and line.startswith("  "):
            held += " " + line.strip()
            continue
        if held:
            yield "entry", held
        held = line[2:] if line.startswith("- ") else None
        if line.startswith("### "):
            yield "heading", line[4:]


def plain(words):
    """Returns text of Markdown without links and emphasis. Code keeps its backquotes."""
    pieces = re.split(r"(`[^`]*`)", words)
    for n in range(0, len(pieces), 2):
        pieces[n] = re.sub(r"(?<![\w*])\*([^*\s][^*]*)\*", r"\1", pieces[n])
    joined = "".join(pieces)
    return re.sub(r"\[([^]`]+)\]\(([^)\s]+)\)",
                  lambda link: link[1] if link[1] == link[2] else f"{link[1]} ({link[2]})", joined)


def tag_text(section):
    """Returns the text of the annotated tag. No line begins with #, since git takes such lines for comments."""
    out = [f"Fieldfab {section['version']}", "", f"Released on {section['date']}."]
    before = "heading"
    for kind, words in entries(section["lines"]):
        if kind == "heading":
            out += ["", words, "-" * len(words), ""]
        else:
            if before == "heading" and out[-1]:
                out.append("")
            whole = re.sub(r"`[^`]*`", lambda code: code[0].replace(" ", "\0"), plain(words))  # code is not broken
            out += [line.replace("\0", " ") for line in textwrap.wrap(
                whole, 72, initial_indent="- ", subsequent_indent="  ", break_long_words=False, break_on_hyphens=False)]
        before = kind
    return "\n".join(out) + "\n"


# Checks. Each returns what holds, and throws a Refusal that says what is missing.


def changed_files():
    return [line[3:] for line in git("status", "--porcelain", "--untracked-files=normal").splitlines()]


def check_tree():
    changed = changed_files()
    if changed:
        more = f" and {len(changed) - 5} more" if len(changed) > 5 else ""
        raise Refusal(f"not in the commit: {', '.join(changed[:5])}{more}")
    return f"no file differs from commit {git('rev-parse', '--short', 'HEAD')}"


def check_branch():
    branch = git("branch", "--show-current")
    if branch != "main":
        raise Refusal(f"the branch is {branch or 'none'}, not main")
    return "main"


def check_changelog():
    newest, number = sections(read(CHANGELOG))[0], version()
    if newest["version"] != number:
        raise Refusal(f"the newest section of {CHANGELOG} is of {newest['version']}, not of {number}")
    count = [kind for kind, _ in entries(newest["lines"])].count("entry")
    if count == 0:
        raise Refusal(f"the section {number} of {CHANGELOG} has no entry")
    if newest["date"] is None:
        raise Refusal(f"the section {number} of {CHANGELOG} has no date: packaging/release.py --date YYYY-MM-DD")
    return f"section {number}, {newest['date']}, with {count} entries"


def check_versions():
    wrong = disagreements()
    released = sections(read(CHANGELOG))[0]["date"]
    if released:
        debian = found(DEBIAN, r"(?m)^ -- .*>  (.*)$")[1]
        stated = {FREECAD: found(FREECAD, r"<date>(.*)</date>")[1],
                  DEBIAN: str(email.utils.parsedate_to_datetime(debian).date())}
        wrong += [f"{name} is of {date}, not of {released}" for name, date in stated.items() if date != released]
    if wrong:
        raise Refusal("; ".join(wrong))
    return f"{version()} in {', '.join(name for name, _ in [SOURCE, *COPIES, *COPIES_WITHOUT_PATCH])}"


def is_tagged(number):
    return bool(git("tag", "--list", f"v{number}"))


def check_tag():
    if is_tagged(version()):
        raise Refusal(f"v{version()} is there already; packaging/release.py --set X.Y.Z begins another version")
    return f"v{version()} is not taken"


def check_tests():
    try:
        record = json.loads(read(TESTED))
        commit, date, kind, passed = (record[key] for key in ("commit", "date", "kind", "passed"))
    except FileNotFoundError:
        raise Refusal(f"{TESTED} is not there: ./dev test --full writes it") from None
    except (ValueError, TypeError, KeyError) as error:
        raise Refusal(f"{TESTED} is no record of tests ({type(error).__name__}: {error})") from None
    last = f"the last tests ({kind}) of {date} at {str(commit)[:12]}"
    if passed is not True:
        raise Refusal(f"{last} failed")
    if kind != "full":
        raise Refusal(f"{last} passed, but were not full")
    if commit != git("rev-parse", "HEAD"):
        raise Refusal(f"{last} passed, but this commit is {git('rev-parse', 'HEAD')[:12]}")
    return f"the full tests of {date} passed at this commit"


def check_packages(command):
    """Builds the packages by the command, which also runs lintian, and compares them with debian/control."""
    commit = git("rev-parse", "HEAD")
    before = changed_files()
    for path in (ROOT / PACKAGES).glob("*.deb"):  # packages of an earlier build would be counted
        path.unlink()
    log = ROOT / PACKAGE_LOG
    log.parent.mkdir(parents=True, exist_ok=True)
    print(f"packages: {command} runs and writes {PACKAGE_LOG}", file=sys.stderr)
    with open(log, "w", encoding="utf-8") as out:
        try:
            code = subprocess.run(shlex.split(command), cwd=ROOT, stdin=subprocess.DEVNULL, stdout=out,
                                  stderr=subprocess.STDOUT).returncode
        except OSError as error:
            raise Refusal(f"{command}: {error.strerror}") from None
    said = log.read_text(encoding="utf-8", errors="replace")
    if code != 0:
        raise Refusal(f"{command} ended with {code}: {' | '.join(said.strip().splitlines()[-3:])} ({PACKAGE_LOG})")
    wanted = {name: version() for name in re.findall(r"(?m)^Package: (\S+)", read("debian/control"))}
    made = {}
    for path in sorted((ROOT / PACKAGES).glob("*.deb")):
        fields = subprocess.run(["dpkg-deb", "--show", "--showformat=${Package} ${Version}", str(path)],
                                capture_output=True, text=True)
        if fields.returncode != 0:
            raise Refusal(f"{path.name} is no Debian package: {fields.stderr.strip()}")
        name, _, number = fields.stdout.partition(" ")
        made[name] = number
    if made != wanted:
        lists = [", ".join(f"{name} {number}" for name, number in sorted(each.items())) or "no package"
                 for each in (made, wanted)]
        raise Refusal(f"{command} made {lists[0]}; debian/control has {lists[1]}")
    if git("rev-parse", "HEAD") != commit or changed_files() != before:
        raise Refusal(f"{command} has changed the tree: {', '.join(changed_files()) or 'another commit'}")
    warnings = len(re.findall(r"(?m)^W: ", said))
    return f"{len(made)} of {version()}; {command} passed; warnings of lintian: {warnings}"


def checked(package_command):
    """Prints a line for each check; returns whether all are ok. No command: the packages are not checked."""
    checks = [("tree", check_tree), ("branch", check_branch), ("changelog", check_changelog),
              ("versions", check_versions), ("tag", check_tag), ("tests", check_tests)]
    if package_command:
        checks.append(("packages", lambda: check_packages(package_command)))
    whole = True
    for name, check in checks:
        try:
            print(f"ok {name}: {check()}", flush=True)
        except (Refusal, OSError) as reason:
            print(f"missing {name}: {reason}", flush=True)
            whole = False
    if not package_command:
        print("not checked packages: --skip-packages was given, and a release has packages")
    return whole and bool(package_command)


def release(package_command):
    """Checks all, and writes the tag's text if all is ok. Returns the exit code."""
    (ROOT / TAG_TEXT).unlink(missing_ok=True)
    if not checked(package_command):
        return 1
    text = tag_text(sections(read(CHANGELOG))[0])
    (ROOT / TAG_TEXT).parent.mkdir(parents=True, exist_ok=True)
    (ROOT / TAG_TEXT).write_text(text, encoding="utf-8")
    print(f"git tag -a v{version()} -F {TAG_TEXT}")
    return 0


# Changes of the version and of the date


def replaced(name, pattern, value, texts):
    """Replaces group 2 of a place in its text, which is read at first use. `texts`: the new texts by file."""
    text = texts.get(name) or read(name)
    match = found(name, pattern, text)
    texts[name] = text[:match.start(2)] + value + text[match.end(2):]


def set_version(number, texts):
    """Writes the version into all places. If the newest section is released, a new one begins."""
    newest = sections(read(CHANGELOG))[0]
    if is_tagged(number):
        raise Refusal(f"v{number} is tagged already")
    if newest["date"] and number != newest["version"]:
        head = "# Changelog\n\n"
        texts[CHANGELOG] = read(CHANGELOG).replace(head, f"{head}## {number} (not released)\n\n", 1)
        maintainer = found("debian/control", r"(?m)^Maintainer: (.*)$")[1]
        texts[DEBIAN] = (f"fieldfab ({number}) unstable; urgency=medium\n\n  * {CHANGELOG} lists the changes.\n\n"
                         f" -- {maintainer}  {email.utils.format_datetime(datetime.datetime.now().astimezone())}\n\n"
                         + read(DEBIAN))
    for places, value in (([SOURCE, *COPIES], number), (COPIES_WITHOUT_PATCH, without_patch(number))):
        for name, pattern in places:
            replaced(name, pattern, value, texts)
    sections(texts[CHANGELOG])  # refuses a version that is not above the earlier ones


def set_date(date, texts):
    """Writes the date of the newest section and its copies. The time is noon, UTC."""
    text = texts.get(CHANGELOG) or read(CHANGELOG)
    newest = sections(text)[0]
    if is_tagged(newest["version"]):
        raise Refusal(f"v{newest['version']} is tagged already")
    texts[CHANGELOG] = re.sub(rf"(?m)^{HEADING}$", f"## {newest['version']}, {date}", text, count=1)
    replaced(FREECAD, r"(<date>)([^<]*)(</date>)", str(date), texts)
    noon = datetime.datetime.combine(date, datetime.time(12), datetime.timezone.utc)
    replaced(DEBIAN, r"(?m)^( -- .*>  )(.*)()$", email.utils.format_datetime(noon), texts)


def change(number, date):
    """Writes version and date, if given; no file is written before all new texts are made. Returns the exit code."""
    texts = {}
    try:
        if number:
            set_version(number, texts)
        if date:
            set_date(day(date), texts)
    except (Refusal, OSError) as reason:
        print(f"release.py: {reason}", file=sys.stderr)
        return 1
    for name, text in texts.items():
        if text != read(name):
            (ROOT / name).write_text(text, encoding="utf-8")
            print(f"written {name}")
    return 0


def main():
    parser = argparse.ArgumentParser(description="Checks whether this commit is fit for a release.")
    parser.add_argument("--set", metavar="X.Y.Z", help="write this version into all places")
    parser.add_argument("--date", metavar="YYYY-MM-DD", help="write the date of the release into all places")
    parser.add_argument("--skip-packages", action="store_true", help="leave the packages out: the result is 1")
    parser.add_argument("--package-command", metavar="COMMAND", default="./dev package",
                        help="makes out/packages and looks them over (default: %(default)s)")
    given = parser.parse_args()
    if given.set and not re.fullmatch(r"(0|[1-9]\d*)(\.(0|[1-9]\d*)){2}", given.set):
        parser.error(f"--set: {given.set} is not X.Y.Z")
    if given.set or given.date:
        return change(given.set, given.date)
    return release(None if given.skip_packages else given.package_command)


if __name__ == "__main__":
    sys.exit(main())
