"""pages.py VOXC WHOLE PAGES FOLDER: a user at two viewers, of a volume and of its pages within a budget. Prints what was told;
screenshots of each go to a folder of its own in FOLDER."""
import os
import sys

from desktop import Viewer

voxc, whole, pages, folder = sys.argv[1:]


def walk(name, volume, *options):
    """The same keys for both."""
    shots = os.path.join(folder, name)
    os.mkdir(shots)
    command = [voxc, "view", volume, "--device", "cpu", "--samples", "1", "--screenshots", shots, *options]
    with Viewer(command) as viewer:
        viewer.focus()
        print(name, viewer.wait("^scene "))
        if options[0] == "--device-memory":
            viewer.wait("^painted .*; [1-9][0-9]* pages so far, [0-9]+ of them read ahead")
        viewer.wait("^shown .*, the finest")
        for keys in [["p"], ["2", "v"], ["5"]]:
            for key in keys:
                viewer.key(key)
                if key != "p":
                    viewer.wait("^shown .*, the finest")
            if keys[-1] != "p":
                viewer.key("p")
            viewer.wait("^screenshot ")
        viewer.click(580, 330)
        print(name, viewer.wait("^(picked|error) "))
        if options[0] == "--device-memory":
            viewer.key("t")
            viewer.wait("^writing")
            viewer.key("ctrl+a")
            viewer.type("G(7)")
            viewer.key("Return")
            print(name, viewer.wait("^(scene|error) "))
            viewer.key("g")
            print(name, viewer.wait("^(scene|error) "))
            viewer.wait("^shown .*, the finest")
        print(name, "exit code", viewer.close())


walk("whole", whole, "--normals", "smooth")
walk("pages", pages, "--device-memory", "128KiB", "--normals", "smooth")
walk("coarse", pages, "--device-memory", "128KiB", "--allow-coarse", "2")
