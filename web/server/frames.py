"""Messages of a JSON head and a body of bytes, between the server and its workers. The WebSocket uses them, too,
without the second half of the lengths."""

import json
import struct

LENGTHS = struct.Struct(">II")  # of the head and of the body


def head_of(values):
    return json.dumps(values, separators=(",", ":"), allow_nan=False).encode()


def frame(values, body=b""):
    head = head_of(values)
    return LENGTHS.pack(len(head), len(body)) + head + body


def socket_message(values, body):
    """Four bytes with the length of the head, the head, the body."""
    head = head_of(values)
    return struct.pack(">I", len(head)) + head + body


def read_frame(stream):
    """The next frame of a stream; None at its end."""
    lengths = stream.read(LENGTHS.size)
    if len(lengths) < LENGTHS.size:
        return None
    head, body = LENGTHS.unpack(lengths)
    return json.loads(stream.read(head)), stream.read(body)


async def read_frame_later(stream):
    """The same of an asyncio stream. Raises asyncio.IncompleteReadError at its end."""
    head, body = LENGTHS.unpack(await stream.readexactly(LENGTHS.size))
    return json.loads(await stream.readexactly(head)), await stream.readexactly(body)
