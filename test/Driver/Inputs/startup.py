"""startup.py VOXC CACHE: how many pages `VOXC --version` asks the system for, where LLVM is linked into it."""
import pathlib
import re
import resource
import subprocess
import sys

voxc, cache = sys.argv[1:]
# With LLVM within it takes 2,200, with its shared libraries 4,000.
MOST = 3200

options = dict(re.findall(r"^(\w+):\w+=(.*)$", pathlib.Path(cache).read_text(), re.M))
if options.get("VOXC_LLVM_WITHIN") != "ON":
    sys.exit(0)


def faults(*command):
    """Of a child, with those of becoming it."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_minflt + after.ru_majflt - before.ru_minflt - before.ru_majflt


pages = min(faults(voxc, "--version") for _ in range(3)) - min(faults("true") for _ in range(3))
if pages > MOST:
    sys.exit(f"'voxc --version' takes {pages} page faults more than `true`; {MOST} are enough")
