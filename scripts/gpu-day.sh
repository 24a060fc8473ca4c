#!/bin/sh
# A day with a GPU, prepared: what it measures and checks, and how, stands in docs/gpu.md.
#   scripts/gpu-day.sh pack FILE.tar.xz [OPTION...]          here: makes the pack (scripts/gpu-day/pack.sh)
#   scripts/gpu-day.sh run FILE.tar.xz OUT [SECONDS [DEVICE]]  there: measures; run again, it goes on
set -eu
here=$(cd "$(dirname "$0")" && pwd)
case ${1:-}:$# in
pack:[2-9] | pack:[1-9][0-9]) shift; exec bash "$here/gpu-day/pack.sh" "$@" ;;
run:[3-5])
  file=$2 out=$3
  shift 3
  if [ ! -e "$out/gpu-day" ]; then # Whole, or not there.
    mkdir -p "$out/unpacking"
    tar -xJf "$file" -C "$out/unpacking"
    mv "$out/unpacking/gpu-day" "$out"
  fi
  exec sh "$out/gpu-day/run.sh" "$out" "$@"
  ;;
*) echo "usage: $0 pack FILE [OPTION...] | run FILE OUT [SECONDS [DEVICE]]" >&2; exit 2 ;;
esac
