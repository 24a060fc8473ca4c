"""Options of inputs in Python are those of voxc build, with its voxels, its warnings and its errors: inputs.py VOXC FOLDER, where
the inputs are written to."""
import re
import struct
import subprocess
import sys
import warnings
import zlib
from pathlib import Path

import numpy as np
import voxc
from voxc.building import INPUT_OPTIONS

program, folder = sys.argv[1], Path(sys.argv[2])
OUTPUT = folder / "tool.hvx"


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def write_inputs():
    """A textured box without a lid, a scan of two volumes and of spacings that differ, arrays."""
    texels = np.random.default_rng(3).integers(0, 256, (64, 64, 3), dtype=np.uint8)
    rows = b"".join(b"\0" + row.tobytes() for row in texels)
    (folder / "t.png").write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 64, 64, 8, 2, 0, 0, 0)) +
                                   chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
    (folder / "box.mtl").write_text("newmtl m\nmap_Kd t.png\nmap_Bump t.png\n")
    corners = [(x, y, z) for x in (0, 1) for y in (0, 2) for z in (0, 3)]
    sides = [(1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)]
    (folder / "box.obj").write_text("mtllib box.mtl\nusemtl m\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n" +
                                    "".join("v %d %d %d\n" % corner for corner in corners) +
                                    "".join("f " + " ".join(f"{v}/{t + 1}" for t, v in enumerate(side)) + "\n" for side in sides))
    samples = np.random.default_rng(4).integers(0, 256, (2, 4, 5, 6), dtype=np.uint8)
    (folder / "scan.nrrd").write_bytes(b"NRRD0004\ntype: uint8\ndimension: 4\nsizes: 6 5 4 2\nkinds: domain domain domain list\n"
                                       b"spacings: 1 1 2.5 nan\nencoding: raw\n\n" + samples.tobytes())
    arrays = {"first": np.zeros((3, 3, 3), np.uint8), "second": np.zeros((3, 3, 3), np.uint8)}
    arrays["first"][0, 0, 1] = 5
    arrays["second"][:2, :2, :2] = 9
    np.savez(folder / "arrays.npz", **arrays)


# An input, what Python is told, and where it is not the same in other letters, what the tool is told.
KEPT = [
    ("box.obj", dict(), None),
    ("box.obj", dict(resolution=12, colour="nearest"), None),
    ("box.obj", dict(resolution=12, colour="mean"), None),
    ("box.obj", dict(resolution=12, coverage="centre"), None),
    ("box.obj", dict(voxel_size=0.25), ["--voxel-size=0.25"]),
    ("box.obj", dict(voxel_size="25cm", unit="m"), None),
    ("box.obj", dict(voxel_size=np.float64(0.3), align=(0.1, 0.2, 0)), ["--voxel-size=0.3", "--align=0.1,0.2,0"]),
    ("box.obj", dict(resolution=9, bounds=np.array([0, 0, 0, 1, 1, 1])), ["--resolution=9", "--bounds=0,0,0,1,1,1"]),
    ("box.obj", dict(resolution=9, bounds=(7, 7, 7, 9, 9, 9)), ["--resolution=9", "--bounds=7,7,7,9,9,9"]),
    ("box.obj", dict(resolution=9, z_up=True), ["--resolution=9", "--up=z"]),
    ("box.obj", dict(resolution=9, interior="fill", fill_colour="ff8000"), None),
    ("box.obj", dict(resolution=9, interior="fill", crop=True), ["--resolution=9", "--interior=fill", "--crop"]),
    ("scan.nrrd", dict(), None),
    ("scan.nrrd", dict(volume=2, threshold=100, window=(50, 200)), ["--volume=2", "--threshold=100", "--window=50,200"]),
    ("scan.nrrd", dict(voxel_size="1"), None),
    ("scan.nrrd", dict(z_up=False, colour_map="heat", volume=1), ["--up=y", "--colour-map=heat", "--volume=1"]),
    ("arrays.npz", dict(), None),
    ("arrays.npz", dict(grid="second"), None),
    ("arrays.npz", dict(grid="first", crop=True), ["--grid=first", "--crop"]),
]
REFUSED = [
    ("box.obj", dict(voxel_size="5 parsecs"), "is no size of a voxel; write a number above 0"),
    ("box.obj", dict(voxel_size="1x1x2"), "is no size of voxels, which are cubes"),
    ("box.obj", dict(voxel_size="5mm", unit="ell"), "'ell' is no unit that is known"),
    ("box.obj", dict(voxel_size="5", unit="mm"), "--unit says what a --voxel-size such as 5mm means"),
    ("box.obj", dict(voxel_size="1", resolution=9), "both say how large voxels are"),
    ("box.obj", dict(threshold=1), "--threshold is for dense volumes"),
    ("box.obj", dict(grid="a"), "--grid is for files of several grids"),
    ("box.obj", dict(fill_colour="ff8000"), "--fill-colour is for --interior fill"),
    ("box.obj", dict(fill_colour="00000000", interior="fill"), "the colour 00000000 means empty"),
    ("box.obj", dict(fill_colour="red", interior="fill"), "'red' is no colour; write rrggbb"),
    ("scan.nrrd", dict(colour="nearest"), "--colour is for meshes"),
    ("scan.nrrd", dict(resolution=9), "--resolution is for meshes and built-in scenes"),
    ("scan.nrrd", dict(volume=3), "volume 3"),
    ("scan.nrrd", dict(grid="a"), "--grid is for .nvdb, .vdb, .npz and .vti files"),
    ("arrays.npz", dict(grid="third"), "'third'"),
    ("builtin:terrain:16", dict(resolution=9), "--resolution 9 would do nothing for 'builtin:terrain:16'"),
]


