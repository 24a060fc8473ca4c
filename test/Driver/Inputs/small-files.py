"""Runs a command that may not write files of more than 4 KiB."""
import resource
import subprocess
import sys

resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))
sys.exit(subprocess.call(sys.argv[1:]) == 0)
