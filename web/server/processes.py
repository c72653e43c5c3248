"""Worker processes as the server sees them: each has one request at a time and limits, and is ended when it does not
answer."""

import asyncio
import collections
import contextlib
import heapq
import itertools
import sys

from .frames import frame, read_frame_later
from .limits import LIMITS

KEPT_TEXTS = 100
# Seconds that a worker may go on when it is asked to stop: on a busy machine killing one costs more.
GRACE = 4.0


class Refused(Exception):
    """A request that has no answer but this. `status`: HTTP's; `told`: kind, message, and mistakes of a text."""

    def __init__(self, status, kind, message, mistakes=()):
        super().__init__(message)
        self.status, self.told = status, {"kind": kind, "message": message, "mistakes": list(mistakes)}


STATUS = {"bad_input": 422, "io": 422, "memory": 422, "internal": 500}


def raise_error(error):
    """Raises what a worker told as an error."""
    raise Refused(STATUS.get(error["kind"], 422), error["kind"], error["message"], error.get("mistakes", ()))


class Worker:
    """One process. It is started when it is first asked, and again after it was killed."""

    def __init__(self, memory=LIMITS.memory):
        self.memory, self.text, self.since = memory, None, 0.0  # when its request began, in the loop's time
        self._process, self._timeout, self._stopping, self._hurried = None, None, False, False
        self.failed = False  # whether a request took more time or memory than it may

    async def start(self):
        if self._process is None:
            words = (sys.executable, "-m", f"{__package__}.worker", str(self.memory))
            self._process = await asyncio.create_subprocess_exec(*words, stdin=asyncio.subprocess.PIPE,
                                                                 stdout=asyncio.subprocess.PIPE)

    async def ask(self, request, seconds):
        """Yields (head, body) of each answer except the last, which only marks the end. Raises Refused; returns early
        where it was stopped."""
        await self.start()
        self.text, self._stopping, self._hurried, done = request.get("text"), False, False, False
        self.since = asyncio.get_running_loop().time()
        try:
            async with asyncio.timeout(seconds) as self._timeout:
                self._process.stdin.write(frame(request))
                await self._process.stdin.drain()
                while True:
                    head, body = await read_frame_later(self._process.stdout)
                    if head.get("done"):
                        done = True
                        break
                    yield head, body
        except TimeoutError:
            if self._stopping:
                return
            if self._hurried:
                raise Refused(503, "busy", f"this takes longer than {LIMITS.crowded_seconds:g} s, and others wait; "
                              "try again later") from None
            raise Refused(422, "time",
                          f"this takes longer than {seconds:g} s, which is what a request may take") from None
        except (asyncio.IncompleteReadError, ConnectionError):
            if self._stopping:
                return
            raise Refused(422, "memory",
                          "the worker came to its end at this: it takes too much memory, or too deep a stack") from None
        finally:
            self._timeout = None
            if not done:
                self.failed = asyncio.get_running_loop().time() - self.since > 1
                self.kill()
        if error := head.get("error"):
            if error["kind"] == "memory":
                self.failed = True
                self.kill()
            raise_error(error)

    def stop(self):
        """Asks it to leave its request; what does not listen is killed."""
        if self._timeout is None or self._stopping:
            return
        self._stopping = True
        with contextlib.suppress(ConnectionError, RuntimeError):
            self._process.stdin.write(frame({"do": "stop"}))
        self._timeout.reschedule(asyncio.get_running_loop().time() + GRACE)

    def hurry(self):
        """Ends a request that others have waited for."""
        if self._timeout is not None and not self._stopping:
            self._hurried = True
            self._timeout.reschedule(asyncio.get_running_loop().time())

    def kill(self):
        if self._process is not None:
            with contextlib.suppress(ProcessLookupError):
                self._process.kill()
            self._process = None


class Pool:
    """Workers for short requests. Requests wait in order of their rank (0 first), then of their arrival. A text goes to
    the worker that had it last, if that one is idle. Where one has waited for
    `LIMITS.crowded_seconds`, those that take longer end."""

    def __init__(self, count):
        self._idle, self._busy = [Worker() for _ in range(count)], set()
        self._heavy = collections.OrderedDict()  # texts that took too much lately: they go last
        self._waiting, self._arrivals = [], itertools.count()

    async def start(self):
        await asyncio.gather(*(worker.start() for worker in self._idle))

    @contextlib.asynccontextmanager
    async def worker(self, text, rank=0):
        if not self._idle:
            turn = asyncio.get_running_loop().create_future()
            heapq.heappush(self._waiting, (rank + (2 if text in self._heavy else 0), next(self._arrivals), turn))
            try:
                worker = await self._patiently(turn)
            except asyncio.CancelledError:
                if turn.done():  # it came in the same moment
                    self._release(turn.result())
                turn.cancel()
                raise
        else:
            worker = next((each for each in self._idle if each.text == text), self._idle[-1])
            self._idle.remove(worker)
        self._busy.add(worker)
        try:
            yield worker
        finally:
            if worker.failed:
                self._heavy[text], worker.failed = None, False
                if len(self._heavy) > KEPT_TEXTS:
                    self._heavy.popitem(last=False)
            self._busy.discard(worker)
            self._release(worker)

    async def _patiently(self, turn):
        """The worker whose turn it is, after those that take too long were hurried."""
        loop = asyncio.get_running_loop()
        await asyncio.wait([turn], timeout=LIMITS.crowded_seconds)
        while not turn.done():
            await asyncio.wait([turn], timeout=1)
            for worker in self._busy:
                if not turn.done() and loop.time() - worker.since > LIMITS.crowded_seconds:
                    worker.hurry()
        return turn.result()

    def _release(self, worker):
        while self._waiting:
            _, _, turn = heapq.heappop(self._waiting)
            if not turn.done():
                return turn.set_result(worker)
        self._idle.append(worker)

    async def ask(self, request):
        """The one answer to a request that comes by itself, after those of pages that are open."""
        async with self.worker(request.get("text"), rank=1) as worker:
            answers = [answer async for answer in worker.ask(request, LIMITS.picture_seconds)]
        return answers[-1]

    def kill(self):
        for worker in self._idle:
            worker.kill()
