"""fabserver's protocol: requests of programs, including hostile ones, to `fieldfab serve`."""

import asyncio
import contextlib
import gzip
import io
import json
import os
import signal
import socket as sockets
import struct
import subprocess
import sys
import time
import zipfile
import zlib

import aiohttp
import distributed
import numpy as np
import pytest
import web_hostile
from conftest import BUILD, COMMAND
from rs274 import moves_of_program
from volume_test import dicom, tiff
from web_server import Server, Socket, children, folder, pixels, refused, server, wait_until

import fieldfab as ff
from fieldfab.serve.processes import Pool, Refused

# A text whose cost doubles with each line, beyond any machine's memory and time.
ENDLESS = "a0 = sphere(1)\n" + "".join(f"a{i + 1} = a{i} | move(a{i}, {1.1**i})\n" for i in range(40)) + "a40\n"
SPHERE = {"text": "sphere(5)"}


# Pictures


def test_a_picture_is_the_kernels_own(server):
    """Each pixel of a slice is the sign of the value at its point."""
    text, window = "circle(4) - move(circle(2), 1, 1)", [-5, -4, 5, 4]
    status, headers, data = server.ask("POST", "/api/picture",
                                       {"text": text, "width": 200, "height": 160, "window": window})
    assert status == 200 and headers["Content-Type"] == "image/png"
    shown = pixels(data)[:, :, 0] > 0
    x, y = np.meshgrid(-5 + (np.arange(200) + 0.5) / 20, 4 - (np.arange(160) + 0.5) / 20)
    inside = ff.parse(text).values(np.stack([x.ravel(), y.ravel(), 0 * x.ravel()], axis=1).astype(np.float32)).reshape(
        160, 200) < 0
    assert (shown == inside).mean() > 0.9999
    assert json.loads(headers["Fieldfab-Picture"])["flat"] is True


def test_shaded_pictures_have_no_background_and_parts_have_colours(server):
    text = 'part(move(box(4, 4, 4), -3), "a", "red")\npart(move(box(4, 4, 4), 3), "b", "blue")\n'
    status, _, data = server.ask("POST", "/api/picture",
                                 {"text": text, "width": 160, "height": 120, "alpha": 0, "beta": 0, "smooth": True})
    assert status == 200
    shown = pixels(data)
    assert shown.shape == (120, 160, 4)
    assert shown[0, 0, 3] == 0 and shown[60, 80, 3] == 0, "nothing is there"
    left, right = shown[60, 40], shown[60, 120]
    assert left[3] == right[3] == 255
    assert left[0] > 2 * left[2] and right[2] > 2 * right[0]


def test_a_section_shows_the_inside(server):
    view = {"text": "sphere(5) - sphere(4)", "alpha": 0, "beta": 0, "at": [0, 0]}
    assert abs(server.post("/api/pick", view)[1]["place"][2] - 5) < 0.01
    cut = server.post("/api/pick", {**view, "section": {"axis": "z", "at": 0}})[1]
    assert abs(cut["place"][2] + 4) < 0.01, "the far wall's inner side"


def test_values_bounds_parameters_and_words(server):
    assert server.post("/api/values", {**SPHERE, "points": [[0, 0, 0], [8, 0, 0]]}) == (200, {"values": [-5.0, 3.0]})
    status, seen = server.post("/api/look", {"text": 'part(sphere(r), "ball", "red")\n'.replace("r)", "5)")})
    assert status == 200 and seen["parts"] == [{"name": "ball", "colour": "#ff0000"}] and not seen["flat"]
    text = "# ½ 😀\nwidth = 20  # 5 to 40, outer width\nbox(width, 1, 1)\n"
    [width] = server.post("/api/parameters", {"text": text})[1]["parameters"]
    assert (width["name"], width["value"], width["range"], width["comment"]) == ("width", 20, [5, 40], "outer width")
    units = text.encode("utf-16-le")
    assert units[2 * width["offset"] : 2 * (width["offset"] + width["length"])].decode("utf-16-le") == "20"
    assert server.post("/api/values", {"text": text, "values": {"width": 30}, "points": [[0, 0, 0]]})[0] == 200
    words = server.post("/api/words", {"text": "spher", "offset": 5})[1]
    assert words["from"] == 0 and [each["name"] for each in words["entries"]] == ["sphere"]


def test_mistakes_have_their_places(server):
    error = refused(server.post("/api/look", {"text": "r = 2\n/* 😀 */ spheer(r)\nq\n".replace("/* 😀 */ ", '"😀"; ')}),
                    422)
    assert error["mistakes"][0]["line"] == 2
    error = refused(server.post("/api/look", {"text": "r = 2\nspheer(r)\nq\n"}), 422, "did you mean 'sphere'?")
    assert [(each["line"], each["column"], each["offset"], each["length"])
            for each in error["mistakes"]] == [(2, 1, 6, 6), (3, 1, 16, 1)]


def test_the_description_has_every_address(server):
    status, _, data = server.ask("GET", "/api")
    told = json.loads(data)
    assert status == 200 and told["openapi"].startswith("3.")
    assert set(told["paths"]) >= {"/api/picture", "/api/look", "/api/values", "/api/pick", "/api/files",
                                  "/api/jobs/{job}", "/api/documents/{name}"}
    fields = told["paths"]["/api/picture"]["post"]["requestBody"]["content"]["application/json"]["schema"]
    assert fields["required"] == ["text"] and fields["properties"]["width"]["maximum"] == 4096


# The WebSocket


def run(coroutine):
    return asyncio.run(asyncio.wait_for(coroutine, 120))


