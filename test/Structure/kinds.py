#!/usr/bin/env python3
"""Holds what a kind touches to a list: kinds.py TREE LIST

LIST has a line "what | pattern | file file" for each kind: the files of the program, tests and documents apart, that have the
pattern in their text or their path. Everything else in LIST is prose.
"""
import re
import sys
from pathlib import Path

LINE = re.compile(r"^(\w+) *\| *(\S+) *\| *(.+)$", re.MULTILINE)
FOLDERS = ("include", "lib", "tools", "apps", "shaders-runtime", "construct-runtime", "cpu-runtime")


def files_with(tree, pattern):
    for folder in FOLDERS:
        for path in sorted((tree / folder).rglob("*")):
            if path.is_file() and (pattern.search(path.relative_to(tree).as_posix()) or pattern.search(path.read_text(errors="replace"))):
                yield str(path.relative_to(tree))


def main(tree, listing):
    rows = LINE.findall(Path(listing).read_text())
    failed = not rows
    for what, pattern, allowed in rows:
        found = set(files_with(Path(tree), re.compile(pattern)))
        for file in sorted(found - set(allowed.split())):
            print(f"{file}: speaks of {what} ({pattern}), which is another file's matter")
            failed = True
        for file in sorted(set(allowed.split()) - found):
            print(f"{file}: is listed for {what}, but does not speak of it")
            failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
