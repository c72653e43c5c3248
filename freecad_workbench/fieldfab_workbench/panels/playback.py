"""Playback of a simulation in the 3D view: stock, tool and axes at any time, the program's lines, and the events."""

import math
import time

import numpy as np

from .. import units
from ..shim import QtCore, QtGui, QtWidgets
from ..views.legend import ColourLegend, ScaleLegend
from ..views.part_view import PartView, is_there
from ..views.player import Player
from ..views.program_view import COLOURS, RAPID_COLOUR, lines
from ..views.stock_scene import StockScene
from ..words import tr
from .event_list import EventList
from .program_view import ProgramView

TICK = 20  # ms
STEPS = 100000  # positions of the slider
SPEEDS = (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000)
ABOUT = 40  # approximate duration of a program at the initial speed, seconds


def clock(seconds):
    """Formats seconds as minutes and seconds: 1:02.3"""
    return f"{int(seconds // 60)}:{seconds % 60:04.1f}"


def _is_in_the_way(obj):
    """Returns whether it is a solid, a path or a machine program, which would overlap with the stock."""
    kind = getattr(getattr(obj, "Proxy", None), "NAME", "")
    return (kind == "MachineProgram" or any(hasattr(obj, name) for name in ("Mesh", "Shape", "Path"))
            and hasattr(obj.ViewObject, "Visibility"))