def test_pictures_come_coarse_first(server):
    async def talk():
        async with Socket(server) as socket:
            await socket.send({"number": 1, "view": "main", "text": "r = 5 # 1 to 9\nsphere(r)", "width": 400,
                               "height": 300, "coarse": True, "smooth": True})
            return await socket.until(lambda told: told.get("last"))

    answers = run(talk())
    assert answers[0][0]["type"] == "parameters" and answers[0][0]["parameters"][0]["name"] == "r"
    shown = [(told["quality"], told["width"], told["number"]) for told, _ in answers[1:]]
    assert shown == [("coarse", 100, 1), ("fine", 400, 1), ("smooth", 400, 1)]
    assert all(pixels(data).shape == (told["height"], told["width"], 4) for told, data in answers[1:])


def test_a_newer_request_takes_the_place_of_older_ones(server):
    """Of a hundred simultaneous requests, the last is answered in full, and most others are dropped."""
    async def talk():
        async with Socket(server) as socket:
            for number in range(100):
                await socket.send({"number": number, "text": f"gyroid(3) & sphere({5 + number / 100})", "width": 640,
                                   "height": 480, "coarse": True})
            return await socket.until(lambda told: told.get("last") and told["number"] == 99)

    answers = [told for told, _ in run(talk()) if told["type"] == "picture"]
    assert not any(told["number"] < 99 and told.get("last") for told in answers[1:])
    assert len({told["number"] for told in answers}) < 30


def test_views_do_not_disturb_each_other(server):
    async def talk():
        async with Socket(server) as socket:
            for view in ("one", "two"):
                await socket.send({"number": 7, "view": view, **SPHERE, "width": 64, "height": 64})
            seen = set()
            while seen != {"one", "two"}:
                told, _ = await socket.receive()
                if told["type"] == "picture":
                    seen.add(told["view"])

    run(talk())


@pytest.mark.parametrize("message, words", [
    ("{", "JSON"), ("[" * 100_000, "JSON"), ("[]", "'number'"), ('{"number": 1}', "'text' is missing"),
    ('{"number": 1, "text": "sphere(1)", "bounds": [NaN, 0, 0, 1, 1, 1]}', "finite"),
    ('{"number": 1, "text": "sphere(1)", "window": [0, 0, Infinity, 1]}', "finite"),
    ('{"number": 1, "text": "sphere(1)", "bounds": [1, 0, 0, 0, 1, 1]}', "the lower ones first"),
    ('{"number": 1, "text": "sphere(1)", "width": 31623, "height": 31623}', "4096"),
    ('{"number": 1, "text": "sphere(1)", "width": 4000, "height": 4000}', "4,000,000"),
    ('{"number": 1, "text": "sphere(1)", "colour": "red"}', "'colour' is not a field"),
    ('{"number": 1, "text": 3}', "must be text"), ('{"number": 1, "text": "\\ud800"}', "surrogate"),
    ('{"number": 1, "text": "sphere(1)", "values": {"r": "1"}}', "'values.r'"),
    ('{"number": 1, "text": "sphere(1)", "mode": "beautiful"}', "shaded, height, normals, bitmap"),
    ('{"number": 1, "text": "exit()", "language": "py"}', "--allow-scripts"),
])  # fmt: skip
def test_bad_messages_are_told_and_the_socket_goes_on(server, message, words):
    async def talk():
        async with Socket(server) as socket:
            await socket.send(message)
            told, _ = await socket.receive()
            assert told["type"] == "error" and words in told["message"], told
            await socket.send({"number": 2, **SPHERE, "width": 16, "height": 16})
            await socket.until(lambda told: told["type"] == "picture")

    run(talk())


def test_a_text_of_ten_megabytes(server):
    async def talk():
        async with Socket(server) as socket:
            await socket.send({"number": 1, "text": "#" * 10_000_000})
            told, _ = await socket.receive()
            assert told["kind"] == "too_large" and "1,000,000" in told["message"]
            with contextlib.suppress(OSError):  # the server closes the connection without reading the rest
                await socket.send({"number": 1, "text": "#" * 20_000_000})
                assert await socket.receive() is None

    run(talk())
    assert server.post("/api/look", {"text": "#" * 10_000_000})[0] == 413
    assert server.post("/api/look", {"text": "#" * 17_000_000})[0] == 413


def test_sockets_of_other_pages_are_refused(server):
    async def talk(**headers):
        async with Socket(server, **headers):
            pass

    with pytest.raises(aiohttp.WSServerHandshakeError) as error:
        run(talk(Origin="http://elsewhere.example"))
    assert error.value.status == 403
    run(talk(Origin=f"http://127.0.0.1:{server.port}"))


# Failures in workers


def test_an_endless_text_ends_and_others_go_on(server):
    """A newer request ends it, although its evaluation never checks for cancellation."""
    async def talk():
        async with Socket(server) as socket, Socket(server) as other:
            await socket.send({"number": 1, "text": ENDLESS})
            await asyncio.sleep(1)
            await other.send({"number": 1, **SPHERE, "width": 32, "height": 32})
            await other.until(lambda told: told["type"] == "picture", 15)
            await socket.send({"number": 2, **SPHERE, "width": 32, "height": 32})
            answers = await socket.until(lambda told: told["number"] == 2 and told["type"] == "picture", 15)
            assert not any(told["type"] == "picture" and told["number"] == 1 for told, _ in answers)

    run(talk())


def test_requests_whose_time_is_over_are_ended_once():
    """Several clients that wait may end a long request at the same moment; the worker then serves the next one."""
    async def talk():
        pool = Pool(1)
        request = {"do": "look", "text": ENDLESS, "language": "frep", "values": {}, "folder": "/tmp"}
        async with pool.worker(ENDLESS) as worker:
            with pytest.raises(Refused, match="others wait"):
                async def end():
                    while worker._timeout is None:
                        await asyncio.sleep(0.01)
                    for _ in range(5):
                        worker.hurry()
                        await asyncio.sleep(0)

                ending = asyncio.create_task(end())
                async for _ in worker.ask(request, 20):
                    pass
            await ending
        assert (await pool.ask({**request, "text": "sphere(5)"}))[0]["flat"] is False
        pool.kill()
        await asyncio.sleep(0.1)  # the loop notices the end of the process

    run(talk())


