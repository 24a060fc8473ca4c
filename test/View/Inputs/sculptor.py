"""sculptor.py VOXC VOLUME DEVICE DIR: a user with a brush, by real keys and a real mouse. Prints what the viewer told, and what the
screen showed; pictures of the screen go to DIR, and the longest time from a stroke to the screen is the last line."""
import os
import re
import sys
import time

from desktop import Viewer

voxc, volume, device, folder = sys.argv[1:]


def finest(viewer, before=None):
    viewer.wait("^shown .*, the finest")
    viewer.rest()
    return viewer.screen.still_picture(before)


def shows_finest(viewer):
    with open(viewer.log, encoding="utf-8") as log:
        return [line for line in log if " shown " in line][-1].rstrip().endswith(", the finest")


def calm(viewer, before):
    """What the screen shows once the viewer has nothing more to tell, which a slow machine may pause in."""
    viewer.rest()
    told = -1
    while told != os.path.getsize(viewer.log) or not shows_finest(viewer):
        told = os.path.getsize(viewer.log)
        time.sleep(1)
    return viewer.screen.still_picture(before)


def brush(viewer, key):
    viewer.key(key)
    return viewer.wait("^brush ")


def again(viewer, key, before):
    """What the screen shows when a key has undone or redone a stroke."""
    viewer.key(key)
    viewer.wait("^carved ")
    return calm(viewer, before)


def stroke(viewer, name, before, steps=30):
    """A stroke of so many steps, each of which ends before the next."""
    viewer.do("mousemove", "420", "330", "mousedown", "1")
    viewer.wait("^carved ")
    for i in range(steps):
        viewer.do("mousemove", str(423 + 8 * i), str(330 + 3 * (i % 5)))
        if not viewer.wait("^carved ").startswith("carved 0 "):
            viewer.wait("^reacted ")
    viewer.do("mouseup", "1")
    shown = calm(viewer, before)
    viewer.screen.save(os.path.join(folder, name + ".png"))
    print(name + ":", "another picture" if shown else "the same picture")
    return shown


with Viewer([voxc, "view", volume, "--device", device, "--samples", "1", "--screenshots", folder], (1280, 720)) as viewer:
    viewer.focus()
    viewer.wait("^scene ")
    first = finest(viewer)
    viewer.click(700, 330)
    print("click:", re.sub(r"(voxel )[-0-9,]*", r"\1X,Y,Z", viewer.wait("^picked ")).split(", colour")[0])
    print(brush(viewer, "b"))
    print(brush(viewer, "period"))
    added = stroke(viewer, "added", first)
    print(brush(viewer, "b"))
    print(brush(viewer, "n"))
    erased = stroke(viewer, "erased", added)
    print("undo:", "as before" if again(viewer, "z", erased) == added else "otherwise")
    print("undo:", "the first picture" if again(viewer, "z", added) == first else "otherwise")
    print("redo:", "as before" if again(viewer, "y", first) == added else "otherwise")
    print(brush(viewer, "b"))
    painted = stroke(viewer, "painted", added)
    viewer.key("j")
    print(viewer.wait("^copied ").split()[0])
    print(brush(viewer, "b"))
    stroke(viewer, "pasted", painted, 2)
    print(brush(viewer, "b"))
    viewer.click(700, 330)
    print("click:", viewer.wait("^picked ").split(";")[1].split(":")[0])
    viewer.key("Escape", "Escape")
    print("exit code", viewer.end())
    log = open(viewer.log, "rb").read().decode()
    complaints = [line for line in viewer.text().splitlines() if "Validation" in line or "VUID" in line]
    print(len(complaints), "complaints of the validation layer")
    times = [float(time) for time in re.findall(r"reacted after ([0-9.]+) ms", log)]
    strokes = sorted(times)
    print("of %d reactions, the median took %.1f ms and the longest %.1f" % (len(strokes), strokes[len(strokes) // 2], strokes[-1]))
