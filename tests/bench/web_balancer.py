"""Picture throughput of two servers behind haproxy, with the configuration of docs/web.md, against the same two servers
without it (half of the clients at each), and against one server. The three take turns. Prints pictures per second,
percentiles of the waiting times, and ratios.

    PYTHONPATH=build/release/python python3 tests/bench/web_balancer.py [SECONDS [ROUNDS]]
"""

import asyncio
import json
import pathlib
import statistics
import sys
import tempfile
import time

import aiohttp

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "hosts"))
from web_balancer import TOKEN, Balanced

CLIENTS = 8
TEXT = (ROOT / "examples" / "bracket.frep").read_text()


async def sockets(port, number, end, waits):
    """Requests pictures by a WebSocket, the next one after the answer."""
    async with (aiohttp.ClientSession(headers={"Authorization": f"Bearer {TOKEN}"}) as session,
                session.ws_connect(f"http://127.0.0.1:{port}/api/socket", max_msg_size=0) as socket):
        count = 0
        while time.monotonic() < end:
            count += 1
            started = time.monotonic()
            await socket.send_str(json.dumps({"number": count, "text": f"{TEXT}# {number} {count}\n", "width": 400,
                                              "height": 300}))
            while (message := await socket.receive(60)).type != aiohttp.WSMsgType.BINARY:
                assert message.type == aiohttp.WSMsgType.TEXT and json.loads(message.data)["type"] == "parameters"
            waits.append(time.monotonic() - started)


async def requests(port, number, end, waits):
    """As sockets(), by single requests."""
    async with aiohttp.ClientSession(headers={"Authorization": f"Bearer {TOKEN}"}) as session:
        count = 0
        while time.monotonic() < end:
            count += 1
            started = time.monotonic()
            body = {"text": f"{TEXT}# {number} {count} r\n", "width": 400, "height": 300}
            async with session.post(f"http://127.0.0.1:{port}/api/picture", json=body) as answer:
                assert answer.status == 200 and await answer.read(), await answer.text()
            waits.append(time.monotonic() - started)


async def load(client, ports, seconds):
    """Returns the waiting times of all clients, s, and pictures per second."""
    waits, start = [], time.monotonic()
    await asyncio.gather(*(client(ports[i % len(ports)], i, start + seconds, waits) for i in range(CLIENTS)))
    return sorted(waits), len(waits) / (time.monotonic() - start)


def main():
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 8
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "documents").mkdir()
        balanced = Balanced(pathlib.Path(folder), pathlib.Path(folder) / "documents")
        ways = {"two, directly": [each.port for each in balanced.servers], "two, by haproxy": [balanced.port],
                "one, directly": [balanced.servers[0].port]}
        try:
            for client in (sockets, requests):
                waits, rates = {name: [] for name in ways}, {name: [] for name in ways}
                for turn in range(rounds + 1):
                    for name in list(ways)[:: 1 if turn % 2 else -1]:  # both orders, since other work comes and goes
                        some, rate = asyncio.run(load(client, ways[name], seconds))
                        if turn:  # the first round is a warm-up
                            waits[name] += some
                            rates[name].append(rate)
                for name in ways:
                    each = sorted(waits[name])
                    shares = "   ".join(f"{label} {1000 * each[min(len(each) - 1, int(share * len(each)))]:5.0f} ms"
                                        for label, share in (("median", 0.5), ("90 %", 0.9), ("99 %", 0.99)))
                    rate = sum(rates[name]) / rounds
                    print(f"{client.__name__:<9} {name:<16} {rate:6.1f} pictures/s   {shares}")
                for name in ("two, directly", "one, directly"):
                    ratios = [a / b for a, b in zip(rates["two, by haproxy"], rates[name])]
                    print(f"{client.__name__:<9} haproxy to {name}: {statistics.median(ratios):.2f} in the median of "
                          f"{rounds} rounds ({min(ratios):.2f} to {max(ratios):.2f})", flush=True)
        finally:
            balanced.end()


if __name__ == "__main__":
    main()
