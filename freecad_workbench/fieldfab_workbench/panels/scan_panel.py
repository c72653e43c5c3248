"""The task panel of a scan: its file, the threshold over the histogram, what is kept, with a coarse solid in the view meanwhile."""

import os

import FreeCAD
import FreeCADGui

from .. import scans
from ..newest import Newest
from ..objects.scan import MISSING, Scan
from ..shim import QtWidgets
from ..views.coin_mesh import smooth_normals
from ..views.scan_preview import ScanPreview
from .edit_panel import EditPanel
from .histogram import Histogram

RAW = (".raw", ".vol", ".dcm")  # whose type or size the file itself may not tell


class ScanPanel(EditPanel):
    def __init__(self, obj):
        super().__init__(obj, "Scan")
        self.overview = self._read_as = None
        self.unread = False  # whether the file was refused as it is
        self._had_crop = bool(obj.Crop)
        FreeCADGui.Selection.clearSelection()  # its green would cover the picture
        self.preview = ScanPreview(obj)
        self.work = Newest(self._failed, self._show_progress)
        self._add_file_rows()
        self._add_threshold_rows()
        self._add_lattice_rows()
        self._add_cleaning_rows()
        self._add_outcome_rows()
        self.fill()
        self._connect()
        self.form.destroyed.connect(self.work.stop)  # whoever closes it
        self._changed_file()

    # Widgets.
    def _add_file_rows(self):
        self.path = QtWidgets.QLineEdit()
        self.path.setPlaceholderText("file, or folder of slices")
        file, folder = QtWidgets.QPushButton("File…"), QtWidgets.QPushButton("Folder…")
        file.clicked.connect(lambda: self.choose(QtWidgets.QFileDialog.getOpenFileName(self.form, "CT volume", self._folder())[0]))
        folder.clicked.connect(lambda: self.choose(QtWidgets.QFileDialog.getExistingDirectory(self.form, "Folder of slices", self._folder())))
        self.layout.addWidget(self.path)
        self.layout.addWidget(_in_a_row([file, folder]))
        self.told = QtWidgets.QLabel()
        self.told.setWordWrap(True)
        self.layout.addWidget(self.told)
        self.layout.addWidget(self.message)
        self.raw, form = self._group("Raw file")
        self.samples = [_count_box(0, 100000) for _ in range(3)]
        self.type = QtWidgets.QComboBox()
        self.type.addItems(scans.SAMPLE_TYPES)
        self.type.setMinimumContentsLength(8)
        self.type.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self.series = QtWidgets.QLineEdit()
        form.addRow(QtWidgets.QLabel("Samples along x, y, z"))
        form.addRow(_in_a_row(self.samples))
        form.addRow("Type", self.type)
        form.addRow("Series", self.series)

    def _add_threshold_rows(self):
        self.histogram = Histogram()
        self.layout.addWidget(self.histogram)
        self.automatic, self.below = QtWidgets.QCheckBox("Automatic"), QtWidgets.QCheckBox("Below it")
        self.automatic.setToolTip("Halfway between the two commonest densities, air and material")
        self.below.setToolTip("What is less dense than the threshold is solid")
        self.threshold = _number_box(-1e9, 1e9, 3)
        self.layout.addWidget(_in_a_row([QtWidgets.QLabel("Threshold"), self.threshold]))
        self.layout.addWidget(_in_a_row([self.automatic, self.below]))

    def _add_lattice_rows(self):
        form = QtWidgets.QFormLayout()
        self.own_spacing = QtWidgets.QCheckBox("Other spacing (mm)")
        self.spacing = [_number_box(1e-6, 1e6, 4) for _ in range(3)]
        self.cropping = QtWidgets.QCheckBox("Crop (first, last sample)")
        self.crop = [_count_box(0, 100000) for _ in range(6)]
        self.voxel = _number_box(0, 1e6, 4)
        self.voxel.setSpecialValueText("as the samples")
        self.voxel.setSuffix(" mm")
        form.addRow(self.own_spacing)
        self.spacing_row = _in_a_row(self.spacing)
        form.addRow(self.spacing_row)
        form.addRow(self.cropping)
        self.crop_rows = [_in_a_row(self.crop[:3]), _in_a_row(self.crop[3:])]
        for row in self.crop_rows:
            form.addRow(row)
        form.addRow("Smallest cell", self.voxel)
        self.layout.addLayout(form)

    def _add_cleaning_rows(self):
        self.cleaning, form = self._group("Clean-up")
        self.denoise = QtWidgets.QComboBox()
        self.denoise.addItems(scans.DENOISING)
        self.largest = QtWidgets.QCheckBox("Largest piece only")
        self.island, self.hole = _number_box(0, 1e9, 2), _number_box(0, 1e9, 2)
        for box in (self.island, self.hole):
            box.setSpecialValueText("all")
            box.setSuffix(" mm³")
        self.island.setToolTip("Smaller pieces go")
        self.hole.setToolTip("Smaller cavities are filled")
        form.addRow("Denoise", self.denoise)
        form.addRow("Islands from", self.island)
        form.addRow("Holes from", self.hole)
        form.addRow(self.largest)

    def _add_outcome_rows(self):
        self.estimate = QtWidgets.QLabel()
        self.estimate.setWordWrap(True)
        self.progress = QtWidgets.QProgressBar()
        self.progress.setRange(0, 1000)
        self.progress.setTextVisible(True)
        room = self.progress.sizePolicy()
        room.setRetainSizeWhenHidden(True)
        self.progress.setSizePolicy(room)
        self.progress.hide()
        for widget in (self.estimate, self.progress):
            self.layout.addWidget(widget)
        self.layout.addStretch()

    def _group(self, title):
        group = QtWidgets.QGroupBox(title)
        self.layout.addWidget(group)
        return group, QtWidgets.QFormLayout(group)

    # From the object into the widgets, and back.
    def fill(self):
        obj = self.obj
        self.path.setText(Scan.path(obj.Proxy, obj))
        for box, value in zip(self.samples, list(obj.Samples) or (0, 0, 0)):
            box.setValue(value)
        self.type.setCurrentText(obj.SampleType)
        self.series.setText(obj.Series)
        self.automatic.setChecked(obj.AutoThreshold)
        self.threshold.setValue(obj.Threshold)
        self.below.setChecked(obj.Below)
        self.own_spacing.setChecked(obj.Spacing.Length > 0)
        for box, value in zip(self.spacing, obj.Spacing if obj.Spacing.Length else (1, 1, 1)):
            box.setValue(value)
        self.cropping.setChecked(bool(obj.Crop))
        for box, value in zip(self.crop, list(obj.Crop)):
            box.setValue(value)
        self.voxel.setValue(obj.VoxelSize.Value)
        self.denoise.setCurrentText(obj.Denoise)
        self.largest.setChecked(obj.KeepLargest)
        self.island.setValue(obj.SmallestIsland.Value)
        self.hole.setValue(obj.SmallestHole.Value)

    def take_over(self):
        wanted = {
            "File": self.path.text(), "Samples": list(self._dims() or ()), "SampleType": self.type.currentText(), "Series": self.series.text(),
            "AutoThreshold": self.automatic.isChecked(), "Threshold": self.threshold.value(), "Below": self.below.isChecked(),
            "Spacing": FreeCAD.Vector(*(self._spacing() or (0, 0, 0))), "Crop": list(self.cut().crop or ()), "VoxelSize": self.voxel.value(),
            "Denoise": self.denoise.currentText(), "KeepLargest": self.largest.isChecked(), "SmallestIsland": self.island.value(), "SmallestHole": self.hole.value(),
        }
        if wanted["File"] == self.obj.Proxy.path(self.obj):
            del wanted["File"]
        for name, value in wanted.items():
            if getattr(getattr(self.obj, name), "Value", getattr(self.obj, name)) != value:
                setattr(self.obj, name, value)

    def file(self):
        raw = self.type.currentIndex()
        return scans.ScanFile(self.path.text(), self._dims(), scans.SAMPLE_TYPES[raw] if raw else "", None, self.series.text())

    def cut(self):
        crop = tuple(box.value() for box in self.crop) if self.cropping.isChecked() else ()
        return scans.Cut(None if self.automatic.isChecked() else self.threshold.value(), self.below.isChecked(), crop if any(crop) else None,
                         self.denoise.currentText() if self.denoise.currentIndex() else "", self.largest.isChecked(), self.island.value(), self.hole.value())

    def _dims(self):
        values = tuple(box.value() for box in self.samples)
        return values if all(values) else None

    def _spacing(self):
        return tuple(box.value() for box in self.spacing) if self.own_spacing.isChecked() else None

    def _folder(self):
        return os.path.dirname(self.path.text() or self.document.FileName)

    def choose(self, path):
        """Takes another file or folder; "" takes none."""
        if path:
            from ..files import whole_stack

            self.path.setText(whole_stack(path))
            self._changed_file()

    # What happens when.
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
        """Reads the file's overview, where the file, or how it is read, is another one."""
        file = self.file()
        if file == self._read_as:
            return
        self._read_as, self.overview, self.unread = file, None, False
        if not file.path:
            self.told.setText("Choose a volume's file, or a folder of its slices.")
        elif not os.path.exists(file.path):
            self.say(f"The scan {file.path} is {MISSING}: choose where it is now. The solid keeps the mesh it has.")
        elif file.path.lower().endswith(".asdf"):
            self.told.setText("A distance field: it is taken as it is.")
        else:
            self.say("", True)
            self.told.setText("Reading…")
            self.work.ask(lambda progress: scans.Overview(file, progress), self._opened)
        self._show_rows()

    def _opened(self, overview):
        self.overview, volume = overview, overview.volume
        self.told.setText(f"{_by(volume.size)} samples of {_by(round(s, 4) for s in volume.spacing)} mm, {volume.type}")
        self.histogram.set_densities(overview.counts, overview.edges)
        self.threshold.setSingleStep((overview.edges[-1] - overview.edges[0]) / 200)
        if not self.own_spacing.isChecked():
            _set_quietly(self.spacing, volume.spacing)
        for box, last in zip(self.crop, [n - 1 for n in volume.size] * 2):
            box.setMaximum(last)
        if not self._had_crop:
            _set_quietly(self.crop, (0, 0, 0, *(n - 1 for n in volume.size)))
        self._had_crop = False  # of another file they mean nothing
        self._changed()

    def _changed(self, *_):
        """Shows what the widgets say now."""
        self._show_rows()
        if self.overview is None:
            return
        overview, cut, spacing = self.overview, self.cut(), self._spacing()
        if self.automatic.isChecked():
            _set_quietly([self.threshold], [overview.threshold])
        self.histogram.set_threshold(self.threshold.value(), cut.below)
        self._show_box(cut.crop)
        if cut.crop and any(a >= b for a, b in zip(cut.crop, cut.crop[3:])):
            self.say("The last sample of a crop must lie behind the first.")
            return

        def make(progress):
            mesh, cell = overview.surface(cut, spacing, progress)
            return mesh.vertices, mesh.triangles, smooth_normals(mesh.vertices, mesh.triangles), cell, cut

        self.work.ask(make, self._made)

    def _show_rows(self):
        """Only what means something now."""
        self.threshold.setEnabled(not self.automatic.isChecked())
        for row in self.crop_rows:
            row.setVisible(self.cropping.isChecked())
        self.spacing_row.setVisible(self.own_spacing.isChecked())
        name = self.path.text().lower()
        self.raw.setVisible(name.endswith(RAW) or bool(self.series.text()) or self.unread)
        self.histogram.setVisible(self.overview is not None)
        self.cleaning.setVisible(not name.endswith(".asdf"))

    def _made(self, result):
        vertices, triangles, normals, cell, cut = result
        self.preview.show_surface(vertices, triangles, normals)
        spacing = self._spacing() or self.overview.volume.spacing
        full = self.voxel.value() or min(spacing)
        samples = 1
        for n in cut.cropped(self.overview.volume).size:
            samples *= n
        memory, count = scans.estimate(samples, cut.cleaned(), len(triangles), cell / full)
        self.estimate.setText(f"About {_rounded(count)} triangles, {_rounded(memory / 1e6)} MB")
        self.say("" if len(triangles) else "Nothing is solid at this threshold.", bool(len(triangles)))

    def _show_box(self, crop):
        volume, spacing = self.overview.volume, self._spacing() or self.overview.volume.spacing
        first, last = (crop[:3], crop[3:]) if crop else ((0, 0, 0), [n - 1 for n in volume.size])
        self.preview.show_box(volume, [n * s for n, s in zip(first, spacing)], [n * s for n, s in zip(last, spacing)])

    def _failed(self, error):
        self.say(str(error))
        if self.overview is None:
            self.told.setText("")
            self.unread = True
            self._show_rows()

    def _show_progress(self, fraction, message):
        self.progress.setVisible(fraction is not None and self.overview is None)
        if fraction is not None:
            self.progress.setValue(round(1000 * fraction))
            self.progress.setFormat(f"{message} %p %")

    def accept(self):
        self.work.stop()
        if not self.path.text():
            self.say("Choose a file first, or Cancel.")
            return False
        return super().accept()

    def close(self):
        self.work.stop()
        self.preview.close()
        super().close()


def _number_box(low, high, decimals):
    box = QtWidgets.QDoubleSpinBox()
    box.setMinimumWidth(60)  # a task panel is narrow
    box.setDecimals(decimals)
    box.setRange(low, high)
    return box


def _count_box(low, high):
    box = QtWidgets.QSpinBox()
    box.setMinimumWidth(50)
    box.setRange(low, high)
    return box


def _in_a_row(widgets):
    row = QtWidgets.QWidget()
    layout = QtWidgets.QHBoxLayout(row)
    layout.setContentsMargins(0, 0, 0, 0)
    for widget in widgets:
        layout.addWidget(widget)
    return row


def _set_quietly(boxes, values):
    for box, value in zip(boxes, values):
        box.blockSignals(True)
        box.setValue(value)
        box.blockSignals(False)


def _by(numbers):
    return " × ".join(f"{n:g}" for n in numbers)


def _rounded(number):
    """Two digits: 1,100,000 for 1,054,094."""
    return f"{float(f'{number:.2g}'):,.0f}"
