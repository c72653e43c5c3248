"""Two servers behind haproxy, with the configuration that docs/web.md shows."""

import contextlib
import re
import socket
import subprocess

from documents import DOCUMENTS
from web_server import Server, wait_until

TOKEN = "the-same-words-for-all"


def configuration():
    [shown] = [block.text for document in DOCUMENTS for block in document.blocks if block.language == "haproxy"]
    return shown + "\n"


def free_port():
    with socket.create_server(("127.0.0.1", 0)) as listener:
        return listener.getsockname()[1]


class Balanced:
    """haproxy with its servers. `ask()` and `port` are those of haproxy's address, as of a `Server`."""

    def __init__(self, folder, documents):
        self.documents = documents
        self.servers = [Server(documents, FIELDFAB_TOKEN=TOKEN) for _ in range(2)]
        self.port, words = free_port(), configuration()
        for shown, port in zip((8080, 8771, 8772), (self.port, *(each.port for each in self.servers))):
            assert len(re.findall(rf"\b{shown}\b", words)) == 1
            words = re.sub(rf"\b{shown}\b", str(port), words)
        (folder / "fabserver.cfg").write_text(words)
        self._said = open(folder / "said", "w+")
        self.process = subprocess.Popen(["/usr/sbin/haproxy", "-db", "-f", folder / "fabserver.cfg"],
                                        stdout=self._said, stderr=subprocess.STDOUT)
        self.address = f"http://127.0.0.1:{self.port}/?token={TOKEN}"
        try:
            wait_until(self._answers, "haproxy's answer", 15)
        except AssertionError:
            self.end()
            raise

    ask = Server.ask

    def _answers(self):
        self._said.seek(0)
        assert self.process.poll() is None, self._said.read()
        with contextlib.suppress(OSError):
            return self.ask("GET", "/api", Authorization=f"Bearer {TOKEN}")[0] == 200

    def start_again(self, i):
        self.servers[i] = Server(self.documents, port=self.servers[i].port, FIELDFAB_TOKEN=TOKEN)

    def end(self):
        self.process.kill()
        self.process.wait()
        self._said.close()
        for each in self.servers:
            with contextlib.suppress(OSError, ValueError):
                each.end()
