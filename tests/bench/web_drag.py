"""Measures the latency of pictures during a drag: from a request with a new text to the coarse and to the fine picture
of 800 x 600 pixels, through the WebSocket of `fieldfab serve` on this machine. Then 50 clients at once. Prints
percentiles.

    PYTHONPATH=build/release/python python3 tests/bench/web_drag.py [SECONDS]
"""

import asyncio
import pathlib
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "hosts"))
from web_server import Server, Socket

import fieldfab as ff  # after the tests' conftest, which finds the build

DATA = ROOT / "tests" / "data" / "frep"
BETWEEN = 0.3  # seconds of rest after a fine picture


def models():
    parts = [(ff.parse_math(path.read_text()), f"part {i}", None)
             for i, path in enumerate(sorted((DATA / "mtm_az").glob("*.math")))]
    mtm_az = ff.frep_text(parts)
    return {
        "prospero, 2D": ({"text": (DATA / "prospero.vm").read_text(), "language": "vm", "mode": "bitmap",
                          "bounds": [-1, -1, 0, 1, 1, 0]}, [-1, -0.75, 1, 0.75], "# {}\n"),
        "mtm_az, 3D": ({"text": mtm_az, "mode": "shaded"}, None, "# {}\n"),
        "bracket, 3D": ({"text": (ROOT / "examples" / "bracket.frep").read_text()}, None, "# {}\n"),
    }


def told(name, seconds):
    if not seconds:
        return print(f"{name:<44} none within the time")
    seconds = sorted(seconds)
    at = {share: 1000 * seconds[min(len(seconds) - 1, int(share * len(seconds)))] for share in (0.5, 0.9, 0.99)}
    print(f"{name:<44} n {len(seconds):5d}   median {at[0.5]:6.0f} ms   90 % {at[0.9]:6.0f} ms   99 % "
          f"{at[0.99]:6.0f} ms", flush=True)


async def drag(server, name, model, window, comment, seconds):
    """Requests pictures as the page does: the next one after the coarse picture, with occasional pauses until the fine
    one."""
    coarse, fine, number, near = [], [], 0, None
    async with Socket(server) as socket:
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            number += 1
            rests = number % 10 == 0
            started = time.monotonic()
            await socket.send({"number": number, "width": 800, "height": 600, "coarse": True, "window": window,
                               "near": near, **model, "text": model["text"] + comment.format(number)})
            while True:
                head, _ = await socket.receive()
                if head["type"] == "error":
                    raise SystemExit(head["message"])
                if head["type"] != "picture" or head["number"] != number:
                    continue
                near, window = head.get("bounds", near), head["window"]
                if head["quality"] == "coarse":
                    coarse.append(time.monotonic() - started)
                    if not rests and near:
                        break
                else:
                    fine.append(time.monotonic() - started)
                    break
    told(f"{name}: coarse", coarse[1:])
    told(f"{name}: fine, at rest", fine)


async def client(server, seconds, number, waits):
    async with Socket(server) as socket:
        end, count = time.monotonic() + seconds, 0
        while time.monotonic() < end:
            count += 1
            started = time.monotonic()
            await socket.send({"number": count, "width": 400, "height": 300, "coarse": True,
                               "text": f"circle(5) - move(circle(2), {number}, {count % 40} / 20)"})
            answers = await socket.until(lambda head: head["type"] != "parameters" and head["number"] == count)
            if answers[-1][0]["type"] == "error":
                raise SystemExit(answers[-1][0]["message"])
            waits.append(time.monotonic() - started)
            await asyncio.sleep(max(0, started + 0.2 - time.monotonic()))


def memory(server):
    """Returns the memory of the server and its workers without mapped files, kB."""
    return sum(int(line.split()[1]) for process in (server.process.pid, *server.workers())
               for line in open(f"/proc/{process}/status") if line.startswith("RssAnon"))


async def crowd(server, seconds):
    waits, before = [[] for _ in range(50)], memory(server)
    await asyncio.gather(*(client(server, seconds, i, each) for i, each in enumerate(waits)))
    told("50 clients, 5 changes a second each: coarse", [wait for each in waits for wait in each])
    print(f"   fewest pictures of a client {min(map(len, waits))}, most {max(map(len, waits))}; "
          f"memory {before // 1024} MB before, {memory(server) // 1024} MB after")


def main():
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 10
    with tempfile.TemporaryDirectory() as folder:
        server = Server(folder)
        try:
            for name, (model, window, comment) in models().items():
                asyncio.run(drag(server, name, model, window, comment, seconds))
            asyncio.run(crowd(server, 2 * seconds))
        finally:
            server.end()


main()
