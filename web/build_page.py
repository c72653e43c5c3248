"""Builds the page (build_page.py CLIENT WORK PAGE) and the script of the demo's static page, WORK/demo.js. npm installs
the packages of the lock file into WORK and runs none of their scripts. Without npm or access to its registry, it prints
one line, and the rest of the build continues."""

import gzip
import pathlib
import shutil
import subprocess
import sys

SECONDS = 240


class Missing(Exception):
    """npm, or a package from its registry, is missing."""


def run(words, folder):
    try:
        return subprocess.run(words, cwd=folder, capture_output=True, text=True, timeout=SECONDS,
                              stdin=subprocess.DEVNULL)
    except subprocess.TimeoutExpired:
        raise Missing(f"{words[0]} did not end within {SECONDS} s") from None


def install(client, work):
    """Installs the packages of the lock file in `client` into `work` unless they are there. Raises Missing."""
    lock = (client / "package-lock.json").read_bytes()
    installed = work / "installed-lock.json"
    if installed.exists() and installed.read_bytes() == lock:
        return
    npm = shutil.which("npm")
    if npm is None:
        raise Missing("there is no npm (./dev setup)")
    work.mkdir(parents=True, exist_ok=True)
    for name in ("package.json", "package-lock.json"):
        shutil.copy(client / name, work / name)
    done = run([npm, "ci", "--ignore-scripts", "--no-audit", "--no-fund", "--prefer-offline", "--fetch-retries=1"],
               work)
    if done.returncode != 0:
        raise Missing("npm ci: " + next((line for line in done.stderr.splitlines() if "error" in line.lower()),
                                        "it failed"))
    installed.write_bytes(lock)


def build(client, work, page):
    install(client, work)
    fresh = work / "page"
    shutil.rmtree(fresh, ignore_errors=True)
    fresh.mkdir()
    link = work / "src"
    shutil.rmtree(link, ignore_errors=True)
    shutil.copytree(client / "src", link)  # next to node_modules, where esbuild looks for packages
    shutil.copy(client / "tsconfig.json", work / "tsconfig.json")
    bundle = ["--bundle", "--minify", "--target=es2022"]
    for tool in (["tsc", "--noEmit", "-p", "."],
                 ["esbuild", "src/main.ts", *bundle, "--format=esm", "--legal-comments=none", "--splitting",
                  "--entry-names=page", f"--outdir={fresh}"],
                 ["esbuild", "src/demo.ts", *bundle, "--format=iife", "--legal-comments=eof",
                  f"--outfile={work}/demo.js"]):
        done = run([str(work / "node_modules" / ".bin" / tool[0]), *tool[1:]], work)
        if done.returncode != 0:
            sys.exit((done.stdout + done.stderr).strip())  # an error in our sources ends the build
    for each in (client / "src").iterdir():
        if each.suffix in (".html", ".css", ".svg"):
            shutil.copy(each, fresh / each.name)
    for each in list(fresh.iterdir()):  # sent to browsers in place of the file itself
        if each.name != "index.html":  # which the server fills in
            (fresh / f"{each.name}.gz").write_bytes(gzip.compress(each.read_bytes(), 9, mtime=0))
    shutil.rmtree(page, ignore_errors=True)
    page.parent.mkdir(parents=True, exist_ok=True)
    shutil.move(fresh, page)


if __name__ == "__main__":
    try:
        build(*(pathlib.Path(each).resolve() for each in sys.argv[1:]))
    except Missing as reason:
        print(f"the page of `fieldfab serve` is not built: {reason}")
