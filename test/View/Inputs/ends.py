"""ends.py COMMAND... [--interrupt]: runs a viewer until it ends by itself, or interrupts it when it shows a scene; prints what
it wrote and its exit code."""
import signal
import sys

from desktop import Viewer

command = sys.argv[1:]
is_interrupted = command[-1] == "--interrupt"
with Viewer(command[:-1] if is_interrupted else command) as viewer:
    if is_interrupted:
        viewer.wait("^shown ")
        viewer.process.send_signal(signal.SIGINT)
    code = viewer.end()
    print(viewer.text() + "exit code %d" % code)
