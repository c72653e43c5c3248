"""Code for the machines of a Dask cluster: runs one request in its own worker process. It imports worker modules
only."""

import os
import subprocess
import tempfile
import threading

from .frames import frame, read_frame
from .launch import worker_command


def run(request, memory, seconds, most, topic, name):
    """Returns (the answers other than progress, {name: bytes} of the written files). Publishes progress under the
    topic. Ends when the event `name` is set, or after `seconds`. `most`: limit of the total size of its files,
    bytes."""
    import distributed  # installed on clusters; the server imports it only with --scheduler

    told, late = distributed.get_worker().log_event, threading.Event()
    stopped = distributed.Event(name, client=distributed.get_client())  # which only this thread can find
    with tempfile.TemporaryDirectory(prefix="fieldfab-job-") as folder:
        words, environment = worker_command(memory)
        with subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment) as process:
            ended = threading.Event()

            def watch():
                waited = 0.0
                while not ended.wait(0.5):
                    waited += 0.5
                    if waited >= seconds:
                        late.set()
                    if late.is_set() or stopped.is_set():
                        process.kill()
                        return

            threading.Thread(target=watch, daemon=True).start()
            heads = []
            try:
                process.stdin.write(frame({**request, "into": folder}))
                process.stdin.flush()
                while (answer := read_frame(process.stdout)) is not None:
                    head = answer[0]
                    if "progress" in head:
                        told(topic, (name, head))
                    elif not head.get("done"):
                        heads.append(head)
                    elif "error" in head:
                        heads.append({"error": head["error"]})
                    if head.get("done"):
                        break
            except BrokenPipeError:
                pass
            finally:
                ended.set()
                process.kill()
        if late.is_set():
            heads = [{"error": {"kind": "time",
                                "message": f"this takes longer than {seconds:g} s, which is what a request may take"}}]
        elif not heads:
            heads = [{"error": {"kind": "memory", "message": "the worker process ended: "
                                "this takes too much memory, or too deep a stack"}}]
        paths = [os.path.join(folder, each) for each in os.listdir(folder)]
        if sum(map(os.path.getsize, paths)) > most:
            heads, paths = [{"error": {"kind": "too_large", "message": f"its files have more than {most:,} bytes"}}], []
        files = {}
        for path in paths:
            with open(path, "rb") as file:
                files[os.path.basename(path)] = file.read()
        return heads, files
