#!/bin/sh
# Traces every cell of the packs that lie beside this one, in turn, and writes results/CELL.ROUND.json beside them,
# and CELL.hits, the hits of a sample of its rays, which are checked when the results are taken in:
#   sh pack-NNN/run.sh [VOXC_TRACE [ROUNDS [REPEATS]]]     VOXC_TRACE may have options: "./voxc-trace --device NVIDIA"
# All packs must be there. Run again, it goes on where it was ended. `voxc bench import` takes the results in.
set -eu
trace=${1:-voxc-trace} rounds=${2:-3} repeats=${3:-20}
# A program by its path is one of the folder that this was started in.
program=${trace%% *}
case $program in
*/*) trace=$(cd "$(dirname "$program")" && pwd)/$(basename "$program")${trace#"$program"} ;;
esac
cd "$(dirname "$0")/.."
mkdir -p joined results

# Joins the pieces of a volume, once.
join() {
  if [ ! -e "joined/$1" ]; then
    cat pack-*/"$1".[0-9]* >"joined/$1.part"
    mv "joined/$1.part" "joined/$1"
  fi
}

# The options that say which rays: of a camera file, of the camera that sees everything, or of a file.
rays() {
  case $1 in
  camera) echo "--camera joined/rays-$2.json:camera --size $3 -o joined/picture.png" ;;
  overview) echo "--size $3 -o joined/picture.png" ;;
  file) echo "--rays joined/rays-$2.bin -o joined/hits.bin" ;;
  esac
}

round=1 failed=0
while [ "$round" -le "$rounds" ]; do
  while read -r cell volume kernel kind digest size sample order; do
    result=results/$cell.$round.json
    if [ -e "$result" ]; then continue; fi
    join "$volume.hvx"
    join "$kernel.spv"
    case $kind in
    camera) join "rays-$digest.json" ;;
    file) join "rays-$digest.bin" ;;
    esac
    # shellcheck disable=SC2086 # Options are words.
    if [ ! -e "results/$cell.hits" ]; then
      join "$sample"
      $trace "joined/$volume.hvx" --trusted --kernel "joined/$kernel.spv" --rays "joined/$sample" --count --quiet \
        -o "results/$cell.hits" </dev/null || {
        echo "the sample of $cell failed" >&2
        failed=$((failed + 1))
      }
    fi
    # shellcheck disable=SC2046,SC2086 # Options are words.
    if $trace "joined/$volume.hvx" --trusted --kernel "joined/$kernel.spv" $(rays "$kind" "$digest" "$size") \
      --order "$order" --repeat "$repeats" --quiet --stats "$result.part" </dev/null; then
      mv "$result.part" "$result"
      echo "round $round: $cell"
    else
      echo "round $round: $cell failed" >&2
      failed=$((failed + 1))
    fi
  done <<CELLS
$(cat pack-*/cells.txt)
CELLS
  round=$((round + 1))
done
[ "$failed" -eq 0 ] || exit 1
