#!/usr/bin/env bash
# Makes a wheel: `pip install` of it brings `import voxc` and the program voxc to every CPython from 3.9 on, on Linux with glibc 2.28 or
# later, with everything but NumPy inside.
#
# Usage: scripts/wheel.sh FOLDER [--architecture amd64|arm64] [BUILD]
# BUILD (default: build/release) is built as far as is needed (scripts/portable.sh); for arm64 (by default in build/aarch64) by a cross
# compiler, so that this machine need not be one. Ends with an error where the wheel would ask for more of a system, or takes more than 90 MB.
cd "$(dirname "$0")/.."
source scripts/lib.sh
readonly usage="usage: scripts/wheel.sh FOLDER [--architecture amd64|arm64] [BUILD]"
[ $# -ge 1 ] || fail "$usage"
readonly folder=$1
shift
preset=release
if [ "${1:-}" = --architecture ]; then
  case ${2:-} in
  amd64) ;;
  arm64) preset=aarch64 ;;
  *) fail "$usage" ;;
  esac
  shift 2
fi
readonly preset build=${1:-build/$preset}
readonly most_bytes=90000000

scripts/portable.sh "$build" "$preset"
python3 -B scripts/portable/needs.py "$build"/portable/bin/voxc "$build"/portable/lib/lib*.so.[0-9]
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$build/CMakeCache.txt")
moment=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}
contents=$(mktemp -d)
trap 'rm -rf "$contents"' EXIT
python3 -B scripts/portable/contents.py "$build" "$contents" "$version" "$moment"
mkdir -p "$folder"
python3 -B scripts/portable/wheel.py . "$build" "$contents" "$folder" "$version" "$moment"
for wheel in "$folder"/voxc-"$version"-*.whl; do
  [ "$(stat -c %s "$wheel")" -le $most_bytes ] || fail "$wheel has more than 90 MB"
done
