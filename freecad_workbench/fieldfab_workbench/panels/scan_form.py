"""Widgets of a scan's panel, and their values."""

import FreeCAD

from .. import scans
from ..shim import QtWidgets
from ..words import tr
from .choices import offer
from .edit_panel import EditPanel
from .histogram import Histogram
from .measures import MeasureBox, place_boxes


class ScanForm(EditPanel):
    """From top to bottom: file, histogram and threshold, lattice, clean-up, outcome."""

    def __init__(self, obj):
        super().__init__(obj, tr("Scan"))
        self._add_file_rows()
        self._add_threshold_rows()
        self._add_lattice_rows()
        self._add_cleaning_rows()
        self._add_outcome_rows()
        self.fill()

    def _add_file_rows(self):
        self.path = QtWidgets.QLineEdit()
        self.path.setPlaceholderText(tr("file, or folder of slices"))
        file, folder = QtWidgets.QPushButton(tr("File…")), QtWidgets.QPushButton(tr("Folder…"))
        file.clicked.connect(self.browse_file)
        folder.clicked.connect(self.browse_folder)
        self.layout.addWidget(self.path)
        self.layout.addWidget(_in_a_row([file, folder]))
        self.told = QtWidgets.QLabel()
        self.told.setWordWrap(True)
        self.layout.addWidget(self.told)
        self.layout.addWidget(self.message)
        self.raw, form = self._group(tr("Raw file"))
        self.samples = [_count_box(0, 100000) for _ in range(3)]
        self.type = QtWidgets.QComboBox()
        offer(self.type, scans.SAMPLE_TYPES, scans.SAMPLE_TYPES[0])
        self.type.setMinimumContentsLength(8)
        self.type.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self.series = QtWidgets.QLineEdit()
        form.addRow(QtWidgets.QLabel(tr("Samples along x, y, z")))
        form.addRow(_in_a_row(self.samples))
        form.addRow(tr("Type"), self.type)
        form.addRow(tr("Series"), self.series)

    def _add_threshold_rows(self):
        self.histogram = Histogram()
        self.layout.addWidget(self.histogram)
        self.automatic, self.below = QtWidgets.QCheckBox(tr("Automatic")), QtWidgets.QCheckBox(tr("Below it"))
        self.automatic.setToolTip(tr("Halfway between the two most frequent densities, air and material"))
        self.below.setToolTip(tr("Densities below the threshold are solid"))
        self.threshold = _number_box(-1e9, 1e9, 3)
        self.layout.addWidget(_in_a_row([QtWidgets.QLabel(tr("Threshold")), self.threshold]))
        self.layout.addWidget(_in_a_row([self.automatic, self.below]))

    def _add_lattice_rows(self):
        form = QtWidgets.QFormLayout()
        self.own_spacing = QtWidgets.QCheckBox(tr("Other spacing"))
        self.spacing = place_boxes((1, 1, 1), 1e-6)
        self.cropping = QtWidgets.QCheckBox(tr("Crop (first, last sample)"))
        self.crop = [_count_box(0, 100000) for _ in range(6)]
        self.voxel = MeasureBox(zero=tr("as the samples"))
        form.addRow(self.own_spacing)
        self.spacing_row = _in_a_row(self.spacing)
        form.addRow(self.spacing_row)
        form.addRow(self.cropping)
        self.crop_rows = [_in_a_row(self.crop[:3]), _in_a_row(self.crop[3:])]
        for row in self.crop_rows:
            form.addRow(row)
        form.addRow(tr("Smallest cell"), self.voxel)
        self.layout.addLayout(form)

    def _add_cleaning_rows(self):
        self.cleaning, form = self._group(tr("Clean-up"))
        self.denoise = QtWidgets.QComboBox()
        offer(self.denoise, scans.DENOISING, scans.DENOISING[0])
        self.largest = QtWidgets.QCheckBox(tr("Largest piece only"))
        self.island, self.hole = (MeasureBox(unit="mm³", high=1e9, zero=tr("all")) for _ in range(2))
        self.island.setToolTip(tr("Pieces of less volume are removed"))
        self.hole.setToolTip(tr("Cavities of less volume are filled"))
        form.addRow(tr("Denoise"), self.denoise)
        form.addRow(tr("Remove islands smaller than"), self.island)
        form.addRow(tr("Fill holes smaller than"), self.hole)
        form.addRow(self.largest)

    def _add_outcome_rows(self):
        self.estimate = QtWidgets.QLabel()
        self.estimate.setWordWrap(True)
        self.progress = QtWidgets.QProgressBar()
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
        self.path.setText(obj.Proxy.path(obj))
        for box, value in zip(self.samples, list(obj.Samples) or (0, 0, 0)):
            box.setValue(value)
        self.type.setCurrentIndex(self.type.findData(obj.SampleType))
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
        self.denoise.setCurrentIndex(self.denoise.findData(obj.Denoise))
        self.largest.setChecked(obj.KeepLargest)
        self.island.setValue(obj.SmallestIsland.Value)
        self.hole.setValue(obj.SmallestHole.Value)

    def take_over(self):
        wanted = {
            "File": self.path.text(), "Samples": list(self.dims() or ()), "SampleType": self.type.currentData(),
            "Series": self.series.text(),
            "AutoThreshold": self.automatic.isChecked(), "Threshold": self.threshold.value(),
            "Below": self.below.isChecked(),
            "Spacing": FreeCAD.Vector(*(self.spacing_asked() or (0, 0, 0))), "Crop": list(self.cut().crop or ()),
            "VoxelSize": self.voxel.value(),
            "Denoise": self.denoise.currentData(), "KeepLargest": self.largest.isChecked(),
            "SmallestIsland": self.island.value(), "SmallestHole": self.hole.value(),
        }
        if wanted["File"] == self.obj.Proxy.path(self.obj):
            del wanted["File"]
        for name, value in wanted.items():
            if getattr(getattr(self.obj, name), "Value", getattr(self.obj, name)) != value:
                setattr(self.obj, name, value)

    def file(self):
        raw = self.type.currentIndex()
        return scans.ScanFile(self.path.text(), self.dims(), scans.SAMPLE_TYPES[raw] if raw else "", None,
                              self.series.text())

    def cut(self):
        crop = tuple(box.value() for box in self.crop) if self.cropping.isChecked() else ()
        return scans.Cut(None if self.automatic.isChecked() else self.threshold.value(), self.below.isChecked(),
                         crop if any(crop) else None,
                         self.denoise.currentData() if self.denoise.currentIndex() else "", self.largest.isChecked(),
                         self.island.value(), self.hole.value())

    def dims(self):
        values = tuple(box.value() for box in self.samples)
        return values if all(values) else None

    def spacing_asked(self):
        return tuple(box.value() for box in self.spacing) if self.own_spacing.isChecked() else None


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


def set_quietly(boxes, values):
    for box, value in zip(boxes, values):
        box.blockSignals(True)
        box.setValue(value)
        box.blockSignals(False)
