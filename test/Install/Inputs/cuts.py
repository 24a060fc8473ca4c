"""Pictures from C and from Python are those of voxc render, in every byte: cuts.py VOXC VOLUME.hvx FOLDER, where cuts.c has written its own."""
import subprocess
import sys
from pathlib import Path

import numpy as np
import voxc

from pictures import Picture

program, path, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])

# What voxc render is told, what Python is told, and the picture of cuts.c that is the same, if there is one.
CASES = [
    ([], {}, "whole"),
    ([], {}, "older"),
    (["--view", "iso", "--clip-box", "0,0,0,32,32,20.5"], dict(view="iso", clip_box=((0, 0, 0), (32, 32, 20.5))), "box"),
    (["--view", "iso", "--clip-box", "0,0,0,32,32,20.5", "--clip-plane", "1,0,1,20", "--clip-plane", "0,-1,0,-25", "--view-height", "40"],
     dict(view="iso", clip_box=(0, 0, 0, 32, 32, 20.5), clip_planes=[(1, 0, 1, 20), (0, -1, 0, -25)], view_height=40), "all"),
    (["--orthographic", "--camera", "60,40,70:16,16,16", "--fov", "30"], dict(orthographic=True, eye=(60, 40, 70), look=(16, 16, 16), fov=30), "parallel"),
    (["--orthographic", "--view", "top"], dict(orthographic=True, view="top"), None),
    (["--orthographic"], dict(orthographic=True), None),
    (["--view-height", "20", "--camera", "60,40,70:16,16,16"], dict(view_height=20, eye=(60, 40, 70), look=(16, 16, 16)), None),
    (["--view", "front", "--style", "normals", "--clip-plane", "0,0,-1,-12"], dict(view="front", style="normals", clip_planes=(0, 0, -1, -12)), None),
]


def rendered(words):
    output = folder / "rendered.png"
    subprocess.run([program, "render", path, *words, "--size", "64x48", "--device", "cpu", "-o", output, "--quiet"], check=True)
    picture = Picture(output)
    rows = np.array([np.frombuffer(row, np.uint8) for row in picture.rows]).reshape(48, 64, picture.channels)
    return rows[..., :3]


tracer = voxc.Volume.load(path).tracer("cpu")
seen = []
for words, options, name in CASES:
    expected = rendered(words)
    python = tracer.render(64, 48, **options)[..., :3]
    assert (python == expected).all(), f"{options}: {(python != expected).any(-1).sum()} pixels differ from those of voxc render {words}"
    if name:
        c = np.fromfile(folder / f"{name}.rgba", np.uint8).reshape(48, 64, 4)[..., :3]
        assert (c == expected).all(), f"{name}: {(c != expected).any(-1).sum()} pixels differ from those of voxc render {words}"
    if words not in [before for before, _ in seen]:
        assert not any((expected == other).all() for _, other in seen), f"{words} changes nothing"
        seen.append((words, expected))
    print("the same:", *words)
