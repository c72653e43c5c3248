"""The WebSocket: views of models. Each view has at most one picture in progress and one request in the queue, which a
newer request replaces."""

import asyncio
import contextlib
import json

import aiohttp
from aiohttp import web

from .frames import socket_message
from .limits import LIMITS
from .processes import Refused
from .protocol import checked, wrong


class View:
    """Requests of one view of one socket."""

    def __init__(self, session):
        self._session, self._next, self._worker, self._task, self._finer, self._text = (
            session, None, None, None, None, None)

    def ask(self, number, name, request):
        self._next = (number, name, request)
        if self._worker is not None:
            self._worker.stop()
        elif self._finer is not None:  # the finer picture still waits for a worker: drop it
            self._finer.cancel()
        if self._task is None or self._task.done():
            self._task = asyncio.create_task(self._run())

    def close(self):
        if self._worker is not None:
            self._worker.stop()
        for task in (self._finer, self._task):
            if task is not None:
                task.cancel()

    async def _run(self):
        while self._next is not None:
            async with (self._session.turn,
                        self._session.pool.worker(self._next[2]["text"], self._session.rank()) as self._worker):
                # Takes the newest request: the wait may have been long.
                (number, name, request), self._next = self._next, None
                head = {"number": number, "view": name}
                first = {**request, "fine": not request["coarse"],
                         "smooth": request["smooth"] and not request["coarse"]}
                good = await self._answer(head, first, parameters=True)
            # Coarse pictures of all clients have priority over fine ones.
            if good and request["coarse"] and self._next is None:
                self._finer = asyncio.create_task(self._fine(head, request))
                await asyncio.wait([self._finer])

    async def _fine(self, head, request):
        async with (self._session.turn,
                    self._session.pool.worker(request["text"], 1 + self._session.rank()) as self._worker):
            if self._next is None:
                await self._answer(head, {**request, "coarse": False})
            self._worker = None

    async def _answer(self, head, request, parameters=False):
        """Sends the pictures of a request, preceded by the parameters of a new text. Returns whether all were made."""
        started = asyncio.get_running_loop().time()
        try:
            if parameters and request["text"] != self._text and request["language"] == "frep":
                self._text = request["text"]
                async for found, _ in self._worker.ask({"do": "parameters", "text": self._text},
                                                       LIMITS.picture_seconds):
                    self._session.tell({"type": "parameters", **head, **found})
            if self._next is not None:  # a newer request arrived between the two and stopped neither
                return False
            async for told, data in self._worker.ask(request, LIMITS.picture_seconds):
                self._session.tell({"type": "picture", **head, **told}, data)
            return True
        except Refused as error:
            self._session.tell({"type": "error", **head, **error.told})
            return False
        except Exception as error:  # a bug of ours: reported, so that the client does not wait for ever
            self._session.tell({"type": "error", **head, "kind": "internal", "mistakes": [],
                                "message": f"{type(error).__name__}: {error}"})
            raise
        finally:
            self._worker = None
            self._session.used(asyncio.get_running_loop().time() - started)


class Session:
    """One socket. Its answers pass a queue, so that a client that does not read blocks no worker."""

    def __init__(self, socket, pool, folder, allow_scripts):
        self._socket, self.pool, self._folder, self._allow_scripts = socket, pool, folder, allow_scripts
        self._used, self._counted = 0.0, asyncio.get_running_loop().time()
        self._ended = None  # the task that closes it
        self._views, self._queue, self.turn = {}, asyncio.Queue(LIMITS.unsent), asyncio.Semaphore(LIMITS.at_once)

    def used(self, seconds):
        """Adds the time of its pictures to a sum that decays with a half-life of 5 s."""
        now = asyncio.get_running_loop().time()
        self._used, self._counted = self._used * 0.5 ** ((now - self._counted) / 5) + seconds, now

    def rank(self):
        """Returns the socket's rank in the queue; heavy users come last."""
        self.used(0)
        return 2 if self._used > LIMITS.much_seconds else 0

    def tell(self, head, body=None):
        if self._ended:
            return
        try:
            self._queue.put_nowait((head, body))
        except asyncio.QueueFull:
            self._ended = asyncio.create_task(self._socket.close(code=aiohttp.WSCloseCode.TRY_AGAIN_LATER,
                                                                 message=b"answers are not read"))

    async def _send(self):
        with contextlib.suppress(ConnectionError, RuntimeError):
            while True:
                head, body = await self._queue.get()
                if body is None:
                    await self._socket.send_json(head)
                else:
                    await self._socket.send_bytes(socket_message(head, body))

    def _take(self, data):
        number = None
        try:
            try:
                given = json.loads(data, parse_constant=lambda word: word)  # NaN stays a text, and is refused by name
            except (ValueError, RecursionError):
                raise wrong("a message is a JSON object") from None
            number = given.get("number") if isinstance(given, dict) else None
            if not isinstance(number, int) or isinstance(number, bool):
                number = None
                raise wrong("'number' must be a whole number; answers repeat it")
            name = given.get("view", "main")
            if not isinstance(name, str) or len(name) > 40:
                raise wrong("'view' must be a short name")
            request = checked("picture", given, self._folder, self._allow_scripts, beside=("number", "view"))
            if name not in self._views and len(self._views) >= LIMITS.views:
                raise wrong(f"a socket has at most {LIMITS.views} views")
            self._views.setdefault(name, View(self)).ask(number, name, request)
        except Refused as error:
            self.tell({"type": "error", "number": number, "view": given.get("view") if number is not None else None,
                       **error.told})

    async def serve(self):
        sender = asyncio.create_task(self._send())
        try:
            async for message in self._socket:
                if self._ended:
                    break
                if message.type == aiohttp.WSMsgType.TEXT:
                    self._take(message.data)
                await asyncio.sleep(0)  # lets other tasks run during a burst of messages
        finally:
            sender.cancel()
            for view in self._views.values():
                view.close()


class Sockets:
    """All open sockets."""

    def __init__(self, pool, folder, allow_scripts):
        self._pool, self._folder, self._allow_scripts = pool, folder, allow_scripts
        self._open = set()

    async def handle(self, request):
        if len(self._open) >= LIMITS.sockets:
            raise Refused(503, "busy", f"{LIMITS.sockets} pages are open already")
        socket = web.WebSocketResponse(heartbeat=20, max_msg_size=LIMITS.message, compress=False)
        await socket.prepare(request)
        self._open.add(socket)
        try:
            await Session(socket, self._pool, self._folder, self._allow_scripts).serve()
        finally:
            self._open.discard(socket)
        return socket

    async def close(self):
        async def end(socket):
            with contextlib.suppress(ConnectionError, TimeoutError):
                await asyncio.wait_for(socket.close(code=aiohttp.WSCloseCode.GOING_AWAY), 1)

        await asyncio.gather(*map(end, list(self._open)))
