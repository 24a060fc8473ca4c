# limited.py NAME=VALUE... COMMAND...: runs a command under limits of the process, by the names of the resource module in
# small letters: fsize=65536. Its exit code is this script's; a signal is told as "signal N", with exit code 99.
import resource
import subprocess
import sys

words = sys.argv[1:]
limits = []
while words and words[0].split("=")[0].isalpha() and "=" in words[0]:
    name, value = words.pop(0).split("=")
    limits.append((getattr(resource, "RLIMIT_" + name.upper()), int(value)))


def limit():
    for kind, value in limits:
        resource.setrlimit(kind, (value, value))


code = subprocess.run(words, preexec_fn=limit).returncode
if code < 0:
    print(f"signal {-code}", file=sys.stderr)
    code = 99
sys.exit(code)
