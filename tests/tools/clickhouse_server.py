"""A stand-in for a ClickHouse server: HTTP in front, chdb in this process behind it.

It knows users, sessions and errors as far as clickhouse-connect asks for them. With several replicas
each request goes to the next one, as behind a load balancer that knows no sessions.
"""

import base64
import importlib
import itertools
import re
import tempfile
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any
from urllib.parse import parse_qsl, urlsplit

USER, PASSWORD = "plant", "s3cret/&?"

#: What stands in a URL beside settings.
_TRANSPORT = frozenset(
    (
        *("query", "database", "session_id", "session_timeout", "session_check", "query_id"),
        *("wait_end_of_query", "send_progress_in_http_headers", "client_protocol_version"),
        *("http_headers_progress_interval_ms", "enable_http_compression", "compress", "default_format"),
    )
)
_CODE = re.compile(r"Code: (\d+)\.")
_FORMAT = re.compile(rb"\bFORMAT\s+(\w+)\s*$")


class Server:
    """A server on a free port of this machine.

    Args:
        replicas: how many answer in turn.
        version: what it calls itself; None for the version of chdb.
    """

    def __init__(self, replicas: int = 1, version: str | None = None) -> None:
        self.version = version
        self.is_lost = False
        self.refusal: str | None = None
        self._turns = itertools.cycle(range(replicas))
        self._handles: dict[tuple[int, str], Any] = {}
        self._lock = threading.Lock()
        outer = self

        class Handler(BaseHTTPRequestHandler):
            protocol_version = "HTTP/1.1"

            def do_POST(self) -> None:
                outer.answer(self)

            def do_GET(self) -> None:
                outer.answer(self)

            def log_message(self, *_: object) -> None:
                """Say nothing."""

        self._http = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self._http.daemon_threads = True
        self.place = f"127.0.0.1:{self._http.server_address[1]}"
        threading.Thread(target=self._http.serve_forever, daemon=True).start()

    def __enter__(self) -> "Server":
        return self

    def __exit__(self, *_: object) -> None:
        self._http.shutdown()
        self._http.server_close()
        for handle in self._handles.values():
            handle.close()

    def answer(self, handler: BaseHTTPRequestHandler) -> None:
        """Answer a request, or break the line off."""
        asked = dict(parse_qsl(urlsplit(handler.path).query, keep_blank_values=True))
        body = handler.rfile.read(int(handler.headers.get("Content-Length") or 0))
        if handler.headers.get("Transfer-Encoding") == "chunked":
            body = b"".join(_chunks(handler))
        if self.is_lost:
            handler.close_connection = True
            handler.connection.close()
            return
        status, headers, content = self._result(handler.headers.get("Authorization", ""), asked, body)
        handler.send_response(status)
        for name, value in {**headers, "Content-Length": str(len(content))}.items():
            handler.send_header(name, value)
        handler.end_headers()
        handler.wfile.write(content)

    def _result(
        self, authorization: str, asked: dict[str, str], body: bytes
    ) -> tuple[int, dict[str, str], bytes]:
        expected = base64.b64encode(f"{USER}:{PASSWORD}".encode()).decode()
        try:
            if authorization != f"Basic {expected}":
                raise RuntimeError(
                    "Code: 516. DB::Exception: Authentication failed (AUTHENTICATION_FAILED)"
                )
            if self.refusal is not None:
                raise RuntimeError(self.refusal)
            with self._lock:
                found, shape = self._run(asked, body)
        except RuntimeError as error:
            message = str(error)[max(str(error).find("Code: "), 0) :]
            code = _CODE.search(message)
            return 500, {"X-ClickHouse-Exception-Code": code[1] if code else "0"}, message.encode()
        return 200, {"X-ClickHouse-Format": shape} if found else {}, found

    def _run(self, asked: dict[str, str], body: bytes) -> tuple[bytes, str]:
        handle = self._handle(asked.get("session_id", ""))
        if "database" in asked:
            handle.query(f"USE `{asked['database']}`")
        parameters = {}
        for name, value in asked.items():
            if name.startswith("param_"):
                parameters[name.removeprefix("param_")] = value
            elif name not in _TRANSPORT:
                handle.query(f"SET {name} = '{value}'")
        if body and asked.get("query", "").startswith("INSERT"):
            with tempfile.NamedTemporaryFile() as file:
                file.write(body)
                file.flush()
                into, _, shape = asked["query"].rpartition(" FORMAT ")
                handle.query(f"{into} FROM INFILE '{file.name}' FORMAT {shape}")
            return b"", ""
        query = asked.get("query", "").encode() or body
        if self.version is not None and query.startswith(b"SELECT version()"):
            return f"{self.version}\tUTC\n".encode(), "TabSeparated"
        shape = found[1].decode() if (found := _FORMAT.search(query)) else "TabSeparated"
        result: bytes = handle.query(query.decode(), shape, params=parameters).bytes()
        return result, shape

    def _handle(self, session: str) -> Any:
        key = (next(self._turns), session)
        if key not in self._handles:
            self._handles[key] = importlib.import_module("chdb").connect(":memory:")
        return self._handles[key]


def _chunks(handler: BaseHTTPRequestHandler) -> Any:
    while size := int(handler.rfile.readline(), 16):
        yield handler.rfile.read(size)
        handler.rfile.readline()
    handler.rfile.readline()
