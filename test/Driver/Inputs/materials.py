"""materials.py FOLDER: a lamp as .obj, and m.vox with a material of each kind. materials.py FOLDER NAME: the words of
NAME.raw, and what is attached to these voxels in NAME.hvx, each kind with how many there are."""
import collections
import struct
import sys

folder = sys.argv[1]


def chunk(name, content):
    return name + struct.pack("<2I", len(content), 0) + content


def text(value):
    return struct.pack("<I", len(value)) + value.encode()


def material(number, **pairs):
    pairs = [text("_" + key) + text(value) for key, value in pairs.items()]
    return chunk(b"MATL", struct.pack("<2I", number, len(pairs)) + b"".join(pairs))


def stream(data, name):
    for row in range(int.from_bytes(data[68:72], "little")):
        at = 168 + 56 * row
        if data[at : at + 32].rstrip(b"\0").decode() == name:
            count, offset = (int.from_bytes(data[at + i : at + i + 8], "little") for i in (40, 48))
            return struct.unpack_from(f"<{count}I", data, offset)
    return None


def write():
    corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
    open(folder + "/lamp.obj", "w").write("mtllib lamp.mtl\n" + corners + "usemtl lamp\nf 1 2 3 4\n")
    open(folder + "/lamp.mtl", "w").write("newmtl lamp\nKd 0.2 0 0\nKe 8 4 0\nPr 1\n")
    colours = [0xFF202020, 0xFF204060, 0xFF30C0FF, 0xFF30C0FF, 0xFFE0E0E0]
    cells = b"".join(bytes([2 * i, 0, 0, i + 1]) for i in range(5))
    content = chunk(b"SIZE", struct.pack("<3I", 9, 1, 1))
    content += chunk(b"XYZI", struct.pack("<I", 5) + cells)
    content += chunk(b"RGBA", struct.pack("<256I", *colours, *[0] * 251))
    content += material(1, type="_diffuse", rough="0.1")
    content += material(2, type="_metal", rough="0.2", metal="0.6")
    content += material(3, type="_emit", emit="1")
    content += material(4, type="_emit", emit="0.75", flux="3")
    content += material(5, type="_glass", rough="0.1", trans="0.9")
    open(folder + "/m.vox", "wb").write(
        b"VOX " + struct.pack("<I", 150) + b"MAIN" + struct.pack("<2I", 0, len(content)) + content
    )


def tell(name):
    """Voxels lie in one row or are all alike, so that x, y, z goes through them as their numbers do."""
    words = [word for (word,) in struct.iter_unpack("<I", open(f"{folder}/{name}.raw", "rb").read()) if word]
    data = open(f"{folder}/{name}.hvx", "rb").read()
    emission, strength, metal = (
        stream(data, kind) for kind in ("emission", "emission-strength", "metallic-roughness")
    )
    found = collections.Counter()
    for number, word in enumerate(words):
        times = "-"
        if strength:
            times = "%g" % struct.unpack("<f", struct.pack("<I", strength[number]))
        found[f"{word:08x} {emission[number]:08x} {times} {metal[number]:08x}"] += 1
    for line in sorted(found):
        print(line, ":", found[line])


write() if len(sys.argv) == 2 else tell(sys.argv[2])
