#!/usr/bin/env python3
"""Every value that the C headers name of an option is one that the library takes: values.py HEADERS FOLDER"""
import re
import sys
from pathlib import Path

import numpy as np
import voxc

COMMENT = r"/\*(?:[^*]|\*(?!/))*\*/"
MEMBER = re.compile(rf"({COMMENT})?\s*const char\s*\*(\w+);[ \t]*({COMMENT})?")


def named(header):
    """The values in quotation marks that stand beside each member, or above it where nothing stands beside."""
    values = {}
    for above, name, beside in MEMBER.findall(header.read_text()):
        values.setdefault(name, []).extend(value for value in re.findall(r'"([^"]*)"', beside or above) if value)
    return values


def main():
    headers, folder = map(Path, sys.argv[1:])
    mesh, scan = folder / "mesh.obj", folder / "scan.raw"
    mesh.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
    scan.write_bytes(bytes(range(8)))
    solid = voxc.build("G(3)", voxels=np.ones((8, 8, 8), bool))
    pictures = solid.tracer("cpu")
    takes = {
        "coverage": lambda value: voxc.build("G(3)", mesh, coverage=value),
        "colour_map": lambda value: voxc.build("G(3)", f"raw:2x2x2:uint8:{scan}", colour_map=value),
        "colour": lambda value: voxc.build("G(3)", mesh, colour=value),
        "interior": lambda value: voxc.build("G(3)", mesh, interior=value),
        "style": lambda value: pictures.render(8, 8, style=value),
        "view": lambda value: pictures.render(8, 8, view=value),
        "query": lambda value: solid.tracer("cpu", query=value),
        "outputs": lambda value: solid.tracer("cpu", outputs=value),
        "precision": lambda value: solid.tracer("cpu", precision=value),
        "device": lambda value: solid.tracer(value),
    }
    values = {}
    for header in ("runtime.h", "voxc.h"):
        values.update(named(headers / header))
    for name, take in takes.items():
        assert values.get(name), f"no header names values of {name}"
        for value in values[name]:
            take(value)
        try:
            take("nonsense")
            sys.exit(f"{name} may be nonsense")
        except voxc.Error as error:
            # Where the sentence lists what there is, the header has all of it.
            listed = re.search(r"there are (.*)$", str(error))
            left_out = set(re.split(r", and, for labels, |, | and, for labels, ", listed[1])) - set(values[name]) if listed else set()
            assert not left_out, f"the headers leave out {left_out} of {name}"
        print(name, *values[name])


if __name__ == "__main__":
    main()
