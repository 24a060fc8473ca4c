"""The kernels of twelve formats, as they are emitted, beside the golden texts of test/Emit/golden.

    golden.py VOXC DIR            tells what differs; exits with 1 if something does
    golden.py VOXC DIR --update   writes DIR anew

Of most kernels the golden text is what the format brings: the lines from "---- The format" to "---- What follows".
What all kernels share stands whole in those of the first format.
"""
import difflib
import pathlib
import subprocess
import sys

BEGIN, END = "---- The format:", "---- What follows"

# A name, the format, its passes and options, and further options of the kernel alone, which headers have not.
FORMATS = [
    ("dag-in-grid", "R(4^3) G(8)", "", ""),
    ("bricks-in-distances", "D(7^3,15) M(2^3)", "--octant-distances", ""),
    ("octree", "S(9)", "", ""),
    ("masked-grids", "M(4^3) M(3^3)", "", ""),
    ("numbered-bricks", "M(2^3) M(2^3) M(2^3)",
     "--values-apart --short-pointers=12 --octant-counts --octant-masks", ""),
    ("hashed", "S(5) H(2^3)", "", ""),
    ("unrolled-wide", "G(4,2) G(2)", "--unroll-sv --values-apart", ""),
    ("flat", "S(4) G(5)", "--flat-traversal", "--shared-stack"),
    ("mirrored", "G(9)", "--occupancy --mirror", ""),
    ("granules", "R(3^3) R(3^3)", "--granules", "--outputs voxel,t,colour,face"),
    ("cone", "R(3^3) M(2^3)", "", "--detail cone"),
    ("points", "D(4^3,5) G(4)", "", "--query occupancy"),
]

HEADERS = ["shared", "glsl", "essl", "cpp", "cuda", "hlsl", "wgsl"]


def compiled(voxc, arguments):
    return subprocess.run([voxc, "compile", *arguments, "-o", "-"], check=True, capture_output=True, text=True).stdout


def of_format(text):
    lines = text.splitlines(keepends=True)
    begin = next(i for i, line in enumerate(lines) if BEGIN in line)
    end = next(i for i, line in enumerate(lines) if END in line)
    return "".join(lines[begin:end])


def kernels(voxc):
    """File names, and what stands in them."""
    for number, (name, layout, passes, options) in enumerate(FORMATS):
        common, own = [layout, *passes.split()], options.split()
        languages = {f"intersect.{kind}": [f"--emit={kind}", *own] for kind in ("glsl", "cpp")}
        languages |= {f"header.{language}": ["--emit=header", "--language", language] for language in HEADERS}
        for file, arguments in languages.items():
            text = compiled(voxc, [*common, *arguments])
            yield f"{name}/{file}", text if number == 0 else of_format(text)


def main():
    voxc, folder, update = sys.argv[1], pathlib.Path(sys.argv[2]), "--update" in sys.argv
    found = dict(kernels(voxc))
    if update:
        for name, text in found.items():
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return 0
    differ = 0
    stored = {str(path.relative_to(folder)) for path in folder.glob("*/*")}
    for name in sorted(stored | set(found)):
        golden = (folder / name).read_text() if name in stored else ""
        if golden != found.get(name, "") or name not in found:
            differ += 1
            lines = difflib.unified_diff(golden.splitlines(), found.get(name, "").splitlines(), name, "emitted",
                                         lineterm="")
            print("\n".join(list(lines)[:40]))
    print(f"{len(found)} kernels, {differ} differ")
    return 1 if differ else 0


sys.exit(main())
