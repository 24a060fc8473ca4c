#!/usr/bin/env python3
"""Tells what a kernel costs where no GPU is at hand, and prints the table of docs/notes/2026-11-23-devices.md.

  kernel-costs.py VOXC EVERY VOLUME.hvx... -- RAYS...      volumes as voxc build wrote them; every EVERY-th ray of each file
  kernel-costs.py KERNEL.spv...                            the first columns alone, of any compute shader

Of the SPIR-V, with all functions in one, variables in SSA form and dead code gone (spirv-opt -O; of voxc's, that which the first
dispatch runs, without exact arithmetic): instructions in all and in loops, loads from buffers in loops, the most 32-bit values
that are alive at one point, and bytes of arrays that each ray has. Of the rays, on the mean: look-ups, words, and
different cache lines of 64 bytes.
Needs spirv-opt, spirv-dis and c++.
"""
import re
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
# The specialization constants of include/voxc/Trace/Kernel.h: nothing is counted, what is left is left to others, and no ray comes from far away.
FIRST_DISPATCH = ["--set-spec-const-default-value=0:false 2:false 3:false 6:false"]
PASSES = ["--freeze-spec-const", "--fold-spec-const-op-composite", "--merge-return", "--inline-entry-points-exhaustive", "--eliminate-dead-functions", "-O"]
# What is no work of its own.
FREE = {"OpLabel", "OpPhi", "OpLoopMerge", "OpSelectionMerge", "OpVariable", "OpFunction", "OpFunctionEnd", "OpLine", "OpNoLine"}
LINE = re.compile(r"^\s*(?:(%\w+) = )?(Op\w+)(.*)$")


def run(*command):
    return subprocess.run([str(part) for part in command], check=True, capture_output=True, text=True).stdout


class Module:
    """The one function of an optimised module: blocks of (result, name, operands), and what types take."""

    def __init__(self, text):
        self.types, self.sizes, self.blocks, self.constants = {}, {}, {}, {}
        self.in_buffers, self.buffer_pointers = set(), set()
        self.private_bytes = 0
        block = None
        for line in text.splitlines():
            match = LINE.match(line.split(";")[0])
            if not match:
                continue
            result, name, operands = match[1], match[2], match[3].split()
            if name.startswith("OpType"):
                self.add_type(result, name, operands)
            elif name == "OpConstant":
                self.constants[result] = operands[1]
            elif name == "OpLabel":
                block = self.blocks.setdefault(result, [])
            elif name == "OpFunctionEnd":
                block = None
            elif block is not None:
                block.append((result, name, operands))
                if operands and operands[0] in self.in_buffers:
                    self.buffer_pointers.add(result)
                if name == "OpVariable":
                    self.private_bytes += 4 * self.sizes[self.types[operands[0]]]

    def add_type(self, result, name, operands):
        """How many 32-bit values one of the type takes; a truth value is one, too."""
        size = {"OpTypeBool": lambda: 1, "OpTypeInt": lambda: int(operands[0]) // 32, "OpTypeFloat": lambda: int(operands[0]) // 32,
                "OpTypeVector": lambda: self.sizes[operands[0]] * int(operands[1]),
                "OpTypeArray": lambda: self.sizes[operands[0]] * int(self.constants[operands[1]]),
                "OpTypeStruct": lambda: sum(self.sizes.get(member, 0) for member in operands)}.get(name, lambda: 0)()
        self.sizes[result] = size
        if name == "OpTypePointer":
            self.types[result] = operands[1]
            self.in_buffers |= {result} if operands[0] in ("StorageBuffer", "PhysicalStorageBuffer", "Uniform") else set()

    def successors(self, label):
        name, operands = self.blocks[label][-1][1:]
        return [o for o in operands if o in self.blocks] if name in ("OpBranch", "OpBranchConditional", "OpSwitch") else []

    def in_loops(self):
        """The blocks of all loops: what is reached from a loop's head without passing its merge block."""
        inside = set()
        for head, instructions in self.blocks.items():
            merges = [operands[0] for _, name, operands in instructions if name == "OpLoopMerge"]
            reached, waiting = set(merges), [head] if merges else []
            while waiting:
                label = waiting.pop()
                if label not in reached:
                    reached.add(label)
                    waiting += self.successors(label)
            inside |= reached - set(merges)
        return inside

    def count(self, labels):
        return sum(name not in FREE for label in labels for _, name, _ in self.blocks[label])

    def loads(self, labels):
        return sum(name == "OpLoad" and operands[1] in self.buffer_pointers
                   for label in labels for _, name, operands in self.blocks[label])

    def most_alive(self):
        """By the standard equations: what a block needs goes back along its edges until nothing changes."""
        sizes = {result: self.sizes.get(operands[0], 0) for instructions in self.blocks.values()
                 for result, name, operands in instructions if result and name != "OpVariable"}
        alive_in = {label: set() for label in self.blocks}
        most, changed = 0, True
        while changed:
            changed, most = False, 0
            for label in reversed(self.blocks):
                alive = set()
                for after in self.successors(label):
                    alive |= alive_in[after]
                    for result, name, operands in self.blocks[after]:
                        if name != "OpPhi":
                            break
                        pairs = zip(operands[1::2], operands[2::2])
                        alive |= {value for value, source in pairs if source == label and value in sizes}
                for result, name, operands in reversed(self.blocks[label]):
                    most = max(most, sum(sizes[value] for value in alive))
                    alive.discard(result)
                    if name != "OpPhi":
                        alive |= {o for o in operands if o in sizes}
                if alive != alive_in[label]:
                    alive_in[label], changed = alive, True
        return most


