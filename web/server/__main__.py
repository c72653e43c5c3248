"""`fieldfab serve`: the page, its render server and its workers."""

import argparse
import asyncio
import importlib.util
import ipaddress
import logging
import os
import signal
import socket
import sys
import webbrowser

try:
    from aiohttp import web
    from aiohttp.http_exceptions import HttpProcessingError
except ImportError:
    print("fieldfab: serve needs aiohttp (Debian's python3-aiohttp)", file=sys.stderr)
    sys.exit(2)

from .app import Server
from .safety import Guard, new_token

USUAL_PORT = 8765


def options_of(arguments):
    parser = argparse.ArgumentParser(prog="fieldfab serve")
    parser.add_argument("folder", nargs="?", default=".")
    parser.add_argument("--port", type=int)
    parser.add_argument("--host", default="127.0.0.1")
    parser.add_argument("--no-browser", action="store_true")
    parser.add_argument("--allow-scripts", action="store_true")
    parser.add_argument("--scheduler")
    return parser.parse_args(arguments)


def is_this_machine(host):
    if host == "localhost":
        return True
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False


def listening(host, port):
    """Returns a listening socket. Without a given port: the default port, or a free one if that is in use."""
    family, kind, protocol, _, address = (
        socket.getaddrinfo(host, port if port is not None else USUAL_PORT, type=socket.SOCK_STREAM)[0])
    try:
        return socket.create_server(address[:2], family=family)
    except OSError:
        if port is not None:
            raise
        return socket.create_server((address[0], 0), family=family)


def is_our_fault(record):
    """Whether a log record is about the server. Records about malformed or broken connections would flood the log."""
    return not (record.exc_info and isinstance(record.exc_info[1],
                                               (HttpProcessingError, ConnectionError, UnicodeError)))


def handle_exception(loop, context):
    """Calls asyncio's default handler, except for broken pipes to workers that were killed."""
    if not isinstance(context.get("exception"), ConnectionError):
        loop.default_exception_handler(context)


async def serve(options):
    local = is_this_machine(options.host)
    token = os.environ.get("FIELDFAB_TOKEN") or (None if local else new_token())
    listener = listening(options.host, options.port)
    port = listener.getsockname()[1]
    name = f"[{options.host}]" if ":" in options.host else options.host
    # With a token any name is accepted: a balancer keeps its own, and the cookie belongs to one name.
    hosts = None if token else {f"{each}:{port}" for each in ("127.0.0.1", "localhost", "[::1]", name)}
    asyncio.get_running_loop().set_exception_handler(handle_exception)
    logging.getLogger("aiohttp.server").addFilter(is_our_fault)
    server = Server(options.folder, options.allow_scripts, scheduler=options.scheduler)
    runner = web.AppRunner(server.app(Guard(hosts, token)), access_log=None)
    await runner.setup()
    await web.SockSite(runner, listener, shutdown_timeout=1).start()
    address = f"http://{name}:{port}/" + (f"?token={token}" if token else "")
    print(f"fabserver: {address} (documents in {server.documents.folder}; Ctrl-C ends it)", flush=True)
    if not options.no_browser:
        webbrowser.open(address)
    ended = asyncio.Event()
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        asyncio.get_running_loop().add_signal_handler(number, ended.set)
    await ended.wait()
    await runner.cleanup()


def main(arguments=None):
    options = options_of(sys.argv[1:] if arguments is None else arguments)
    if not os.path.isdir(options.folder):
        print(f"fieldfab: {options.folder}: there is no such folder", file=sys.stderr)
        return 2
    if options.scheduler and importlib.util.find_spec("distributed") is None:
        print("fieldfab: --scheduler needs Dask (Debian's python3-distributed)", file=sys.stderr)
        return 2
    try:
        asyncio.run(serve(options))
    except OSError as error:
        print(f"fieldfab: {options.host}: {error.strerror}", file=sys.stderr)
        return 2
    return 130


if __name__ == "__main__":
    sys.exit(main())
