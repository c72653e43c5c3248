"""Hostile clients for some seconds: they disconnect during requests, send garbage, flood, hold connections open and
read no answers.

    PYTHONPATH=build/release/python /usr/bin/python3 tests/hosts/web_hostile.py [SECONDS]

A regular client requests pictures at the same time. Prints percentiles of its waiting times, and the memory of the
server and its workers."""

import asyncio
import contextlib
import json
import os
import random
import sys
import tempfile
import time

import aiohttp
from web_server import Server, Socket, children

PAGE = {"text": "sphere(5) - box(3, 3, 20)", "width": 200, "height": 150}
# Texts that need much time, memory or stack.
HEAVY = ["a0 = sphere(1)\n" + "".join(f"a{i + 1} = a{i} | move(a{i}, {1.1**i})\n" for i in range(40)) + "a40\n",
         "(" * 200_000 + "1" + ")" * 200_000, "gyroid(0.01) & sphere(500)",
         "sphere(1" + " + 1" * 100_000 + ")", "box(1e9, 1e9, 1e-9) - " * 2000 + "sphere(1)"]  # fmt: skip
ADDRESSES = ["/", "/api", "/api/documents", "/api/documents/../../etc/passwd", "/api/jobs/none", "/api/library",
             "/api/machining", "/page/page.js", "/api/scans/x.nii", "/" + "a" * 9000]


async def connection(port):
    return await asyncio.open_connection("127.0.0.1", port)


async def vanishes(port):
    """Requests an expensive picture and disconnects before the answer."""
    async with aiohttp.ClientSession() as session, session.ws_connect(f"http://127.0.0.1:{port}/api/socket") as socket:
        for number in range(random.randint(1, 8)):
            await socket.send_str(json.dumps({"number": number, "view": str(number), **PAGE,
                                              "text": random.choice(HEAVY), "coarse": True, "smooth": True}))
        await asyncio.sleep(random.random())
        socket._response.connection.transport.abort()


