#!/usr/bin/env python3
"""Holds what the C libraries export to what their headers declare: exports.py HEADERS PREFIX"""
import re
import subprocess
import sys
from pathlib import Path

DECLARED = re.compile(r"VOXC_API[^;]*?\b(voxc_\w+)\(")


def declared(header):
    return set(DECLARED.findall(header.read_text()))


def exported(library):
    lines = subprocess.run(["nm", "--dynamic", "--defined-only", str(library)], check=True, capture_output=True, text=True).stdout
    return {line.split()[-1].split("@")[0] for line in lines.splitlines()}


def main():
    headers, prefix = map(Path, sys.argv[1:])
    runtime = declared(headers / "runtime.h")
    wrong = []
    for name, functions in (("libvoxc-rt.so", runtime), ("libvoxc.so", runtime | declared(headers / "voxc.h"))):
        [library] = prefix.rglob(name)
        found = exported(library)
        wrong += [f"{name} lacks {function}" for function in sorted(functions - found)]
        wrong += [f"{name} exports {symbol}" for symbol in sorted(found - functions)]
    sys.exit("\n".join(wrong) or None)


if __name__ == "__main__":
    main()
