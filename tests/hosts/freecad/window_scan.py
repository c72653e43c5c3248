"""Runs inside FreeCAD's window: the panel of a scan, from the import to the solid."""

import os
import pathlib
import threading
import time

import FreeCAD
import FreeCADGui
import numpy as np
import pytest
import window
from pointer import drag_arrow
from window import Heartbeat, clock, live, press, wait

from fieldfab_workbench import files, kernel, scans
from fieldfab_workbench.commands import scans as commands
from fieldfab_workbench.objects import scan
from fieldfab_workbench.panels import scan_panel
from fieldfab_workbench.shim import QtCore, QtGui, QtWidgets

CT = pathlib.Path(__file__).resolve().parents[2] / "data" / "ct"
Button = QtWidgets.QDialogButtonBox


@pytest.fixture
def opened(monkeypatch):
    """Collects the opened scan panels, newest last."""
    made = []
    real = scan_panel.ScanPanel.__init__
    monkeypatch.setattr(scan_panel.ScanPanel, "__init__", lambda self, obj: made.append(self) or real(self, obj))
    return made


def brought(opened, document, path):
    """Returns the panel of an imported file, after its picture is shown."""
    files.insert(str(path), document.Name)
    wait(lambda: opened and opened[-1].overview is not None and opened[-1].work.idle(), what="the overview")
    FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    live(0.2)
    return opened[-1]


def drag(histogram, share):
    """Drags the mouse to a position of the histogram, 0 to 1."""
    at = QtCore.QPointF(share * histogram.width(), histogram.height() / 2)
    for kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseMove, QtCore.QEvent.MouseButtonRelease):
        QtWidgets.QApplication.sendEvent(histogram, QtGui.QMouseEvent(
            kind, at, QtCore.Qt.LeftButton, QtCore.Qt.LeftButton, QtCore.Qt.NoModifier))


def pixels(picture, colour, reach=40):
    """Returns the number of pixels near a colour, of every second pixel in every second row."""
    return sum(abs(c.red() - colour[0]) + abs(c.green() - colour[1]) + abs(c.blue() - colour[2]) < reach
               for y in range(0, picture.height(), 2) for x in range(0, picture.width(), 2)
               for c in [picture.pixelColor(x, y)])


def test_from_import_to_solid(document, opened):
    steps = document.UndoCount
    panel = brought(opened, document, CT / "cthead")
    obj = document.Objects[0]
    assert obj.Mesh.CountFacets == 0, "nothing is computed before OK"
    assert "256 × 256 × 99" in panel.told.text() and "triangles" in panel.estimate.text()
    assert panel.threshold.value() == pytest.approx(43.2, abs=0.5) and not panel.threshold.isEnabled()
    seen = window.shot("scan_automatic")
    assert pixels(seen, (77, 144, 214)) > 100, "what is solid is blue in the histogram"
    shown = panel.estimate.text()
    for step in range(20):
        drag(panel.histogram, 0.2 + 0.02 * step)
        live(0.02)
    wait(panel.work.idle)
    assert (not panel.automatic.isChecked() and panel.threshold.value()
            == pytest.approx(panel.histogram.density_at(0.58 * panel.histogram.width()), abs=1))
    assert panel.estimate.text() != shown, "the picture follows"
    window.shot("scan_bone")
    panel.cropping.setChecked(True)
    panel.crop[3].setValue(128)
    wait(panel.work.idle)
    window.shot("scan_cropped")
    panel.voxel.setValue(3)
    threshold = panel.threshold.value()
    press(Button.Ok)
    assert (obj.isValid() and obj.Triangles > 1000 and obj.Crop == [0, 0, 0, 128, 255, 98]
            and obj.Threshold == pytest.approx(threshold))
    assert obj.Mesh.BoundBox.XMax < 129 and document.UndoCount == steps + 1 and obj.FileState == scan.AS_READ
    window.shot("scan_solid")
    document.undo()
    assert not document.Objects


