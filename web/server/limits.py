"""What one request may ask for. Each refusal names its limit."""

import dataclasses


@dataclasses.dataclass(frozen=True)
class Limits:
    text: int = 1_000_000  # bytes of a model's text
    document: int = 4_000_000  # bytes of a document
    message: int = 16_000_000  # bytes of a request or a message; longer ones are cut off unread
    documents: int = 2_000  # documents that are listed
    side: int = 4096  # pixels along a side of a picture
    pixels: int = 4_000_000
    scan: int = 1_000_000_000  # bytes of a scan that is uploaded
    uploads: int = 2  # at a time
    upload_seconds: float = 600
    points: int = 100_000  # values at points in one request
    views: int = 8  # views of one socket
    sockets: int = 200
    unsent: int = 16  # answers that a socket may leave unread
    picture_seconds: float = 20
    crowded_seconds: float = 5  # the same where another request has waited for so long
    much_seconds: float = 3  # of workers that a socket took lately, beyond which others go first
    at_once: int = 2  # pictures of one socket in the making, or waiting for a worker
    job_seconds: float = 300
    jobs: int = 2  # at a time; more wait
    waiting_jobs: int = 20
    kept_jobs: int = 20  # finished ones, whose files may still be fetched
    memory: int = 4 << 30  # bytes of address space of a worker
    file: int = 1 << 30  # bytes of a file that a job writes


LIMITS = Limits()