def test_workers_find_their_modules_wherever_the_server_is(tmp_path, monkeypatch):
    """The path of modules may be relative to the folder that the server started in; a json.py of the user is not
    Python's."""
    (tmp_path / "json.py").write_text("raise SystemExit(7)")
    (tmp_path / "model.frep").write_text("sphere(5)")
    monkeypatch.setenv("PYTHONPATH", "build/release/python")
    monkeypatch.chdir(tmp_path)

    async def talk():
        pool = Pool(1)
        request = {"do": "look", "text": "sphere(5)", "language": "frep", "values": {}, "folder": "."}
        assert (await pool.ask(request))[0]["flat"] is False
        pool.kill()
        await asyncio.sleep(0.1)  # the loop notices the end of the process

    run(talk())


def test_no_request_waits_for_ever_behind_others():
    """Requests of rank 0 arrive all the time. One of rank 2 gets its turn."""
    async def talk():
        pool, served = Pool(1), []

        async def one(rank):
            async with pool.worker("", rank):
                served.append(rank)
                await asyncio.sleep(0.05)

        async def crowd():
            while 2 not in served:
                await one(0)

        crowds = [asyncio.create_task(crowd()) for _ in range(4)]
        await asyncio.sleep(0.1)
        await asyncio.wait_for(one(2), 20)
        await asyncio.gather(*crowds)
        assert served.index(2) > 20, "others go first for some seconds"

    run(talk())


def test_a_worker_that_is_killed_is_replaced(server):
    for process in server.workers():
        os.kill(process, signal.SIGKILL)
    time.sleep(0.2)
    answers = [server.post("/api/look", SPHERE)[0] for _ in range(6)]
    assert answers[-1] == 200 and set(answers) <= {200, 422}
    assert answers.count(422) <= 2


def test_deep_nesting_is_an_answer(server):
    assert server.post("/api/look", {"text": "(" * 200_000 + "sphere(1)" + ")" * 200_000})[0] in (200, 422)
    assert server.post("/api/look", SPHERE)[0] == 200


def test_what_is_empty_is_told(server):
    refused(server.post("/api/look", {"text": "sphere(1) & move(sphere(1), 10)"}), 422, "nothing to show")
    refused(server.post("/api/look", {"text": ""}), 422)


def test_workers_end_with_their_server(tmp_path):
    running = Server(tmp_path)
    workers = running.workers()
    assert len(workers) >= 2
    running.kill()
    end = time.monotonic() + 10
    while any(os.path.exists(f"/proc/{each}") and "zombie" not in open(f"/proc/{each}/status").read()
              for each in workers):
        assert time.monotonic() < end
        time.sleep(0.05)


# Files


def finished(server, job):
    while job["state"] in ("waiting", "working"):
        job = json.loads(
            server.ask("GET", f"/api/jobs/{job['job']}?state={job['state']}&progress={job['progress']}")[2])
    return job


def test_files_of_formats(server, tmp_path):
    text = 'part(box(4, 4, 4), "base", "teal")\npart(move(sphere(2), 0, 0, 5), "ball", "gold")\n'
    for extension in (".glb", ".stl", ".3mf", ".asdf", ".frep"):
        status, job = server.post("/api/files", {"text": text, "extension": extension})
        assert status == 202
        job = finished(server, job)
        assert job["state"] == "done", job
        status, headers, data = server.ask("GET", f"/api/jobs/{job['job']}/file")
        assert status == 200 and len(data) == job["result"]["bytes"]
        assert headers["Content-Disposition"] == f'attachment; filename="model{extension}"'
        for name, saved in (("part.stl", "part.stl"), ("..%2Fpart", f"model{extension}"),
                            ("a%22;b", f"model{extension}")):
            headers = server.ask("GET", f"/api/jobs/{job['job']}/file?name={name}")[1]
            assert headers["Content-Disposition"] == f'attachment; filename="{saved}"'
        if extension == ".glb":
            assert data[:4] == b"glTF" and struct.unpack_from("<I", data, 8)[0] == len(data)
            assert b'"base"' in data and b'"ball"' in data
        if extension == ".stl":
            (tmp_path / "model.stl").write_bytes(data)
            assert ff.inspect(ff.Mesh.load(tmp_path / "model.stl")).valid


def test_a_flat_model_becomes_a_plate(server, tmp_path):
    _, job = server.post("/api/files", {"text": "circle(5)", "extension": ".stl", "thickness": 2})
    job = finished(server, job)
    (tmp_path / "plate.stl").write_bytes(server.ask("GET", f"/api/jobs/{job['job']}/file")[2])
    assert abs(ff.Mesh.load(tmp_path / "plate.stl").volume - np.pi * 25 * 2) < 1
    assert job["result"]["thickness"] == 2


def test_jobs_are_cancelled_and_refused(server):
    _, job = server.post("/api/files", {"text": ENDLESS, "extension": ".stl"})
    status, _, data = server.ask("GET", f"/api/jobs/{job['job']}/file")
    refused((status, json.loads(data)), 409, "no file")
    assert server.ask("DELETE", f"/api/jobs/{job['job']}")[0] == 200
    assert finished(server, job)["state"] == "cancelled"
    refused(server.post("/api/files", {**SPHERE, "extension": ".exe"}), 400, "not a format")
    refused(server.post("/api/files", {**SPHERE, "extension": "/../../x.stl"}), 400, "not a format")
    status, _, _ = server.ask("GET", "/api/jobs/nothing")
    assert status == 404


