"""fabserver's limits and the edges of its protocol: each answers clearly, and the page comes compressed."""

import asyncio
import gzip
import json
import math
import os
import re
import struct
import subprocess
import time
import zlib

import aiohttp
import numpy as np
import pytest
from conftest import COMMAND
from web_server import Server, Socket, folder, pixels, refused, server, wait_until

import fieldfab as ff
from fieldfab.serve import files, limits, pictures

SPHERE = {"text": "sphere(5)"}
# Seconds of work.
LONG = {"text": "gyroid(1) & box(120, 120, 120)", "extension": ".stl"}


# The page


def test_the_page_comes_compressed(server):
    """Each of its files is what was built, and all that a text's page loads has less than 400 kB on the wire."""
    _, _, index = server.ask("GET", "/")
    names = re.findall(r'(?:src|href)="/page/([^"]+)"', index.decode()) + ["sandbox.html"]
    assert {"page.js", "style.css", "icon.svg"} <= set(names)
    script = server.ask("GET", "/page/page.js")[2].decode()
    loaded = {*names, *re.findall(r'"\./([\w-]+\.js)"', script)}
    assert any(name.startswith("playback") for name in loaded), "three.js counts, too"
    wire = len(index)
    for name in loaded:
        status, headers, data = server.ask("GET", f"/page/{name}", Accept_Encoding="gzip, deflate")
        assert status == 200 and headers["Content-Encoding"] == "gzip", name
        assert headers["Vary"] == "Accept-Encoding" and "gzip" not in headers["Content-Type"]
        wire += len(data)
        plain = server.ask("GET", f"/page/{name}")
        assert plain[0] == 200 and "Content-Encoding" not in plain[1] and plain[2] == gzip.decompress(data), name
        assert headers["Content-Type"] == plain[1]["Content-Type"]
    assert wire < 400_000, wire
    assert server.ask("GET", "/page/page.js.gz")[0] == 404


def test_serve_opens_the_browser(tmp_path):
    """As $BROWSER says, with the address that is printed."""
    told, browser = tmp_path / "told", tmp_path / "browser"
    browser.write_text(f'#!/bin/sh\necho "$1" > {told}\n')
    browser.chmod(0o755)
    process = subprocess.Popen([COMMAND, "serve", tmp_path, "--port", "0"], stdout=subprocess.PIPE, text=True,
                               env={**os.environ, "BROWSER": f"{browser} %s", "FIELDFAB_TOKEN": "secret words"})
    try:
        address = re.search(r"http://.*?(?= \(documents)", process.stdout.readline())[0]
        wait_until(lambda: told.exists() and told.read_text().strip(), "the browser")
        assert told.read_text().strip() == address and "token=secret words" in address
    finally:
        process.terminate()
        process.wait(20)
        process.stdout.close()


# Pictures


def test_normals_and_heights_are_those_of_the_solid(server):
    view = {"alpha": 0.0, "beta": 0.0, "width": 64, "height": 64, "window": [-6, -6, 6, 6]}
    status, headers, data = server.ask("POST", "/api/picture", {**SPHERE, **view, "mode": "normals"})
    assert status == 200
    image = pixels(data).astype(float)
    at = (np.arange(64) + 0.5) * 12 / 64 - 6
    x, y = np.meshgrid(at, -at)
    inside = np.hypot(x, y) < 4.6
    normal = np.dstack([x, y, np.sqrt(np.maximum(0, 25 - x**2 - y**2))]) / 5
    assert (image[inside][:, 3] == 255).all() and (image[np.hypot(x, y) > 5.3][:, 3] == 0).all()
    assert np.abs(image[..., :3][inside] / 255 * 2 - 1 - normal[inside]).max() < 0.05

    status, headers, data = server.ask("POST", "/api/picture", {**SPHERE, **view, "mode": "height"})
    low, high = json.loads(headers["Fieldfab-Picture"])["heights"]
    values = heights(data)
    z = low + (values - 1) / 65534 * (high - low)
    assert np.abs(z[inside] - 5 * normal[..., 2][inside]).max() < 0.02
    assert (values[np.hypot(x, y) > 5.3] == 0).all()