def test_the_crop_is_dragged(document, opened):
    panel = brought(opened, document, CT / "cthead")
    assert panel.handles is None
    panel.cropping.setChecked(True)
    wait(panel.work.idle)
    FreeCADGui.ActiveDocument.ActiveView.viewFront()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    FreeCADGui.ActiveDocument.ActiveView.getCameraNode().height = 500
    live(0.3)
    spacing = panel.overview.volume.spacing
    drag_arrow(document, panel.handles, 3, -100)
    assert panel.crop[3].value() == pytest.approx(255 - 100 / spacing[0], abs=8)
    drag_arrow(document, panel.handles, 2, -50)
    assert panel.crop[2].value() == pytest.approx(50 / spacing[2], abs=8)
    drag_arrow(document, panel.handles, 0, -400)
    assert panel.crop[0].value() == panel.crop[3].value() - 1, "the crop keeps two samples"
    wait(panel.work.idle)
    window.shot("scan_crop_dragged")
    panel.cropping.setChecked(False)
    live(0.1)
    assert panel.handles is None
    press(Button.Cancel)


def test_the_window_answers_while_a_scan_is_read_and_its_threshold_dragged(document, opened):
    panel = brought(opened, document, CT / "cthead")
    overview, ended = panel.overview, []

    def busy():
        while not ended:
            overview.surface(scans.Cut())

    # Time of software rendering of the view under the same load; it cannot move to another thread.
    other = threading.Thread(target=busy)
    other.start()
    with Heartbeat() as drawing:
        for step in range(20):
            getattr(FreeCADGui.ActiveDocument.ActiveView, ("viewTop", "viewIsometric")[step % 2])()
            live(0.05)
    ended.append(True)
    other.join()
    silence = {"reading": [], "dragging": []}
    for _ in range(3):  # other programs may occupy the processor at times
        panel._read_as = None
        with Heartbeat() as beat:
            panel._changed_file()
            wait(lambda: panel.overview is not None and panel.work.idle())
        silence["reading"].append(beat.longest)
        with Heartbeat() as beat:
            for step in range(20):
                drag(panel.histogram, 0.2 + 0.02 * step)
                live(0.05)
            wait(panel.work.idle)
        silence["dragging"].append(beat.longest)
    asked = clock()
    before = panel.estimate.text()
    drag(panel.histogram, 0.3)
    wait(lambda: panel.estimate.text() != before)
    seen = clock() - asked
    least = {name: min(times) for name, times in silence.items()}
    print(f"longest silence: {least}, drawing alone {drawing.longest:.3f} s; threshold to surface {seen:.3f} s")
    assert all(time < 0.1 + drawing.longest for time in least.values()) and seen < 1
    press(Button.Cancel)


def test_cancel_takes_it_back(document, opened):
    panel = brought(opened, document, CT / "engine.nii.gz")
    root = document.Objects[0].ViewObject.RootNode
    before = root.getNumChildren()
    panel.denoise.setCurrentText("median")
    press(Button.Cancel)
    assert not document.Objects and root.getNumChildren() == before - 1


def drop(*paths):
    """Sends the window the events of a drop of files."""
    data = QtCore.QMimeData()
    data.setUrls([QtCore.QUrl.fromLocalFile(str(path)) for path in paths])
    at = QtCore.QPoint(700, 400)
    for event in (QtGui.QDragEnterEvent(at, QtCore.Qt.CopyAction, data, QtCore.Qt.LeftButton, QtCore.Qt.NoModifier),
                  QtGui.QDropEvent(at, QtCore.Qt.CopyAction, data, QtCore.Qt.LeftButton, QtCore.Qt.NoModifier)):
        QtWidgets.QApplication.sendEvent(FreeCADGui.getMainWindow(), event)
    live(0.3)


def test_files_can_be_dropped(document, opened, tmp_path):
    drop(CT / "CT_pitch.nii.gz")
    press(Button.Cancel)
    assert not document.Objects
    opened.clear()
    drop(CT / "CT_pitch.nii.gz")
    wait(lambda: opened and opened[-1].overview is not None and opened[-1].work.idle(),
         what="the panel of what was dropped")
    opened[-1].voxel.setValue(5)
    press(Button.Ok)
    assert [obj.Label for obj in document.Objects] == ["CT_pitch"] and document.Objects[0].isValid()
    (tmp_path / "ball.frep").write_text("sphere(r = 10)")
    (tmp_path / "script.py").write_text(f"open({str(tmp_path / 'ran')!r}, 'w')")
    drop(tmp_path / "ball.frep")
    assert document.Objects[-1].Label == "ball" and document.Objects[-1].isValid() and len(document.Objects) == 2
    document.undo()
    assert len(document.Objects) == 1


