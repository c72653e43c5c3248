"""Runs inside FreeCAD's window: exports of a simulation's panel."""

from simulating import Button, document, opened, simulated
from window import press, wait


def test_reports_and_frames_are_written(document, opened, tmp_path):
    panel = simulated(document, opened, tmp_path, target=False, cell=0.5)
    panel.write_report(str(tmp_path / "report.html"))
    wait(lambda: panel.task is None)
    assert "rapid contact" in (tmp_path / "report.html").read_text() and "written" in panel.message.text()
    panel.write_frames(str(tmp_path / "frames"), 2)
    wait(lambda: panel.task is None)
    assert sorted(p.name for p in (tmp_path / "frames").iterdir()) == ["frame_0001.png", "frame_0002.png"]
    press(Button.Ok)