def kernel_costs(spirv, constants, folder):
    run("spirv-opt", *constants, *PASSES, spirv, "-o", folder / "optimised.spv")
    module = Module(run("spirv-dis", "--raw-id", folder / "optimised.spv"))
    loops = module.in_loops()
    return [module.count(module.blocks), module.count(loops), module.loads(loops), module.most_alive(), module.private_bytes]


def format_of(volume):
    """The IR in a volume's head (docs/hvx.md)."""
    with open(volume, "rb") as file:
        head = file.read(1 << 16)
    size, streams = struct.unpack_from("<I4xI", head, 60)
    begin = 168 + 56 * streams
    return head[begin:begin + size]


def ray_costs(voxc, volume, rays, every, folder):
    run(voxc, "compile", folder / "format.vir", "--emit=cpp", "-o", folder, "--quiet")
    interface, kernel = folder / "voxc_interface.h", folder / "intersect.cpp"
    text = interface.read_text()
    asked = re.sub(r"return words\[(.*?)\];", r"return touched(words + (\1));", text)
    if asked == text:
        sys.exit(f"{volume}: its kernel has another load_word than this script knows")
    interface.write_text(asked.replace("#pragma once\n", '#pragma once\n\n#include "touched.h"\n', 1))
    run("c++", "-std=c++20", "-O2", "-w", "-I", HERE, "-I", folder, kernel, HERE / "touched.cpp", "-o", folder / "touched")
    return [run(folder / "touched", volume, file, every).split() for file in rays]


def main():
    arguments = sys.argv[1:]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        if "--" not in arguments:
            for spirv in arguments:
                print("|", Path(spirv).stem, "|", " | ".join(str(n) for n in kernel_costs(spirv, [], folder)), "|", flush=True)
            return
        voxc, every, *volumes = arguments[:arguments.index("--")]
        rays = arguments[arguments.index("--") + 1:]
        for volume in volumes:
            (folder / "format.vir").write_bytes(format_of(volume))
            run(voxc, "compile", folder / "format.vir", "--emit=spirv", "-o", folder, "--quiet")
            columns = kernel_costs(folder / "intersect.spv", FIRST_DISPATCH, folder)
            figures = ray_costs(voxc, volume, rays, every, folder)
            columns += [" / ".join(f"{float(figure[i]):.1f}" for figure in figures) for i in range(3)]
            print("|", Path(volume).stem, "|", " | ".join(str(column) for column in columns), "|", flush=True)


if __name__ == "__main__":
    main()
