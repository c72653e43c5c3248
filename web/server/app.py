"""The server's addresses (table in docs/web.md)."""

import asyncio
import json
import os
import pathlib
import re
import secrets

from aiohttp import web

import fieldfab as ff

from . import files, machining, openapi
from .cluster import Cluster
from .documents import Documents
from .jobs import Jobs
from .limits import LIMITS
from .processes import Pool, Refused
from .protocol import checked, wrong
from .scans import Scans
from .safety import REPORT_POLICY, SANDBOX_POLICY, guarding, policy
from .sockets import Sockets

HERE = pathlib.Path(__file__).resolve().parent
PAGE, EXAMPLES = HERE / "page", HERE / "examples"
FILE_NAME = re.compile(r"[^\W_][\w .+-]{0,119}", re.ASCII)  # that a browser is told to save a job's file as
NO_PAGE = "The page is not built: npm was out of reach when Fieldfab was built. The protocol works (docs/web.md).\n"


class Server:
    def __init__(self, folder, allow_scripts=False, workers=None, scheduler=None):
        """`scheduler`: address of a Dask scheduler for jobs; None runs them on this machine."""
        self.documents = Documents(folder, allow_scripts)
        self.scans, self.allow_scripts = Scans(folder), allow_scripts
        self.pool = Pool(workers or max(2, os.cpu_count() or 2))
        self.cluster = Cluster(scheduler) if scheduler else None
        self.jobs = Jobs(self.cluster.worker) if self.cluster else Jobs()
        self.sockets = Sockets(self.pool, self.documents.folder, allow_scripts)

    def app(self, guard):
        app = web.Application(middlewares=[guarding(guard)], client_max_size=LIMITS.message)
        app.add_routes([
            web.get("/", self.page),
            web.get("/page/{name}", self.part_of_page),
            web.get("/api", self.description),
            web.get("/api/socket", self.sockets.handle),
            web.get("/api/documents", self.list_documents),
            web.get("/api/documents/{name}", self.read_document),
            web.put("/api/documents/{name}", self.write_document),
            web.delete("/api/documents/{name}", self.remove_document),
            web.get("/api/examples", self.list_examples),
            web.get("/api/examples/{name}", self.read_example),
            web.put("/api/scans/{name}", self.upload_scan),
            web.delete("/api/scans/{name}", self.remove_scan),
            web.post("/api/scan", self.look_at_scan),
            web.get("/api/library", self.library),
            web.post("/api/picture", self.picture),
            *(web.post(f"/api/{do}", self.answer_to(do)) for do in ("look", "values", "pick", "parameters", "words")),
            web.get("/api/machining", self.machining_tables),
            web.post("/api/files", self.start_file),
            web.post("/api/machine", self.start_machining),
            web.get("/api/jobs/{job}", self.job),
            web.delete("/api/jobs/{job}", self.cancel_job),
            web.get("/api/jobs/{job}/file", self.file_of_job),
            web.get("/api/jobs/{job}/files/{name}", self.file_of_job),
        ])
        app.on_startup.append(self._start)
        app.on_shutdown.append(self._shut_down)
        app.on_cleanup.append(self._clean_up)
        return app

    async def _start(self, app):
        await self.pool.start()

    async def _shut_down(self, app):
        await self.sockets.close()

    async def _clean_up(self, app):
        self.pool.kill()
        self.jobs.close()
        if self.cluster:
            await self.cluster.close()

    # The page

    async def page(self, request):
        if not (PAGE / "index.html").exists():
            return web.Response(text=NO_PAGE, status=503)
        nonce = secrets.token_urlsafe(12)
        text = (PAGE / "index.html").read_text(encoding="utf-8").replace("@NONCE@", nonce)
        return web.Response(text=text, content_type="text/html", headers={"Content-Security-Policy": policy(nonce)})

    async def part_of_page(self, request):
        path = PAGE / request.match_info["name"]
        if path.name not in {each.name for each in PAGE.iterdir() if each.is_file() and each.suffix != ".gz"}:
            raise web.HTTPNotFound
        headers = {"Content-Security-Policy": SANDBOX_POLICY} if path.name == "sandbox.html" else {}
        return web.FileResponse(path,
                                headers={**headers, "Cache-Control": "no-cache", "Vary": "Accept-Encoding",
                                         "X-Content-Type-Options": "nosniff"})

    async def description(self, request):
        return web.json_response(openapi.description())

    # Documents

    async def list_documents(self, request):
        return web.json_response({"documents": self.documents.names(), "scans": self.scans.names(),
                                  "scripts": self.allow_scripts, "formats": sorted(files.written_formats())})

    async def read_document(self, request):
        data, version = self.documents.read(request.match_info["name"])
        return web.Response(body=data, content_type="text/plain", charset="utf-8", headers={"ETag": f'"{version}"'})

    async def write_document(self, request):
        expected = request.headers.get("If-Match", "").strip('"') or None
        version = self.documents.write(request.match_info["name"], await request.read(), expected)
        return web.json_response({"version": version}, headers={"ETag": f'"{version}"'})

    async def remove_document(self, request):
        self.documents.remove(request.match_info["name"], request.headers.get("If-Match", "*").strip('"'))
        return web.json_response({})

    async def upload_scan(self, request):
        return web.json_response(await self.scans.upload(request.match_info["name"], request), status=201)

    async def remove_scan(self, request):
        self.scans.remove(request.match_info["name"])
        return web.json_response({})

    async def look_at_scan(self, request):
        wanted = await self._checked("scan", request)
        head, _ = await self._asked(request, {**wanted, "path": self.scans.existing(wanted["name"])})
        return web.json_response(head)

    async def list_examples(self, request):
        names = sorted(path.name for path in EXAMPLES.iterdir()) if EXAMPLES.is_dir() else []
        return web.json_response({"examples": names})

    async def read_example(self, request):
        name = request.match_info["name"]
        if not EXAMPLES.is_dir() or name not in os.listdir(EXAMPLES):
            raise Refused(404, "missing", f"there is no example '{name}'")
        return web.Response(text=(EXAMPLES / name).read_text(encoding="utf-8"))

    async def library(self, request):
        return web.json_response({"functions": ff.library(),
                                  "words": [{"kind": w.kind, "name": w.name} for w in ff.language.words("")]})

    # Models

    async def _given(self, request):
        try:
            return json.loads(await request.read(), parse_constant=lambda word: word)
        except (ValueError, RecursionError):
            raise wrong("a request is a JSON object") from None

    async def _checked(self, do, request):
        return checked(do, await self._given(request), self.documents.folder, self.allow_scripts)

    async def _asked(self, request, wanted):
        """Returns the pool's answer; stops the request if its client disconnects."""
        task = asyncio.create_task(self.pool.ask(wanted))
        try:
            while not task.done():
                await asyncio.wait([task], timeout=0.5)
                if request.transport is None or request.transport.is_closing():
                    raise Refused(400, "gone", "the connection was closed")
            return task.result()
        finally:
            task.cancel()

    def answer_to(self, do):
        async def answer(request):
            head, _ = await self._asked(request, await self._checked(do, request))
            return web.json_response(head)

        return answer

    async def picture(self, request):
        head, data = await self._asked(request, {**await self._checked("picture", request), "coarse": False})
        return web.Response(body=data, content_type="image/png", headers={"Fieldfab-Picture": json.dumps(head)})

    # Jobs

    async def start_file(self, request):
        wanted = await self._checked("file", request)
        if wanted["extension"] not in files.written_formats():
            raise wrong(f"'{wanted['extension'][:20]}' is not a format of files; "
                        f"these are: {' '.join(sorted(files.written_formats()))}")
        return web.json_response(self.jobs.start(wanted, "model" + wanted["extension"]).told(), status=202)

    async def machining_tables(self, request):
        return web.json_response(machining.tables())

    async def start_machining(self, request):
        wanted = await self._checked("machine", request)
        name = "program" + ff.cam.machine(wanted["job"]["machine"])["extension"]
        return web.json_response(self.jobs.start(wanted, name).told(), status=202)

    async def job(self, request):
        """Long polling: answers when the job differs from `state` and `progress` of the query, or after 10 s."""
        job = self.jobs.job(request.match_info["job"])
        if "state" in request.query:
            try:
                seen = (request.query["state"], float(request.query.get("progress", 0)))
            except ValueError:
                raise wrong("'progress' must be a number") from None
            await self.jobs.wait(job, seen, 10)
        return web.json_response(job.told())

    async def cancel_job(self, request):
        self.jobs.cancel(self.jobs.job(request.match_info["job"]))
        return web.json_response({})

    async def file_of_job(self, request):
        job = self.jobs.job(request.match_info["job"])
        if job.state != "done":
            raise Refused(409, "state", f"the job is {job.state}; it has no file")
        name = request.match_info.get("name", job.name)
        if name not in os.listdir(job.folder):
            raise Refused(404, "missing", f"the job made no file '{name[:60]}'")
        saved = request.query.get("name", "")
        if not FILE_NAME.fullmatch(saved):
            saved = name
        headers = {"Content-Disposition": f'attachment; filename="{saved}"', "X-Content-Type-Options": "nosniff"}
        if name.endswith(".html"):  # our reports: no scripts, no external resources, an opaque origin
            headers = {"Content-Security-Policy": REPORT_POLICY, "X-Content-Type-Options": "nosniff"}
        return web.FileResponse(os.path.join(job.folder, name), headers=headers)
