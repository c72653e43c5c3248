"""Playback of a simulation in the background: a thread computes the stock at the most recently requested time."""

import threading

import numpy as np

from .. import kernel
from ..work import Task
from .coin_fields import packed

MOVING = 2  # cells merged along each axis while playing


class Frame:
    """The stock at a time. `pieces`: {index: (arrays, colours)} of all pieces that have changed since the last frame
    taken."""

    def __init__(self, seconds, pieces, whole=None):
        self.seconds, self.pieces, self.whole = seconds, pieces, whole


class Player:
    """Makes frames of an objects.simulation.Run. All methods are for the window's thread and do not block."""

    def __init__(self, run):
        self.run, self.simulation = run, run.simulation
        self.playback = self.simulation.playback
        self.ends = self.playback.seconds
        self.length = float(self.ends[-1]) if len(self.ends) else 0.0
        self.lines_of_cuts = self.simulation.lines_of_cuts
        self.tools_of_cuts = self.simulation.tools_of_cuts
        self._colour_of_cut = self._colours()
        # `busy`: held while the playback computes a stock
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
        """Requests the stock at a time. `moving`: with coarser cells."""
        with self._changed:
            self._wanted = (min(max(seconds, 0.0), self.length), MOVING if moving else 1)
            self._changed.notify()

    def take(self):
        """Returns the newest Frame once, or None if there is no new one. Raises errors of the thread."""
        if not self.task.is_alive() and self.task.error is not None:
            self.task.outcome()
        with self._changed:
            frame, self._frame = self._frame, None
        return frame

    @property
    def idle(self):
        """Returns whether there is neither a pending request nor a frame to take."""
        with self._changed:
            return self._wanted is None and self._frame is None

    def close(self):
        self.task.cancel()
        with self._changed:
            self._changed.notify()

    # Methods for the player's thread.
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
            # Pieces drawn coarsely during motion are refined at rest.
            changed |= {i for i, drawn in coarse_now.items() if drawn > coarse}
            indices = sorted(changed)
            pieces = {i: (arrays, self._colour_of_cut[arrays[3]])
                      for i, arrays in zip(indices, surface.to_draw(indices, coarse))}
            coarse_now.update((i, coarse) for i in indices)
            whole = self._whole_surface() if seconds >= self.length and coarse == 1 else None
            with self._changed:
                if self._frame is not None:  # the previous frame was not taken: merge its pieces
                    pieces = {**self._frame.pieces, **pieces}
                self._frame = Frame(seconds, pieces, whole)
                self.frames += 1
                if self._wanted == wanted:
                    self._wanted = None

    def _whole_surface(self):
        """Returns the finished stock coloured by its deviations, made once, or None without a target."""
        if self._whole is None and self.simulation.deviation_scale is not None:
            arrays = kernel.load().stock.to_draw(self.simulation.mesh)
            self._whole = (arrays, packed(self.simulation.colours))
        return self._whole

    # Data of the program.
    def at(self, seconds):
        """Returns the state of the machine at a time (fieldfab.stock.Playback.at)."""
        return self.playback.at(seconds)

    def tool_parts(self, move):
        """Returns {role: arrays} of a move's tool."""
        draw = kernel.load().stock.to_draw
        return {role: draw(self.playback.tool_mesh(move, role)) for role in ("cutting", "shank", "holder")}

    def ways(self):
        """Returns the paths of the tool tip in part coordinates: [(tool, or None for rapids; points; number of points
        of each polyline)]."""
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
        """Returns the time at which a line of the program ends, seconds."""
        done = self.playback.done_after_line(line)
        return float(self.ends[done - 1]) if done else 0.0

    def step(self, seconds, moves):
        """Returns the end time of the move that is `moves` moves later, or earlier if negative."""
        here = int(np.searchsorted(self.ends, seconds + 1e-9, side="right"))
        if moves < 0:
            here = int(np.searchsorted(self.ends, seconds - 1e-9, side="left"))
        at = here + moves - (1 if moves > 0 else 0)
        return 0.0 if at < 0 or not len(self.ends) else float(self.ends[min(at, len(self.ends) - 1)])
