"""Task panel of a simulation: its set-up and its playback."""

import json
import os

from .. import kernel, meshes, work
from ..objects.simulation import planned_of, verdict
from ..shim import QtCore, QtWidgets, flags
from ..views.part_view import is_there
from ..words import tr
from .edit_panel import EditPanel
from .playback import Playback
from .setup_form import SetupForm

FRAMES = 200  # number of frames of a film
LEAST_HEIGHT = 480  # pixels
AROUND = 190  # pixels of a dock's height outside of the panel


class SimulationPanel(EditPanel):
    def __init__(self, obj):
        super().__init__(obj, tr("Simulation"))
        self.setup, self.playback, self.run, self.task = SetupForm(obj), Playback(self.document), None, None
        self.tabs = QtWidgets.QTabWidget()
        scroll = QtWidgets.QScrollArea()
        scroll.setWidget(self.setup)
        scroll.setWidgetResizable(True)
        scroll.setFrameShape(QtWidgets.QFrame.NoFrame)
        self.tabs.addTab(scroll, tr("Set-up"))
        self.tabs.addTab(self._playback_page(), tr("Playback"))
        self.layout.addWidget(self.tabs, 1)
        self.layout.addLayout(self._start_row())
        self.layout.addWidget(self.message)
        self.playback.said.connect(self.say)
        self.seen_before = obj.ViewObject.Visibility
        obj.Proxy.edited = True
        obj.ViewObject.Visibility = obj.ViewObject.Visibility and bool(obj.MadeFrom)  # not drawn twice
        self.timer = QtCore.QTimer(self.form)
        self.timer.timeout.connect(self._watch)
        self.timer.start(30)
        if obj.Verdict:
            self.playback.events.set_events(self._events())
            self._say_verdict()
        if obj.MadeFrom:
            self.tabs.setCurrentIndex(1)
            self._show_kept()

    def _events(self):
        return [json.loads(line) for line in self.obj.Events]

    def _say_verdict(self):
        self.say(f"{self.obj.Label}: {verdict(self._events(), tr)}", not self.obj.Events)

    # Widgets.
    def _playback_page(self):
        page = QtWidgets.QWidget()
        layout = QtWidgets.QVBoxLayout(page)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.playback, 1)
        row = QtWidgets.QHBoxLayout()
        self.exports = []
        for words, tip, function in (
            (tr("Report…"), tr("Write the report as an HTML page with pictures"), self.ask_for_report),
            (tr("Frames…"), tr("Write pictures for a film"), self.ask_for_frames),
            (tr("Keep as object"), tr("Keep the stock as it is at this moment as a mesh of the document"), self.keep),
        ):
            button = QtWidgets.QPushButton(words)
            button.setToolTip(tip)
            button.clicked.connect(function)
            row.addWidget(button)
            self.exports.append(button)
        layout.addLayout(row)
        self._allow(False)
        return page

    def make_room(self):
        """Also enlarges the dock's height, for the program and its numbers."""
        super().make_room()
        if dock := self.dock():
            self.form.setMinimumHeight(max(LEAST_HEIGHT, dock.height() - AROUND))

    def _start_row(self):
        row = QtWidgets.QHBoxLayout()
        self.start_button = QtWidgets.QPushButton(tr("Simulate"))
        self.start_button.clicked.connect(self.start_or_stop)
        self.bar = QtWidgets.QProgressBar()
        self.carried_out = work.Gauge(self.bar)
        self.bar.setTextVisible(False)
        row.addWidget(self.start_button)
        row.addWidget(self.bar, 1)
        return row

    def _allow(self, playing):
        self.playback.setEnabled(playing)
        for button in self.exports:
            button.setEnabled(playing)

    # Work in the background.
    def start_or_stop(self):
        """Starts the simulation in the background, or stops the running one."""
        if self.task is not None:
            self.task.cancel()
            return
        try:
            self.take_over()
            wanted = self.obj.Proxy.task(self.obj)
        except ValueError as error:
            self.say(str(error))
            return
        self._begin(wanted.run, self._simulated)

    def _begin(self, function, done):
        self.task, self.done = work.Task(function), done
        self.start_button.setText(tr("Stop"))
        self.say("", True)
        self.form.destroyed.connect(self.task.cancel)  # e.g. if the document is closed
        self.task.start()

    def _watch(self):
        if not is_there(self.document):
            self.timer.stop()
            if self.task is not None:
                self.task.cancel()
            return
        if self.task is None:
            return
        self.carried_out.show(self.task.fraction)
        if self.task.is_alive():
            if self.task.message:
                self.say(self.task.message, True)
            return
        task, self.task = self.task, None
        self.carried_out.stop()
        self.start_button.setText(tr("Simulate"))
        try:
            result = task.outcome()
        except work.Cancelled:
            self.say(tr("stopped; the result is unchanged"))
        except (kernel.load().Error, ValueError, OSError) as error:
            self.say(str(error))
        else:
            self.done(result)

    def _simulated(self, run):
        self.document.recompute([self.obj])  # uses the cached run
        if not self.obj.isValid():
            self.say(self.obj.getStatusString())
            return
        self.tabs.setCurrentIndex(1)
        self._play(run)

    def _show_kept(self):
        """Plays the run of this session, if there is one; otherwise asks the user to simulate."""
        try:
            run = self.obj.Proxy.kept_run(self.obj)
        except ValueError as error:
            self.say(str(error))
            return
        if run is not None:
            self._play(run)
        elif not self.obj.Events:
            self.say(tr("press Simulate to play it"), True)

    def _play(self, run):
        self.run = run
        self.obj.ViewObject.Visibility = False  # replaced by the playback
        planned = planned_of(self.obj)
        part = planned.Setup.Part if planned is not None and planned.Setup is not None else None
        self.playback.show(run, run.report["events"], list(filter(None, dict.fromkeys([self.obj.Target or part]))))
        self._allow(True)
        self._say_verdict()

    # Results.
    def ask_for_report(self):
        path = QtWidgets.QFileDialog.getSaveFileName(self.form, tr("Report"), f"{self.obj.Label}.html",
                                                     tr("HTML (*.html)"))[0]
        if path:
            self.write_report(path)

    def write_report(self, path):
        simulation = self.run.simulation
        self._begin(lambda progress: simulation.html(path, progress=progress),
                    lambda result: self.say(tr("written: {path}").format(path=path), True))

    def ask_for_frames(self):
        folder = QtWidgets.QFileDialog.getExistingDirectory(self.form, tr("Folder for frame_0001.png and so on"))
        if folder:
            self.write_frames(folder)

    def write_frames(self, folder, count=FRAMES):
        player, simulation = self.playback.player, self.run.simulation

        def write(progress):
            with player.busy:
                simulation.frames(folder, count=count, progress=progress)

        self._begin(write, lambda result: self.say(
            tr("{count} frames are in {folder}").format(count=count, folder=os.path.basename(folder)), True))

    def keep(self):
        """Adds the stock at the current time to the document, as a mesh."""
        player, seconds = self.playback.player, self.playback.seconds

        def make(progress):
            with player.busy:
                return player.playback.stock_at(seconds, progress=progress).mesh()

        line = self.playback.program.line()
        self._begin(make, lambda mesh: self._kept(mesh, line))

    def _kept(self, mesh, line):
        kept = self.document.addObject("Mesh::Feature", "Stock")
        kept.Label = tr("{label}, stock at line {line}").format(label=self.obj.Label, line=line)
        kept.Mesh = meshes.to_freecad(mesh)
        kept.ViewObject.Visibility = False
        self.say(tr("kept: {label}").format(label=kept.Label), True)

    # FreeCAD's interface of a task panel.
    def take_over(self):
        self.setup.write()

    def apply(self):
        try:
            return super().apply()
        except ValueError as error:
            self.say(str(error))
            return False

    def getStandardButtons(self):
        buttons = QtWidgets.QDialogButtonBox
        return flags(buttons.Ok | buttons.Cancel)

    def close(self):
        self.timer.stop()
        if self.task is not None:
            self.task.cancel()
        self.playback.end()
        if self.obj in self.document.Objects:
            self.obj.ViewObject.Visibility = self.seen_before
            self.obj.Proxy.edited = False
        super().close()
