"""user.py VOXC VOLUME SEARCH DIR: a user at the viewer, by real keys and a real mouse in a real window. Prints what the
viewer told, and what the screen showed; pictures of the screen go to DIR."""
import os
import sys

from desktop import Viewer

voxc, volume, search, folder = sys.argv[1:]
done = 0

# The colour of points that lead (apps/window/Chart.cpp).
LEADING = (110, 180, 255)


def step(name, told=None):
    """One interaction that did what it should."""
    global done
    done += 1
    print("%2d %s%s" % (done, name, ": " + told if told else ""))


def load(viewer, text):
    viewer.key("t")
    viewer.wait("^writing")
    viewer.key("ctrl+a")
    viewer.type(text)
    viewer.key("Return")
    return viewer.wait("^(scene|error) ")


def camera(viewer):
    viewer.key("c")
    return viewer.wait("^camera --camera ")


def finest(viewer, before=None):
    """What the screen shows when the picture is fine, and not `before` any more."""
    viewer.wait("^shown .*, the finest")
    viewer.rest()
    return viewer.screen.still_picture(before)


def fits(viewer):
    """Whether the panel has room for all of its text: further frames, which a key brings that changes nothing of it, show the same."""
    settled = viewer.screen.still_picture()
    before = viewer.screen.panel()
    viewer.key("F1")
    shown = viewer.screen.still_picture(settled)
    viewer.key("F1")
    viewer.screen.still_picture(shown)
    return "the panel fits" if viewer.screen.panel() == before else "the panel is cut off"


def leave(viewer):
    """Escape ends what was begun, and asks before it closes the window."""
    viewer.key("t")
    viewer.wait("^writing")
    viewer.type("S(9)")
    viewer.key("Escape")
    viewer.wait("^wrote")
    camera(viewer)
    step("leave the text", "the window stays")
    viewer.rest()
    before = viewer.screen.still_picture()
    viewer.key("F1")
    step("keys", "shown" if viewer.screen.still_picture(before) else "not shown")
    viewer.screen.save(os.path.join(folder, "help.png"))
    viewer.key("Escape")
    step("leave the keys", "hidden" if viewer.screen.still_picture() == before else "still shown")
    viewer.key("Escape")
    asked = viewer.screen.still_picture(before)
    viewer.screen.save(os.path.join(folder, "close.png"))
    viewer.key("c")
    step("leave, and go on", "the window stays" if asked and viewer.screen.still_picture(asked) == before else "not asked")
    viewer.key("Escape")
    viewer.screen.still_picture(before)
    viewer.key("Escape")
    step("close", "exit code %d" % viewer.end())


def move(viewer):
    """Whatever moves the camera shows another picture, and is told by other numbers."""
    moves = [(name, lambda name=name: viewer.key(name)) for name in ["w", "s", "d", "a", "e", "q"]]
    moves += [(name, lambda name=name: viewer.key(name)) for name in ["Left", "Up", "equal", "minus"]]
    moves += [("drag", lambda: viewer.drag(500, 300, 560, 330))]
    moves += [("drag by the right button", lambda: viewer.drag(500, 300, 540, 280, 3))]
    moves += [("wheel", lambda: viewer.click(500, 300, 4))]
    home, shown = camera(viewer), viewer.screen.still_picture()
    last = home
    for name, act in moves:
        act()
        shown = finest(viewer, before=shown)
        now = camera(viewer)
        step(name, "another picture" if shown and now != last else "nothing")
        last = now
    viewer.key("f")
    step("fly", viewer.wait("^mode "))
    eye = camera(viewer).split(":")[0]
    viewer.drag(500, 300, 530, 300)
    finest(viewer, before=shown)
    step("drag", "the eye stays" if camera(viewer).split(":")[0] == eye else "the eye moves")
    viewer.key("f")
    viewer.wait("^mode orbit")
    viewer.key("r")
    finest(viewer)
    step("home", "the camera of the beginning" if camera(viewer) == home else "elsewhere")
    viewer.key("v")
    step("view", viewer.wait("^view "))
    return finest(viewer)


def look(viewer, folder):
    """Every style is another picture."""
    shown = {}
    for key in "23456":
        viewer.key(key)
        style = viewer.wait("^style ").split()[1]
        shown[style] = finest(viewer)
        viewer.screen.save(os.path.join(folder, style + ".png"))
        step("style", style)
    print("   %d different pictures" % len(set(shown.values())))
    viewer.key("h")
    step("no heat map", viewer.wait("^style "))
    finest(viewer)


def switch(viewer, folder):
    """Other formats and devices show the same voxels; what cannot be loaded changes nothing."""
    viewer.rest()
    before = viewer.screen.still_picture()

    def told():
        return "the same picture" if finest(viewer) == before else "another picture"

    step("write a format", load(viewer, "R(3^3) G(3) --whole-level-dedup"))
    print("   " + told())
    step("write what is none", load(viewer, "R(3^3) G("))
    step("write what is too small", load(viewer, "G(4)"))
    # The error comes when the frames that the key has brought are over.
    step("write what the voxels do not fit", load(viewer, "R(3^3) G(3) --palette=1"))
    print("   " + fits(viewer))
    viewer.screen.save(os.path.join(folder, "error.png"))
    viewer.key("g")
    step("next device", viewer.wait("^(scene|error) "))
    print("   " + told())
    viewer.key("bracketright")
    step("next of the search", viewer.wait("^(scene|error) "))
    print("   " + told())
    viewer.click(*viewer.screen.find(LEADING, 5))
    step("click a point of the search", viewer.wait("^(scene|error) "))
    print("   " + told())


arguments = [voxc, "view", volume, "--device", "cpu", "--samples", "1", "--search", search, "--screenshots", folder]
with Viewer(arguments) as viewer:
    viewer.focus()
    step("open", viewer.wait("^scene "))
    finest(viewer)
    viewer.screen.save(os.path.join(folder, "open.png"))
    move(viewer)
    look(viewer, folder)
    viewer.click(580, 330)
    step("click", viewer.wait("^picked "))
    print("   " + fits(viewer))
    viewer.screen.save(os.path.join(folder, "click.png"))
    viewer.click(790, 10)
    step("click", viewer.wait("^picked "))
    switch(viewer, folder)
    viewer.key("p")
    step("screenshot", os.path.basename(viewer.wait("^screenshot ").split(":")[0]))
    leave(viewer)
    complaints = [line for line in viewer.text().splitlines() if "Validation" in line or "VUID" in line]
    print("   %d complaints of the validation layer" % len(complaints), *complaints[:3], sep="\n   ")
