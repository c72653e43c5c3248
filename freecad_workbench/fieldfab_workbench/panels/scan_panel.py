"""Task panel of a scan: its file, the threshold in the histogram, and clean-up. The 3D view previews a coarse solid."""

import math
import os

import FreeCADGui

from .. import scans, units
from ..files import whole_stack
from ..newest import Newest
from ..shim import QtWidgets
from ..views.coin_mesh import MeshBytes
from ..views.scan_preview import ScanPreview
from ..words import tr
from ..work import Gauge
from .scan_form import ScanForm, set_quietly
from .scan_handles import handles_of

RAW = (".raw", ".vol", ".dcm")  # files that may lack the sample type or the size


class ScanPanel(ScanForm):
    def __init__(self, obj):
        super().__init__(obj)
        self.overview = self._read_as = None
        self.unread = False  # whether reading the file failed
        self._had_crop = bool(obj.Crop)
        self._unseen = obj.Mesh.CountFacets == 0
        FreeCADGui.Selection.clearSelection()  # the selection's green would hide the preview
        self.preview, self.handles, self._handles_are_for = ScanPreview(obj), None, None
        self.work, self.reading = Newest(self._failed, self._show_progress), Gauge(self.progress)
        self.form.destroyed.connect(self.work.stop)  # however the form is closed
        self.form.destroyed.connect(self._remove_handles)
        self._connect()
        self._changed_file()

    # The file.
    def browse_file(self):
        self.choose(QtWidgets.QFileDialog.getOpenFileName(self.form, tr("CT volume"), self._folder())[0])

    def browse_folder(self):
        self.choose(QtWidgets.QFileDialog.getExistingDirectory(self.form, tr("Folder of slices"), self._folder()))

    def _folder(self):
        return os.path.dirname(self.path.text() or self.document.FileName)

    def choose(self, path):
        """Sets another file or folder. "" changes nothing."""
        if path:
            self.path.setText(whole_stack(path))
            self._changed_file()

    # Signals.
    def _connect(self):
        self.path.editingFinished.connect(self._changed_file)
        self.type.currentIndexChanged.connect(self._changed_file)
        for box in self.samples:
            box.editingFinished.connect(self._changed_file)
        self.series.editingFinished.connect(self._changed_file)
        self.histogram.dragged.connect(self._dragged)
        self.threshold.valueChanged.connect(self._typed_threshold)
        for box in (self.automatic, self.below, self.own_spacing, self.cropping, self.largest):
            box.toggled.connect(self._changed)
        for box in (*self.spacing, *self.crop, self.voxel, self.island, self.hole):
            box.valueChanged.connect(self._changed)
        self.denoise.currentIndexChanged.connect(self._changed)

    def _dragged(self, density):
        self.automatic.setChecked(False)
        self.threshold.setValue(density)

    def _typed_threshold(self):
        if not self.automatic.isChecked():
            self._changed()

    def _changed_file(self, *_):
        """Reads the file's overview if the file or its reading parameters have changed."""
        file = self.file()
        if file == self._read_as:
            return
        self._read_as, self.overview, self.unread = file, None, False
        if not file.path:
            self.told.setText(tr("Choose a volume's file, or a folder of its slices."))
        elif not os.path.exists(file.path):
            self.say(tr("The scan {path} is missing: choose where it is now. The solid keeps the mesh it has.").format(
                path=file.path))
        elif file.path.lower().endswith(".asdf"):
            self.told.setText(tr("A distance field: it is used unchanged."))
        else:
            self.say("", True)
            self.told.setText(tr("Reading…"))
            self.work.ask(lambda progress: scans.Overview(file, progress), self._opened)
        self._show_rows()

    def _opened(self, overview):
        self.overview, volume = overview, overview.volume
        self.told.setText(tr("{count} samples of {spacing}, {kind}").format(
            count=" × ".join(map(str, volume.size)), spacing=units.told_all(volume.spacing, between=" × "),
            kind=volume.type))
        self.histogram.set_densities(overview.counts, overview.edges)
        self.threshold.setSingleStep((overview.edges[-1] - overview.edges[0]) / 200)
        if not self.own_spacing.isChecked():
            set_quietly(self.spacing, volume.spacing)
        for box, last in zip(self.crop, [n - 1 for n in volume.size] * 2):
            box.setMaximum(last)
        if not self._had_crop:
            set_quietly(self.crop, (0, 0, 0, *(n - 1 for n in volume.size)))
        self._had_crop = False  # the crop is meaningless for another file
        self._changed()

    def _changed(self, *_):
        """Updates the preview from the widgets."""
        self._show_rows()
        if self.overview is None:
            return
        overview, cut, spacing = self.overview, self.cut(), self.spacing_asked()
        if self.automatic.isChecked():
            set_quietly([self.threshold], [overview.threshold])
        self.histogram.set_threshold(self.threshold.value(), cut.below)
        self._show_box(cut.crop)
        self._show_handles(spacing)
        if cut.crop and any(a >= b for a, b in zip(cut.crop, cut.crop[3:])):
            self.say(tr("The last sample of a crop must lie after the first."))
            return

        def make(progress):
            mesh, cell = overview.surface(cut, spacing, progress)
            return MeshBytes(mesh.vertices, mesh.triangles), cell, cut

        self.work.ask(make, self._made)

    def _show_rows(self):
        """Shows only the rows that apply."""
        self.threshold.setEnabled(not self.automatic.isChecked())
        for row in self.crop_rows:
            row.setVisible(self.cropping.isChecked())
        self.spacing_row.setVisible(self.own_spacing.isChecked())
        name = self.path.text().lower()
        self.raw.setVisible(name.endswith(RAW) or bool(self.series.text()) or self.unread)
        self.histogram.setVisible(self.overview is not None)
        self.cleaning.setVisible(not name.endswith(".asdf"))

    def _made(self, result):
        surface, cell, cut = result
        self.preview.show_surface(surface)
        if self._unseen and surface.count:
            self._unseen = False
            FreeCADGui.SendMsgToActiveView("ViewFit")
        spacing = self.spacing_asked() or self.overview.volume.spacing
        full = self.voxel.value() or min(spacing)
        samples = math.prod(cut.cropped(self.overview.volume).size)
        memory, count = scans.estimate(samples, cut.cleaned(), surface.count, cell / full)
        self.estimate.setText(
            tr("About {count} triangles, {memory} MB").format(count=_rounded(count), memory=_rounded(memory / 1e6)))
        self.say("" if surface.count else tr("There is no solid at this threshold."), surface.count > 0)

    def _show_box(self, crop):
        volume, spacing = self.overview.volume, self.spacing_asked() or self.overview.volume.spacing
        first, last = (crop[:3], crop[3:]) if crop else ((0, 0, 0), [n - 1 for n in volume.size])
        self.preview.show_box(volume, [n * s for n, s in zip(first, spacing)], [n * s for n, s in zip(last, spacing)])

    def _show_handles(self, spacing):
        """Shows arrows while the scan is cropped."""
        wanted = (self.overview, spacing) if self.cropping.isChecked() else None
        if wanted != self._handles_are_for:
            self._remove_handles()
            self.handles, self._handles_are_for = handles_of(self) if wanted else None, wanted
        elif self.handles:
            self.handles.refresh()

    def _remove_handles(self):
        if self.handles:
            self.handles.close()
        self.handles = self._handles_are_for = None

    def _failed(self, error):
        self.say(str(error))
        if self.overview is None:
            self.told.setText("")
            self.unread = True
            self._show_rows()

    def _show_progress(self, fraction, message):
        self.progress.setVisible(fraction is not None and self.overview is None)
        if fraction is not None:
            self.reading.show(fraction)
            self.progress.setFormat(f"{message} %p %")

    def accept(self):
        self.work.stop()
        if not self.path.text():
            self.say(tr("Choose a file first, or Cancel."))
            return False
        return super().accept()

    def reject(self):
        """Reverts the changes. Removes a scan that was never computed explicitly, because FreeCAD's import may have
        ended the undo step."""
        document, name = self.document, self.obj.Name
        document.abortTransaction()
        self.close()
        left = document.getObject(name)
        if left is not None and not left.MadeFrom:
            document.removeObject(name)
        document.recompute()
        return True

    def close(self):
        self.work.stop()
        self.preview.close()
        self._remove_handles()
        super().close()


def _rounded(number):
    """Formats with two significant digits: 1,100,000 for 1,054,094."""
    return f"{float(f'{number:.2g}'):,.0f}"
