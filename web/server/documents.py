"""Documents: plain files in one folder, written whole or not at all."""

import contextlib
import fcntl
import hashlib
import os
import re

import fieldfab as ff

from .limits import LIMITS
from .processes import Refused

NAME = re.compile(r"[^\W_][\w .+-]{0,99}\.(frep|json|job|math|vm)", re.ASCII | re.IGNORECASE)
SCRIPT_NAME = re.compile(r"[^\W_][\w .+-]{0,99}\.(py|ko|scad)", re.ASCII | re.IGNORECASE)


def version_of(data):
    return hashlib.sha256(data).hexdigest()[:16]


class Documents:
    def __init__(self, folder, allow_scripts=False):
        self.folder = os.path.realpath(folder)
        self._allow_scripts = allow_scripts

    def _is_name(self, name):
        return NAME.fullmatch(name) or (self._allow_scripts and SCRIPT_NAME.fullmatch(name))

    def _path(self, name):
        """Returns a document's path. Raises Refused for an invalid name and for a link out of the folder."""
        if not self._is_name(name):
            raise Refused(400, "name", f"'{name[:120]}' cannot be the name of a document: it has letters, digits, "
                          "spaces and . + - _, begins with a letter or a digit, and ends with .frep or .json")
        path = os.path.join(self.folder, name)
        if os.path.dirname(os.path.realpath(path)) != self.folder:
            raise Refused(403, "name", f"'{name}' is a link that leads out of the folder")
        return path

    def names(self):
        with os.scandir(self.folder) as entries:
            found = [entry for entry in entries if self._is_name(entry.name) and entry.is_file()]
        found = sorted(found, key=lambda entry: entry.stat().st_mtime, reverse=True)[: LIMITS.documents]
        return [{"name": entry.name, "bytes": entry.stat().st_size, "changed": entry.stat().st_mtime}
                for entry in found]

    def read(self, name):
        """Returns a document's bytes and their version."""
        path = self._path(name)
        try:
            if not os.path.isfile(path):
                raise FileNotFoundError
            if os.path.getsize(path) > LIMITS.document:
                raise Refused(413, "too_large", f"'{name}' has more than {LIMITS.document:,} bytes")
            with open(path, "rb") as file:
                data = file.read()
        except FileNotFoundError:
            raise Refused(404, "missing", f"there is no document '{name}'") from None
        except OSError as error:
            raise Refused(422, "io", f"'{name}': {error.strerror}") from None
        return data, version_of(data)

    def version(self, name):
        """Returns the version of a document; None if it does not exist."""
        try:
            return self.read(name)[1]
        except Refused as error:
            if error.status == 404:
                return None
            raise

    def write(self, name, data, expected):
        """Writes the document if its version is the expected one ("*": any version; None: the document must not exist).
        Returns the new version."""
        path = self._path(name)
        if len(data) > LIMITS.document:
            raise Refused(413, "too_large", f"the document has {len(data):,} bytes; {LIMITS.document:,} are possible")
        try:
            data.decode()
        except UnicodeDecodeError as error:
            raise Refused(400, "bad_request", f"the document is not UTF-8 (byte {error.start})") from None
        with self._alone():
            if expected != "*" and self.version(name) not in (expected, version_of(data)):
                raise Refused(409, "changed", f"'{name}' was changed by someone else meanwhile")
            try:
                ff.write_file(path, data)
            except ff.Error as error:
                raise Refused(422, "io", str(error)) from None
        return version_of(data)

    @contextlib.contextmanager
    def _alone(self):
        """Locks the folder against other servers: a version is compared and replaced in one step."""
        folder = os.open(self.folder, os.O_RDONLY | os.O_DIRECTORY)
        try:
            with contextlib.suppress(OSError):  # some network file systems have no locks
                fcntl.flock(folder, fcntl.LOCK_EX)
            yield
        finally:
            os.close(folder)

    def remove(self, name, expected="*"):
        """Removes the document if its version is the expected one ("*": any version)."""
        path = self._path(name)
        with self._alone():
            if expected != "*" and self.version(name) not in (expected, None):
                raise Refused(409, "changed", f"'{name}' was changed by someone else meanwhile")
            try:
                os.remove(path)
            except FileNotFoundError:
                raise Refused(404, "missing", f"there is no document '{name}'") from None
