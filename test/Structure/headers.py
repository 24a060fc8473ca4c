#!/usr/bin/env python3
"""Holds the list of public headers: headers.py TREE PAGE

PAGE has three sections, "Promised", "Beneath them" and "Of this tree", which name headers of TREE/include as `voxc/Part/Header.h`.
Each header stands in one of them; those that promised ones include, and no others, are beneath. At most MOST are promised.
"""
import re
import sys
from pathlib import Path

MOST = 35
NAME = re.compile(r"`(voxc/[\w/]+\.h)`")
INCLUDE = re.compile(r'^ *# *include *"(voxc/[^"]+)"', re.MULTILINE)


def sections(page):
    parts = re.split(r"^## (.+)$", page, flags=re.MULTILINE)[1:]
    return {title: NAME.findall(text) for title, text in zip(parts[::2], parts[1::2])}


def reached(include, headers):
    """The headers with all that they include."""
    found, waiting = set(headers), list(headers)
    while waiting:
        for header in INCLUDE.findall((include / waiting.pop()).read_text()):
            if header not in found:
                found.add(header)
                waiting.append(header)
    return found


def complaints(include, page):
    listed = sections(page)
    promised, beneath = listed.get("Promised", []), listed.get("Beneath them", [])
    names = [header for headers in listed.values() for header in headers]
    there = {path.relative_to(include).as_posix() for path in (include / "voxc").rglob("*.h")}
    for header in sorted(set(names) - there):
        yield f"{header} is listed, but is no header"
    for header in sorted(there - set(names)):
        yield f"{header} is not listed; say what is promised of it"
    for header in sorted({header for header in names if names.count(header) > 1}):
        yield f"{header} is listed more than once"
    if not 0 < len(promised) <= MOST:
        yield f"{len(promised)} headers are promised; more than {MOST} are more than anybody keeps"
    below = reached(include, [header for header in promised if header in there]) - set(promised)
    for header in sorted(below - set(beneath)):
        yield f"{header} is included by a promised header, and should be listed beneath them"
    for header in sorted(set(beneath) - below):
        yield f"{header} is included by no promised header, and should be listed as one of this tree"


def main(tree, page):
    sys.exit("\n".join(complaints(tree / "include", page.read_text())) or None)


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
