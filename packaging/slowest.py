"""Lists the slowest tests of JUnit reports: slowest.py REPORT.xml ... Prints each report's sum and the 30 slowest."""

import pathlib
import sys
import xml.etree.ElementTree as ElementTree

COUNT = 30


def tests_of(path):
    """Yields seconds and name of each test of a report."""
    for case in ElementTree.parse(path).iter("testcase"):
        file, name = case.get("classname", "").removeprefix("tests.").removeprefix("hosts."), case.get("name")
        yield float(case.get("time", 0)), name if file in ("", name) else f"{file}: {name}"


def main():
    found = []
    for path in map(pathlib.Path, sys.argv[1:]):
        tests = list(tests_of(path))
        found += [(seconds, f"{path.stem}: {name}") for seconds, name in tests]
        print(f"{sum(seconds for seconds, _ in tests):8.1f}  all {len(tests)} of {path.stem}")
    for seconds, name in sorted(found, reverse=True)[:COUNT]:
        print(f"{seconds:8.1f}  {name}")


if __name__ == "__main__":
    main()
