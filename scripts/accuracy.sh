#!/usr/bin/env bash
# The measurements of docs/accuracy.md: every volume from its camera, and the series of the first one.
#   scripts/accuracy.sh VOXC OUT CAMERAS.json NAME=VOLUME.hvx...     NAME is that of a camera; more options in ACCURACY_OPTIONS
# OUT/NAME gets the tables, accuracy.json and the plots.
set -euo pipefail
readonly voxc="$1" out="$2" cameras="$3"
shift 3
series=(--series)
for pair in "$@"; do
  name="${pair%%=*}" volume="${pair#*=}"
  mkdir -p "$out/$name"
  # shellcheck disable=SC2086 # Options are words.
  "$voxc" accuracy "$volume" --trusted --camera "$cameras:$name" --size 800x450 --threads 1 --lods 0.5,1,2,4,8 \
    --check 20000 "${series[@]}" -o "$out/$name" ${ACCURACY_OPTIONS:-} | tee "$out/$name/tables.txt"
  series=()
done
