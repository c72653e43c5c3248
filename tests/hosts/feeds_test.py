"""`fieldfab cam --optimise`: its programs, simulated again."""

import json
import re

import pytest
from simulate_test import TOOLS, run

import fieldfab as ff

JOB = """
machine = "linuxcnc"
[input]
model = "part.frep"
[stock]
lower = [-22.03, -17.02, -8.04]
upper = [22.03, 17.02, 0.5]
""" + TOOLS + """
[[operation]]
type = "rough"
tool = 1
stepdown = 2
bottom = -8
feed = 900
[[operation]]
type = "finish"
tool = 2
stepover = 0.15
bottom = -8
feed = 700
"""
PART = "move(box(40, 30, 4), 0, 0, -6) | (move(sphere(9), -8, 0, -9) & move(box(60, 60, 8), 0, 0, -4))"


def planned(folder, name, *options, more=""):
    (folder / "part.frep").write_text(PART)
    (folder / "job.toml").write_text(JOB + more)
    done = run("--json", "cam", folder / "job.toml", "-o", folder / f"{name}.ngc", *options)
    assert done.returncode == 0, done.stderr
    report = folder / f"{name}.json"
    simulated = run("simulate", folder / f"{name}.ngc", "--setup", folder / "job.toml", "--report", report)
    assert simulated.returncode == 0, simulated.stderr
    return json.loads(done.stdout), json.loads(report.read_text()), (folder / f"{name}.ngc").read_text().splitlines()


def greatest_rate(told, lines):
    """Returns the greatest rate of removal along feeds of 0.5 mm and more, mm3/min, by the simulation's report."""
    feed, feeds = 0, []
    for line in lines:
        if found := re.search(r"F([\d.]+)", line):
            feed = float(found[1])
        feeds.append(feed)
    return max(record["removed"] / record["cut"] * feeds[record["line"] - 1]
               for record in told["lines"] if record["cut"] > 0.5)


def test_adjusted_feeds_save_time_and_cut_the_same(tmp_path):
    plain, before, lines = planned(tmp_path, "plain")
    fast, after, quick = planned(tmp_path, "fast", "--optimise")
    assert plain["seconds"] == plain["planned_seconds"] == pytest.approx(fast["planned_seconds"])
    assert fast["seconds"] < 0.9 * plain["seconds"]
    assert after["seconds"] < before["seconds"], "by the simulation's clock, too"
    assert after["removed"] == pytest.approx(before["removed"], rel=1e-4)
    assert after["deviation"]["deepest_gouge"] == pytest.approx(before["deviation"]["deepest_gouge"], abs=2e-3)
    assert greatest_rate(after, quick) < 1.02 * greatest_rate(before, lines)
    assert fast["cut"] == pytest.approx(plain["cut"], rel=1e-6) and fast["rapid"] == plain["rapid"]


def test_limits_come_from_the_job(tmp_path):
    told, _, lines = planned(tmp_path, "limits", more="[feeds]\nleast = 1\nmost = 1.1\n")
    feeds = {float(found[1]) for line in lines if (found := re.search(r"F([\d.]+)", line))}
    planned_feeds = {900, 700, 200}
    assert all(any(feed - 0.01 <= each <= 1.1 * feed + 0.01 for feed in (*planned_feeds, 600)) for each in feeds)
    assert told["seconds"] < told["planned_seconds"]
    for limits, words in (("least = 0", "least must be above 0"), ("most = 0.5", "most must be from 1"),
                          ("fastest = 3", "no key 'fastest'")):
        (tmp_path / "wrong.toml").write_text(JOB + f"[feeds]\n{limits}\n")
        done = run("cam", tmp_path / "wrong.toml", "-o", tmp_path / "wrong.ngc")
        assert done.returncode == 2 and "wrong.toml:" in done.stderr and words in done.stderr, done.stderr


def test_python_adjusts_feeds(tmp_path):
    (tmp_path / "part.frep").write_text(PART)
    (tmp_path / "job.toml").write_text(JOB)
    job = ff.cam.Job(tmp_path / "job.toml")
    for limits in ({"least": 0}, {"most": 0.5}, {"most": float("nan")}):
        with pytest.raises(ff.Error, match="must be"):
            job.adjust_feeds(**limits)
    job.adjust_feeds(most=2)
    job.run()
    assert sum(report["seconds"] - report["planned_seconds"] for report in job.reports) < 0
    assert max(moves[:, 3].max() for moves in job.moves) <= 2 * 900 + 1e-6
