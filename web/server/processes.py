"""The server's side of worker processes. Each has one request at a time and limits, and is killed if it does not
answer."""

import asyncio
import collections
import contextlib
import heapq
import itertools

from .frames import frame, read_frame_later
from .launch import worker_command
from .limits import LIMITS

KEPT_TEXTS = 100
# Seconds from a request to stop until a worker is killed. On a busy machine a new process costs more.
GRACE = 4.0
DELAY = 2.0  # seconds by which a request of the next rank may overtake


class Refused(Exception):
    """Raised for a refused request. `status`: of HTTP; `told`: kind, message, and errors of a text."""

    def __init__(self, status, kind, message, mistakes=()):
        super().__init__(message)
        self.status, self.told = status, {"kind": kind, "message": message, "mistakes": list(mistakes)}


STATUS = {"bad_input": 422, "io": 422, "memory": 422, "internal": 500}


def raise_error(error):
    """Raises the error that a worker reported."""
    raise Refused(STATUS.get(error["kind"], 422), error["kind"], error["message"], error.get("mistakes", ()))


class Worker:
    """One process. It is started by the first request, and again after it was killed."""

    def __init__(self, memory=LIMITS.memory):
        self.memory, self.text, self.since = memory, None, 0.0  # start of its request, in the loop's time
        self._process, self._timeout, self._stopping, self._hurried = None, None, False, False
        self.failed = False  # whether a request exceeded its time or memory

    async def start(self):
        if self._process is None:
            words, environment = worker_command(self.memory)
            self._process = await asyncio.create_subprocess_exec(
                *words, stdin=asyncio.subprocess.PIPE, stdout=asyncio.subprocess.PIPE, env=environment)

    async def ask(self, request, seconds):
        """Yields (head, body) of each answer except the end mark. Raises Refused; returns early after stop()."""
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
                          "the worker process ended: this takes too much memory, or too deep a stack") from None
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
        """Asks the process to abandon its request; kills it if it does not react."""
        if self._timeout is None or self._stopping:
            return
        self._stopping = True
        with contextlib.suppress(ConnectionError, RuntimeError):
            self._process.stdin.write(frame({"do": "stop"}))
        self._end_in(GRACE)

    def hurry(self):
        """Ends a long request for the sake of others in the queue."""
        if self._timeout is not None and not self._stopping:
            self._hurried = True
            self._end_in(0)

    def _end_in(self, seconds):
        with contextlib.suppress(RuntimeError):  # its time is over already, and the task has not noticed yet
            self._timeout.reschedule(asyncio.get_running_loop().time() + seconds)

    def kill(self):
        if self._process is not None:
            with contextlib.suppress(ProcessLookupError):
                self._process.kill()
            self._process = None


class Pool:
    """Workers for short requests. The queue is ordered by arrival; each rank (0: first) counts as `DELAY` seconds, so
    that none waits for ever behind new ones of lower rank. A text goes to the worker that had it last, if that one is
    idle. After a request has waited for `LIMITS.crowded_seconds`, longer ones are ended."""

    def __init__(self, count):
        self._idle, self._busy = [Worker() for _ in range(count)], set()
        self._heavy = collections.OrderedDict()  # texts that recently exceeded a limit: last in the queue
        self._waiting, self._arrivals = [], itertools.count()

    async def start(self):
        await asyncio.gather(*(worker.start() for worker in self._idle))

    @contextlib.asynccontextmanager
    async def worker(self, text, rank=0):
        if not self._idle:
            loop = asyncio.get_running_loop()
            turn, rank = loop.create_future(), rank + (2 if text in self._heavy else 0)
            heapq.heappush(self._waiting, (loop.time() + DELAY * rank, next(self._arrivals), turn))
            try:
                worker = await self._patiently(turn)
            except BaseException:
                if turn.done():  # a worker was assigned at the same time
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
        """Returns the assigned worker; ends requests that take too long if necessary."""
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
        """Returns the only answer to a single request, ranked after those of open pages."""
        async with self.worker(request.get("text"), rank=1) as worker:
            answers = [answer async for answer in worker.ask(request, LIMITS.picture_seconds)]
        return answers[-1]

    def kill(self):
        for worker in self._idle:
            worker.kill()
