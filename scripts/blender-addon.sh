#!/usr/bin/env bash
# Makes the zip file of the add-on for Blender, which Blender's preferences install (docs/blender.md).
#
# Usage: scripts/blender-addon.sh FOLDER
set -euo pipefail
cd "$(dirname "$0")/.."
[ $# -eq 1 ] || { echo "usage: scripts/blender-addon.sh FOLDER" >&2; exit 1; }
mkdir -p "$1"
version=$(sed -n 's/^#define VOXC_VERSION_\(MAJOR\|MINOR\|PATCH\) \([0-9]*\).*/\2/p' include/voxc/Support/Version.h | paste -sd.)
readonly file=$(realpath "$1")/voxc_blender-$version.zip
# One moment for all files, so that the same sources make the same bytes.
python3 - integrations/blender/voxc_blender "$file" <<'PYTHON'
import pathlib
import sys
import zipfile

folder = pathlib.Path(sys.argv[1])
with zipfile.ZipFile(sys.argv[2], "w", zipfile.ZIP_DEFLATED) as archive:
    for path in sorted(folder.glob("*.py")) + [pathlib.Path("LICENSE")]:
        member = zipfile.ZipInfo(f"{folder.name}/{path.name}", (2026, 1, 1, 0, 0, 0))
        member.compress_type, member.external_attr = zipfile.ZIP_DEFLATED, 0o644 << 16
        archive.writestr(member, path.read_bytes())
PYTHON
echo "$file"