def test_jobs_run_on_a_cluster(tmp_path):
    """As on this machine: files, errors, progress, cancellation. An unreachable cluster is reported."""
    path = {"PYTHONPATH": str(BUILD / "python")}
    with distributed.LocalCluster(n_workers=1, threads_per_worker=2, dashboard_address=None, env=path) as cluster:
        [nanny] = cluster.workers.values()
        running = Server(tmp_path, "--scheduler", cluster.scheduler_address,
                         command=(sys.executable, "-m", "fieldfab.serve"), **path)
        workers = running.workers()
        try:
            job = finished(running, running.post("/api/files", {**SPHERE, "extension": ".stl"})[1])
            assert job["state"] == "done" and job["progress"] == 1, job
            (tmp_path / "ball.stl").write_bytes(running.ask("GET", f"/api/jobs/{job['job']}/file")[2])
            assert abs(ff.Mesh.load(tmp_path / "ball.stl").volume / (4 / 3 * np.pi * 125) - 1) < 0.01
            job = finished(running, running.post("/api/files", {"text": "spheer(5)", "extension": ".stl"})[1])
            assert job["state"] == "failed" and "did you mean 'sphere'?" in job["error"]["message"]

            _, job = running.post("/api/files", {"text": ENDLESS, "extension": ".stl"})
            wait_until(lambda: children(nanny.pid), "the job's process on the cluster")
            assert running.workers() == workers, "no process of the server's own"
            assert running.ask("DELETE", f"/api/jobs/{job['job']}")[0] == 200
            assert finished(running, job)["state"] == "cancelled"
            wait_until(lambda: not children(nanny.pid), "its end")
        finally:
            running.end()
    running = Server(tmp_path, "--scheduler", cluster.scheduler_address,
                     command=(sys.executable, "-m", "fieldfab.serve"), **path)
    try:
        job = finished(running, running.post("/api/files", {**SPHERE, "extension": ".stl"})[1])
        assert job["state"] == "failed" and "does not answer" in job["error"]["message"]
    finally:
        running.end()


# Documents


def test_documents_are_written_whole_and_with_versions(server, folder):
    status, headers, _ = server.ask("PUT", "/api/documents/part.frep", b"sphere(5)\n")
    assert status == 200 and open(f"{folder}/part.frep").read() == "sphere(5)\n"
    version = headers["ETag"]
    assert server.ask("PUT", "/api/documents/part.frep", b"box(1, 1, 1)\n")[0] == 409, "there is one already"
    assert server.ask("PUT", "/api/documents/part.frep", b"box(1, 1, 1)\n", If_Match=version)[0] == 200
    assert server.ask("PUT", "/api/documents/part.frep", b"box(2, 1, 1)\n", If_Match=version)[0] == 409, (
        "changed meanwhile")
    status, headers, data = server.ask("GET", "/api/documents/part.frep")
    assert data == b"box(1, 1, 1)\n" and headers["ETag"] != version
    assert "part.frep" in [each["name"] for each in json.loads(server.ask("GET", "/api/documents")[2])["documents"]]
    assert [name for name in os.listdir(folder) if name.startswith(".")] == []
    assert server.ask("DELETE", "/api/documents/part.frep")[0] == 200 and not os.path.exists(f"{folder}/part.frep")
    assert server.ask("GET", "/api/documents/part.frep")[0] == 404


@pytest.mark.parametrize("name", ["../out.frep", "..%2Fout.frep", "%2e%2e%2fout.frep", "a%2Fb.frep", "%2Fetc%2Fpasswd",
                                  ".hidden.frep", "x.py", "x.frep%00.txt", "x.sh", "con%0A.frep", "a" * 200 + ".frep"])
def test_names_stay_in_the_folder(server, folder, name):
    before = sorted(os.listdir(folder)), sorted(os.listdir(os.path.dirname(folder)))
    assert server.ask("PUT", f"/api/documents/{name}", b"sphere(1)")[0] in (400, 404, 405)
    assert server.ask("GET", f"/api/documents/{name}")[0] in (400, 404)
    assert (sorted(os.listdir(folder)), sorted(os.listdir(os.path.dirname(folder)))) == before


def test_links_do_not_lead_out(server, folder, tmp_path):
    (tmp_path / "secret.frep").write_text("sphere(1)")
    os.symlink(tmp_path / "secret.frep", f"{folder}/link.frep")
    assert server.ask("GET", "/api/documents/link.frep")[0] == 403
    assert server.ask("PUT", "/api/documents/link.frep", b"box(1, 1, 1)", If_Match="*")[0] == 403
    assert (tmp_path / "secret.frep").read_text() == "sphere(1)"


def test_documents_have_limits(server):
    assert server.ask("PUT", "/api/documents/large.frep", b"#" * 4_000_001)[0] == 413
    assert server.ask("PUT", "/api/documents/bytes.frep", b"\xff\xfe")[0] == 400


def test_texts_open_files_of_the_folder_only(server, folder, tmp_path):
    (tmp_path / "outside.frep").write_text("sphere(1)")
    with open(f"{folder}/ball.frep", "w") as file:
        file.write("sphere(3)\n")
    with open(f"{folder}/indirect.frep", "w") as file:
        file.write(f'open("{tmp_path}/outside.frep")\n')
    assert server.post("/api/values", {"text": 'open("ball.frep")', "points": [[0, 0, 0]]}) == (200, {"values": [-3.0]})
    for name in ("/etc/passwd", f"{tmp_path}/outside.frep", "../../outside.frep", "indirect.frep", "ball.py",
                 "missing.frep"):
        error = refused(server.post("/api/look", {"text": f'move(\n  open("{name}"), 1)'}), 422)
        assert error["mistakes"], name
    refused(server.post("/api/look", {"text": '"x"; open("..\\/ball.frep")'}), 422)
    os.symlink(tmp_path / "outside.frep", f"{folder}/aside.frep")
    refused(server.post("/api/look", {"text": 'open("aside.frep")'}), 422, "is not in the folder")


