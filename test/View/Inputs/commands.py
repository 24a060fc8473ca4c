"""commands.py VOXC PAGE: opens a window by each command that the page shows as shell, and prints which scene it came to."""
import re
import shlex
import sys

from desktop import Viewer

voxc, page = sys.argv[1:]
with open(page, encoding="utf-8") as file:
    blocks = re.findall(r"^```sh\n(.*?)^```", file.read(), re.MULTILINE | re.DOTALL)
for line in "".join(blocks).splitlines():
    command = line.split("#")[0].strip()
    print(command)
    with Viewer([voxc, *shlex.split(command)[1:]]) as viewer:
        viewer.focus()
        print(viewer.wait("^scene "))
        if viewer.close() != 0:
            sys.exit(viewer.text())
