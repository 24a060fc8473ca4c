"""player.py VOXC ANIMATION DEVICE DIR: a user who plays an animation, by real keys. Prints what the viewer told, and whether the screen
showed the frame that was asked for, beside what it shows of that frame alone; what is saved goes to DIR."""
import os
import sys

from desktop import Viewer

voxc, volume, device, folder = sys.argv[1:]
COMMON = ["--device", device, "--samples", "1", "--camera", "40,25,45:12,4,10", "--style", "flat", "--screenshots", folder]


def finest(viewer, before=None):
    viewer.wait("^shown .*, the finest")
    viewer.rest()
    return viewer.screen.still_picture(before)


def alone(frame):
    """What a viewer shows of one frame."""
    with Viewer([voxc, "view", f"{volume}#{frame}", *COMMON], (800, 600)) as viewer:
        viewer.focus()
        return finest(viewer)


frames = {frame: alone(frame) for frame in (1, 2, 5)}
with Viewer([voxc, "view", volume, "--fps", "20", *COMMON], (800, 600)) as viewer:

    def shows(frame):
        viewer.wait("^shown .*, the finest")
        print("shown:", "as alone" if viewer.screen.still_picture() == frames[frame] else "otherwise")

    viewer.focus()
    first = finest(viewer)
    print("frame 1:", "as alone" if first == frames[1] else "otherwise")
    viewer.key("Next")
    print(viewer.wait("^frame "))
    shows(2)
    viewer.key("Prior", "Prior")
    print(viewer.wait("^frame "))
    print(viewer.wait("^frame "))
    shows(5)
    viewer.key("space")
    print(viewer.wait("^playing"))
    for _ in range(7):
        viewer.wait("^frame ")
    print("played 7 frames")
    viewer.key("space")
    print(viewer.wait("^stopped playing"))
    viewer.key("F2")
    print(viewer.wait("^saved ").replace(folder + os.sep, ""))
    viewer.key("g")
    viewer.wait("^scene ")
    viewer.key("Next", "Prior")
    print("another device has", viewer.wait("^frame ")[-4:])
    viewer.key("Escape", "Escape")
    print("exit code", viewer.end())
    complaints = [line for line in viewer.text().splitlines() if "Validation" in line or "VUID" in line]
    print(len(complaints), "complaints of the validation layer")
