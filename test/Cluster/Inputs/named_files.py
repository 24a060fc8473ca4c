"""Models below a folder whose files are named by percents, in another case, from above, and in other folders."""
import struct
import sys
import zlib
from pathlib import Path

HERE = Path(sys.argv[1])
MODELS = HERE / "models"


def png(colour):
    """An image of one texel."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    header = struct.pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(b"\0" + bytes(colour)))
            + chunk(b"IEND", b""))


(MODELS / "maps" / "by percent.png").write_bytes(png([200, 10, 10]))
(HERE / "textures" / "away.png").write_bytes(png([10, 200, 10]))
(HERE / "other.png").write_bytes(png([10, 10, 200]))
(MODELS / "Two Words.MTL").write_text("newmtl near\nmap_Kd maps/by%20percent.png\n"
                                      "newmtl far\nmap_Kd C:\\elsewhere\\AWAY.png\n")
(MODELS / "named.obj").write_text("mtllib two\\ words.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nvt 0 0\n"
                                  "usemtl near\nf 1/1 2/1 3/1\nusemtl far\nf 2/1 3/1 4/1\n")
(MODELS / "named.ply").write_text("""ply
format ascii 1.0
comment TextureFile away.png
element vertex 3
property float x
property float y
property float z
property float u
property float v
element face 1
property list uchar int vertex_indices
end_header
0 0 0 0 0
1 0 0 0 0
0 1 0 0 0
3 0 1 2
""")
(MODELS / "named.nhdr").write_text("NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n"
                                   "data file: ../samples.raw\n\n")
(HERE / "samples.raw").write_bytes(bytes(range(8)))
