#!/usr/bin/env python3
"""Finds classes that two headers define by one name: names.py TREE

The linker takes either one's inline functions for both. Looks at definitions that begin a line, in their namespace.
"""
import re
import sys
from pathlib import Path

LINE = re.compile(r"^(?:namespace ([\w:]+) \{|(?:class|struct|enum class) (\w+)(?: final)?(?: : [^;]*)? \{)", re.MULTILINE)


def definitions(text):
    namespace = ""
    for match in LINE.finditer(text):
        if match[1]:
            namespace = match[1]
        else:
            yield f"{namespace}::{match[2]}"


def main(tree):
    headers = {}
    for folder in ("include", "lib", "tools", "apps"):
        for path in sorted((Path(tree) / folder).rglob("*.h")):
            for name in definitions(path.read_text()):
                headers.setdefault(name, []).append(str(path.relative_to(tree)))
    several = {name: files for name, files in headers.items() if len(files) > 1}
    for name, files in several.items():
        print(f"{name} is defined by {' and '.join(files)}")
    return 1 if several or not headers else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
