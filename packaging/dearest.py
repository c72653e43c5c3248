"""Lists what took longest to compile: dearest.py BUILD [COUNT] [--write].

BUILD is a folder of Ninja, whose log has the times of the last compilation of each object: clock time, which is
processor time if the machine had nothing else to do. --write puts the table into CONTRIBUTING.md, between the lines
that name this script."""

import argparse
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
TARGET = ROOT / "CONTRIBUTING.md"
TABLE = re.compile(r"(<!-- dearest\.py -->\n).*?(<!-- /dearest\.py -->)", re.S)


def sources_of(build, output):
    """Returns the sources of an object, relative to the tree: several for a file that CMake made to include them."""
    stem = output.removesuffix(".o")
    made = build / stem
    if "/Unity/" in stem and made.exists():
        return [str(pathlib.Path(each).relative_to(ROOT)) for each in re.findall(r'#include "(.*)"', made.read_text())]
    folder, _, name = re.sub(r"CMakeFiles/[^/]+\.dir/", "", stem).rpartition("/")
    return [f"{folder}/{name}" if folder else name]


def compiled(build):
    """Yields seconds and sources of each object, by the last line of Ninja's log that names it."""
    times = {}
    for line in (build / ".ninja_log").read_text().splitlines()[1:]:
        start, end, _, output, _ = line.split("\t")
        if output.endswith((".o", ".gch")):
            times[output] = (int(end) - int(start)) / 1000
    for output, seconds in times.items():
        yield seconds, sources_of(build, output)


def table(build, count):
    rows = sorted(compiled(build), reverse=True)
    total = sum(seconds for seconds, _ in rows)
    lines = ["| s | compiled as one |", "|---:|---|"]
    for seconds, sources in rows[:count]:
        folder = str(pathlib.Path(sources[0]).parent)
        names = ", ".join(pathlib.Path(each).name for each in sources[:3])
        more = f" and {len(sources) - 3} more" if len(sources) > 3 else ""
        lines.append(f"| {seconds:.0f} | `{folder}`: {names}{more} |")
    lines.append(f"| {total:.0f} | all {len(rows)} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("count", type=int, nargs="?", default=20)
    parser.add_argument("--write", action="store_true")
    arguments = parser.parse_args()
    if not (arguments.build / ".ninja_log").exists():
        sys.exit(f"{arguments.build} has no log of Ninja: ./dev build makes it")
    made = table(arguments.build, arguments.count)
    print(made, end="")
    if arguments.write:
        text = TARGET.read_text()
        TARGET.write_text(TABLE.sub(lambda found: found[1] + made + found[2], text))


if __name__ == "__main__":
    main()