# Machining

TOOL = {"number": 1, "shape": "flat", "diameter": 6, "flute": 20, "length": 40}
JOB = {"machine": "linuxcnc", "zero": "corner", "stock": {"margin": 2, "top": 1}, "tools": [TOOL],
       "operations": [{"type": "rough", "tool": 1, "allowance": 0}]}
BLOCK = "box(30, 20, 8) - move(box(8, 8, 8), 0, 0, 4)"


def test_the_tables_of_machines_and_operations(server):
    told = json.loads(server.ask("GET", "/api/machining")[2])
    assert {each["id"] for each in told["machines"]} == set(ff.cam.machines())
    rough = next(each for each in told["operations"] if each["name"] == "rough")
    assert ({"cell", "stepover", "allowance", "bottom"} <= {each["name"] for each in rough["settings"]}
            and {"feed", "spindle"} <= {each["name"] for each in told["joining"]})


def test_a_program_is_planned_and_simulated(server, tmp_path):
    job = finished(server, server.post("/api/machine", {"text": BLOCK, "job": JOB, "simulate": True})[1])
    assert job["state"] == "done", job
    told, file = job["result"], lambda name: server.ask("GET", f"/api/jobs/{job['job']}/files/{name}")
    assert (told["good"] and told["events"] == [] and told["removed"] > 300 and 20 < told["seconds"] < 2000
            and told["stock"][3] - told["stock"][0] > 34)
    (tmp_path / "program.ngc").write_bytes(file("program.ngc")[2])
    places, kinds, _ = moves_of_program(tmp_path / "program.ngc", tools=((1, 40, 6),))
    assert len(places) > 20 and places[:, 2].min() > -9.1 and "STRAIGHT_FEED" in kinds
    assert server.ask("GET", f"/api/jobs/{job['job']}/file")[2] == (tmp_path / "program.ngc").read_bytes()
    for name in ("sheet.html", "report.html"):
        status, headers, data = file(name)
        assert (status == 200 and b"<html" in data and "sandbox" in headers["Content-Security-Policy"]
                and "script" not in headers["Content-Security-Policy"].replace("sandbox allow-popups", ""))
    stock, data = json.loads(file("stock.json")[2]), file("stock.bin")[2]
    volumes = [drawn_volume(stock["stills"][: i + 1], data) for i in (0, len(stock["stills"]) - 1)]
    assert abs(volumes[0] - volumes[1] - told["removed"]) < 0.05 * told["removed"], "what is drawn is what was removed"
    assert {int(pose[6]) for pose in stock["poses"]} == {1} and set(stock["tools"]["1"]) >= {"cutting"}
    (tmp_path / "part.frep").write_text(BLOCK)
    (tmp_path / "job.toml").write_bytes(file("job.toml")[2])
    subprocess.run([COMMAND, "cam", tmp_path / "job.toml", "-o", tmp_path / "again.ngc"], check=True,
                   capture_output=True)
    assert ((tmp_path / "again.ngc").read_text().splitlines()[3:]
            == (tmp_path / "program.ngc").read_text().splitlines()[3:]), "the command plans the same"
    assert file("setup.py")[0] == 404 and file("..%2F..%2Fapp.py")[0] == 404


def drawn_volume(stills, data):
    """Returns the volume inside the newest pieces of a surface."""
    newest = {piece["piece"]: piece for still in stills for piece in still["pieces"]}
    total = 0
    for piece in newest.values():
        vertices = np.frombuffer(data, "<f4", 3 * piece["vertices"], piece["at"]).reshape(-1, 3).astype(float)
        a, b, c = vertices[np.frombuffer(data, "<u2" if piece["vertices"] < 65536 else "<u4", 3 * piece["triangles"],
                                         piece["corners"]).reshape(-1, 3).T]
        total += np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6
    return total


@pytest.mark.parametrize("change, words", [
    ({"machine": "../mine.toml"}, "must be one of"),
    ({"tools": [{**TOOL, "library": "/etc/passwd"}]}, "'library' is not a setting"),
    ({"stock": {"file": "/etc/passwd"}}, "'file' is not a setting"),
    ({"input": {"model": "x"}}, "must be an object of"),
    ({"tools": [{**TOOL, "name": 'x"\nlibrary = "y'}]}, "short text"),
    ({"operations": [{'type"]\n': "x"}]}, "not a setting"),
    ({"operations": [{"type": "rough", "tool": 1, "feed": float("nan")}]}, "finite"),
    ({"tools": [TOOL] * 51}, "at most 50"),
])  # fmt: skip
def test_jobs_name_no_files(server, change, words):
    refused(server.post("/api/machine", {"text": BLOCK, "job": {**JOB, **change}}), 400, words)


def test_what_a_job_lacks_is_told(server):
    job = finished(server, server.post(
        "/api/machine", {"text": BLOCK, "job": {**JOB, "operations": [{"type": "rough", "tool": 1, "stepovr": 1}]}})[1])
    assert job["state"] == "failed" and "stepover" in job["error"]["message"]
    job = finished(server, server.post(
        "/api/machine", {"text": BLOCK, "job": {**JOB, "tools": [{**TOOL, "name": '"]x'}], "operations": []}})[1])
    assert job["state"] == "failed" and "operation" in job["error"]["message"]


# Scans


def ball(radius, size):
    at = np.indices((size, size, size)) - (size - 1) / 2
    return np.clip(100 + 40 * (radius - np.sqrt((at**2).sum(axis=0))), 0, 200).astype(np.float32)


def ball_scan(path, radius=8, size=32):
    """Writes a scan of a ball with densities 0 to 200, 100 at its surface; spacing 1 mm."""
    ff.Volume(ball(radius, size)).save(path)
    return path.read_bytes()