class Playback(QtWidgets.QWidget):
    """Controls of the playback. `show(run, events)` starts it, `end()` removes everything from the 3D view. `said`
    emits a line for the user, and whether it is a success."""

    said = QtCore.Signal(str, bool)

    def __init__(self, document):
        super().__init__()
        self.document, self.player, self.scene, self.legend, self.colours = document, None, None, None, None
        self.parts, self._hidden = [], []
        self.seconds, self.playing, self.shown = 0.0, False, 0
        self.layout_ = QtWidgets.QVBoxLayout(self)
        self.layout_.setContentsMargins(0, 4, 0, 0)
        self._add_transport()
        self._add_places()
        self._add_choices()
        self.program, self.events = ProgramView(), EventList()
        both = QtWidgets.QSplitter(QtCore.Qt.Vertical)
        both.addWidget(self.program)
        both.addWidget(self.events)
        both.setSizes([230, 150])
        self.layout_.addWidget(both, 1)
        self.program.asked.connect(self.go_to_line)
        self.events.chosen.connect(self.go_to_event)
        self.timer = QtCore.QTimer(self)
        self.timer.timeout.connect(self._tick)

    # Widgets.
    def _add_transport(self):
        row, style = QtWidgets.QHBoxLayout(), self.style()
        self.buttons = {}
        for name, picture, tip, function in (
            ("first", "SP_MediaSkipBackward", tr("To the beginning"), lambda: self.go_to(0)),
            ("back", "SP_MediaSeekBackward", tr("Previous move"), lambda: self.step(-1)),
            ("play", "SP_MediaPlay", tr("Play or pause"), self.toggle),
            ("on", "SP_MediaSeekForward", tr("Next move"), lambda: self.step(1)),
            ("last", "SP_MediaSkipForward", tr("To the end"), lambda: self.go_to(self.player.length)),
        ):
            button = QtWidgets.QToolButton()
            button.setIcon(style.standardIcon(getattr(QtWidgets.QStyle, picture)))
            button.setToolTip(tip)
            button.setAutoRaise(True)
            button.clicked.connect(function)
            row.addWidget(button)
            self.buttons[name] = button
        self.speed = QtWidgets.QComboBox()
        for speed in SPEEDS:
            self.speed.addItem(f"{speed}\N{MULTIPLICATION SIGN}", speed)
        self.speed.setToolTip(tr("Speed relative to the machine"))
        self.speed.currentIndexChanged.connect(lambda index: self._start_clock())
        row.addWidget(self.speed)
        row.addStretch()
        self.time = QtWidgets.QLabel()
        row.addWidget(self.time)
        self.layout_.addLayout(row)
        self.slider = QtWidgets.QSlider(QtCore.Qt.Horizontal)
        self.slider.setRange(0, STEPS)
        self.slider.setPageStep(STEPS // 50)
        self.slider.valueChanged.connect(self._slid)
        self.slider.sliderReleased.connect(lambda: self.go_to(self.seconds))
        self.layout_.addWidget(self.slider)

    def _add_places(self):
        row = QtWidgets.QHBoxLayout()
        row.addWidget(QtWidgets.QLabel(tr("Line")))
        self.line = QtWidgets.QSpinBox()
        self.line.setKeyboardTracking(False)
        self.line.setMinimumWidth(90)
        self.line.setToolTip(tr("Go to a line of the program"))
        self.line.valueChanged.connect(self.go_to_line)
        row.addWidget(self.line)
        self.doing = QtWidgets.QLabel()
        row.addWidget(self.doing)
        row.addStretch()
        self.layout_.addLayout(row)
        self.axes, self.axes_row = {}, QtWidgets.QGridLayout()
        self.axes_row.setHorizontalSpacing(6)
        self.axes_row.setVerticalSpacing(2)
        self.layout_.addLayout(self.axes_row)

    def _add_choices(self):
        grid = QtWidgets.QGridLayout()

        def choice(words, tip, on, function, row, column):
            box = QtWidgets.QCheckBox(words)
            box.setToolTip(tip)
            box.setChecked(on)
            box.toggled.connect(function)
            grid.addWidget(box, row, column)
            return box

        self.see_tool = choice(tr("Tool"), tr("Show the cutter"), True, self._show_roles, 0, 0)
        self.see_holder = choice(tr("Shank and holder"), tr(
                                                            "Show the shank and the holder, which must not touch "
                                                            "anything"), True,
                                 self._show_roles, 0, 1)
        self.see_deviation = choice(tr("Deviation at the end"),
                                    tr("Colour the finished stock by its distance from the target"), True,
                                    lambda on: self.go_to(self.seconds), 1, 0)
        self.turning = choice(tr("Table turns"), tr("Turn the stock with the machine's table"), False,
                              lambda on: self._place(), 1, 1)
        self.see_stock = choice(tr("Stock"), tr("Show the stock as it is at this moment"), True,
                                lambda on: self.scene and self.scene.show_stock(on), 2, 0)
        self.see_part = choice(tr("Part"), tr("Show the solid that the program should produce"), False,
                               lambda on: self._show_part(), 2, 1)
        self.see_paths = choice(tr("Paths"), tr("Show the paths of the tool tips, each tool in its colour"), False,
                                lambda on: self._show_paths(), 3, 0)
        self.layout_.addLayout(grid)

    # Beginning and ending.
    def show(self, run, events, parts=()):
        """Starts the playback of an objects.simulation.Run at its end. `parts`: the target objects. Hides other visible
        objects that overlap with the stock until end()."""
        self.end()
        self.parts, self._hidden = (
            list(parts), [obj for obj in self.document.Objects if _is_in_the_way(obj) and obj.ViewObject.Visibility])
        seen = bool(self._hidden)
        for obj in self._hidden:
            obj.ViewObject.Visibility = False
        self.see_part.setEnabled(bool(self.parts))
        self.player, self.scene, self.view = Player(run), StockScene(), PartView(self.document)
        self.destroyed.connect(self.player.close)  # e.g. if the document is closed
        self._tool_shown = self._moment = self._asked_line = None
        self._fitted = seen
        self.view.add(self.scene.root)
        self.view.tell_clicks(self._clicked)
        simulation = run.simulation
        self.turned = len(simulation.axes) > 3
        self.turning.setVisible(self.turned)
        self.see_deviation.setVisible(simulation.deviation_scale is not None)
        if simulation.deviation_scale is not None:
            self.legend = ScaleLegend(self.view.widget(), simulation.deviation_scale, simulation.colour_of_deviation)
        self._make_axes(simulation.axes)
        self.program.set_lines(run.lines)
        self.events.set_events(events)
        self.line.blockSignals(True)
        self.line.setRange(1, max(1, len(run.lines)))
        self.line.blockSignals(False)
        length = max(self.player.length, 1.0)
        self.speed.setCurrentIndex(min(range(len(SPEEDS)), key=lambda i: abs(math.log(SPEEDS[i] * ABOUT / length))))
        box = simulation.stock_box
        self.size = math.dist(box[:3], box[3:])
        self._show_roles()
        self.scene.show_stock(self.see_stock.isChecked())
        self._show_part()
        self._show_paths()
        self.go_to(self.player.length)
        self.timer.start(TICK)

    def end(self):
        self.timer.stop()
        self.playing = False
        if self.player is None:
            return
        self.player.close()
        self.view.tell_clicks(None)
        self.view.remove(self.scene.root)
        for legend in (self.legend, self.colours):
            if legend is not None:
                legend.close()
        self.player = self.scene = self.legend = self.colours = None
        there = self.document.Objects if is_there(self.document) else []
        for obj in self.parts:
            if obj in there:
                obj.ViewObject.Visibility = False
        for obj in self._hidden:
            if obj in there:
                obj.ViewObject.Visibility = True
        self.parts, self._hidden = [], []

    def _make_axes(self, letters):
        for label in self.axes.values():
            label.setParent(None)
        self.axes, fixed = {}, QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.FixedFont)
        for i, letter in enumerate(letters):
            self.axes[letter] = label = QtWidgets.QLabel()
            label.setFont(fixed)
            label.setFrameShape(QtWidgets.QFrame.StyledPanel)
            unit = units.shown_unit("mm") if i < 3 else tr("degrees")
            label.setToolTip(tr("Position of axis {letter}, {unit}").format(letter=letter, unit=unit))
            self.axes_row.addWidget(label, i // 3, i % 3)

    # User actions.
    def toggle(self):
        self.playing = not self.playing
        if self.playing and self.seconds >= self.player.length:
            self.seconds = 0.0
        self._start_clock()
        self._show_button()
        if not self.playing:
            self.go_to(self.seconds)

    def go_to(self, seconds):
        """Stops at a time."""
        if self.player is None:
            return
        self.playing, self.seconds, self._asked_line = False, min(max(seconds, 0.0), self.player.length), None
        self._show_button()
        self.scene.set_mark()
        self.player.want(self.seconds)

    def step(self, moves):
        self.go_to(self.player.step(self.seconds, moves))

    def go_to_line(self, line):
        """Stops at the end of a line."""
        if self.player is None:
            return
        self.go_to(float(np.nextafter(self.player.end_of_line(line), 0)))  # the move that ends, not the next one
        self._asked_line = line
        self._show_line(line)

    def go_to_event(self, event):
        if event["kind"] in ("gouge", "excess") and self.see_deviation.isChecked():
            self.go_to(self.player.length)  # at the end, where the colours show it
            self._asked_line = event["line"]
            self._show_line(event["line"])
        else:
            self.go_to_line(event["line"])
        self.scene.set_mark(event["place"], self.size / 60)
        self.view.look_at(self._turned(event["place"]))
        self.said.emit(tr("line {line}: {message}").format(line=event["line"], message=event["message"]), False)

    def _clicked(self, origin, direction):
        back = np.linalg.inv(self._matrix())
        hit = self.scene.cut_hit_by((back @ [*origin, 1.0])[:3], back[:3, :3] @ direction)
        if hit is None:
            return
        place, cut = hit
        line, tool = int(self.player.lines_of_cuts[cut]), int(self.player.tools_of_cuts[cut])
        self.scene.set_mark(place, self.size / 120)
        if line:
            self._show_line(line)
            self.said.emit(tr("this place was cut by line {line} with tool {tool}").format(line=line, tool=tool), True)
        else:
            self.said.emit(tr("this place was not cut"), True)

    # Showing.
    def _start_clock(self):
        self._began = (time.monotonic(), self.seconds)

    def _tick(self):
        if not is_there(self.document):
            self.timer.stop()
            self.player.close()
            return
        try:
            frame = self.player.take()
        except Exception as error:  # error on the player's thread
            self.timer.stop()
            self.said.emit(str(error), False)
            return
        if frame is not None:
            self._show(frame)
        if self.playing:
            began, first = self._began
            wanted = first + (time.monotonic() - began) * self.speed.currentData()
            if wanted >= self.player.length:
                self.go_to(self.player.length)
            else:
                self.player.want(wanted, moving=True)

    def _show(self, frame):
        self.shown += 1
        self.scene.show_pieces(frame.pieces)
        deviation = frame.whole is not None and self.see_deviation.isChecked()
        if deviation:
            self.scene.show_whole(*(frame.whole if self.scene.whole.arrays is not frame.whole[0] else ()))
        if self.legend is not None:
            self.legend.setVisible(deviation)
        self._moment = self.player.at(frame.seconds)
        if self.playing:
            self.seconds = frame.seconds
        self._place()
        if not self._fitted:
            self._fitted = True
            if not any(o.ViewObject.Visibility for o in self.document.Objects):
                self.view.fit()  # otherwise keep the user's view
        self._show_numbers(frame.seconds)
        self._show_line(self._asked_line or self._moment["line"])

    def _place(self):
        """Updates the positions of tool and stock."""
        if self._moment is None:
            return
        if (move_tool := self._moment["tool"]) != self._tool_shown:
            self.scene.show_tool(self.player.tool_parts(self._moment["move"]))
            self._tool_shown = move_tool
        self.scene.move_tool(self._moment["tip"], self._moment["axis"])
        self.scene.set_turn(self._matrix())

    def _matrix(self):
        if self.turned and self.turning.isChecked() and self._moment is not None:
            return self.player.simulation.turn_of_work(self._moment["axes"])
        return np.eye(4)

    def _turned(self, place):
        return (self._matrix() @ [*place, 1.0])[:3]

    def _show_numbers(self, seconds):
        self.slider.blockSignals(True)
        self.slider.setValue(round(STEPS * seconds / max(self.player.length, 1e-9)))
        self.slider.blockSignals(False)
        self.time.setText(f"{clock(seconds)} / {clock(self.player.length)}")
        for letter, label in self.axes.items():
            value = self._moment["axes"]["XYZABC".index(letter)]
            if letter in "XYZ":
                label.setText(f"{letter} {units.shown(value):9.{4 if units.in_inches() else 3}f}")
            else:
                label.setText(f"{letter} {value:9.3f}\N{DEGREE SIGN}")
        self.doing.setText((tr("tool {tool}, rapid") if self._moment["rapid"] else tr("tool {tool}")).format(
            tool=self._moment["tool"]))

    def _show_line(self, line):
        self.program.mark(line)
        self.line.blockSignals(True)
        self.line.setValue(line)
        self.line.blockSignals(False)

    def _show_roles(self):
        if self.scene is not None:
            self.scene.set_seen("cutting", self.see_tool.isChecked())
            for role in ("shank", "holder"):
                self.scene.set_seen(role, self.see_holder.isChecked())

    def _show_part(self):
        for obj in self.parts if self.player is not None else []:
            obj.ViewObject.Visibility = self.see_part.isChecked()

    def _show_paths(self):
        if self.player is None:
            return
        if self.colours is not None:
            self.colours.close()
            self.colours = None
        if not self.see_paths.isChecked():
            self.scene.show_paths()
            return
        nodes, entries = [], []
        for place, (tool, points, counts) in enumerate(self.player.ways()):
            colour = RAPID_COLOUR if tool is None else COLOURS[place % len(COLOURS)]
            nodes.append(lines(points, counts, colour, 1.2, 0x0F0F if tool is None else 0xFFFF))
            entries.append((colour, tr("rapids") if tool is None else tr("cuts of tool {tool}").format(tool=tool),
                            tool is None))
        self.scene.show_paths(nodes)
        if entries:
            self.colours = ColourLegend(self.view.widget(), entries)

    def _show_button(self):
        picture = QtWidgets.QStyle.SP_MediaPause if self.playing else QtWidgets.QStyle.SP_MediaPlay
        self.buttons["play"].setIcon(self.style().standardIcon(picture))

    def _slid(self, value):
        self.go_to(self.player.length * value / STEPS)
        if self.slider.isSliderDown():
            self.player.want(self.seconds, moving=True)
