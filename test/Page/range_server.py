"""A static server that answers HTTP range requests at a given speed, by the standard library alone; and ways to go wrong."""
import contextlib
import http.server
import os
import re
import socket
import threading
import time
from pathlib import Path

PIECE = 1 << 16


class Line:
    """What all connections share: so many bits a second."""

    def __init__(self, bits_a_second):
        self.seconds_a_byte = 8 / bits_a_second if bits_a_second else 0
        self.free = 0
        self.lock = threading.Lock()

    def take(self, count):
        """Waits until so many bytes have gone over the line."""
        with self.lock:
            self.free = max(self.free, time.monotonic()) + count * self.seconds_a_byte
            end = self.free
        time.sleep(max(0, end - time.monotonic()))


class Handler(http.server.BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    disable_nagle_algorithm = True

    def setup(self):
        super().setup()
        with self.server.lock:
            self.server.connections.add(self.connection)

    def log_message(self, *_):
        pass

    def do_GET(self):
        server = self.server
        path = server.folder / self.path.lstrip("/")
        asked = re.fullmatch(r"bytes=(\d+)-(\d+)", self.headers.get("Range", ""))
        if not path.is_file():
            return self.send_error(404)
        with contextlib.suppress(ConnectionError), path.open("rb") as file:
            self.send_file(file, asked if server.knows_ranges else None)

    def send_file(self, file, asked):
        """The file or a part of it, as long as it was when it was opened."""
        server, size = self.server, os.fstat(file.fileno()).st_size
        begin, end = (int(asked[1]), min(int(asked[2]) + 1, size)) if asked else (0, size)
        with server.lock:
            server.requests.append((self.path, begin, end))
        if asked and begin >= size:
            self.send_response(416)
            self.send_header("Content-Range", f"bytes */{size}")
            self.send_header("Content-Length", "0")
            return self.end_headers()
        self.send_response(206 if asked else 200)
        self.send_header("Content-Type", "text/html" if self.path.endswith(".html") else "application/octet-stream")
        self.send_header("Content-Length", str(end - begin))
        if asked:
            self.send_header("Content-Range", f"bytes {begin}-{end - 1}/{size}")
        self.end_headers()
        file.seek(begin)
        while begin < end and (piece := file.read(min(PIECE, end - begin))):
            server.line.take(len(piece))
            self.wfile.write(piece)
            begin += len(piece)
        if begin < end:
            self.close_connection = True # The file was cut meanwhile, and its reader still waits for the rest: no other answer can follow.


@contextlib.contextmanager
def serving(folder, bits_a_second=0, knows_ranges=True):
    """A server of a folder; `url` is where it is, `requests` what it was asked for."""
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    server.daemon_threads = True
    server.folder, server.line, server.knows_ranges = Path(folder), Line(bits_a_second), knows_ranges
    server.requests, server.connections, server.lock = [], set(), threading.Lock()
    server.url = f"http://127.0.0.1:{server.server_address[1]}/"
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()

    def close():
        server.shutdown()
        server.server_close()
        thread.join()
        with server.lock:
            for connection in server.connections:
                with contextlib.suppress(OSError):
                    connection.shutdown(socket.SHUT_RDWR)

    server.close = close
    try:
        yield server
    finally:
        close()