def test_a_scan_is_uploaded_looked_at_and_shown(server, folder, tmp_path):
    data = ball_scan(tmp_path / "ball.nii.gz")
    assert server.ask("PUT", "/api/scans/ball.nii.gz", data)[0] == 201
    assert open(f"{folder}/ball.nii.gz", "rb").read() == data
    assert (server.ask("PUT", "/api/scans/ball.nii.gz", b"other")[0] == 409
            and open(f"{folder}/ball.nii.gz", "rb").read() == data)
    assert json.loads(server.ask("GET", "/api/documents")[2])["scans"] == ["ball.nii.gz"]
    status, scan = server.post("/api/scan", {"name": "ball.nii.gz"})
    assert (status == 200 and scan["size"] == [32, 32, 32] and sum(scan["counts"]) == 32**3
            and len(scan["counts"]) <= 256)
    assert scan["from"] <= 0 and scan["to"] >= 200 and 60 < scan["halfway"] < 140
    for level, within in ((100, False), (60, True)):
        text = f'level = {level}\nopen("ball.nii.gz", threshold = level)\n'
        values = server.post("/api/values",
                             {"text": text, "points": [[15.5, 15.5, 15.5], [15.5, 15.5 + 8.5, 15.5]]})[1]["values"]
        assert values[0] < 0 and (values[1] < 0) == within
    assert server.ask("DELETE", "/api/scans/ball.nii.gz")[0] == 200 and not os.path.exists(f"{folder}/ball.nii.gz")
    refused(server.post("/api/scan", {"name": "ball.nii.gz"}), 404, "no scan")


@pytest.mark.parametrize("name", ["../out.nii", "..%2Fout.nii", "%2Fetc%2Fpasswd.nii", ".hidden.nii", "x.mhd",
                                  "x.frep", "x.nii%00.sh", "a" * 200 + ".nii"])
def test_scans_stay_in_the_folder(server, folder, name):
    before = sorted(os.listdir(folder)), sorted(os.listdir(os.path.dirname(folder)))
    assert server.ask("PUT", f"/api/scans/{name}", b"data")[0] in (400, 404, 405)
    assert server.ask("DELETE", f"/api/scans/{name}")[0] in (400, 404, 405)
    assert (sorted(os.listdir(folder)), sorted(os.listdir(os.path.dirname(folder)))) == before


def test_scans_are_whole_or_refused(server, folder, tmp_path):
    os.symlink(tmp_path / "elsewhere.nii", f"{folder}/link.nii")
    (tmp_path / "elsewhere.nii").write_bytes(b"secret")
    refused(server.post("/api/scan", {"name": "link.nii"}), 404)
    assert (server.ask("PUT", "/api/scans/link.nii", b"data")[0] == 409
            and (tmp_path / "elsewhere.nii").read_bytes() == b"secret")
    assert server.ask("PUT", "/api/scans/empty.nii", b"")[0] == 400
    assert server.ask("PUT", "/api/scans/garbage.nii", os.urandom(4000))[0] == 201
    refused(server.post("/api/scan", {"name": "garbage.nii"}), 422)
    os.remove(f"{folder}/garbage.nii"), os.remove(f"{folder}/link.nii")
    with sockets.create_connection(("127.0.0.1", server.port)) as half:  # it breaks off
        half.sendall(f"PUT /api/scans/half.nii HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n"
                     "Content-Length: 100000\r\n\r\n".encode() + bytes(50_000))
        wait_until(lambda: any(each.startswith(".upload") for each in os.listdir(folder)), "the upload's beginning")
    wait_until(lambda: not any(each.startswith(".upload") for each in os.listdir(folder)), "the upload's end")
    assert not os.path.exists(f"{folder}/half.nii")
    with sockets.create_connection(("127.0.0.1", server.port)) as long:
        long.sendall(f"PUT /api/scans/long.nii HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n"
                     "Content-Length: 2000000000\r\n\r\n".encode())
        assert b" 413 " in long.recv(1000)


def test_an_upload_that_is_cancelled_ends_its_conversion(server, folder):
    """The worker ends within a second of the client's going away, and leaves nothing."""
    size = 700
    body = gzip.compress(bytes(size**3), 1)
    head = (f"NRRD0004\ntype: uint8\ndimension: 3\nsizes: {size} {size} {size}\nspacings: 1 1 1\nencoding: gzip\n\n")
    before = set(server.workers())
    with sockets.create_connection(("127.0.0.1", server.port)) as client:
        client.sendall(f"PUT /api/scans/large.nrrd HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n"
                       f"Content-Length: {len(head) + len(body)}\r\n\r\n{head}".encode() + body)
        wait_until(lambda: set(server.workers()) - before, "the conversion")
        [worker] = set(server.workers()) - before
        time.sleep(0.3)
        assert worker in server.workers(), "it takes long enough to be cancelled"
    wait_until(lambda: worker not in server.workers(), "the end of the conversion", 1)
    wait_until(lambda: not any(each.startswith(".upload") for each in os.listdir(folder)), "no files of it")
    assert not os.path.exists(f"{folder}/large.nii")


