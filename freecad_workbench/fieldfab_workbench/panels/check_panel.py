"""Cross-check of a solid against OpenVDB and CGAL: a table of results, and the mesh coloured by its deviations."""

import csv
import io

import FreeCADGui
import numpy as np

from ..kernel_messages import translated
from .. import kernel, meshes, units
from ..certainty import is_uncertain, with_doubt
from ..deviations import colours, deviations, nice_reach
from ..icons import icon
from ..newest import Newest
from ..objects.solid import source_of
from ..shim import QtCore, QtGui, QtWidgets, flags
from ..sources import with_cell
from ..views.coin_mesh import MeshBytes
from ..views.deviation_view import DeviationView
from ..words import marked, tr
from ..work import Gauge
from .edit_panel import COLOURS

HEADINGS = ("", marked("Measured value and its bound"))


class CheckPanel:
    """Panel that runs the check in the background while it is open. It does not change the document."""

    def __init__(self, obj):
        self.obj, self.report, self.coloured, self.shown = obj, None, None, None
        FreeCADGui.Selection.clearSelection()  # the selection's green would hide the colours
        self.form = QtWidgets.QWidget()
        self.form.setWindowTitle(tr("Cross-check"))
        self.form.setWindowIcon(FreeCADGui.getIcon(icon("CrossCheck")))  # Qt alone may lack its plugin for SVG
        layout = QtWidgets.QVBoxLayout(self.form)
        self.verdict = QtWidgets.QLabel(tr("Checking {label} against OpenVDB and CGAL…").format(label=obj.Label))
        self.verdict.setWordWrap(True)
        self.progress = QtWidgets.QProgressBar()
        self.gauge = Gauge(self.progress)
        self.table = QtWidgets.QTableWidget(0, len(HEADINGS))
        self.table.setHorizontalHeaderLabels([heading and tr(heading) for heading in HEADINGS])
        self.table.verticalHeader().hide()
        self.table.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self.table.horizontalHeader().setSectionResizeMode(0, QtWidgets.QHeaderView.ResizeToContents)
        self.table.horizontalHeader().setSectionResizeMode(1, QtWidgets.QHeaderView.Stretch)
        self.table.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.table.setMinimumHeight(260)
        self.colour = QtWidgets.QCheckBox(tr("Deviations in colours"))
        self.colour.setChecked(True)
        self.colour.setEnabled(False)
        self.colour.toggled.connect(self._show_colours)
        self.figures = QtWidgets.QLabel()
        self.figures.setWordWrap(True)
        self.save = QtWidgets.QPushButton(tr("Save table…"))
        self.save.setEnabled(False)
        self.save.clicked.connect(self._save)
        for widget in (self.verdict, self.progress, self.table, self.colour, self.figures, self.save):
            layout.addWidget(widget)
        self.work = Newest(self._failed, self._show_progress)
        self.form.destroyed.connect(self.work.stop)
        self._start()

    def _start(self):
        fieldfab, obj = kernel.load(), self.obj
        try:
            source, settings = source_of(obj, placed=False), obj.Proxy.mesh_settings(obj)
        except ValueError as error:
            self._failed(error)
            return
        mesh = obj.Mesh.copy()
        mesh.Placement = type(mesh.Placement)()
        data = meshes.bms_of(mesh)

        def colour(progress):
            shape = meshes.from_bms(data)
            vertices, triangles = shape.vertices, shape.triangles
            off = deviations(source.field(progress), vertices, triangles)
            reach = nice_reach(off)
            return MeshBytes(vertices, triangles, flat=True, colours=colours(off / reach)), reach, off

        def check(progress):
            field = source.field(progress)
            return fieldfab.check(field, progress=progress, **with_cell(field, **settings))

        def coloured(result):
            self.work.ask(check, self._checked)
            self.coloured = result
            off = result[-1]
            self.figures.setText(tr("Mesh to solid: {mean} on average, {most} at most.").format(
                mean=units.told(np.abs(off).mean(), digits=3), most=units.told(np.abs(off).max(), digits=3)))
            self.colour.setEnabled(True)
            self._show_colours()

        self.work.ask(colour, coloured)

    def _checked(self, report):
        self.report = report
        broken = [row for row in report.rows if not row.passed]
        words = tr("{broken} of {count} checks are broken.") if broken else tr("All {count} checks are passed.")
        words, good = words.format(broken=len(broken), count=len(report.rows)), not broken
        if good and is_uncertain(self.obj):
            words, good = with_doubt(words, self.obj.Certainty)
        self.verdict.setText(units.in_words(words))
        self.verdict.setStyleSheet(f"color: {COLOURS[good]}")
        self.table.setRowCount(len(report.rows))
        for i, row in enumerate(report.rows):
            figures = tr("{measured} of {bound}").format(measured=f"{units.shown(row.measured, row.unit):.4g}",
                                                         bound=units.told(row.bound, row.unit))
            texts = ("✓" if row.passed else "✗", f"{row.name}\n{figures}")
            for column, text in enumerate(texts):
                item = QtWidgets.QTableWidgetItem(text.strip())
                item.setToolTip(row.name)
                if column == 0:
                    item.setForeground(QtGui.QColor(COLOURS[row.passed]))
                self.table.setItem(i, column, item)
        self.save.setEnabled(True)
        QtCore.QTimer.singleShot(0, self.table.resizeRowsToContents)  # after the columns have got their widths

    def _show_colours(self, *_):
        if self.shown is not None:
            self.shown.close()
            self.shown = None
        if self.coloured is not None and self.colour.isChecked():
            self.shown = DeviationView(self.obj, *self.coloured[:-1])

    def _failed(self, error):
        self.verdict.setText(units.in_words(translated(str(error))))
        self.verdict.setStyleSheet(f"color: {COLOURS[False]}")

    def _show_progress(self, fraction, message):
        self.progress.setVisible(fraction is not None)
        if fraction is not None:
            self.gauge.show(fraction)
            self.progress.setFormat(message or "%p %")

    def text(self):
        """Returns the table as comma-separated values."""
        out = io.StringIO()
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(("check", "measured", "bound", "unit", "passed"))
        for row in self.report.rows:
            writer.writerow((row.name, repr(row.measured), repr(row.bound), row.unit, "yes" if row.passed else "no"))
        return out.getvalue()

    def _save(self):
        kinds = tr("Comma-separated values (*.csv);;Text (*.txt)")
        path = QtWidgets.QFileDialog.getSaveFileName(self.form, tr("Save table"), f"{self.obj.Label}.csv", kinds)[0]
        if path:
            try:
                kernel.write_file(path, self.text())
            except OSError as error:
                self._failed(error)

    # FreeCAD's interface of a task panel.
    def getStandardButtons(self):
        return flags(QtWidgets.QDialogButtonBox.Close)

    def reject(self):
        self.work.stop()
        self.coloured = None
        self._show_colours()
        FreeCADGui.Control.closeDialog()
        return True