async def sends_garbage(port):
    reader, writer = await connection(port)
    kind = random.randrange(4)
    if kind == 0:
        writer.write(os.urandom(random.randint(1, 60_000)))
    elif kind == 1:
        writer.write(f"{random.choice(['GET', 'PUT', 'POST', 'DELETE', 'BREW'])} {random.choice(ADDRESSES)} "
                     f"HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n".encode() + b"X: " + b"y" * random.randint(1, 20_000)
                     + b"\r\n\r\n" + os.urandom(100))
    elif kind == 2:
        body = random.choice([b"[" * 50_000, b'{"text":"' + os.urandom(2000) + b'"}', b'{"text": 1e999}', b"{}",
                              json.dumps({**PAGE, "text": random.choice(HEAVY)}).encode()])
        writer.write(f"POST /api/{random.choice(['picture', 'look', 'files', 'machine', 'scan', 'pick'])} HTTP/1.1\r\n"
                     f"Host: 127.0.0.1:{port}\r\nContent-Length: {len(body)}\r\n\r\n".encode() + body)
    else:
        writer.write(f"GET /api/socket HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\n"
                     "Connection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                     "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n".encode() + os.urandom(3000))
    await asyncio.wait_for(reader.read(2000), random.random() * 3)
    writer.close()


async def floods(port):
    """Sends requests as fast as possible, and reads no answers."""
    async with aiohttp.ClientSession() as session, session.ws_connect(f"http://127.0.0.1:{port}/api/socket") as socket:
        for number in range(2000):
            text = f"sphere({5 + number % 100 / 100})"
            await socket.send_str(json.dumps({"number": number, "view": str(number % 12), **PAGE, "text": text,
                                              "width": 400, "height": 300}))
        await asyncio.sleep(2)


async def holds(port):
    """Sends some bytes now and then, or half of an upload."""
    _, writer = await connection(port)
    writer.write(random.choice([b"", b"GET / HTTP/1.1\r\nHost: ", f"PUT /api/scans/held{random.randrange(10**9)}.nii "
                                f"HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nContent-Length: 100000000\r\n\r\n".encode()]))
    for _ in range(10):
        await asyncio.sleep(1)
        writer.write(b"x")
        await writer.drain()
    writer.close()


async def starts_jobs(port):
    async with aiohttp.ClientSession() as session:
        for _ in range(30):
            body = {"text": random.choice([*HEAVY, PAGE["text"]]), "extension": ".stl"}
            async with session.post(f"http://127.0.0.1:{port}/api/files", json=body) as answer:
                job = (await answer.json()).get("job")
            if job and random.random() < 0.9:
                await (await session.delete(f"http://127.0.0.1:{port}/api/jobs/{job}")).read()


async def again_and_again(hostile, port, end):
    while time.monotonic() < end:
        with contextlib.suppress(OSError, aiohttp.ClientError, asyncio.TimeoutError, TimeoutError, AttributeError):
            await asyncio.wait_for(hostile(port), 15)
        await asyncio.sleep(0.05)


async def polite(server, end, waited, refusals):
    """Requests a picture of its own text every 0.2 s; again after a refusal, as the page does."""
    while time.monotonic() < end:
        async with Socket(server) as socket:
            started, number = time.monotonic(), 0
            while number < 25 and time.monotonic() < end:
                await socket.send({"number": number, **PAGE, "text": f"{PAGE['text']} # {random.random()}",
                                   "coarse": True})
                # Awaited within the iteration, so that `number` is unchanged.
                answers = await socket.until(
                    lambda told: told["type"] != "parameters" and told["number"] == number)
                number += 1
                if answers[-1][0]["type"] == "error":
                    refusals.append(answers[-1][0]["message"])
                    await asyncio.sleep(1)
                    continue
                waited.append(time.monotonic() - started)
                await asyncio.sleep(0.2)
                started = time.monotonic()


def resident(server):
    """Returns the memory without mapped files, MB: of the server, and of each of its workers, the largest first. Two of
    these or more are the pool's; the others have a job each."""
    def of(number):
        with contextlib.suppress(OSError):
            return int(next(line for line in open(f"/proc/{number}/status") if line.startswith("RssAnon"))
                       .split()[1]) / 1024
        return 0

    return of(server.process.pid), sorted(map(of, children(server.process.pid)), reverse=True)


async def siege(server, seconds, crowd=4):
    """Returns (waiting times of the regular client in s, its refusals, [(seconds since the start, MB of the server, MB
    of each worker)], the server's output). Ends the server."""
    start = time.monotonic()
    end, waited, refusals, memory = start + seconds, [], [], [(0, *resident(server))]
    hostile = [asyncio.create_task(again_and_again(each, server.port, end))
               for each in (vanishes, sends_garbage, floods, holds, starts_jobs) for _ in range(crowd)]
    said = asyncio.create_task(asyncio.to_thread(server.process.stdout.read))
    well = asyncio.create_task(polite(server, end, waited, refusals))
    while time.monotonic() < end:
        await asyncio.sleep(min(2, max(0.1, end - time.monotonic())))
        memory.append((time.monotonic() - start, *resident(server)))
        if well.done():
            break
    try:
        await well
        await asyncio.gather(*hostile)
    except BaseException:
        server.process.terminate()
        print(await said)
        raise
    server.process.terminate()
    return waited, refusals, memory, await said


def main():
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 600
    with tempfile.TemporaryDirectory() as folder:
        server = Server(folder)
        try:
            waited, refusals, memory, said = asyncio.run(siege(server, seconds))
            left = os.listdir(folder)
        finally:
            server.kill()
    waited.sort()
    shares = {name: waited[min(len(waited) - 1, int(share * len(waited)))]
              for name, share in (("median", 0.5), ("90 %", 0.9), ("99 %", 0.99), ("at most", 1))}
    print(f"{len(waited)} pictures; waits: {', '.join(f'{name} {wait:.2f} s' for name, wait in shares.items())}; "
          f"refusals: {len(refusals)} {set(refusals) or ''}; left in the folder: {left}; it said {said or 'nothing'}")
    for i in [*range(0, len(memory) - 1, max(1, len(memory) // 20)), len(memory) - 1]:
        at, of_server, of_workers = memory[i]
        print(f"{at:6.0f} s: server {of_server:4.0f} MB, workers {' '.join(f'{each:.0f}' for each in of_workers)} MB")


if __name__ == "__main__":
    main()
