"""chunks.py FOLDER: a terrain of 128^3 voxels in chunks of 32^3, which take turns between two formats, and undivided as whole.hvx.
Chunks without voxels have no file. Needs NumPy and the installed module voxc."""
import pathlib
import sys

import voxc

CHUNK = 32

folder, source = pathlib.Path(sys.argv[1]), pathlib.Path(__file__).parent
folder.mkdir(parents=True, exist_ok=True)
formats = [(source / name).read_text() for name in ("dag.vir", "grid.vir")]
whole = voxc.build("R(4^3) G(5)", "builtin:terrain", resolution=128)
whole.save(str(folder / "whole.hvx"))
for low, words in whole.chunks(CHUNK):
    place = [begin // CHUNK for begin in low]
    chunk = voxc.build(formats[sum(place) % 2], voxels=words)
    chunk.save(str(folder / "chunk-{}-{}-{}.hvx".format(*place)))
    print(*place, chunk.format, chunk.voxels)
