#!/usr/bin/env bash
# Makes the page of the records in docs/evaluation, which a release has beside its packages, and its figures as CSV.
#   scripts/evaluation-report.sh VOXC OUT.html
set -euo pipefail
cd "$(dirname "$0")/../docs/evaluation"
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
# Of a cell that was measured for the study of walks too, that counts. The formats of today are tables of their own.
cp -r results.jsonl walks.jsonl pictures "$folder"
"$1" bench report "$folder" -o "$2" \
  --note 'sponza=Crytek Sponza, 279,163 triangles, the export of 2010 that still has the banner in the middle of the atrium.' \
  --note 'san-miguel=An incomplete San Miguel: 9,430,202 triangles, without tree trunks, ivy, some leaves and large plants; cropped to its courtyard.' \
  --note 'buddha=Happy Buddha, simplified to 100,000 triangles of its 1.09 million.' \
  --note 'hairball=A stand-in for the hairball: 2,889,600 triangles of 1,200 made-up strands; its density has not been compared with the original.'
