"""Runs what a change can reach: check.py [--seconds N] [COMMIT]. `./dev check` runs it.

The change is what differs from COMMIT (default: the last commit, or, where nothing differs from it, the one before).
Lint of the changed files runs beside the build; then the C++ tests that the change reaches, and the Python tests; see
packaging/reach.py. A change in C++ reaches all that runs the command or the module: of those Python tests the quickest
are run, by their times in the last ./dev test, until --seconds (default 220) are used. What was left out is listed.
"""

import argparse
import os
import pathlib
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree

import reach

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "release"
TIMES = ROOT / "build" / "times" / "python.xml"
UNKNOWN = 20.0  # seconds that a test is thought to take of which no time is known
CPP = (".cpp", ".h", ".inl", *reach.OF_BUILD)


def last_times():
    """Returns {pytest's argument: seconds} of the last whole run: of a file all its tests, and of each test that runs
    within FreeCAD."""
    times = {}
    if TIMES.exists():
        for case in ElementTree.parse(TIMES).iter("testcase"):
            file = case.get("classname").replace(".", "/") + ".py"
            seconds = float(case.get("time"))
            times[file] = times.get(file, 0.0) + seconds
            if file == reach.INSIDE:
                times[f"{file}::{case.get('name').partition('@')[0]}"] = seconds
    return times


def as_single_tests(tests, times):
    """Replaces the file that runs all that is within FreeCAD by its tests."""
    if reach.INSIDE not in tests:
        return set(tests)
    return {test for test in tests if test != reach.INSIDE} | (
        {test for test in times if test.startswith(f"{reach.INSIDE}::")} or {reach.INSIDE})


def within(tests, seconds, times):
    """Splits tests into those that fit into a time, the quickest first, and the others."""
    taken, left, used = [], [], 0.0
    for test in sorted(tests, key=lambda test: (times.get(test, UNKNOWN), test)):
        used += times.get(test, UNKNOWN)
        (taken if used <= seconds else left).append(test)
    return taken, left


class Work:
    """Runs commands in the tree's folder, and remembers whether one failed."""

    def __init__(self):
        self.failed = False
        self.start = time.monotonic()

    def seconds(self):
        return time.monotonic() - self.start

    def run(self, title, *words, **more):
        print(f"== {title} ({self.seconds():.0f} s)", flush=True)
        passed = subprocess.run(words, cwd=ROOT, **more).returncode == 0
        self.failed |= not passed
        return passed


def main():
    parser = argparse.ArgumentParser(prog="./dev check", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=220)
    parser.add_argument("commit", nargs="?", metavar="COMMIT")
    arguments = parser.parse_args()
    commit = arguments.commit or ("HEAD" if reach.changed_files("HEAD") else "HEAD^")
    changed = reach.changed_files(commit)
    print(f"{len(changed)} files changed since {reach.git('log', '-1', '--format=%h %s', commit)[0]}")
    work, jobs = Work(), os.cpu_count()
    lint = subprocess.Popen(["./dev", "lint", "--since", commit], cwd=ROOT, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True)
    cpp = any(name.endswith(CPP) for name in changed)
    python, others = reach.python_tests(changed), set()
    built = work.run("build", "./dev", "build", "all", "tests") if cpp or python else True
    if built and cpp:
        programs = reach.test_programs(BUILD, changed)
        if programs:
            work.run(f"C++ tests of {len(programs)} programs", "ctest", "--test-dir", BUILD, "-j", str(jobs),
                     "--output-on-failure", "--no-label-summary", "-L", f"^({'|'.join(sorted(programs))})$")
        others = set(filter(reach.is_test, reach.git("ls-files", "tests/hosts")))
    print(f"== lint ({work.seconds():.0f} s)", flush=True)
    said = lint.communicate()[0]
    if lint.returncode != 0:
        work.failed = True
        print(said)
    left = set()
    if built:
        times, seconds = last_times(), (arguments.seconds - work.seconds()) * jobs
        taken, left = within(as_single_tests(python, times), seconds, times)
        seconds -= sum(times.get(each, UNKNOWN) for each in taken)
        more, left_too = within(as_single_tests(others - python, times) - {*taken, *left}, seconds, times)
        left += left_too
        if taken or more:
            work.run("Python tests", "/usr/bin/python3", "-m", "pytest", "-q", "-p", "no:cacheprovider", "-n",
                     str(jobs), "--dist", "loadgroup", *taken, *more,
                     env={**os.environ, "PYTHONPATH": str(BUILD / "python")})
    if left:
        print("not run, for ./dev test:", *sorted(left), sep="\n  ")
    print(f"check: {'failed' if work.failed else 'passed'} in {work.seconds():.0f} s")
    sys.exit(work.failed)


if __name__ == "__main__":
    main()
