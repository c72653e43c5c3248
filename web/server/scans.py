"""Scans: files of densities in the documents' folder, uploaded whole or not at all."""

import asyncio
import os
import re
import secrets

from .limits import LIMITS
from .processes import Refused
from .protocol import wrong

# Formats without references to other files, which could be anywhere.
NAME = re.compile(r"[^\W_][\w .+-]{0,99}\.(nii|nii\.gz|vdb|tif|tiff)", re.ASCII | re.IGNORECASE)


class Scans:
    def __init__(self, folder):
        self._folder, self._turn = os.path.realpath(folder), asyncio.Semaphore(LIMITS.uploads)

    def path(self, name):
        """Returns a scan's path. Raises Refused for an invalid name."""
        if not NAME.fullmatch(name):
            raise Refused(400, "name", f"'{name[:120]}' is no name of a scan: "
                          "letters, digits, spaces and . + - _, and .nii, .nii.gz, .vdb or .tif at the end")
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
        """Writes the body of a request to a new scan; never overwrites one."""
        path = self.path(name)
        if (request.content_length or 0) > LIMITS.scan:
            raise Refused(413, "too_large", f"a scan may have {LIMITS.scan:,} bytes")
        if self._turn.locked():
            raise Refused(503, "busy", f"{LIMITS.uploads} scans are uploaded already; try again later")
        waiting = os.path.join(self._folder, f".upload-{secrets.token_hex(8)}")
        async with self._turn:
            try:
                async with asyncio.timeout(LIMITS.upload_seconds):
                    with open(waiting, "xb") as file:
                        await self._receive(request, file)
                    await asyncio.to_thread(self._publish, waiting, path)
            except TimeoutError:
                raise Refused(408, "time", f"the upload took longer than {LIMITS.upload_seconds:g} s") from None
            except FileExistsError:
                raise Refused(409, "changed", f"there is a scan '{name}' already") from None
            except OSError as error:
                raise Refused(422, "io", f"'{name}': {error.strerror or 'the connection was closed'}") from None
            finally:
                if os.path.exists(waiting):
                    os.remove(waiting)

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
