"""A worker process: `python3 -m fieldfab.serve.worker MEMORY`. It reads requests from standard input and writes answers
to standard output, in frames. A text can need any amount of memory, time and stack: a failure is confined to this
process."""

import ctypes
import math
import os
import queue
import resource
import signal
import sys
import threading

import fieldfab as ff

from . import archives, files, machining, pictures
from .frames import frame, read_frame
from .models import Mistakes, Models, parameters_of, scan_told, utf16

PR_SET_PDEATHSIG = 1


class Stopped(Exception):
    """Raised inside a request whose result is no longer needed."""


class Worker:
    def __init__(self, output):
        self._output, self._models = output, Models()
        self.requests, self.stopped = queue.Queue(), threading.Event()
        self._told = None  # the last share and message of a job

    def listen(self, stream):
        """Reads requests and, during a request, the message that stops it."""
        while (message := read_frame(stream)) is not None:
            if message[0]["do"] == "stop":
                self.stopped.set()
            else:
                self.stopped.clear()
                self.requests.put(message[0])
        os._exit(0)

    def answer(self, values, body=b""):
        self._output.write(frame(values, body))
        self._output.flush()

    def progress(self, fraction, message):
        if self.stopped.is_set():
            raise Stopped

    def told_progress(self, fraction, message):
        self.progress(fraction, message)
        share = math.floor(100 * fraction) / 100
        if (share, message) != self._told:
            self._told = (share, message)
            self.answer({"progress": share, "message": message})

    def picture(self, request):
        for told, data in pictures.pictures(self._models.of(request), request, self.progress):
            self.progress(0, "")
            self.answer(told, data)

    def look(self, request):
        model = self._models.of(request)
        parts = [{"name": name, "colour": colour} for _, name, colour in model.parts if name]
        self.answer({"bounds": model.bounds, "flat": model.flat, "parts": parts, "nodes": model.solid.node_count()})

    def values(self, request):
        solid = self._models.of(request).solid
        values = [solid.value(*point) for point in request["points"]]
        self.answer({"values": [value if math.isfinite(value) else None for value in values]})

    def pick(self, request):
        self.answer(pictures.pick(self._models.of(request), request, self.progress))

    def parameters(self, request):
        self.answer({"parameters": parameters_of(request["text"])})

    def scan(self, request):
        self.answer(scan_told(request["path"]))

    def convert(self, request):
        self.answer(archives.convert(request["path"], request["into"]))

    def words(self, request):
        """Returns completions at an offset in UTF-16 units."""
        data = request["text"].encode()
        offset = len(
            request["text"].encode("utf-16-le")[: 2 * request["offset"]].decode("utf-16-le", "replace").encode())
        found = ff.language.completions(data, offset)
        entries = [{"kind": e.kind, "name": e.name, "signature": e.signature, "meaning": e.meaning, "insert": e.insert}
                   for e in found.entries]
        self.answer({"from": utf16(data, found.offset), "to": utf16(data, found.offset + found.length),
                     "entries": entries})

    def file(self, request):
        self._told = None
        self.answer(files.write(self._models.of(request), request, self.told_progress))

    def machine(self, request):
        self._told = None
        self.answer(machining.machine(self._models.of(request), request, self.told_progress))

    def serve(self):
        known = {each.__name__: each for each in (self.picture, self.look, self.values, self.pick, self.parameters,
                                                  self.scan, self.convert, self.words, self.file, self.machine)}
        while True:
            request = self.requests.get()
            try:
                known[request["do"]](request)
                self.answer({"done": True})
            except Stopped:
                self.answer({"done": True, "stopped": True})
            except Mistakes as error:
                self.answer({"done": True,
                             "error": {"kind": "bad_input", "message": str(error), "mistakes": error.places}})
            except ff.Error as error:
                self.answer({"done": True, "stopped": True} if error.kind == "cancelled"
                            else {"done": True, "error": {"kind": error.kind, "message": str(error)}})
            except MemoryError:
                self.answer({"done": True,
                             "error": {"kind": "memory", "message": "this takes more memory than a request may have"}})
                os._exit(1)  # the process is in an unknown state
            except Exception as error:  # a bug of ours: reported, not hidden
                self.answer({"done": True,
                             "error": {"kind": "internal", "message": f"{type(error).__name__}: {error}"}})


def main():
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)  # ends with the server, even if that is killed
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the server's to handle
    memory = int(sys.argv[1])
    resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    output = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # output of libraries must not mix with frames
    worker = Worker(output)
    threading.Thread(target=worker.listen, args=(sys.stdin.buffer,), daemon=True).start()
    worker.serve()


if __name__ == "__main__":
    main()
