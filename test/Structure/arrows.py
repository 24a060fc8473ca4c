#!/usr/bin/env python3
"""Holds the includes between parts to a list: arrows.py TREE LIST

A part is a folder of TREE/lib and TREE/include/voxc. LIST has a line "Part -> Part Part" for each: the parts whose headers
it includes. They stand above it, so that parts go in no circle. A line "Part/Header.h => other/header.h" lets that public header
include that one. Everything else in LIST is prose.
"""
import re
import sys
from pathlib import Path

LINE = re.compile(r"^([\w-]+) *->(.*)$", re.MULTILINE)
EXCEPTION = re.compile(r"^(\S+) *=> *(\S+)$", re.MULTILINE)
INCLUDE = re.compile(r'^ *# *include *([<"])([^>"]+)[>"]', re.MULTILINE)
STANDARD_HEADER = re.compile(r"[a-z_]+")
# Vectors and matrices that callers may hand over.
MATHEMATICS_HEADER = re.compile(r"glm/[a-z0-9]+\.hpp")


def read_list(path):
    return {part: others.split() for part, others in LINE.findall(path.read_text())}


def read_exceptions(path):
    return set(EXCEPTION.findall(path.read_text()))


def includes(root):
    """Every include below a folder of parts: part, file, '<' or '"', header. Headers beside the folders include parts for those
    who want all of them."""
    for path in sorted(root.glob("*/**/*")):
        if path.suffix in (".h", ".cpp"):
            part = path.relative_to(root).parts[0]
            for mark, header in INCLUDE.findall(path.read_text()):
                yield part, path, mark, header


def part_of(header):
    """The part that a header in quotes belongs to; None if it names no folder, as those of the same folder do."""
    folders = header.removeprefix("voxc/").split("/")[:-1]
    return folders[0] if folders else None


def circles(allowed):
    above = set()
    for part, others in allowed.items():
        for other in others:
            if other not in above:
                yield f"{part} -> {other}: {other} does not stand above {part}; parts must not go in a circle"
        above.add(part)


def strays(found, allowed):
    for part, path, mark, header in found:
        other = part_of(header) if mark == '"' else None
        if other not in (None, part, *allowed.get(part, [])):
            yield f"{path}: {part} must not include {header}; the list has no {part} -> {other}"


def leftovers(found, allowed):
    used = {(part, part_of(header)) for part, _, mark, header in found if mark == '"'}
    for part, others in allowed.items():
        for other in others:
            if (part, other) not in used:
                yield f"{part} -> {other}: nothing in {part} includes {other}; strike it from the list"


def strangers(found, allowed):
    parts = {part for part, *_ in found}
    for part in sorted(parts - allowed.keys()):
        yield f"{part}: the list has no line for this part"
    for part in sorted(allowed.keys() - parts):
        yield f"{part}: the list has a line for it, but there is no such part"


def leaks(found, exceptions):
    """What would make those who include a public header look for more than voxc's public headers."""
    for _, path, mark, header in found:
        is_public = header.startswith("voxc/") if mark == '"' else STANDARD_HEADER.fullmatch(header) or MATHEMATICS_HEADER.fullmatch(header)
        is_exception = ("/".join(path.parts[-2:]), header) in exceptions
        if not is_public and not is_exception:
            yield f"{path}: a public header must not include {header}, which is neither public nor of the standard library nor of GLM"


def main():
    tree, allowed = Path(sys.argv[1]), read_list(Path(sys.argv[2]))
    public = list(includes(tree / "include/voxc"))
    exceptions = read_exceptions(Path(sys.argv[2]))
    found = public + list(includes(tree / "lib"))
    wrong = [*strangers(found, allowed), *circles(allowed), *strays(found, allowed), *leftovers(found, allowed), *leaks(public, exceptions)]
    sys.exit("\n".join(wrong) or None)


if __name__ == "__main__":
    main()
