"""A small web server for the site on this machine: static files with the right content types."""

from functools import partial
from http import HTTPStatus
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

from .check_page import CHECK_POLICY, PATH
from .hosting import NOT_FOUND
from .pages import POLICY, REFERENCE


class Handler(SimpleHTTPRequestHandler):
    """Serves the files of a folder and logs nothing."""

    extensions_map = {  # noqa: RUF012  (the base class has this form)
        **SimpleHTTPRequestHandler.extensions_map,
        ".js": "text/javascript",
        ".svg": "image/svg+xml",
        ".bin": "application/octet-stream",
    }
    protocol_version = "HTTP/1.1"

    def end_headers(self) -> None:
        """Send the security policy, and ask the browser to check for newer files each time.

        Workers obey the policy of this header only.  The reference has no policy, since pdoc writes inline scripts.
        """
        if not self.path.startswith(f"/{REFERENCE}/"):
            own = self.path.startswith(f"/{PATH}")
            self.send_header("Content-Security-Policy", CHECK_POLICY if own else POLICY)
        self.send_header("Cache-Control", "no-cache")
        super().end_headers()

    def send_error(self, code: int, message: str | None = None, explain: str | None = None) -> None:
        """Send the site's own page where there is no file, as other servers do; else the plain error."""
        page = Path(self.directory) / NOT_FOUND
        if code != HTTPStatus.NOT_FOUND or not page.is_file():
            super().send_error(code, message, explain)
            return
        data = page.read_bytes()
        self.send_response(code)
        self.send_header("Content-Type", "text/html; charset=utf-8")
        self.send_header("Content-Length", str(len(data)))
        self.end_headers()
        if self.command != "HEAD":
            self.wfile.write(data)

    def log_message(self, format: str, *args: Any) -> None:
        """Log nothing."""


def server(folder: Path, port: int = 0) -> ThreadingHTTPServer:
    """Return a server for the folder that only this machine can reach; port 0 means any free port."""
    return ThreadingHTTPServer(("127.0.0.1", port), partial(Handler, directory=str(folder)))
