"""Access control: requests from this page only, to a known host name, and with a token if other machines have
access."""

import hmac
import secrets

from aiohttp import web

from .processes import Refused

COOKIE = "fieldfab_token"


def policy(nonce):
    """Returns the Content-Security-Policy of the page: no external resources, no inline scripts."""
    return (
        f"default-src 'none'; script-src 'self'; style-src 'self' 'nonce-{nonce}'; img-src 'self' blob: data:; "
        "font-src 'self'; connect-src 'self'; frame-src 'self'; base-uri 'none'; form-action 'none'; "
        "frame-ancestors 'none'"
    )


# The frame for nodes' code has an opaque origin, without access to network, storage or page.
SANDBOX_POLICY = (
    "sandbox allow-scripts; default-src 'none'; script-src 'unsafe-inline' 'unsafe-eval' blob:; worker-src blob:; "
    "connect-src 'none'; frame-ancestors 'self'"
)
REPORT_POLICY = (
    "sandbox allow-popups; default-src 'none'; style-src 'unsafe-inline'; img-src data:; frame-ancestors 'none'")
NOTHING_POLICY = "default-src 'none'; frame-ancestors 'none'"


class Guard:
    def __init__(self, hosts, token=None):
        """`hosts`: accepted host names with ports; None if a token is required instead."""
        self.hosts, self.token = hosts, token

    def _same(self, given):
        return given is not None and hmac.compare_digest(given.encode(), self.token.encode())

    def check(self, request):
        """Raises Refused, or HTTPFound for a token in the URL, which becomes a cookie."""
        if self.hosts is not None and request.headers.get("Host", "").lower() not in self.hosts:
            raise Refused(403, "host", "this server does not answer to that name")
        origin = request.headers.get("Origin")
        if origin is not None and origin.split("://")[-1].lower() != request.headers.get("Host", "").lower():
            raise Refused(403, "origin", "requests of other pages are refused")
        if request.headers.get("Sec-Fetch-Site") in ("cross-site", "same-site") and request.path != "/":
            raise Refused(403, "origin", "requests of other pages are refused")
        if self.token is None:
            return
        if request.method == "GET" and request.path == "/" and self._same(request.query.get("token")):
            answer = web.HTTPFound("/")
            answer.set_cookie(COOKIE, self.token, httponly=True, samesite="Strict", path="/")
            raise answer
        header = request.headers.get("Authorization", "")
        if (not self._same(request.cookies.get(COOKIE))
                and not self._same(header.removeprefix("Bearer ") if header.startswith("Bearer ") else None)):
            raise Refused(401, "token", "the token is missing or wrong: open the address that `fieldfab serve` printed")


def guarding(guard):
    @web.middleware
    async def middleware(request, handler):
        try:
            guard.check(request)
            answer = await handler(request)
        except Refused as error:
            answer = web.json_response({"error": error.told}, status=error.status)
        except web.HTTPRequestEntityTooLarge:
            answer = web.json_response({"error": {"kind": "too_large", "message": "the request is longer than requests "
                                                  "may be", "mistakes": []}}, status=413)
        except web.HTTPFound as found:
            found.headers["Referrer-Policy"] = "no-referrer"
            raise
        except web.HTTPException as error:
            answer = web.json_response({"error": {"kind": "http", "message": error.reason, "mistakes": []}},
                                       status=error.status)
        if not answer.prepared:
            answer.headers.setdefault("Content-Security-Policy", NOTHING_POLICY)
            answer.headers.setdefault("Cache-Control", "no-store")
            answer.headers.update({"X-Content-Type-Options": "nosniff", "Referrer-Policy": "no-referrer",
                                   "Cross-Origin-Opener-Policy": "same-origin"})
        return answer

    return middleware


def new_token():
    return secrets.token_urlsafe(18)
