"""FreeCAD killed while it saves and while it recomputes: afterwards the old or the new document is on the disk,
complete."""

import json
import math
import os
import random
import shutil
import subprocess
import time

import pytest

from family import sample_or_all
from freecad_host import HERE, environment, home

ROUNDS = sample_or_all(8, 24)
MOMENTS = {"saving": 0.15, "making": 0.3}  # longest duration of each, seconds


def freecadcmd(script, home, document, **more):
    return subprocess.Popen(["freecadcmd", str(HERE / "freecad" / script)], stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                            env=environment(home, QT_QPA_PLATFORM="offscreen", FIELDFAB_DOCUMENT=str(document), **more))


def kill_at(moment, victim, chance):
    """Kills a victim at a random time within one of its saves or recomputes. Returns the radii that its document may
    have afterwards."""
    wanted, saved = 1 + chance.randrange(2), 5.0
    for line in victim.stdout:
        doing, radius = (line.split() + ["", ""])[:2]
        saved = float(radius) if doing == "saved" else saved
        if doing == moment:
            wanted -= 1
            if wanted == 0:
                break
    time.sleep(chance.uniform(0, MOMENTS[moment]))
    victim.kill()
    for line in victim.stdout:  # its remaining output
        doing, now = (line.split() + ["", ""])[:2]
        if doing in ("saving", "saved"):
            radius = now
            saved = float(now) if doing == "saved" else saved
    victim.wait()
    return {saved, float(radius)}


def test_a_killed_freecad_leaves_the_old_document_or_the_new_one(home, tmp_path):
    fresh = tmp_path / "fresh.FCStd"
    assert freecadcmd("crash_make.py", home, fresh).wait(60) == 0 and fresh.exists()
    chance, expected = random.Random(20), {}
    while len(expected) < ROUNDS:
        document = tmp_path / f"round{len(expected)}.FCStd"
        shutil.copy(fresh, document)
        moment = chance.choice(("saving", "saving", "making"))
        expected[document] = (moment, kill_at(moment, freecadcmd("crash_victim.py", home, document), chance))
    # FreeCAD writes a new file, renames the old one to .FCStd1, and then renames the new one. Killed between the two
    # renames it leaves the old file as .FCStd1.
    between = [document for document in expected if not document.exists()]
    left = {document: document.with_suffix(".FCStd1") if document in between else document for document in expected}
    for document in between:
        shutil.copy(left[document], document)
    checker = freecadcmd("crash_check.py", home, fresh, FIELDFAB_DOCUMENTS=os.pathsep.join(map(str, expected)))
    checker.communicate(timeout=120)
    seen = json.loads((home / "result.json").read_text())
    halfway = sum(any(".FCStd." in other.name and other.name.startswith(document.name) for other in tmp_path.iterdir())
                  for document in expected)
    print(f"{len(expected)} rounds, {sum(moment == 'saving' for moment, _ in expected.values())} of them at a save; "
          f"{halfway} left a half-written new file, {len(between)} were between two renames")
    for document, (moment, radii) in expected.items():
        found = seen[str(document)]
        assert "error" not in found, (moment, found)
        assert found["radius"] in radii, (moment, radii, found)
        assert (found["closed"] and found["triangles"] == found["facets"] and found["valid"]
                and not found["recomputed"]), (moment, found)
        assert found["volume"] == pytest.approx(4 / 3 * math.pi * found["radius"] ** 3,
                                                rel=0.01) == pytest.approx(found["measured"], rel=0.01), (moment, found)
    assert len({moment for moment, _ in expected.values()}) == 2
