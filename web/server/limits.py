"""Limits of requests. Each refusal names its limit."""

import dataclasses


@dataclasses.dataclass(frozen=True)
class Limits:
    text: int = 1_000_000  # bytes of a model's text
    document: int = 4_000_000  # bytes of a document
    message: int = 16_000_000  # bytes of a request or a message; longer ones are rejected unread
    documents: int = 2_000  # number of listed documents
    side: int = 4096  # pixels along a side of a picture
    pixels: int = 4_000_000
    scan: int = 1_000_000_000  # bytes of an uploaded scan
    unpacked: int = 2_000_000_000  # bytes of the files of an archive, and of a scan's densities
    scan_files: int = 5_000  # files in an archive
    uploads: int = 2  # at a time
    upload_seconds: float = 600
    points: int = 100_000  # values at points in one request
    views: int = 8  # views of one socket
    sockets: int = 200
    unsent: int = 16  # unread answers of a socket
    picture_seconds: float = 20
    crowded_seconds: float = 5  # limit of a request if another one waits for a worker
    much_seconds: float = 3  # recent worker time of a socket above which others have priority
    at_once: int = 2  # pictures of one socket in progress or in the queue
    job_seconds: float = 300
    jobs: int = 2  # at a time; others are queued
    waiting_jobs: int = 20
    kept_jobs: int = 20  # finished jobs whose files are kept
    memory: int = 4 << 30  # bytes of address space of a worker
    file: int = 1 << 30  # bytes of a job's file


LIMITS = Limits()
