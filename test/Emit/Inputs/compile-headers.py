#!/usr/bin/env python3
"""compile-headers.py FOLDER COMPILER OPTION...: gives each header of a folder, as it stands, to a compiler. Those of entries are left out:
they are for a text that has named its levels."""
import subprocess
import sys
from pathlib import Path

folder, *compiler = sys.argv[1:]
headers = [path for path in sorted(Path(folder).glob("*.h")) if not path.stem.endswith("_entry")]
refused = [path.name for path in headers if subprocess.run([*compiler, "-fsyntax-only", "-include", path, "-x", "c++", "/dev/null"]).returncode != 0]
print(f"{len(headers)} headers, refused: {', '.join(refused) or 'none'}")
sys.exit(bool(refused) or not headers)
