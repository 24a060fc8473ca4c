"""Files of optional components, by the program and by the C library: components.py VOXC FOLDER. Prints what became of each."""
import subprocess
import sys
from pathlib import Path

import voxc

program, folder = sys.argv[1], Path(sys.argv[2])
OUTPUT = folder / "tool.hvx"


def tool(*words):
    return subprocess.run([program, *words], stderr=subprocess.PIPE, text=True)


def both(path):
    """The voxels that both make of the file, or the one sentence that both say."""
    OUTPUT.unlink(missing_ok=True)
    done = tool("build", "G(4)", path, "-o", OUTPUT, "--quiet")
    try:
        volume = voxc.build("G(4)", path)
    except voxc.Error as error:
        assert done.returncode == 3 and error.kind == "environment" and str(error) in done.stderr, (str(error), done.stderr)
        return str(error)
    assert done.returncode == 0 and (volume.words == voxc.Volume.load(OUTPUT).words).all(), done.stderr
    return f"{volume.voxels} voxels"


(folder / "tent.off").write_text("OFF\n4 3 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n3 0 1 2\n3 0 2 3\n3 0 3 1\n")
assert tool("build", "G(4)", "builtin:shell:4", "-o", OUTPUT, "--quiet").returncode == 0
if tool("export", OUTPUT, "-o", folder / "fog.vdb", "--quiet").returncode != 0:
    (folder / "fog.vdb").write_text("none")
for name in ("tent.off", "fog.vdb"):
    print(name + ":", both(folder / name))
