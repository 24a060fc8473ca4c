# kill.py PATTERN COMMAND...: runs a command and kills it with SIGKILL as soon as a file of this pattern is there, whole or not.
import glob
import subprocess
import sys

child = subprocess.Popen(sys.argv[2:])
while child.poll() is None and not glob.glob(sys.argv[1]):
    pass
child.kill()
child.wait()
