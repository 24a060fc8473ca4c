# heavy_parent.py COMMAND...: runs a command from a process of 1.5 GiB.
import os
import sys

held = b"\1" * (3 << 29)
child = os.fork()
if child == 0:
    os.execvp(sys.argv[1], sys.argv[1:])
sys.exit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