def zipped(contents):
    """Returns a .zip archive of {name: bytes}."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in contents.items():
            archive.writestr(name, content)
    return made.getvalue()


BALL = ball(8, 32)
NRRD = b"NRRD0004\ntype: float\ndimension: 3\nsizes: 32 32 32\nspacings: 1 1 1\nendian: little\nencoding: raw\n"
MHD = (b"ObjectType = Image\nNDims = 3\nDimSize = 32 32 32\nElementType = MET_FLOAT\nElementSpacing = 1 1 1\n"
       b"ElementByteOrderMSB = False\n")
DICOM = {f"series/IM{k}": dicom(k, rows=BALL[k].astype("u2"), z=k, spacing=(1, 1, 1)) for k in range(32)}
OTHERS = {f"other/IM{k}": dicom(k, "1.2.9", rows=0 * BALL[k].astype("u2") + k, z=k, spacing=(1, 1, 1))
          for k in range(5)}
CONVERTED = {
    "ball.nrrd": NRRD + b"\n" + BALL.tobytes(),
    "ball.mha": MHD + b"ElementDataFile = LOCAL\n" + BALL.tobytes(),
    "mhd and raw.zip": zipped({"a/ball.mhd": MHD + b"ElementDataFile = ball.raw\n", "a/ball.raw": BALL.tobytes()}),
    "nhdr and raw.zip": zipped({"ball.nhdr": NRRD + b"data file: ball.raw\n\n", "ball.raw": BALL.tobytes()}),
    "dicom.zip": zipped({**DICOM, "DICOMDIR": b"no slice", "__MACOSX/._IM1": b"", "readme.txt": b"words"}),
    "two series.zip": zipped({**DICOM, **OTHERS}),
}


@pytest.mark.parametrize("name", CONVERTED)
def test_scans_of_other_formats_become_nifti(server, folder, name):
    """Also from archives, whose folders are left out."""
    status, _, data = server.ask("PUT", f"/api/scans/{name.replace(' ', '%20')}", CONVERTED[name])
    told = json.loads(data)
    stem = name.rpartition(".")[0]
    assert status == 201 and told["name"] == f"{stem}.nii", told
    assert ("the longest of 2 series" in told["note"]) == (name == "two series.zip")
    status, scan = server.post("/api/scan", {"name": told["name"]})
    assert status == 200 and scan["size"] == [32, 32, 32] and scan["spacing"] == [1, 1, 1]
    densities = ff.Volume.open(f"{folder}/{stem}.nii").densities()
    assert abs(densities - (BALL if "dicom" not in name and "series" not in name else BALL.astype("u2"))).max() == 0
    again = server.ask("PUT", f"/api/scans/{name.replace(' ', '%20')}", CONVERTED[name])
    refused((again[0], json.loads(again[2])), 409, "already")
    assert server.ask("DELETE", f"/api/scans/{told['name'].replace(' ', '%20')}")[0] == 200
    assert [each for each in os.listdir(folder) if each.startswith(".")] == []


SECRET = "/etc/passwd"
HOSTILE = {
    "names.nrrd": (NRRD + f"data file: {SECRET}\n\n".encode(), "was not uploaded with it"),
    "spaced.nrrd": (NRRD + f"  datafile :{SECRET}\n\n".encode(), "was not uploaded with it"),
    "list.nrrd": (NRRD + b"data file: LIST\n" + SECRET.encode() + b"\n\n", "was not uploaded with it"),
    "names.mha": (MHD + f"ElementDataFile = {SECRET}\n".encode(), "was not uploaded with it"),
    "twice.mha": (MHD + f"ElementDataFile = LOCAL\nElementDataFile = {SECRET}\n".encode(), "was not uploaded with it"),
    "none.mha": (MHD, "has no 'ElementDataFile'"),
    "endless.nrrd": (NRRD + b"# words\n" * 20_000, "has no end"),
    "up.zip": (zipped({"ball.mhd": MHD + b"ElementDataFile = ../../ball.raw\n", "ball.raw": b""}),
               "was not uploaded with it"),
    "two.zip": (zipped({"a.nii": b"1", "b.nii": b"2"}), "these are 2 scans: a.nii, b.nii"),
    "empty.zip": (zipped({}), "no files"),
    "garbage.zip": (os.urandom(5000), "cannot be read"),
    "words.zip": (zipped({"readme.txt": b"words"}), ""),
    "garbage.nrrd": (NRRD + b"\n" + bytes(100), ""),
    "garbage.dcm": (os.urandom(5000), ""),
    "many.zip": (zipped({f"{i}.dcm": b"" for i in range(5_001)}), "5,000 are possible"),
    "bomb.zip": (None, "2,000,000,000 are possible"),
    "sizes.nrrd": (NRRD.replace(b"32 32 32", b"32000 32000 32000") + b"\n", ""),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_scans_are_refused(server, folder, tmp_path, name):
    """Headers that name other files, bombs and garbage: one line, and no file."""
    data, words = HOSTILE[name]
    if data is None:  # 2.1 GB of zeros in 2 MB
        with zipfile.ZipFile(tmp_path / "bomb.zip", "w", zipfile.ZIP_DEFLATED) as archive:
            with archive.open("zeros.raw", "w", force_zip64=True) as file:
                for _ in range(2100):
                    file.write(bytes(1_000_000))
        data = (tmp_path / "bomb.zip").read_bytes()
    before = sorted(os.listdir(folder))
    status, _, answer = server.ask("PUT", f"/api/scans/{name}", data)
    error = refused((status, json.loads(answer)), 422, words)
    assert "upload-" not in error["message"] and sorted(os.listdir(folder)) == before


def test_slices_have_the_distances_of_their_file(server, folder):
    slices = {f"s/{k}.tif": tiff(BALL[k].astype("u1")) for k in range(32)}
    told = b"widthScale = 0.5\nheightScale = 0.75\ndepthScale = 2\n"
    given = zipped({**slices, "s/dimensions.txt": told, "s/readme.txt": b"words"})
    assert server.ask("PUT", "/api/scans/slices.zip", given)[0] == 201
    scan = server.post("/api/scan", {"name": "slices.nii"})[1]
    assert scan["size"] == [32, 32, 32] and scan["spacing"] == [0.5, 0.75, 2]
    server.ask("DELETE", "/api/scans/slices.nii")


def test_what_a_killed_server_left_of_uploads_is_removed(tmp_path):
    for name, age in ((".upload-0123456789abcdef", 7200), (".upload-0123456789abcde0", 0), (".upload-mine", 7200)):
        (tmp_path / name).mkdir()
        os.utime(tmp_path / name, (time.time() - age,) * 2)
    Server(tmp_path).end()
    assert sorted(os.listdir(tmp_path)) == [".upload-0123456789abcde0", ".upload-mine"]


# Safety


def test_other_names_and_other_pages_are_refused(server):
    assert server.ask("GET", "/api/documents", Host="elsewhere.example")[0] == 403, "rebinding of names"
    assert server.ask("GET", "/api/documents", Host=f"localhost:{server.port}")[0] == 200
    assert server.ask("POST", "/api/look", SPHERE, Origin="http://elsewhere.example")[0] == 403
    assert server.ask("POST", "/api/look", SPHERE, Origin="null")[0] == 403
    assert server.ask("GET", "/api/documents", Sec_Fetch_Site="cross-site")[0] == 403
    assert server.ask("POST", "/api/look", SPHERE, Origin=f"http://127.0.0.1:{server.port}")[0] == 200


def test_the_page_has_a_policy(server):
    status, headers, data = server.ask("GET", "/")
    assert status == 200 and b"@NONCE@" not in data
    policy = headers["Content-Security-Policy"]
    assert "default-src 'none'" in policy and "script-src 'self';" in policy and "frame-ancestors 'none'" in policy
    assert "unsafe" not in policy
    assert headers["X-Content-Type-Options"] == "nosniff"
    sandbox = server.ask("GET", "/page/sandbox.html")[1]["Content-Security-Policy"]
    assert ("sandbox allow-scripts;" in sandbox and "connect-src 'none'" in sandbox
            and "allow-same-origin" not in sandbox)
    assert server.ask("GET", "/page/..%2Fapp.py")[0] == 404 and server.ask("GET", "/page/app.py")[0] == 404
    page = sum(len(zlib.compress(server.ask("GET", f"/page/{name}")[2]))
               for name in os.listdir(BUILD / "python" / "fieldfab" / "serve" / "page"))
    assert page < 400_000


def test_it_listens_on_this_machine_only(server):
    listening = [line.split() for line in open("/proc/net/tcp").read().splitlines()[1:]]
    at = [fields[1] for fields in listening if fields[3] == "0A" and int(fields[1].split(":")[1], 16) == server.port]
    assert at == [f"0100007F:{server.port:04X}"]


def test_other_machines_need_the_token(tmp_path):
    running = Server(tmp_path, "--host", "0.0.0.0", FIELDFAB_TOKEN="a-token-for-this-test")
    try:
        assert "?token=a-token-for-this-test" in running.address
        for headers in ({}, {"Cookie": "fieldfab_token=wrong"}, {"Authorization": "Bearer wrong"},
                        {"Authorization": "a-token-for-this-test"}):
            assert running.ask("GET", "/api/documents", **headers)[0] == 401
        assert running.ask("GET", "/")[0] == 401 and running.ask("GET", "/?token=wrong")[0] == 401
        assert running.ask("GET", "/page/page.js")[0] == 401
        status, headers, _ = running.ask("GET", "/?token=a-token-for-this-test")
        assert (status == 302 and headers["Location"] == "/" and "HttpOnly" in headers["Set-Cookie"]
                and "SameSite=Strict" in headers["Set-Cookie"])
        assert running.ask("GET", "/api/documents", Cookie=headers["Set-Cookie"].split(";")[0])[0] == 200
        assert running.ask("GET", "/api/documents", Authorization="Bearer a-token-for-this-test")[0] == 200
    finally:
        running.end()


def test_scripts_run_only_where_they_are_allowed(server, tmp_path):
    script = {"text": f"open({str(tmp_path / 'ran')!r}, 'w').close()\nfrom fieldfab.shapes import sphere\n"
              "solid = sphere(5)\n", "language": "py"}
    refused(server.post("/api/look", script), 403, "--allow-scripts")
    assert server.ask("PUT", "/api/documents/script.py", b"")[0] == 400
    assert not (tmp_path / "ran").exists()
    running = Server(tmp_path, "--allow-scripts")
    try:
        status, seen = running.post("/api/look", script)
        assert status == 200 and abs(seen["bounds"][3] - 5) < 0.2 and (tmp_path / "ran").exists()
        assert running.ask("PUT", "/api/documents/script.py", b"")[0] == 200
    finally:
        running.end()


def test_garbage_and_idle_connections_do_no_harm(server):
    idle = [sockets.create_connection(("127.0.0.1", server.port)) for _ in range(50)]
    for each in idle[::2]:
        each.sendall(os.urandom(300))
    assert server.post("/api/look", SPHERE)[0] == 200
    for each in idle:
        each.close()


def test_a_short_siege(tmp_path):
    """Clients disconnect, send garbage, flood and hold connections for 15 s (web_hostile.py: 10 minutes). A regular
    client gets its pictures meanwhile. The server's memory does not grow; it leaves no files and prints no messages."""
    running = Server(tmp_path)
    try:
        waited, _, memory, said = asyncio.run(web_hostile.siege(running, 15, crowd=2))
    finally:
        running.kill()
    assert waited and max(waited) < 60
    assert max(server for _, server, _ in memory) < 250 and max(sum(workers) for _, _, workers in memory) < 4000
    assert said == "" and os.listdir(tmp_path) == []


def test_the_command_tells_what_is_wrong(tmp_path):
    done = subprocess.run([COMMAND, "serve", tmp_path / "nowhere", "--no-browser"], capture_output=True, text=True,
                          timeout=30)
    assert done.returncode == 2 and "there is no such folder" in done.stderr
    running = Server(tmp_path)
    try:
        done = subprocess.run([COMMAND, "serve", tmp_path, "--no-browser", "--port", str(running.port)],
                              capture_output=True, text=True, timeout=30)
        assert done.returncode == 2 and "in use" in done.stderr
        running.process.send_signal(signal.SIGINT)
        assert running.process.wait(10) == 130
    finally:
        running.kill()
