"""cuts.py VOXC VOLUME [OPTION ...]: opens a window, clicks its middle, and changes to parallel rays and back. Prints what the viewer told,
and whether the picture is another."""
import sys

from desktop import Viewer

voxc, volume, *options = sys.argv[1:]
with Viewer([voxc, "view", volume, "--device", "cpu", *options]) as viewer:
    viewer.focus()
    viewer.wait("^shown .*, the finest")
    viewer.rest()
    first = viewer.screen.still_picture()
    viewer.click(400, 300)
    print(viewer.wait("^picked "))
    viewer.rest()
    for key in ("x", "x"):
        viewer.key(key)
        print(viewer.wait("^rays "))
        viewer.wait("^shown .*, the finest")
        viewer.key("c")
        print(viewer.wait("^camera "))
        print("the same picture" if viewer.screen.still_picture() == first else "another picture")
    print("exit code", viewer.close())
