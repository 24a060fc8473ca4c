#!/usr/bin/env python3
"""Holds pages to limits: docs.py TREE LIST

Lines of prose have less than 120 columns; tables, code and pictures may have more. Each page of docs begins by saying who it is for.
LIST has a line "PAGE | N" for each page of at most N lines, and "Not yet: PAGE ..." for those that are looked at later. Everything
else in LIST is prose.
"""
import re
import sys
from pathlib import Path

COLUMNS = 119
ROW = re.compile(r"^(\S+\.md) +\| +(\d+)$", re.MULTILINE)
NOT_YET = re.compile(r"^Not yet:(.*)$", re.MULTILINE)
# In tables, pictures and alone in its line, as addresses are.
MAY_BE_LONG = re.compile(r"\s*(\||!\[|<)|\s*\S+$")


def pages(tree):
    return sorted([*tree.glob("docs/*.md"), *(tree / name for name in ("README.md", "HACKING.md", "SECURITY.md"))])


def prose(text):
    """Numbered lines outside of code."""
    is_code = False
    for number, line in enumerate(text.split("\n"), 1):
        if re.match(r"\s*```", line):
            is_code = not is_code
        elif not is_code:
            yield number, line


def first_paragraph(text):
    return next((part for part in text.split("\n\n") if part.strip() and not part.startswith("#")), "")


def complaints(tree, limits, not_yet):
    for path in pages(tree):
        name, text = path.relative_to(tree).as_posix(), path.read_text()
        if name in not_yet:
            continue
        for number, line in prose(text):
            if len(line) > COLUMNS and not MAY_BE_LONG.match(line):
                yield f"{name}:{number}: has {len(line)} columns; at most {COLUMNS} are read with ease"
        lines = text.count("\n")
        if lines > limits.get(name, lines):
            yield f"{name}: has {lines} lines, and may have {limits[name]}; what is not for today goes to docs/notes"
        if name.startswith("docs/") and not first_paragraph(text).startswith("For "):
            yield f"{name}: its first paragraph should begin with whom it is for: 'For ...'"
    for name in limits.keys() - {path.relative_to(tree).as_posix() for path in pages(tree)}:
        yield f"{name}: the list has a limit for it, but there is no such page"


def main(tree, path):
    text = path.read_text()
    limits = {name: int(most) for name, most in ROW.findall(text)}
    not_yet = {name for names in NOT_YET.findall(text) for name in names.split()}
    wrong = [*complaints(tree, limits, not_yet), *([] if limits else ["the list has no limits"])]
    sys.exit("\n".join(wrong) or None)


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
