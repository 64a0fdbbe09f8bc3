"""A small web server for a site on this machine, as a host would serve it: static files, the right types."""

from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

from .pages import POLICY


class Handler(SimpleHTTPRequestHandler):
    """Files of the folder, silently; the policy holds for workers too."""

    extensions_map = {  # noqa: RUF012  (the library's own shape)
        **SimpleHTTPRequestHandler.extensions_map,
        ".js": "text/javascript",
        ".svg": "image/svg+xml",
        ".bin": "application/octet-stream",
    }
    protocol_version = "HTTP/1.1"

    def end_headers(self) -> None:
        """The policy, and no keeping without asking: the folder may be written anew."""
        self.send_header("Content-Security-Policy", POLICY)
        self.send_header("Cache-Control", "no-cache")
        super().end_headers()

    def log_message(self, format: str, *args: Any) -> None:
        """Nothing."""


def server(folder: Path, port: int = 0) -> ThreadingHTTPServer:
    """A server on this machine only; by default on a free port."""
    return ThreadingHTTPServer(("127.0.0.1", port), partial(Handler, directory=str(folder)))
