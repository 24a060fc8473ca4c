"""no-brush.py VOXC VOLUME: a user who takes a brush to a volume that has a format without edits."""
import sys

from desktop import Viewer

with Viewer([sys.argv[1], "view", sys.argv[2], "--device", "cpu", "--samples", "1"]) as viewer:
    viewer.focus()
    viewer.wait("^shown .*, the finest")
    viewer.key("b")
    print(viewer.wait("^error "))
    print("exit code", viewer.close())
