"""The WebSocket: views of models. Each view has at most one picture in the making, and at most one that waits: a newer request takes its place."""

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
    """What one view of one socket asks for."""

    def __init__(self, session):
        self._session, self._next, self._worker, self._task, self._text = session, None, None, None, None

    def ask(self, number, name, request):
        self._next = (number, name, request)
        if self._worker is not None:
            self._worker.stop()
        if self._task is None or self._task.done():
            self._task = asyncio.create_task(self._run())

    def close(self):
        if self._worker is not None:
            self._worker.stop()
        if self._task is not None:
            self._task.cancel()

    async def _run(self):
        while self._next is not None:
            async with self._session.pool.worker(self._next[2]["text"]) as self._worker:
                (number, name, request), self._next = self._next, None  # the newest, after what may have been a long wait
                head = {"number": number, "view": name}
                first = {**request, "fine": not request["coarse"], "smooth": request["smooth"] and not request["coarse"]}
                good = await self._answer(head, first, parameters=True)
            if good and request["coarse"] and self._next is None:  # the coarse pictures of all go before the fine ones of any
                async with self._session.pool.worker(request["text"], rank=1) as self._worker:
                    if self._next is None:
                        await self._answer(head, {**request, "coarse": False})
                    self._worker = None

    async def _answer(self, head, request, parameters=False):
        """Sends the pictures of a request, after the text's parameters if it is new. Returns whether all were made."""
        try:
            if parameters and request["text"] != self._text and request["language"] == "frep":
                self._text = request["text"]
                async for found, _ in self._worker.ask({"do": "parameters", "text": self._text}, LIMITS.picture_seconds):
                    self._session.tell({"type": "parameters", **head, **found})
            if self._next is not None:  # a newer request came between the two, which stops neither
                return False
            async for told, data in self._worker.ask(request, LIMITS.picture_seconds):
                self._session.tell({"type": "picture", **head, **told}, data)
            return True
        except Refused as error:
            self._session.tell({"type": "error", **head, **error.told})
            return False
        finally:
            self._worker = None


class Session:
    """One socket. What it tells goes through a queue, so that a client that does not read holds no worker."""

    def __init__(self, socket, pool, folder, allow_scripts):
        self._socket, self.pool, self._folder, self._allow_scripts = socket, pool, folder, allow_scripts
        self._views, self._queue = {}, asyncio.Queue(LIMITS.unsent)

    def tell(self, head, body=None):
        try:
            self._queue.put_nowait((head, body))
        except asyncio.QueueFull:
            asyncio.create_task(self._socket.close(code=aiohttp.WSCloseCode.TRY_AGAIN_LATER, message=b"answers are not read"))

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
                given = json.loads(data, parse_constant=lambda word: word)  # NaN is refused as no number, by name
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
            self.tell({"type": "error", "number": number, "view": given.get("view") if number is not None else None, **error.told})

    async def serve(self):
        sender = asyncio.create_task(self._send())
        try:
            async for message in self._socket:
                if message.type == aiohttp.WSMsgType.TEXT:
                    self._take(message.data)
        finally:
            sender.cancel()
            for view in self._views.values():
                view.close()


class Sockets:
    """All of them."""

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
        for socket in list(self._open):
            with contextlib.suppress(ConnectionError, TimeoutError):
                await asyncio.wait_for(socket.close(code=aiohttp.WSCloseCode.GOING_AWAY), 1)
