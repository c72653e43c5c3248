"""Two fabservers behind haproxy: pictures come from both; one that is killed takes no document and no client along."""

import asyncio
import contextlib
import json
import math
import time

import aiohttp
import pytest
from selenium.webdriver.common.keys import Keys
from web_balancer import TOKEN, Balanced
from web_page import Page, browser
from web_server import wait_until

BEARER = {"Authorization": f"Bearer {TOKEN}"}


@pytest.fixture
def balanced(tmp_path):
    (tmp_path / "documents").mkdir()
    running = Balanced(tmp_path, tmp_path / "documents")
    yield running
    running.end()


def server_of(answer):
    """Returns the name of the server that haproxy chose."""
    return answer.cookies["fieldfab_server"].value


def test_pictures_come_from_both(balanced):
    """Programs without cookies get either server. A browser keeps its server: its jobs are there, its socket, too."""
    async def talk():
        seen = set()
        for number in range(8):
            async with aiohttp.ClientSession(f"http://127.0.0.1:{balanced.port}", headers=BEARER) as session:
                body = {"text": f"sphere({number + 1})", "width": 32, "height": 24}
                async with session.post("/api/picture", json=body) as answer:
                    assert answer.status == 200 and (await answer.read())[:4] == b"\x89PNG"
                    seen.add(server_of(answer))
        assert seen == {"one", "two"}
        sockets = set()
        for _ in range(4):
            async with aiohttp.ClientSession(f"http://127.0.0.1:{balanced.port}", headers=BEARER,
                                             cookie_jar=aiohttp.CookieJar(unsafe=True)) as session:  # of an IP address
                async with session.get("/api/documents") as answer:
                    mine = server_of(answer)
                async with session.post("/api/files", json={"text": "sphere(5)", "extension": ".stl"}) as answer:
                    job = await answer.json()
                while job["state"] in ("waiting", "working"):
                    place = f"/api/jobs/{job['job']}?state={job['state']}&progress={job['progress']}"
                    async with session.get(place) as answer:
                        assert answer.status == 200, await answer.text()
                        job = await answer.json()
                assert job["state"] == "done"
                async with session.ws_connect("/api/socket") as socket:
                    sockets.add(mine)
                    await socket.send_str(json.dumps({"number": 1, "text": "sphere(5)", "width": 32, "height": 24}))
                    while (await socket.receive(30)).type != aiohttp.WSMsgType.BINARY:
                        pass
        assert sockets == {"one", "two"}

    asyncio.run(asyncio.wait_for(talk(), 120))


def test_the_token_is_asked_for(balanced):
    assert balanced.ask("GET", "/api/documents")[0] == 401
    assert balanced.ask("GET", "/api/documents", Origin="http://elsewhere.example", **BEARER)[0] == 403
    assert balanced.ask("GET", "/api/documents", Origin=f"http://127.0.0.1:{balanced.port}", **BEARER)[0] == 200


class Client:
    """Edits its own document and looks at it, as the page does. It tries again after each failure."""

    def __init__(self, balanced, name):
        self.address, self.name, self.version = f"http://127.0.0.1:{balanced.port}", name, None
        self.text = self.saved = ""
        self.pictures, self.failures, self.connections = [], 0, 0

    async def save(self, session, text):
        expected = {"If-Match": f'"{self.version}"'} if self.version else {}
        place = f"/api/documents/{self.name}"
        async with session.put(place, data=text.encode(), headers=expected) as answer:
            if answer.status == 409:  # an answer was lost: is it the text of ours?
                async with session.get(place) as now:
                    assert (await now.text()) == self.text, "another one's text"
                    self.version = now.headers["ETag"].strip('"')
                return False
            if answer.status in (502, 503, 504):
                raise aiohttp.ClientError(answer.reason)
            assert answer.status == 200, await answer.text()
            self.version = (await answer.json())["version"]
        self.saved = text
        return True

    def goes_on(self, end):
        """Until the end, and then until what was written last is saved."""
        return time.monotonic() < end or self.saved != self.text

    async def run(self, end):
        number = 0
        while self.goes_on(end):
            with contextlib.suppress(aiohttp.ClientError, ConnectionError, EOFError):
                async with aiohttp.ClientSession(self.address, headers=BEARER) as session:
                    async with session.ws_connect("/api/socket") as socket:
                        self.connections += 1
                        while self.goes_on(end):
                            text = f"sphere({5 + number / 1000})  # {self.name}\n"
                            self.text = text
                            while not await self.save(session, text):
                                pass
                            await socket.send_str(json.dumps({"number": number, "text": text, "width": 80,
                                                              "height": 60}))
                            while (message := await socket.receive(30)).type != aiohttp.WSMsgType.BINARY:
                                if message.type != aiohttp.WSMsgType.TEXT:
                                    raise EOFError
                            self.pictures.append(time.monotonic())
                            number += 1
            self.failures += 1
            await asyncio.sleep(0.1)


def test_one_is_killed_under_load(balanced):
    """Each client's document is what the client wrote last, and each client gets pictures after the kill."""
    async def load():
        clients, start = [Client(balanced, f"part {i}.frep") for i in range(8)], time.monotonic()
        tasks = [asyncio.create_task(each.run(start + 16)) for each in clients]
        await asyncio.sleep(5)
        balanced.servers[0].kill()
        killed = time.monotonic()
        await asyncio.sleep(5)
        await asyncio.to_thread(balanced.start_again, 0)
        await asyncio.gather(*tasks)
        return clients, killed

    clients, killed = asyncio.run(asyncio.wait_for(load(), 120))
    for each in clients:
        assert (balanced.documents / each.name).read_text() == each.text
        assert sum(picture < killed for picture in each.pictures) > 2
        assert sum(picture > killed + 2 for picture in each.pictures) > 2
    assert sum(each.connections > 1 for each in clients) >= 2, "some had their socket at the server that was killed"
    # What the killed server was writing may be left beside its file, hidden.
    left = [path.name for path in balanced.documents.iterdir()]
    assert sum(not name.startswith(".") for name in left) == len(clients) and len(left) <= len(clients) + 1, left


def test_the_page_goes_on(browser, balanced):
    """A page loses its server while its user types: the other server takes its text, and shows it."""
    (balanced.documents / "part.frep").write_text("circle(3)\n")
    page = Page(browser, [balanced])
    browser.get(balanced.address)
    wait_until(lambda: page.find("#new-text").is_displayed(), "the gallery")
    page.open("part.frep")
    page.settled()
    mine = {"one": 0, "two": 1}[browser.get_cookie("fieldfab_server")["value"]]
    balanced.servers[mine].kill()
    page.type("#editor", Keys.CONTROL + "a", "circle(7)")
    page.saved()
    page.until(lambda: not page.find("#away").is_displayed(), "another server's socket")
    page.find("#fit").click()
    page.until(lambda: abs(page.coloured() / (math.pi * 49) - 1) < 0.02, "the picture of the other server")
    assert (balanced.documents / "part.frep").read_text() == "circle(7)"
