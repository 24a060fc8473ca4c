#!/bin/sh
# A day with a GPU, prepared: what it measures and checks, and how, stands in docs/gpu.md.
#   scripts/gpu-day.sh pack FILE.tar.xz [OPTION...]          here: makes the pack (scripts/gpu-day/pack.sh)
#   scripts/gpu-day.sh run FILE.tar.xz OUT [SECONDS [DEVICE]]  there: measures; run again, it goes on
set -eu
here=$(cd "$(dirname "$0")" && pwd)
case ${1:-} in
pack) shift; exec bash "$here/gpu-day/pack.sh" "$@" ;;
run)
  mkdir -p "$3"
  [ -e "$3/gpu-day/run.sh" ] || tar -xJf "$2" -C "$3"
  out=$3
  shift 3
  exec sh "$out/gpu-day/run.sh" "$out" "$@"
  ;;
*) echo "usage: $0 pack FILE [OPTION...] | run FILE OUT [SECONDS [DEVICE]]" >&2; exit 2 ;;
esac
