"""Scans: files of densities in the documents' folder, uploaded whole or not at all."""

import asyncio
import contextlib
import os
import re
import secrets
import shutil
import time

from .limits import LIMITS
from .processes import Refused, Worker
from .protocol import wrong

# Formats without references to other files, which could be anywhere.
NAME = re.compile(r"[^\W_][\w .+-]{0,99}\.(nii|nii\.gz|vdb|tif|tiff)", re.ASCII | re.IGNORECASE)
# Others become .nii files (archives.py).
CONVERTED = re.compile(r"([^\W_][\w .+-]{0,99})\.(nrrd|mha|dcm|dicom|ima|zip)", re.ASCII | re.IGNORECASE)
ENDINGS = ".nii, .nii.gz, .vdb, .tif, .nrrd, .mha, .dcm or .zip"
LOOK = 0.2  # seconds between two looks whether a client still waits for its answer
STALE = 3600.0  # seconds after which the files of an upload are those of a server that was killed


class Scans:
    def __init__(self, folder):
        self._folder, self._turn = os.path.realpath(folder), asyncio.Semaphore(LIMITS.uploads)
        for entry in os.scandir(self._folder):
            with contextlib.suppress(OSError):  # another server of the folder may remove it, too
                if re.fullmatch(r"\.upload-[0-9a-f]{16}", entry.name) and time.time() - entry.stat().st_mtime > STALE:
                    self._clear(entry.path)

    def path(self, name):
        """Returns a scan's path. Raises Refused for an invalid name."""
        if not NAME.fullmatch(name):
            raise Refused(400, "name", f"'{name[:120]}' cannot be the name of a scan: it has letters, digits, spaces "
                          f"and . + - _, begins with a letter or a digit, and ends with {ENDINGS}")
        return os.path.join(self._folder, name)

    def existing(self, name):
        path = self.path(name)
        if not os.path.isfile(path) or os.path.dirname(os.path.realpath(path)) != self._folder:
            raise Refused(404, "missing", f"there is no scan '{name}'")
        return path

    def names(self):
        with os.scandir(self._folder) as entries:
            return sorted(entry.name for entry in entries
                          if NAME.fullmatch(entry.name) and entry.is_file(follow_symlinks=False))[: LIMITS.documents]

    async def upload(self, name, request):
        """Writes the body of a request to a new scan; never overwrites one. Returns the values of the answer: its name
        in the folder, and a remark."""
        converted = CONVERTED.fullmatch(name)
        stored = f"{converted[1]}.nii" if converted else name
        path = self.path(stored)
        if (request.content_length or 0) > LIMITS.scan:
            raise Refused(413, "too_large", f"a scan may have {LIMITS.scan:,} bytes")
        if converted and os.path.lexists(path):
            raise Refused(409, "changed", f"there is a scan '{stored}' already")
        if self._turn.locked():
            raise Refused(503, "busy", f"{LIMITS.uploads} scans are uploaded already; try again later")
        waiting, note = os.path.join(self._folder, f".upload-{secrets.token_hex(8)}"), ""
        async with self._turn:
            try:
                if converted:
                    os.mkdir(waiting)
                given = os.path.join(waiting, name) if converted else waiting
                async with asyncio.timeout(LIMITS.upload_seconds):
                    with open(given, "xb") as file:
                        await self._receive(request, file)
                if converted:
                    made = os.path.join(waiting, "made.nii")
                    note = await self._while_there(request, self._convert(given, made))
                if self._gone(request):
                    raise Refused(400, "gone", "the upload was cancelled")
                await asyncio.to_thread(self._publish, made if converted else given, path)
            except TimeoutError:
                raise Refused(408, "time", f"the upload took longer than {LIMITS.upload_seconds:g} s") from None
            except FileExistsError:
                raise Refused(409, "changed", f"there is a scan '{stored}' already") from None
            except OSError as error:
                raise Refused(422, "io", f"'{name}': {error.strerror or 'the connection was closed'}") from None
            finally:
                await asyncio.to_thread(self._clear, waiting)
        return {"name": stored, "note": note}

    @staticmethod
    def _gone(request):
        return request.transport is None or request.transport.is_closing()

    async def _while_there(self, request, work):
        """Returns the result of a coroutine, which is cancelled when the client goes away: aiohttp lets it run."""
        task = asyncio.ensure_future(work)
        try:
            while not (await asyncio.wait({task}, timeout=LOOK))[0]:
                if self._gone(request):
                    raise Refused(400, "gone", "the upload was cancelled")
            return task.result()
        finally:
            task.cancel()
            await asyncio.wait({task})  # until its worker has ended

    @staticmethod
    async def _convert(path, into):
        """Returns a remark about the scan."""
        worker = Worker()  # of its own, for its memory
        try:
            answers = [head async for head, _ in worker.ask({"do": "convert", "path": path, "into": into},
                                                            LIMITS.job_seconds)]
        finally:
            worker.kill()
        return answers[-1]["note"]

    @staticmethod
    def _clear(path):
        if os.path.isdir(path):
            shutil.rmtree(path, ignore_errors=True)
        elif os.path.exists(path):
            os.remove(path)

    async def _receive(self, request, file):
        size = 0
        async for part in request.content.iter_chunked(1 << 20):
            size += len(part)
            if size > LIMITS.scan:
                raise Refused(413, "too_large", f"a scan may have {LIMITS.scan:,} bytes")
            await asyncio.to_thread(file.write, part)
        if size == 0:
            raise wrong("the scan is empty")

    def _publish(self, waiting, path):
        with open(waiting, "rb") as file:
            os.fsync(file.fileno())
        os.link(waiting, path)  # fails if the file exists

    def remove(self, name):
        os.remove(self.existing(name))