def path_of(name):
    return name if ":" in name else str(folder / name)


def words_of(options, words):
    return words if words is not None else [f"--{name.replace('_', '-')}={value}" for name, value in options.items()]


def tool(name, words):
    OUTPUT.unlink(missing_ok=True)
    return subprocess.run([program, "build", "G(6)", path_of(name), "-o", OUTPUT, *words], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


def lines(text, mark):
    return tuple(line.removeprefix(mark) for line in text.splitlines() if line.startswith(mark))


def keeps(name, options, words):
    done = tool(name, words_of(options, words))
    assert done.returncode == 0, (name, options, done.stderr)
    expected = voxc.Volume.load(OUTPUT)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        volume = voxc.build("G(6)", path_of(name), **options)
    assert volume.words.tolist() == expected.words.tolist(), (name, options)
    assert (volume.to_model == expected.to_model).all() and volume.provenance == expected.provenance, (name, options)
    assert volume.warnings == lines(done.stderr, "voxc: warning: "), (name, volume.warnings, done.stderr)
    assert volume.notes == lines(done.stderr, "voxc: note: "), (name, volume.notes, done.stderr)
    assert tuple(str(warning.message) for warning in caught) == volume.warnings
    assert all(warning.category is voxc.InputWarning and warning.filename == __file__ for warning in caught)
    print("the same:", name, options, f"{volume.voxels} voxels, {len(volume.warnings)} warnings, {len(volume.notes)} notes")
    return volume


def refuses(name, options, sentence):
    done = tool(name, words_of(options, None))
    assert done.returncode != 0 and sentence in done.stderr, (name, options, done.stderr)
    try:
        voxc.build("G(6)", path_of(name), **options)
        sys.exit(f"{name} takes {options}")
    except voxc.Error as error:
        assert sentence in str(error) and str(error) in done.stderr, (str(error), done.stderr)
        assert {"usage": 2, "input": 1}[error.kind] == done.returncode, (name, options, error.kind)
    print("refused alike:", name, options)


def check_labels():
    """In a format of labels the samples are labels, without being asked for."""
    done = tool("arrays.npz", ["--material", "--grid=second"])
    assert done.returncode == 0, done.stderr
    volume = voxc.build("G(6)", folder / "arrays.npz", grid="second", passes="material")
    assert volume.read().max() == 9 and (volume.read() == voxc.Volume.load(OUTPUT).read()).all()


def check_automatic():
    """The program builds it, and says the same."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        automatic = voxc.build("auto", folder / "scan.nrrd", volume=2, window=(50, 200), crop=True)
        plain = voxc.build("G(6)", folder / "scan.nrrd", volume=2, window=(50, 200), crop=True)
    assert (automatic.read() == plain.read()).all() and automatic.warnings == plain.warnings != ()
    assert len(caught) == 2 * len(plain.warnings) and all(warning.filename == __file__ for warning in caught)


write_inputs()
volumes = [keeps(*case) for case in KEPT]
assert volumes[1].words.tolist() != volumes[2].words.tolist() and volumes[17].voxels == 8
assert any("map_Bump" in warning for warning in volumes[0].warnings) and "empty" in volumes[8].warnings[-1]
for case in REFUSED:
    refuses(*case)
check_labels()
check_automatic()
with warnings.catch_warnings():
    warnings.simplefilter("error")
    try:
        voxc.build("G(6)", folder / "arrays.npz")
        sys.exit("a warning that is an error is none")
    except voxc.InputWarning:
        pass
# All that the tool has in its help, of the group of inputs.
usage = subprocess.run([program, "build", "--help"], stdout=subprocess.PIPE, text=True, check=True).stdout
named = re.findall(r"^ *--([a-z-]+)", usage.partition("\nInput:")[2].partition("\n\n")[0], re.M)
known = {name.replace("_", "-") for name in INPUT_OPTIONS + ("threshold", "window")} - {"z-up"} | {"up"}
assert named and set(named) == known, (named, known)
print("python has what the command line has")
