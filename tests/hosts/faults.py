"""Runs the command with failing calls, full disks and losses of power (faults.cpp)."""

import os
import shutil
import subprocess

import pytest
from conftest import BUILD, COMMAND

LIBRARY = BUILD / "tests" / "libfaults.so"
CRASHES = (-6, -11, -7, 134, 139, 135)  # SIGABRT, SIGSEGV, SIGBUS


def run(arguments, folder, timeout=120, threads=2, program=None, **faults):
    """Runs the command, or another program, in `folder`, with a separate folder for temporary files. `faults`:
    variables of faults.cpp in lower case."""
    if not LIBRARY.exists():
        pytest.skip(f"{LIBRARY} is not built (target faults)")
    temporary = folder.parent / (folder.name + ".tmp")
    temporary.mkdir(exist_ok=True)
    environment = {**os.environ, "TMPDIR": str(temporary), "LD_PRELOAD": str(LIBRARY)}
    environment |= {f"FAULT_{name.upper()}": str(value) for name, value in faults.items()}
    words = [*(program or [COMMAND, "--threads", str(threads)]), *map(str, arguments)]
    done = subprocess.run(words, capture_output=True, text=True, timeout=timeout, cwd=folder, env=environment,
                          errors="replace")
    done.left = sorted(path.name for path in temporary.iterdir())
    shutil.rmtree(temporary)
    return done


def files_of(folder):
    """Returns {name: content} of all files below a folder."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def lose_power(journal, folder):
    """Simulates a loss of power: undoes renames in folders that were not synced, and truncates files to their synced
    part. `journal`: folder written by faults.cpp; `folder`: working folder of the program."""
    synced, renames = {}, []
    for line in (journal / "journal").read_text().splitlines() if (journal / "journal").exists() else []:
        kind, *words = line.split("\t")
        if kind == "file":
            synced[int(words[0])] = (int(words[1]), words[2])
        elif kind == "folder":
            renames = [entry for entry in renames if entry[3] != int(words[0])]
        else:
            renames.append((folder / words[0], folder / words[1], words[2], int(words[3])))
    for old, new, kept, _ in reversed(renames):
        if new.exists():
            new.rename(old)
        if kept != "-":
            shutil.copyfile(kept, new)
    return synced


def cut_to_synced(folder, synced, before):
    """Truncates new files to their synced part. A file with two names is not new."""
    for path in folder.rglob("*"):
        if not path.is_file() or path.read_bytes() == before.get(str(path.relative_to(folder))):
            continue
        status = path.stat()
        if status.st_nlink > 1:
            continue
        size, changed = synced.get(status.st_ino, (0, ""))
        if changed != f"{status.st_mtime_ns // 10**9}.{status.st_mtime_ns % 10**9:09d}":
            size = 0
        os.truncate(path, min(size, status.st_size))
