#!/usr/bin/env bash
# Makes a wheel: `pip install` of it brings `import voxc` and the program voxc to every CPython from 3.9 on, on Linux with glibc 2.28 or
# later, with everything but NumPy inside.
#
# Usage: scripts/wheel.sh FOLDER [BUILD]
# BUILD (default: build/release) is built as far as is needed (scripts/portable.sh). Ends with an error where the wheel would ask for more
# of a system, or takes more than 90 MB.
set -euo pipefail
cd "$(dirname "$0")/.."
[ $# -ge 1 ] || { echo "usage: scripts/wheel.sh FOLDER [BUILD]" >&2; exit 1; }
readonly folder=$1 build=${2:-build/release}
readonly most_bytes=90000000

scripts/portable.sh "$build"
python3 -B scripts/portable/needs.py "$build"/portable/bin/voxc "$build"/portable/lib/lib*.so.[0-9]
version=$("$build"/portable/bin/voxc --version | cut -d ' ' -f 2)
moment=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}
contents=$(mktemp -d)
trap 'rm -rf "$contents"' EXIT
python3 -B scripts/portable/contents.py "$build" "$contents" "$version" "$moment"
mkdir -p "$folder"
python3 -B scripts/portable/wheel.py . "$build" "$contents" "$folder" "$version" "$moment"
wheel=$(ls "$folder"/voxc-"$version"-*.whl)
[ "$(stat -c %s "$wheel")" -le $most_bytes ] || { echo "$wheel has more than 90 MB" >&2; exit 1; }
