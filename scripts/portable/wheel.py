"""wheel.py ROOT BUILD CONTENTS FOLDER VERSION TIME: the wheel of BUILD/portable, and of the module in ROOT/python; CONTENTS has its licences and
its bill of materials (contents.py). The same input makes the same bytes."""
import base64
import hashlib
import pathlib
import sys
import time
import zipfile

# Of processors, as the head of a library numbers them.
TAGS = {62: "py3-none-manylinux_2_28_x86_64", 183: "py3-none-manylinux_2_28_aarch64"}
METADATA = """Metadata-Version: 2.1
Name: voxc
Version: {version}
Summary: A compiler for hybrid voxel formats: volumes built, traced and made pictures of, on CPU and GPU
License: Apache-2.0 WITH LLVM-exception
Requires-Python: >=3.9
Requires-Dist: numpy >=1.19
Classifier: Operating System :: POSIX :: Linux
Classifier: Programming Language :: Python :: 3
Classifier: Topic :: Scientific/Engineering :: Visualization
Description-Content-Type: text/markdown

{text}"""
WHEEL = "Wheel-Version: 1.0\nGenerator: voxc\nRoot-Is-Purelib: false\nTag: {tag}\n"


class Wheel:
    def __init__(self, path, info, moment):
        self.file = zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9)
        self.info, self.rows = info, []
        self.date = time.gmtime(max(moment, 315532800))[:6] # A zip file begins in 1980.

    def add(self, name, content, runs=False):
        entry = zipfile.ZipInfo(name, self.date)
        entry.compress_type = zipfile.ZIP_DEFLATED
        entry.external_attr = (0o100755 if runs else 0o100644) << 16
        self.file.writestr(entry, content)
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip("=")
        self.rows.append(f"{name},sha256={digest},{len(content)}\n")

    def add_folder(self, folder, below, runs=False, kinds=None):
        for path in sorted(folder.rglob("*")):
            if path.is_file() and not path.is_symlink() and "__pycache__" not in path.parts and (not kinds or path.suffix in kinds):
                self.add(f"{below}/{path.relative_to(folder).as_posix()}", path.read_bytes(), runs)

    def close(self):
        record = f"{self.info}/RECORD"
        entry = zipfile.ZipInfo(record, self.date)
        entry.external_attr = 0o100644 << 16
        self.file.writestr(entry, "".join(self.rows) + f"{record},,\n", zipfile.ZIP_DEFLATED)
        self.file.close()


def tag_of(library):
    """For what processor a library is, in the words of a wheel."""
    with library.open("rb") as file:
        return TAGS[int.from_bytes(file.read(20)[18:], "little")]


def main():
    root, build, contents, folder = map(pathlib.Path, sys.argv[1:5])
    version, moment = sys.argv[5], int(sys.argv[6])
    info, data = f"voxc-{version}.dist-info", f"voxc-{version}.data"
    tag = tag_of(build / "portable/lib/libvoxc.so.0")
    path = folder / f"voxc-{version}-{tag}.whl"
    wheel = Wheel(path, info, moment)
    wheel.add_folder(root / "python/voxc", "voxc")
    wheel.add_folder(build / "portable/lib", "voxc/lib", runs=True)
    wheel.add_folder(build / "portable/bin", "voxc/bin", runs=True)
    wheel.add_folder(root / "tools/report", "voxc/share/voxc/report", kinds={".py", ".html", ".css", ".js"})
    wheel.add(f"{data}/scripts/voxc", (root / "scripts/portable/command.py").read_bytes(), runs=True)
    wheel.add(f"{info}/METADATA", METADATA.format(version=version, text=(root / "python/README.md").read_text()).encode())
    wheel.add(f"{info}/WHEEL", WHEEL.format(tag=tag).encode())
    wheel.add(f"{info}/LICENSE", (root / "LICENSE").read_bytes())
    wheel.add_folder(contents, info)
    wheel.close()
    print(f"{path}, {path.stat().st_size / 1e6:.1f} MB")


main()