def heights(data):
    """Decodes a PNG of 16 bits as the server writes it."""
    at, packed = 8, b""
    while at < len(data):
        length, name = struct.unpack_from(">I4s", data, at)
        body = data[at + 8 : at + 8 + length]
        if name == b"IHDR":
            width, height, depth, kind = struct.unpack_from(">IIBB", body)
            assert (depth, kind) == (16, 0)
        elif name == b"IDAT":
            packed += body
        at += 12 + length
    rows = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(height, 1 + 2 * width)
    assert set(rows[:, 0]) <= {0, 2}
    raw = np.where(rows[:, :1] == 2, np.cumsum(rows[:, 1:], axis=0, dtype=np.uint8), rows[:, 1:])
    return np.ascontiguousarray(raw).view(">u2").astype(int)


@pytest.mark.parametrize("perspective", [0.0, 0.6, 1.5])
def test_a_pick_is_where_it_is_seen(server, perspective):
    """The point is on the surface, and on the line from the eye through the place of the picture."""
    text, alpha, beta = "box(20, 14, 30) - move(cylinder(4, 60), 3)", 0.7, -0.8
    bounds = server.post("/api/look", {"text": text})[1]["bounds"]
    middle = pictures.turned([(a + b) / 2 for a, b in zip(bounds[:3], bounds[3:])], alpha, beta)
    for at in ([0.0, 0.0], [5.0, 2.0], [-6.0, 7.0], [3.5, -4.0]):
        status, found = server.post("/api/pick", {"text": text, "alpha": alpha, "beta": beta,
                                                  "perspective": perspective, "at": at})
        assert status == 200
        assert found["place"] and abs(found["value"]) < 0.01, (at, found)
        u, v, depth = pictures.turned(found["place"], alpha, beta)
        near = 1 - (depth - middle[2]) / pictures.eye_distance(bounds, perspective)
        seen = [m + (each - m) / near for m, each in zip(middle, (u, v))]
        assert math.dist(seen, at) < 1e-6


@pytest.mark.parametrize("perspective", [0.0, 0.6, 1.5])
def test_a_picture_that_fits_shows_the_whole_model(server, perspective):
    """No part of it touches an edge of the picture; it fills most of one direction."""
    status, _, data = server.ask("POST", "/api/picture", {"text": "box(20, 14, 60)", "perspective": perspective,
                                                          "alpha": 0.0, "beta": 0.0, "width": 120, "height": 120})
    assert status == 200
    seen = pixels(data)[..., 3] > 0
    assert not (seen[0].any() or seen[-1].any() or seen[:, 0].any() or seen[:, -1].any())
    assert seen.any(axis=0).sum() > 100


# Documents


def test_a_document_that_changed_is_not_removed(server):
    version = json.loads(server.ask("PUT", "/api/documents/gone.frep", b"circle(1)")[2])["version"]
    status, _, data = server.ask("DELETE", "/api/documents/gone.frep", If_Match='"0000000000000000"')
    refused((status, json.loads(data)), 409, "was changed by someone else")
    assert server.ask("GET", "/api/documents/gone.frep")[0] == 200
    assert server.ask("DELETE", "/api/documents/gone.frep", If_Match=f'"{version}"')[0] == 200
    assert server.ask("GET", "/api/documents/gone.frep")[0] == 404
    assert server.ask("DELETE", "/api/documents/gone.frep", If_Match=f'"{version}"')[0] == 404


@pytest.mark.parametrize("ending", ["py", "ko", "scad"])
def test_scripts_are_neither_stored_nor_run(server, folder, ending):
    status, _, data = server.ask("PUT", f"/api/documents/script.{ending}", b"cube(1);")
    refused((status, json.loads(data)), 400, "cannot be the name of a document")
    assert not os.path.exists(os.path.join(folder, f"script.{ending}"))
    for path in ("/api/picture", "/api/look"):
        refused(server.post(path, {"text": "cube(1);", "language": ending}), 403, "--allow-scripts")


def test_files_of_each_format(server, tmp_path):
    """Each format of the list makes a file that is not empty; what can be read again has the size of the model."""
    wanted = json.loads(server.ask("GET", "/api/documents")[2])["formats"]
    assert wanted == sorted(files.written_formats()) and len(wanted) > 8
    for extension in wanted:
        status, job = server.post("/api/files", {"text": "box(10, 8, 6)", "extension": extension, "voxel": 0.5})
        assert status == 202, (extension, job)
        while job["state"] in ("waiting", "working"):
            job = json.loads(server.ask("GET", f"/api/jobs/{job['job']}?state={job['state']}&progress="
                                        f"{job['progress']}")[2])
        assert job["state"] == "done", (extension, job["error"])
        status, headers, data = server.ask("GET", f"/api/jobs/{job['job']}/file?name=part{extension}")
        assert status == 200 and len(data) > 10, extension
        assert headers["Content-Disposition"] == f'attachment; filename="part{extension}"'
        if extension in (".stl", ".ply", ".off", ".obj", ".3mf"):
            (tmp_path / f"part{extension}").write_bytes(data)
            assert abs(ff.Mesh.load(tmp_path / f"part{extension}").volume - 480) < 5, extension


