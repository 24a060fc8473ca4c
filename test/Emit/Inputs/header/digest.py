#!/usr/bin/env python3
"""Which forms of a volume's digest emitted texts define: digest.py STATS TEXT..."""
import json
import re
import sys
from pathlib import Path

digest = int(json.loads(Path(sys.argv[1]).read_text())["storage_digest"], 16)
for path in map(Path, sys.argv[2:]):
    defined = re.findall(r"#define VOXC_DEEP_STORAGE_DIGEST (.*)", path.read_text())
    forms = {f"0x{digest:016x}ull": "whole", f"uvec2(0x{digest & 0xffffffff:08x}u, 0x{digest >> 32:08x}u)": "halves"}
    print(f"{path.name}: {', '.join(forms.get(text, 'wrong ' + text) for text in defined)}")
