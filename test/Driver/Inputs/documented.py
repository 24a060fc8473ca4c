"""Runs every voxc command that a page shows as shell for small inputs: documented.py VOXC FOLDER PAGE [--every-kind]

Without --every-kind, inputs are one of each class of options.

The model of the page is replaced by the input, and what only makes it large by less: formats hold 32 voxels a side, pictures are small,
searches short. `voxc view` needs a display (test/View). Pictures must show something, and parts must join to the bytes of one build.
"""
import re
import shlex
import shutil
import subprocess
import sys
import zlib
from pathlib import Path

from kinds import inputs

voxc, folder, page, every_kind = sys.argv[1], Path(sys.argv[2]).resolve(), sys.argv[3], "--every-kind" in sys.argv[4:]

# Whatever the page calls a model that it reads.
MODEL = re.compile(r"(sponza|armadillo|model)\.(obj|ply)|(monu10|monu3|scene)\.vox")
SMALLER = [(r"\bG\((5|7|8)\)(?=.*R\()|(?<=\) )G\((5|7|8)\)", "G(1)"), (r"\b([GS])\((7|9)\)", r"\1(5)"), (r"D\(5\^3, 15\)", "D(1^3, 15)"),
           (r"R\(1\^3\) M\(2\^3\) M\(2\^3\) M\(2\^3\)", "R(1^3) M(2^3) M(2^3)")]
VALUES = {"--rays": "2000", "--parts": "2", "--local": "2", "--budget": "10s", "--random": "1"}
# Kinds whose voxels are made, and not their own.
RESOLVED = (".obj", ".ply")
# An input of each class of options, and a volume.
CLASSES = ("box.obj", "ball.vox", "ball.nii.gz", "ball.hvx")
# Measuring takes its time.
MEASURED = {"search": CLASSES, "bench": CLASSES, "accuracy": CLASSES[:1]}
SIZED = ("render", "run", "search", "bench")
ON_CPU = ("render", "run", "search", "verify", "accuracy", "suggest")


def commands():
    blocks = re.findall(r"^```sh\n(.*?)^```", Path(page).read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    lines = [line.split(" #")[0].strip() for line in "".join(blocks).splitlines()]
    return [words for words in (shlex.split(line) for line in lines if line.startswith("voxc ")) if words[1] != "view"]


def smaller(word):
    for pattern, less in SMALLER:
        word = re.sub(pattern, less, word) if "(" in word else word
    return word


def is_for(words, name, is_first):
    """Whether a command is to be run for an input. One that names no model and nothing that was made of one is run with the first."""
    read = [word for before, word in zip(words, words[1:]) if before != "-o"]
    if not any(MODEL.fullmatch(word) or re.search(r"\.(hvx|hvf|plan)$", word) for word in read):
        return is_first
    return name in MEASURED.get(words[1], (name,))


def adapted(words, name):
    """The command for an input, as small as it can be."""
    result, skips = [], False
    for before, word in zip([""] + words, words):
        if skips:
            skips = False
        elif word == "--resolution":
            skips = True
            if name.endswith(RESOLVED):
                result += ["--resolution", "32"]
        elif before in VALUES:
            result.append(VALUES[before])
        elif MODEL.fullmatch(word) and before not in ("-o", "--output"):
            result.append(name)
        else:
            result.append(smaller(word))
    result += ["--size", "48x32"] if words[1] in SIZED else []
    result += ["--formats", "few.txt", "--all", "--check", "0"] if words[1] == "search" else []
    result += ["--devices", "cpu"] if words[1] == "bench" else []
    return result + (["--device", "cpu"] if words[1] in ON_CPU else [])


def run(*words, where=None):
    done = subprocess.run([voxc, *map(str, words)], cwd=where or folder, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"in {where or folder}: `{shlex.join(['voxc', *map(str, words)])}` ended with {done.returncode}: {done.stderr}")
    return done.stdout


def shows_something(path):
    data = path.read_bytes()
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        return len(data) > 500  # A JPEG.
    at, packed = 8, b""
    while at < len(data):
        length, kind = int.from_bytes(data[at:at + 4], "big"), data[at + 4:at + 8]
        packed += data[at + 8:at + 8 + length] if kind == b"IDAT" else b""
        at += 12 + length
    return len(set(zlib.decompress(packed))) > 16


def check_fragments(where, name):
    """Of README.md: two fragments, merged, are the bytes of one build."""
    merged = where / "sponza-2048.hvx"
    if not merged.exists():
        return ""
    run("build", smaller("R(4,4,4) G(7)"), name, "--whole-level-dedup", "-o", "one.hvx", "--quiet", where=where)
    if merged.read_bytes() != (where / "one.hvx").read_bytes():
        sys.exit(f"{name}: two fragments are not one build")
    return ", two fragments are one build"


names = [name for name in inputs(folder, run) if every_kind or name in CLASSES]
(folder / "few.txt").write_text("R(4^3) G(1)\nG(5)\n")  # A search through more takes seconds.
for number, name in enumerate(names):
    where = folder / str(number)
    where.mkdir()
    for file in folder.iterdir():
        if file.is_file():
            (where / file.name).symlink_to(file)
    count = 0
    for words in commands():
        if is_for(words, name, number == 0):
            run(*adapted(words, name)[1:], where=where)
            count += 1
    for picture in [*where.glob("*.png"), *where.glob("*.jpg")]:
        if not picture.is_symlink() and not shows_something(picture):  # Slices of an input may be empty.
            sys.exit(f"{name}: {picture.name} shows nothing")
    print(f"{name}: {count} commands{check_fragments(where, name)}")
    shutil.rmtree(where)
