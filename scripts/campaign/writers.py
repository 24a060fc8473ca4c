"""Every command of voxc that writes files, as a table: what it runs, which files it makes, and how these are compared.

A writer's files are whole when they are, byte by byte, those of a run that nothing disturbed. Files with times in them are
compared by what does not depend on time.
"""
import json
import shutil
import struct
import subprocess
from dataclasses import dataclass
from pathlib import Path

FORMAT = "R(2^3) G(6)"
SCENE = "builtin:terrain:256"
# A mesh hears an interrupt in the middle of its cubes, as a built-in scene does not.
MESH_FORMAT, MESH = "R(4^3) G(5)", "shell.obj"
EARLIER = b"earlier\n"


def content(path):
    return path.read_bytes()


def cells(path):
    """Of records of measurements: which cells there are, and what they hit. Of one that failed and was tried again the last counts."""
    records = [json.loads(line) for line in path.read_text().splitlines()]
    return {record["cell"]: json.dumps(record.get("error")) for record in records}


def nothing(path):
    """Of files that hold times alone, or what a budget of seconds came to."""
    path.read_bytes()


@dataclass
class Writer:
    words: list          # Of the command, with {out} for its folder and {in} for that of its inputs.
    files: list          # Patterns of what it writes into its folder.
    compared: object = content
    begins: object = None  # Prepares its folder.
    goes_on: bool = False  # What it leaves after a fault is for the next run to go on with.
    children: bool = False
    set_of_files: bool = False  # Of these the first are missing while it is not whole.


def plan(bench, out):
    """A build plan beside the folder of its outputs."""
    shutil.copy(bench.inputs / "p.plan", out / "p.plan")


def planned_parts(bench, out):
    plan(bench, out)
    shutil.copytree(bench.inputs / "p.plan.d", out / "p.plan.d")


