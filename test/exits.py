# exits.py CODE COMMAND...: runs a command and succeeds if it ends with this exit code.
import subprocess
import sys

expected, command = int(sys.argv[1]), sys.argv[2:]
code = subprocess.run(command).returncode
if code != expected:
    sys.exit(f"exit code {code} instead of {expected}: {' '.join(command)}")
