"""pipes.py VOXC: reads a little of what the tool writes, and closes the pipe."""
import subprocess
import sys

voxc, = sys.argv[1:]


def read(name, what, words, take):
    process = subprocess.Popen([voxc, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, bufsize=0)
    take(process.stdout)
    process.stdout.close()
    error = process.stderr.read().decode()
    status = process.wait()
    print(f"{name}: {what}, " + (f"ended by signal {-status}" if status < 0 else f"exit code {status}") + f", {error!r}")


def line(stream):
    while stream.read(1) not in (b"\n", b""):
        pass


# More than a pipe takes at once, or no more is written.
read("suggest", "one line", ["suggest", "builtin:terrain:64", "--stats", "-", "--quiet"], line)
read("compile", "one byte", ["compile", "R(4^3) G(7)", "--emit=header", "-o", "-", "--quiet"], lambda stream: stream.read(1))
