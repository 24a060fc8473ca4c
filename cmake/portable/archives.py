"""archives.py FOLDER MADE COMPILER...: what -lNAME is to find in FOLDER in place of the system's shared libraries: archives, with all
archives that they need in their turn. MADE is where scripts/portable.sh has made those that Debian lacks."""
import pathlib
import subprocess
import sys

# -lNAME: the archives that it stands for. libtiff finds JPEG in libturbojpeg, which has all of libjpeg within, and no JBIG (NoJbig.c).
ARCHIVES = {
    "z": ["z"], "zstd": ["zstd"], "bz2": ["bz2"], "expat": ["expat"], "png": ["png16", "z"], "webp": ["webp"], "draco": ["draco"], "stb": ["stb"],
    "blosc": ["blosc", "lz4", "snappy", "z", "zstd"],
    "tiff": ["tiff", "lzma", "Lerc", "deflate", "webp", "z", "zstd"],
    "spirv-cross-c-shared": [f"spirv-cross-{part}" for part in ("c", "cpp", "hlsl", "msl", "glsl", "reflect", "util", "core")],
}
# Those that are made: Debian has a shared library alone, or an archive whose code may only lie in a program.
MADE = ["meshoptimizer", "turbojpeg"]


def main():
    folder, made, compiler = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3:]
    for name, parts in ARCHIVES.items():
        paths = []
        for part in parts:
            path = subprocess.run([*compiler, f"-print-file-name=lib{part}.a"], capture_output=True, text=True, check=True).stdout.strip()
            if not pathlib.Path(path).is_absolute():
                sys.exit(f"lib{part}.a, which lib{name} needs, is missing; scripts/packages-full.txt has its package")
            paths.append(path)
        (folder / f"lib{name}.so").write_text(f"INPUT({' '.join(paths)})\n")
    for name in MADE:
        (folder / f"lib{name}.so").write_text(f"INPUT({made}/lib{name}.a)\n")


main()
