"""fabserver for tests: `fieldfab serve` as a process, and clients for it."""

import asyncio
import contextlib
import http.client
import json
import os
import re
import signal
import struct
import subprocess
import time
import urllib.parse
import zlib

import aiohttp
import numpy as np
import pytest
from conftest import COMMAND
from selenium import webdriver
from selenium.webdriver.chrome.service import Service


class Server:
    """A server on a free or given port, with its documents in `folder`."""

    def __init__(self, folder, *options, port=0, command=(COMMAND, "serve"), **environment):
        kept = {name: value for name, value in os.environ.items() if not name.lower().endswith("_proxy")}
        words = [*command, folder, "--no-browser", "--port", str(port), *options]
        self.process = subprocess.Popen(list(map(str, words)), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                        text=True, env={**kept, **environment}, start_new_session=True)
        self.said = self.process.stdout.readline()
        self.address = re.search(r"http://\S+", self.said)[0]
        self.place = urllib.parse.urlsplit(self.address)

    @property
    def port(self):
        return self.place.port

    def ask(self, method, path, body=None, **headers):
        """Returns status, headers and bytes of an answer. `body`: bytes, or a value for JSON. Names of headers have _
        for -."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        body = json.dumps(body).encode() if body is not None and not isinstance(body, bytes) else body
        try:
            connection.request(method, path, body, {name.replace("_", "-"): value for name, value in headers.items()})
            answer = connection.getresponse()
            return answer.status, answer.headers, answer.read()
        finally:
            connection.close()

    def post(self, path, body):
        status, _, data = self.ask("POST", path, body)
        return status, json.loads(data)

    def kill(self):
        """Kills the server by SIGKILL."""
        self.process.kill()
        self.process.wait()
        self.process.stdout.close()

    def end(self):
        self.process.send_signal(signal.SIGTERM)
        try:
            self.process.wait(10)
        finally:
            self.kill()

    def workers(self):
        """Returns process ids of its workers."""
        return children(self.process.pid)


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    running = Server(tmp_path_factory.mktemp("documents"))
    yield running
    running.end()


@pytest.fixture(scope="module")
def folder(server):
    return server.said.split("documents in ")[1].split(";")[0]


def refused(answer, status, *words):
    """Asserts that an answer is a refusal with that status and words. Returns the error."""
    got, told = answer
    assert got == status, told
    assert all(word in told["error"]["message"] for word in words), told
    return told["error"]


def children(parent):
    """Returns ids of the child processes of a process."""
    found = []
    for name in os.listdir("/proc"):
        with contextlib.suppress(OSError, ValueError):
            if name.isdigit() and int(open(f"/proc/{name}/stat").read().rpartition(")")[2].split()[1]) == parent:
                found.append(int(name))
    return found


def wait_until(condition, what, seconds=60):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, f"{what}: not within {seconds} s"
        time.sleep(0.05)


def pixels(data):
    """Decodes a PNG of the server: 8 bits, rows with filter type Up."""
    at, parts = 8, {}
    while at < len(data):
        length, name = struct.unpack_from(">I4s", data, at)
        parts.setdefault(name, b"")
        parts[name] += data[at + 8 : at + 8 + length]
        assert zlib.crc32(data[at + 4 : at + 8 + length]) == struct.unpack_from(">I", data, at + 8 + length)[0]
        at += 12 + length
    width, height, depth, kind = struct.unpack_from(">IIBB", parts[b"IHDR"])
    assert depth == 8
    channels = {0: 1, 2: 3, 6: 4}[kind]
    rows = np.frombuffer(zlib.decompress(parts[b"IDAT"]), np.uint8).reshape(height, 1 + width * channels)
    assert (rows[:, 0] == 2).all()
    return np.cumsum(rows[:, 1:], axis=0, dtype=np.uint8).reshape(height, width, channels)


class Socket:
    """Messages to and from the server's WebSocket, in a coroutine."""

    def __init__(self, server, **headers):
        self._server, self._headers = server, headers

    async def __aenter__(self):
        self._session = aiohttp.ClientSession()
        self._socket = await self._session.ws_connect(f"http://127.0.0.1:{self._server.port}/api/socket",
                                                      headers=self._headers, max_msg_size=0)
        return self

    async def __aexit__(self, *_):
        await self._session.close()

    async def send(self, message):
        await self._socket.send_str(message if isinstance(message, str) else json.dumps(message))

    async def receive(self, seconds=60):
        """Returns (values of a message, bytes of a picture); None after the socket was closed."""
        message = await asyncio.wait_for(self._socket.receive(), seconds)
        if message.type == aiohttp.WSMsgType.TEXT:
            return json.loads(message.data), b""
        if message.type == aiohttp.WSMsgType.BINARY:
            [length] = struct.unpack_from(">I", message.data)
            return json.loads(message.data[4 : 4 + length]), message.data[4 + length :]
        return None

    async def until(self, wanted, seconds=60):
        """Returns all answers up to the first for which `wanted` is true."""
        answers, end = [], time.monotonic() + seconds
        while True:
            answers.append(await self.receive(end - time.monotonic()))
            if wanted(answers[-1][0]):
                return answers


@contextlib.contextmanager
def chromium(profile=None):
    """A headless browser with WebGL rendered in software. `profile`: the folder of what it keeps; else a new one."""
    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for each in ("--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                 "--disable-dev-shm-usage", "--no-proxy-server",
                 "--window-size=1360,860", "--force-device-scale-factor=1"):  # fmt: skip
        options.add_argument(each)
    if profile:
        options.add_argument(f"--user-data-dir={profile}")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    kept = os.environ.copy()
    os.environ["no_proxy"] = "127.0.0.1,localhost"
    try:
        driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
        try:
            yield driver
        finally:
            driver.quit()
    finally:
        os.environ.clear()
        os.environ.update(kept)
