"""Messages of a JSON head and a body of bytes, between the server and its workers. Messages of the WebSocket have the
same form without the length of the body."""

import json
import struct

LENGTHS = struct.Struct(">II")  # lengths of head and body


def head_of(values):
    return json.dumps(values, separators=(",", ":"), allow_nan=False).encode()


def frame(values, body=b""):
    head = head_of(values)
    return LENGTHS.pack(len(head), len(body)) + head + body


def socket_message(values, body):
    """Returns four bytes with the length of the head, the head and the body."""
    head = head_of(values)
    return struct.pack(">I", len(head)) + head + body


def read_frame(stream):
    """Returns the next frame of a stream; None at its end."""
    lengths = stream.read(LENGTHS.size)
    if len(lengths) < LENGTHS.size:
        return None
    head, body = LENGTHS.unpack(lengths)
    return json.loads(stream.read(head)), stream.read(body)


async def read_frame_later(stream):
    """As read_frame(), for an asyncio stream. Raises asyncio.IncompleteReadError at its end."""
    head, body = LENGTHS.unpack(await stream.readexactly(LENGTHS.size))
    return json.loads(await stream.readexactly(head)), await stream.readexactly(body)
