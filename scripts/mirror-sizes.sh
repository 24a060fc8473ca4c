#!/bin/sh
# mirror-sizes.sh VOXC RESOLUTION INPUT...: how many bytes shape alone takes in G(n), and with nodes shared that are
# equal but for a reflection, as rows of a Markdown table.
set -eu
voxc=$1 resolution=$2
shift 2
log2=0
while [ $((1 << log2)) -lt "$resolution" ]; do log2=$((log2 + 1)); done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

words() { # words INPUT PASS...: those of the volume.
  input=$1
  shift
  "$voxc" build "G($log2)" "$input" --resolution "$resolution" --occupancy "$@" -o "$work/v.hvx" --quiet --stats - |
    sed -n 's/^ *"words": \([0-9]*\),*$/\1/p' | head -n 1
}

echo "| Input, $resolution^3 | \`G($log2)\`, bytes | with \`--mirror\` | of it |"
echo "|---|---|---|---|"
for input in "$@"; do
  plain=$(words "$input")
  mirrored=$(words "$input" --mirror)
  echo "| $(basename "$input") | $((4 * plain)) | $((4 * mirrored)) | $(awk "BEGIN { printf \"%.2f\", $mirrored / $plain }") |"
done