# Limits


def test_points_have_a_limit(server):
    refused(server.post("/api/values", {**SPHERE, "points": [[0, 0, 0]] * (limits.LIMITS.points + 1)}), 400,
            "'points' must be a list of at most 100,000 places")


def test_views_of_a_socket_have_a_limit(server):
    async def run():
        async with Socket(server) as socket:
            for i in range(limits.LIMITS.views + 1):
                await socket.send({**SPHERE, "number": i, "view": f"view {i}", "width": 16, "height": 16})
            return await socket.until(lambda told: told["type"] == "error")

    told = asyncio.run(run())[-1][0]
    assert told["message"] == "a socket has at most 8 views" and told["number"] == limits.LIMITS.views


def test_sockets_have_a_limit(tmp_path):
    """One too many is refused, and told why; when one is closed, there is room again."""
    server = Server(tmp_path)

    async def run():
        async with aiohttp.ClientSession(connector=aiohttp.TCPConnector(limit=0)) as session:
            address = f"http://127.0.0.1:{server.port}/api/socket"
            opened = [await session.ws_connect(address) for _ in range(limits.LIMITS.sockets)]
            async with session.get(address, headers={
                    "Upgrade": "websocket", "Connection": "Upgrade", "Sec-WebSocket-Version": "13",
                    "Sec-WebSocket-Key": "x3JJHMbDL1EzLkh9GBhXDw=="}) as answer:
                status, told = answer.status, await answer.json()
            await opened[0].close()
            end = time.monotonic() + 20
            while True:
                try:
                    await session.ws_connect(address)
                    return status, told
                except aiohttp.WSServerHandshakeError:
                    assert time.monotonic() < end
                    await asyncio.sleep(0.05)

    try:
        refused(asyncio.run(run()), 503, "200 pages are open already")
    finally:
        server.end()


def test_jobs_wait_in_a_queue_with_a_limit(server):
    most = limits.LIMITS.jobs + limits.LIMITS.waiting_jobs
    jobs = [server.post("/api/files", LONG) for _ in range(most + 1)]
    try:
        assert [status for status, _ in jobs[:-1]] == [202] * most
        refused(jobs[-1], 503, "too many jobs are waiting; try again later")
    finally:
        for _, job in jobs[:-1]:
            assert server.ask("DELETE", f"/api/jobs/{job['job']}")[0] == 200
    states = [json.loads(server.ask("GET", f"/api/jobs/{job['job']}?state=working")[2])["state"] for _, job in jobs[:-1]
              if server.ask("GET", f"/api/jobs/{job['job']}")[0] == 200]
    assert set(states) <= {"cancelled", "working"}
    status, job = server.post("/api/files", {**SPHERE, "extension": ".stl"})
    assert status == 202, "there is room again"


# Access


def test_the_token_that_is_made_up(tmp_path):
    """With --host and without FIELDFAB_TOKEN there is a new token each time; without it each address answers 401."""
    tokens = set()
    for _ in range(2):
        server = Server(tmp_path, "--host", "0.0.0.0", FIELDFAB_TOKEN="")
        try:
            token = re.search(r"token=(\S+)", server.said)[1]
            tokens.add(token)
            assert len(token) >= 24
            for path in ("/", "/api/documents", "/page/page.js", "/api/socket", "/?token=wrong"):
                status, _, data = server.ask("GET", path)
                refused((status, json.loads(data)), 401, "the token is missing or wrong")
            assert server.ask("GET", "/api/documents", Authorization=f"Bearer {token}")[0] == 200

            async def run(headers):
                async with aiohttp.ClientSession() as session:
                    socket = await session.ws_connect(f"http://127.0.0.1:{server.port}/api/socket", headers=headers)
                    await socket.close()

            with pytest.raises(aiohttp.WSServerHandshakeError, match="401"):
                asyncio.run(run({}))
            asyncio.run(run({"Authorization": f"Bearer {token}"}))
        finally:
            server.end()
    assert len(tokens) == 2