def test_the_command_takes_any_slice_of_a_stack(document, opened, monkeypatch):
    monkeypatch.setattr(QtWidgets.QFileDialog, "getOpenFileName", lambda *_: (str(CT / "cthead" / "042.tif"), ""))
    FreeCADGui.runCommand("Fieldfab_ImportScan")
    wait(lambda: opened and opened[-1].overview is not None and opened[-1].work.idle(), what="the overview")
    assert opened[-1].path.text() == str(CT / "cthead") and document.Objects[0].Label == "cthead"
    press(Button.Cancel)
    assert not document.Objects


def test_raw_files_ask_for_what_they_do_not_say(document, opened, tmp_path):
    at = (np.arange(30) - 14.5) * 0.5
    z, y, x = np.meshgrid(at, at, at, indexing="ij")
    ball = np.clip(128 + 100 * (5 - np.sqrt(x * x + y * y + z * z)), 0, 255)
    (tmp_path / "plain.raw").write_bytes(ball.astype("<u2").tobytes())
    files.insert(str(tmp_path / "plain.raw"), document.Name)
    wait(lambda: opened and opened[-1].message.text(), what="the question")
    panel = opened[-1]
    assert panel.raw.isVisible() and not panel.histogram.isVisible()
    for box in panel.samples:
        box.setValue(30)
    panel.type.setCurrentText("uint16")
    panel.own_spacing.setChecked(True)
    for box in panel.spacing:
        box.setValue(0.5)
    wait(lambda: panel.overview is not None and panel.work.idle(), what="the overview")
    assert panel.message.text() == "" and panel.histogram.isVisible()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    window.shot("scan_raw")
    press(Button.Ok)
    obj = document.Objects[0]
    assert (obj.isValid() and obj.Samples == [30, 30, 30]
            and obj.Volume.Value == pytest.approx(4 / 3 * np.pi * 125, rel=0.03))
    kept = obj.MadeFrom
    FreeCADGui.ActiveDocument.setEdit(obj.Name)
    wait(lambda: opened[-1] is not panel and opened[-1].overview is not None and opened[-1].work.idle())
    press(Button.Ok)
    assert obj.MadeFrom == kept, "looking changes nothing"


def test_distance_fields_have_a_plain_panel(document, opened, tmp_path):
    kernel.load().build(kernel.load().parse("sphere(r = 5)"), voxel=0.5).save(tmp_path / "ball.asdf")
    files.insert(str(tmp_path / "ball.asdf"), document.Name)
    live(0.5)
    assert not opened[-1].histogram.isVisible() and "distance field" in opened[-1].told.text()
    press(Button.Ok)
    assert document.Objects[0].isValid() and document.Objects[0].Volume.Value == pytest.approx(523.6, rel=0.02)


def test_a_missing_file_is_found_again(document, opened, tmp_path):
    path = tmp_path / "pitch.nii.gz"
    path.write_bytes((CT / "CT_pitch.nii.gz").read_bytes())
    panel = brought(opened, document, path)
    panel.voxel.setValue(4)
    press(Button.Ok)
    obj = document.Objects[0]
    triangles = obj.Triangles
    document.saveAs(str(tmp_path / "part.FCStd"))
    name, made = obj.Name, document.Name
    FreeCAD.closeDocument(made)
    os.rename(path, tmp_path / "found.nii.gz")
    again = FreeCAD.openDocument(str(tmp_path / "part.FCStd"))
    obj = again.getObject(name)
    live(0.3)
    assert obj.FileState == scan.MISSING and obj.Triangles == triangles == obj.Mesh.CountFacets
    assert obj.ViewObject.Proxy.getIcon().endswith("ScanMissing.svg")
    FreeCADGui.getDocument(again.Name).setEdit(name)
    live(0.3)
    panel = opened[-1]
    assert "missing" in panel.message.text()
    window.shot("scan_missing")
    panel.choose(str(tmp_path / "found.nii.gz"))
    wait(lambda: panel.overview is not None and panel.work.idle())
    press(Button.Ok)
    assert (obj.isValid() and obj.FileState == scan.AS_READ
            and not obj.ViewObject.Proxy.getIcon().endswith("ScanMissing.svg"))


