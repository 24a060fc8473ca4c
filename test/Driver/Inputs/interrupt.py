# interrupt.py [--after FILE] COMMAND...: starts a command that would run for long, interrupts it after a second, or when FILE
# has three lines, and expects exit code 130.
import pathlib
import signal
import subprocess
import sys
import time

command = sys.argv[1:]
awaited = pathlib.Path(command[1]) if command[0] == "--after" else None
process = subprocess.Popen(command[2:] if awaited else command)
time.sleep(1)
while awaited and process.poll() is None and (not awaited.exists() or awaited.read_text().count("\n") < 3):
    time.sleep(0.1)
if process.poll() is not None:
    sys.exit(f"the command ended by itself with {process.returncode}")
process.send_signal(signal.SIGINT)
code = process.wait(timeout=60)
if code != 130:
    sys.exit(f"exit code {code} instead of 130")