BUILD = ["build", FORMAT, SCENE, "-o", "{out}/v.hvx"]
PICTURE = ["--size", "320x200", "--device", "cpu"]
WRITERS = {
    "build": Writer(BUILD, ["v.hvx"]),
    "build, one thread": Writer([*BUILD, "--threads", "1"], ["v.hvx"]),
    "build, compressed": Writer([*BUILD, "--compress", "--memory", "16MiB"], ["v.hvx"]),
    "build a mesh": Writer(["build", MESH_FORMAT, "{in}/" + MESH, "--whole-level-dedup", "-o", "{out}/v.hvx"], ["v.hvx"]),
    "build a fragment": Writer(["build", MESH_FORMAT, "{in}/" + MESH, "--fragment", "1/3", "-o", "{out}/f.hvf"], ["f.hvf"]),
    "a task": Writer(["build", "--plan", "{out}/p.plan", "--task", "0-4"], ["p.plan.d/part-*.hvf"], begins=plan, goes_on=True),
    "a task, two threads": Writer(["build", "--plan", "{out}/p.plan", "--task", "0-4", "--threads", "2"],
                                  ["p.plan.d/part-*.hvf"], begins=plan, goes_on=True),
    "a merge": Writer(["merge", "--plan", "{out}/p.plan", "--node", "0-2"], ["p.plan.d/merge*.hvf", "p.hvx"],
                      begins=planned_parts, goes_on=True),
    "submit": Writer(["submit", "{out}/p.plan", "--local", "2"], ["p.plan.d/*.hvf", "p.hvx"], begins=plan, goes_on=True,
                     children=True),
    "merge": Writer(["merge", "{in}/0.hvf", "{in}/1.hvf", "{in}/2.hvf", "-o", "{out}/v.hvx"], ["v.hvx"]),
    "split": Writer(["split", "{in}/v.hvx", "--fragment", "0/2", "-o", "{out}/f.hvf"], ["f.hvf"]),
    "edit": Writer(["edit", "{in}/v.hvx", "-o", "{out}/v.hvx", "--clear", "0,0,0,90,90,90"], ["v.hvx"]),
    "attach": Writer(["attach", "{in}/v.hvx", "--normals", "-o", "{out}/v.hvx"], ["v.hvx"]),
    "pages": Writer(["export", "{in}/v.hvx", "-o", "{out}/v.hvx", "--compress", "--page-bytes", "4KiB"], ["v.hvx"]),
    "export .ply": Writer(["export", "{in}/v.hvx", "-o", "{out}/v.ply"], ["v.ply"]),
    "export .raw": Writer(["export", "{in}/v.hvx", "-o", "{out}/v.raw"], ["v.raw"]),
    "export .vox": Writer(["export", "{in}/v.hvx", "-o", "{out}/v.vox", "--lossy"], ["v.vox"]),
    "export .nvdb": Writer(["export", "{in}/v.hvx", "-o", "{out}/v.nvdb"], ["v.nvdb"]),
    "export .glb": Writer(["export", "{in}/v.hvx", "-o", "{out}/v.glb"], ["v.glb"]),
    "export slices": Writer(["export", "{in}/v.hvx", "-o", "{out}/s%d.png"], ["s*.png"], set_of_files=True),
    "export a page": Writer(["export", "{in}/v.hvx", "-o", "{out}/v.html"], ["v.html"]),
    "plan": Writer(["plan", MESH_FORMAT, "{in}/" + MESH, "--parts", "5", "-o", "{out}/p.plan"], ["p.plan"]),
    "render": Writer(["render", "{in}/v.hvx", "-o", "{out}/v.png", *PICTURE], ["v.png"]),
    "run": Writer(["run", FORMAT, "builtin:terrain:64", "-o", "{out}/v.png", *PICTURE], ["v.png"]),
    "trace": Writer(["trace", "{in}/v.hvx", "--rays", "{in}/rays", "-o", "{out}/hits", "--device", "cpu"], ["hits"]),
    "compile": Writer(["compile", FORMAT, "-o", "{out}/k"], ["k/*"]),
    "facts": Writer(["facts", SCENE, "--stats", "{out}/f.json"], ["f.json"], compared=nothing),
    "bench": Writer(["bench", "builtin:terrain:64", "--formats", "R(2^3) G(4);G(6);S(6)", "--devices", "cpu", "--size", "64x48",
                     "--repeat", "1", "-o", "{out}/sweep", "--retry"], ["sweep/*.jsonl"], compared=cells, goes_on=True,
                    children=True),
    "search": Writer(["search", "builtin:terrain:64", "--resolution", "64", "--budget", "60s", "--formats", "{in}/formats.txt",
                      "--check", "0", "--size", "64x48", "--device", "cpu", "-o", "{out}/search"], ["search/*.jsonl"],
                     compared=nothing, goes_on=True, children=True),
}


def make_inputs(voxc, folder):
    """What the writers read: a volume, its fragments, a plan with its parts, rays, formats, a mesh."""
    def run(*words):
        subprocess.run([voxc, *map(str, words), "--quiet"], check=True, stdout=subprocess.DEVNULL)
    run("build", FORMAT, SCENE, "-o", folder / "v.hvx")
    for i in range(3):
        run("build", FORMAT, SCENE, "--fragment", f"{i}/3", "-o", folder / f"{i}.hvf")
    write_shell(folder / MESH)
    run("plan", MESH_FORMAT, folder / MESH, "--parts", "5", "--fan-in", "3", "-o", folder / "p.plan")
    run("build", "--plan", folder / "p.plan", "--task", "0-4")
    (folder / "rays").write_bytes(b"".join(struct.pack("<6f", 300, 300, 300, -1, i % 400 / 400 - 1.2, i // 400 / 500 - 1.2)
                                           for i in range(200000)))
    (folder / "formats.txt").write_text("R(2^3) G(4)\nG(6)\n")


def write_shell(path, rows=150):
    """A bent sheet of 2 * rows^2 triangles."""
    lines = [f"v {x} {(x * 7 + z * 5) % 23 * 0.7 + (x - z) ** 2 * 0.004} {z}" for x in range(rows + 1) for z in range(rows + 1)]
    corner = lambda x, z: x * (rows + 1) + z + 1
    for x in range(rows):
        for z in range(rows):
            a, b, c, d = corner(x, z), corner(x + 1, z), corner(x + 1, z + 1), corner(x, z + 1)
            lines += [f"f {a} {b} {c}", f"f {a} {c} {d}"]
    path.write_text("\n".join(lines) + "\n")
