#!/usr/bin/env bash
# The default pictures of docs/pictures.md, made anew.
#   scripts/pictures.sh VOXC MODELS OUT
# MODELS is a folder with the models of the table below, by these names.
set -euo pipefail
readonly voxc="$1" models="$2" out="$3"
mkdir -p "$out"

# The picture, the model, and the format that it is built in.
readonly table='
sponza      sponza/sponza.obj             R(4,4,4)G(5)
san-miguel  san_miguel.glb                G(9)
buddha      buddha_100k.ply               G(9)
bunny       bunny.ply                     G(9)
hairball    hairball_standin_small.ply    G(9)
spot        spot/spot.obj                 G(9)
monu10      vox/monu10.vox                G(8)
dragon      vox/dragon.vox                G(8)
bonsai      volumes/bonsai.nii.gz         G(8)
points      tabletop_points.ply           G(9)
'
while read -r name model format; do
  [ -n "$name" ] || continue
  "$voxc" run "$format" "$models/$model" --size 480x270 --device cpu -o "$out/$name.jpg"
done <<< "$table"
