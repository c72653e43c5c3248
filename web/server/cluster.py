"""Jobs on a Dask cluster (`--scheduler ADDRESS`): each in its own process there, with the limits of local jobs."""

import asyncio
import os
import secrets

from .limits import LIMITS
from .processes import Refused, raise_error
from .remote import run

CONNECTING = 5.0  # seconds


class Cluster:
    """A connection to a scheduler, opened on first use."""

    def __init__(self, address):
        self.address, self._client, self._connecting = address, None, asyncio.Lock()
        self._topic, self.listeners = f"fieldfab-{secrets.token_hex(8)}", {}

    async def client(self):
        import distributed  # takes 0.5 s, and most servers have no cluster

        async with self._connecting:
            if self._client is None or self._client.status != "running":
                try:
                    self._client = await distributed.Client(self.address, asynchronous=True, timeout=CONNECTING,
                                                            set_as_default=False)
                except (OSError, TimeoutError, asyncio.TimeoutError, ValueError) as error:
                    raise Refused(503, "cluster",
                                  f"the cluster at {self.address} does not answer: {str(error)[:200]}") from None
                self._client.subscribe_topic(self._topic, self._take)
        return self._client

    def _take(self, event):
        _, (name, head) = event
        if name in self.listeners:
            self.listeners[name].put_nowait(head)

    def worker(self):
        return ClusterWorker(self, self._topic)

    async def close(self):
        if self._client is not None:
            await self._client.close(timeout=1)


class ClusterWorker:
    """The worker of one job, with the interface of `processes.Worker`."""

    def __init__(self, cluster, topic):
        self._cluster, self._topic, self._name, self._stopping = (
            cluster, topic, f"fieldfab-{secrets.token_hex(8)}", None)

    async def ask(self, request, seconds):
        """Yields (head, b"") for progress and the result. The result's files are then in `request["into"]`. Raises
        Refused."""
        client = await self._cluster.client()
        news = self._cluster.listeners[self._name] = asyncio.Queue()
        inner = {key: value for key, value in request.items() if key != "into"}
        future = client.submit(run, inner, LIMITS.memory, seconds, LIMITS.file, self._topic, self._name, key=self._name,
                               pure=False, retries=0)
        done = asyncio.ensure_future(future._result(raiseit=True))
        self._running = True
        try:
            while not done.done():
                step = asyncio.ensure_future(news.get())
                await asyncio.wait({done, step}, return_when=asyncio.FIRST_COMPLETED)
                if step.done():
                    yield step.result(), b""
                step.cancel()
            try:
                heads, files = done.result()
            except Exception as error:  # of the cluster, such as a dead worker or a missing module
                raise Refused(503, "cluster",
                              f"the cluster failed: {type(error).__name__}: {str(error)[:300]}") from None
            for name, data in files.items():
                with open(os.path.join(request["into"], os.path.basename(name)), "wb") as file:
                    file.write(data)
            self._running = False
            for head in heads:
                if "error" in head:
                    raise_error(head["error"])
                yield head, b""
        finally:
            del self._cluster.listeners[self._name]
            done.cancel()
            if self._running:
                self._stopping = asyncio.ensure_future(self._stop(client, future))

    async def _stop(self, client, future):
        import distributed  # as above

        await distributed.Event(self._name, client=client).set()
        await future.cancel()

    def kill(self):
        """Does nothing: ask() stops the request when it is closed."""
