"""Small inputs of every kind that voxc reads without a component of its own."""
import gzip
import struct


def ball(x, y, z, side=24):
    return sum((2 * c - side + 1) ** 2 for c in (x, y, z)) < (side - 2) ** 2


def samples(side=24):
    return bytes(200 if ball(x, y, z) else 0 for z in range(side) for y in range(side) for x in range(side))


def nifti(path):
    head = bytearray(352)
    struct.pack_into("<i", head, 0, 348)
    struct.pack_into("<8h", head, 40, 3, 24, 24, 24, 1, 1, 1, 1)
    struct.pack_into("<hh", head, 70, 2, 8)  # uint8
    struct.pack_into("<8f", head, 76, 1, 1, 1, 1, 0, 0, 0, 0)
    struct.pack_into("<f", head, 108, 352)
    head[344:348] = b"n+1\0"
    path.write_bytes(gzip.compress(bytes(head) + samples()))


def nrrd(path):
    path.write_bytes(b"NRRD0004\ntype: uint8\ndimension: 3\nsizes: 24 24 24\nencoding: raw\n\n" + samples())


def binvox(path):
    runs = bytearray()
    cells = [ball(x, y, z) for x in range(24) for z in range(24) for y in range(24)]
    at = 0
    while at < len(cells):
        end = at
        while end < len(cells) and cells[end] == cells[at] and end - at < 255:
            end += 1
        runs += bytes([cells[at], end - at])
        at = end
    path.write_bytes(b"#binvox 1\ndim 24 24 24\ntranslate 0 0 0\nscale 1\ndata\n" + bytes(runs))


def mesh(path):
    corners = [(x, y, z) for x in (0, 3) for y in (0, 4) for z in (0, 5)]
    faces = ["1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4"]
    path.write_text("".join(f"v {x} {y} {z}\n" for x, y, z in corners) + "".join(f"f {face}\n" for face in faces))


def inputs(folder, run):
    """Writes an input of each kind to a folder, in which `run(WORD...)` runs voxc; what a command line calls them."""
    mesh(folder / "box.obj")
    nifti(folder / "ball.nii.gz")
    nrrd(folder / "ball.nrrd")
    binvox(folder / "ball.binvox")
    (folder / "ball.raw").write_bytes(samples())
    run("build", "G(5)", "ball.nrrd", "-o", "ball.hvx", "--quiet")
    for ending in ("vox", "nvdb", "ply"):
        run("export", "ball.hvx", "-o", f"ball.{ending}", "--quiet")
    run("export", "ball.hvx", "-o", "ball%02d.png", "--quiet")
    return ["box.obj", "ball.ply", "ball.vox", "ball.nii.gz", "ball.nrrd", "ball.binvox", "ball.nvdb", "ball.hvx", "raw:24x24x24:uint8:ball.raw",
            "builtin:terrain:32", "ball%02d.png"]
