"""Jobs: long requests that write files. Each runs in its own process, on this machine or on a cluster."""

import asyncio
import os
import secrets
import shutil
import tempfile

from .limits import LIMITS
from .processes import Refused, Worker


class Job:
    def __init__(self, folder, request, name):
        """`name`: of its first file, in the job's folder."""
        self.number, self.name = secrets.token_urlsafe(9), name
        self.folder = request["into"] = os.path.join(folder, self.number)
        os.mkdir(self.folder)
        self.state, self.progress, self.message, self.result, self.error = "waiting", 0.0, "", None, None
        self.request, self.worker, self.task, self.changed = request, None, None, asyncio.Condition()

    def told(self):
        return {"job": self.number, "name": self.name, "state": self.state, "progress": self.progress,
                "message": self.message, "result": self.result, "error": self.error}


class Jobs:
    def __init__(self, worker=Worker):
        """`worker`: factory of the worker of a job."""
        self._worker = worker
        self._folder = tempfile.mkdtemp(prefix="fieldfab-jobs-")
        self._jobs, self._turn = {}, asyncio.Semaphore(LIMITS.jobs)

    def start(self, request, name):
        if sum(job.state in ("waiting", "working") for job in self._jobs.values()) >= LIMITS.jobs + LIMITS.waiting_jobs:
            raise Refused(503, "busy", "too many jobs are waiting; try again later")
        job = Job(self._folder, request, name)
        self._jobs[job.number] = job
        self._forget_old()
        job.task = asyncio.create_task(self._run(job))
        return job

    def job(self, number):
        if number not in self._jobs:
            raise Refused(404, "missing", "there is no such job, or it is too old")
        return self._jobs[number]

    async def _tell(self, job, **values):
        vars(job).update(values)
        async with job.changed:
            job.changed.notify_all()

    async def _run(self, job):
        try:
            async with self._turn:
                job.worker = self._worker()
                await self._tell(job, state="working")
                try:
                    async for head, _ in job.worker.ask(job.request, LIMITS.job_seconds):
                        if "progress" in head:
                            await self._tell(job, progress=head["progress"], message=head["message"])
                        else:
                            job.result = head
                finally:
                    job.worker.kill()
            await self._tell(job, state="done" if job.result else "cancelled", progress=1.0)
        except Refused as error:
            await self._tell(job, state="failed", error=error.told)
        except asyncio.CancelledError:
            await self._tell(job, state="cancelled")

    async def wait(self, job, seen, seconds):
        """Returns when the job differs from `seen`, or after `seconds`."""
        try:
            async with asyncio.timeout(seconds):
                async with job.changed:
                    await job.changed.wait_for(lambda: (job.state, job.progress) != seen)
        except TimeoutError:
            pass

    def cancel(self, job):
        job.task.cancel()

    def _forget_old(self):
        finished = [job for job in self._jobs.values() if job.state not in ("waiting", "working")]
        for job in finished[: max(0, len(finished) - LIMITS.kept_jobs)]:
            del self._jobs[job.number]
            shutil.rmtree(job.folder, ignore_errors=True)

    def close(self):
        for job in self._jobs.values():
            job.task.cancel()
        shutil.rmtree(self._folder, ignore_errors=True)