def test_ok_computes_beside_the_window(document, opened):
    panel = brought(opened, document, CT / "engine.nii.gz")
    panel.denoise.setCurrentIndex(panel.denoise.findData("median"))
    panel.voxel.setValue(0.5)  # so that the solid takes longer than the pictures below, however fast the machine is
    wait(panel.work.idle, what="the picture")
    [box] = [box for box in FreeCADGui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox) if box.isVisible()]
    box.button(Button.Ok).click()
    assert panel.making is not None and panel.bar_of_making.isVisible()
    live(0.3)
    window.shot("scan_making")
    assert QtWidgets.QApplication.activeModalWidget() is None and not document.Objects[0].MadeFrom
    wait(lambda: not FreeCADGui.Control.activeDialog(), "the solid")
    assert document.Objects[0].isValid() and document.Objects[0].Triangles > 10_000 and document.UndoCount == 1


def test_a_cancelled_recompute_keeps_the_solid(document, opened):
    panel = brought(opened, document, CT / "engine.nii.gz")
    panel.voxel.setValue(6)
    press(Button.Ok)
    obj = document.Objects[0]
    volume, triangles = obj.Volume.Value, obj.Triangles
    obj.Denoise, obj.VoxelSize = "median", 0.5
    seen = []

    def look():
        for dialog in FreeCADGui.getMainWindow().findChildren(QtWidgets.QProgressDialog):
            if dialog.isVisible() and not dialog.wasCanceled():
                seen.append(time.monotonic())
                dialog.cancel()

    timer = QtCore.QTimer()
    timer.timeout.connect(look)
    timer.start(800)
    with Heartbeat() as beat:
        document.recompute()
    ended = time.monotonic()
    timer.stop()
    assert seen and not obj.isValid() and "cancelled" in obj.getStatusString()
    assert obj.Volume.Value == volume and obj.Triangles == triangles == obj.Mesh.CountFacets
    print(f"cancelled within {1000 * (ended - seen[0]):.0f} ms, longest silence {1000 * beat.longest:.0f} ms")
    obj.Denoise, obj.VoxelSize = "none", 6
    document.recompute()
    assert obj.isValid() and obj.Triangles == triangles


def test_a_file_that_is_no_volume_is_told(document, opened, tmp_path):
    (tmp_path / "nothing.nrrd").write_text("nonsense")
    files.insert(str(tmp_path / "nothing.nrrd"), document.Name)
    wait(lambda: opened and opened[-1].message.text(), what="the message")
    assert "nothing.nrrd" in opened[-1].message.text()
    press(Button.Cancel)
    assert not document.Objects


def test_a_script_runs_only_after_yes(document, tmp_path, monkeypatch):
    script = tmp_path / "part.py"
    script.write_text("import pathlib, fieldfab as ff\npathlib.Path(__file__).with_suffix('.ran').touch()\n"
                      "solid = ff.shapes.sphere(5)\n")
    monkeypatch.setattr(QtWidgets.QFileDialog, "getOpenFileName", lambda *_: (str(script), ""))
    asked = []
    for answer, ran in ((QtWidgets.QMessageBox.No, False), (QtWidgets.QMessageBox.Yes, True)):
        monkeypatch.setattr(QtWidgets.QMessageBox, "question", lambda *a, answer=answer: asked.append(a[2]) or answer)
        FreeCADGui.runCommand("Fieldfab_RunScript")
        assert (tmp_path / "part.ran").exists() == ran
    assert (len(asked) == 2 and str(script) in asked[0]
            and document.Objects[0].Volume.Value == pytest.approx(523.6, rel=0.02))
    script.write_text("import fieldfab as ff\nff.part(ff.shapes.sphere(5), 'ball', 'red')\n"
                      "ff.part(ff.shapes.box(1, 2, 3), 'box')\n")
    group = commands.add_script(str(script))
    assert [(part.Label, round(part.Volume.Value)) for part in group.Group] == [
        ("ball", pytest.approx(524, abs=5)), ("box", 6)]
    assert group.Group[0].ViewObject.ShapeColor[:3] == (1.0, 0.0, 0.0)
    script.write_text("import fieldfab\nsolid = 1 / 0\n")
    with pytest.raises(ValueError, match=r"part.py:2: ZeroDivisionError"):
        commands.add_script(str(script))


