"""Playing a simulation back beside the window: a thread makes the stock at the moment that is wanted last."""

import threading

import numpy as np

from .. import kernel
from ..work import Task
from .coin_fields import packed

MOVING = 2  # blocks of so many cells are one while it moves


class Frame:
    """The stock at a moment. `pieces`: {index: (arrays, colours)} of what has changed since the last frame that was
    taken."""

    def __init__(self, seconds, pieces, whole=None):
        self.seconds, self.pieces, self.whole = seconds, pieces, whole


class Player:
    """Makes frames of an objects.simulation.Run. All methods are for the window's thread; none of them waits."""

    def __init__(self, run):
        self.run, self.simulation = run, run.simulation
        self.playback = self.simulation.playback
        self.ends = self.playback.seconds
        self.length = float(self.ends[-1]) if len(self.ends) else 0.0
        self.lines_of_cuts = self.simulation.lines_of_cuts
        self.tools_of_cuts = self.simulation.tools_of_cuts
        self._colour_of_cut = self._colours()
        # `busy`: held while the playback goes to a moment
        self._changed, self.busy = threading.Condition(), threading.Lock()
        self._wanted = self._frame = self._whole = None
        self.frames = 0
        self.task = Task(self._work)
        self.task.start()

    def _colours(self):
        of_tool = {tool: tuple(rgb) for tool, rgb in self.simulation.colours_of_tools.items()}
        table = np.array([of_tool.get(tool, (160, 160, 160)) for tool in range(max(of_tool) + 1)], np.uint32)
        return packed(table)[np.clip(self.tools_of_cuts, 0, len(table) - 1)]

    def want(self, seconds, moving=False):
        """Asks for the stock at a moment; a coarser picture of it while it moves."""
        with self._changed:
            self._wanted = (min(max(seconds, 0.0), self.length), MOVING if moving else 1)
            self._changed.notify()

    def take(self):
        """The newest Frame, once; None where there is no new one. Raises what went wrong with it."""
        if not self.task.is_alive() and self.task.error is not None:
            self.task.outcome()
        with self._changed:
            frame, self._frame = self._frame, None
        return frame

    @property
    def idle(self):
        """Whether nothing is wanted that has not been taken."""
        with self._changed:
            return self._wanted is None and self._frame is None

    def close(self):
        self.task.cancel()
        with self._changed:
            self._changed.notify()

    # On the thread.
    def _work(self, progress):
        surface, coarse_now = kernel.load().stock.Surface(), {}
        while True:
            with self._changed:
                while self._wanted is None and not self.task.cancelled:
                    self._changed.wait(0.5)
                if self.task.cancelled:
                    return
                seconds, coarse = wanted = self._wanted
            with self.busy:
                stock = self.playback.stock_at(seconds, progress=progress)
            changed = set(surface.update(stock, progress=progress))
            # What was drawn coarsely while it moved is drawn finely once it stands.
            changed |= {i for i, drawn in coarse_now.items() if drawn > coarse}
            indices = sorted(changed)
            pieces = {i: (arrays, self._colour_of_cut[arrays[3]])
                      for i, arrays in zip(indices, surface.to_draw(indices, coarse))}
            coarse_now.update((i, coarse) for i in indices)
            whole = self._whole_surface() if seconds >= self.length and coarse == 1 else None
            with self._changed:
                if self._frame is not None:  # not taken yet: it goes along with this one
                    pieces = {**self._frame.pieces, **pieces}
                self._frame = Frame(seconds, pieces, whole)
                self.frames += 1
                if self._wanted == wanted:
                    self._wanted = None

    def _whole_surface(self):
        """The finished stock in the colours of its deviations, made once; None without a target."""
        if self._whole is None and self.simulation.deviation_scale is not None:
            arrays = kernel.load().stock.to_draw(self.simulation.mesh)
            self._whole = (arrays, packed(self.simulation.colours))
        return self._whole

    # Of the program.
    def at(self, seconds):
        """What the machine does at a moment (fieldfab.stock.Playback.at)."""
        return self.playback.at(seconds)

    def tool_parts(self, move):
        """{role: arrays} of a move's tool."""
        draw = kernel.load().stock.to_draw
        return {role: draw(self.playback.tool_mesh(move, role)) for role in ("cutting", "shank", "holder")}

    def ways(self):
        """[(tool, None for rapids; points; how many each polyline has)]: where the tip goes, part coordinates."""
        if self._ways is None:
            way = [self.playback.poses(move)[:, :3] for move in range(len(self.ends))]
            rapid, tools = np.asarray(self.playback.rapid), np.asarray(self.playback.tools)
            self._ways = []
            for tool in (*sorted(set(tools[~rapid].tolist())), None):
                wanted = [way[i] for i in np.flatnonzero(rapid if tool is None else ~rapid & (tools == tool))
                          if len(way[i]) > 1]
                if wanted:
                    self._ways.append((tool, np.concatenate(wanted).astype("f4"),
                                       np.array([len(each) for each in wanted], "i4")))
        return self._ways

    _ways = None

    def end_of_line(self, line):
        """When the program has done a line, seconds."""
        done = self.playback.done_after_line(line)
        return float(self.ends[done - 1]) if done else 0.0

    def step(self, seconds, moves):
        """The end of the move so many moves on."""
        here = int(np.searchsorted(self.ends, seconds + 1e-9, side="right"))
        if moves < 0:
            here = int(np.searchsorted(self.ends, seconds - 1e-9, side="left"))
        at = here + moves - (1 if moves > 0 else 0)
        return 0.0 if at < 0 or not len(self.ends) else float(self.ends[min(at, len(self.ends) - 1)])
