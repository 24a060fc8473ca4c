#!/usr/bin/env python3
"""Says what the functions of a program ask of a processor: instructions.py PROGRAM VARIANT...

A function belongs to the variant whose name stands behind the last dot of its own, as in "trace.x86_64_v3", or else to the
others. A line for each of these: the widest registers that they use, and whether an encoding that came with AVX is among them.
Then a line for each call or jump from anywhere into a variant that the function does not belong to.
"""
import re
import subprocess
import sys

FUNCTION = re.compile(r"^[0-9a-f]+ <(.+)>:$")
INSTRUCTION = re.compile(r"^ +[0-9a-f]+:\t(?P<name>\S+) *(?P<operands>.*)$")
TARGET = re.compile(r"^[0-9a-f]+ <([^+>]+)")
WIDTHS = ("no vectors", "xmm", "ymm", "zmm")


def main(program, *variants):
    def group_of(function):
        return next((variant for variant in variants if function.endswith("." + variant)), "others")

    widths, with_avx, strays = {}, set(), set()
    listing = subprocess.run(["objdump", "-d", "--no-show-raw-insn", program], check=True, capture_output=True, text=True).stdout
    for line in listing.splitlines():
        if match := FUNCTION.match(line):
            function = match[1]
            group = group_of(function)
        if not (match := INSTRUCTION.match(line)):
            continue
        width = max(i for i, name in enumerate(WIDTHS) if i == 0 or name in match["operands"])
        widths[group] = max(widths.get(group, 0), width)
        if match["name"].startswith("v"):
            with_avx.add(group)
        if (target := TARGET.match(match["operands"])) and group_of(target[1]) not in (group, "others"):
            strays.add(f"{function} goes to {target[1]}")
    for group in sorted(widths):
        print(f"{group}: {WIDTHS[widths[group]]}{', AVX' if group in with_avx else ''}")
    for stray in sorted(strays):
        print(stray)


if __name__ == "__main__":
    main(*sys.argv[1:])
