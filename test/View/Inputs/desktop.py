"""A display of its own (Xvfb), a viewer on it, and hands for its keys and its mouse (xdotool)."""
import mmap
import os
import re
import struct
import subprocess
import sys
import tempfile
import time
import zlib

# Waits are this long at most; on a busy machine everything takes its time.
PATIENCE = 120


class Screen:
    """What Xvfb shows, as it lies in its memory file: an X window dump."""

    def __init__(self, path):
        with open(path, "rb") as file:
            self.memory = mmap.mmap(file.fileno(), 0, prot=mmap.PROT_READ)
        header = struct.unpack(">25I", self.memory[:100])
        self.width, self.height, self.stride = header[4], header[5], header[12]
        self.begin = header[0] + 12 * header[19]

    def bytes(self):
        return self.memory[self.begin : self.begin + self.stride * self.height]

    def picture(self):
        """The bytes of what lies to the right of the panel."""
        data, left = self.bytes(), 4 * 360
        return b"".join(data[y * self.stride + left : y * self.stride + 4 * self.width] for y in range(self.height))

    def panel(self):
        """The bytes of the panel and of what lies below it."""
        data = self.bytes()
        return b"".join(data[y * self.stride : y * self.stride + 4 * 360] for y in range(self.height))

    def still_picture(self, before=None):
        """The picture, once it is not `before` any more and has stayed the same for a moment."""
        end = time.monotonic() + PATIENCE
        last = None
        while time.monotonic() < end:
            now = self.picture()
            if now == last and now != before:
                return now
            last = now
            time.sleep(0.3)
        return None

    def find(self, colour, side):
        """The middle of the last square of one colour, as one reads."""
        rows = list(self.rows())
        wanted = bytes(colour) * side
        for y in range(self.height - side, -1, -1):
            at = rows[y].rfind(wanted)
            if at >= 0 and at % 3 == 0 and all(row[at : at + 3 * side] == wanted for row in rows[y : y + side]):
                return at // 3 + side // 2, y + side // 2
        sys.exit("there is no square of this colour on the screen")

    def rows(self):
        data = self.bytes()
        for y in range(self.height):
            row = data[y * self.stride : y * self.stride + 4 * self.width]
            pixels = bytearray(3 * self.width)
            pixels[0::3], pixels[1::3], pixels[2::3] = row[2::4], row[1::4], row[0::4]
            yield bytes(pixels)

    def save(self, path):
        def chunk(kind, content):
            return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

        size = struct.pack(">IIBBBBB", self.width, self.height, 8, 2, 0, 0, 0)
        data = zlib.compress(b"".join(b"\0" + row for row in self.rows()), 9)
        with open(path, "wb") as file:
            file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", size) + chunk(b"IDAT", data) + chunk(b"IEND", b""))


class Viewer:
    """`with Viewer([voxc, "view", ...]) as viewer`: a viewer that runs; its log is read as it grows."""

    def __init__(self, command, size=(800, 600)):
        self.folder = tempfile.mkdtemp()
        self.log = os.path.join(self.folder, "log")
        self.command, self.size, self.position = command, size, 0

    def __enter__(self):
        end, begin = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(begin), "-screen", "0", "%dx%dx24" % self.size, "-fbdir", self.folder]
            + ["-nolisten", "tcp"],
            pass_fds=[begin],
            stderr=subprocess.DEVNULL,
        )
        os.close(begin)
        with os.fdopen(end) as pipe:
            self.environment = dict(os.environ, DISPLAY=":" + pipe.readline().strip())
        self.screen = Screen(os.path.join(self.folder, "Xvfb_screen0"))
        self.output = open(os.path.join(self.folder, "output"), "w+b")
        self.process = subprocess.Popen(
            self.command + ["--size", "%dx%d" % self.size, "--log", self.log],
            env=self.environment,
            stdout=self.output,
            stderr=subprocess.STDOUT,
        )
        return self

    def focus(self):
        """Waits for the window, and gives it the keys, as no window manager does here."""
        self.wait("^window ")
        self.do("search", "--sync", "--onlyvisible", "--name", "voxc view", "windowfocus", "--sync")

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        self.server.kill()
        self.server.wait()

    def do(self, *words):
        subprocess.run(["xdotool", *words], env=self.environment, check=True, stdout=subprocess.DEVNULL)

    def key(self, *names):
        self.do("key", *names)

    def type(self, text):
        self.do("type", "--delay", "20", text)

    def move(self, x, y):
        self.do("mousemove", str(x), str(y))

    def rest(self):
        """The mouse lies where it hides nothing of the picture."""
        self.move(20, 30)

    def click(self, x, y, button=1):
        self.do("mousemove", str(x), str(y), "click", str(button))

    def drag(self, x, y, to_x, to_y, button=1):
        middle = (str((x + to_x) // 2), str((y + to_y) // 2))
        self.do("mousemove", str(x), str(y), "mousedown", str(button), "mousemove", *middle)
        self.do("mousemove", str(to_x), str(to_y), "mouseup", str(button))

    def text(self):
        """All that the viewer wrote on standard output and error."""
        self.output.flush()
        with open(self.output.name, "rb") as file:
            return file.read().decode()

    def wait(self, pattern):
        """The next line of the log that has the pattern, after the last one that was waited for."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            if os.path.exists(self.log):
                with open(self.log, "rb") as file:
                    file.seek(self.position)
                    for line in file:
                        if not line.endswith(b"\n"):
                            break
                        self.position += len(line)
                        text = line.decode()[10:].rstrip("\n")
                        if re.search(pattern, text):
                            return text
            if self.process.poll() is not None:
                break
            time.sleep(0.01)
        sys.exit("no '%s' came; the viewer wrote:\n%s" % (pattern, self.text()))

    def close(self):
        """Closes the window by the keyboard, where nothing else is to be left; the exit code."""
        self.key("Escape", "Escape")
        return self.end()

    def end(self):
        """The exit code of the viewer, once it ends."""
        return self.process.wait(PATIENCE)
