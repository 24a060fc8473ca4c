# interrupt.py COMMAND...: starts a command that would run for long, interrupts it, and expects exit code 130.
import signal
import subprocess
import sys
import time

process = subprocess.Popen(sys.argv[1:])
time.sleep(1)
if process.poll() is not None:
    sys.exit(f"the command ended by itself with {process.returncode}")
process.send_signal(signal.SIGINT)
code = process.wait(timeout=60)
if code != 130:
    sys.exit(f"exit code {code} instead of 130")
