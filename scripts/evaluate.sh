#!/usr/bin/env bash
# The whole evaluation of docs/evaluation: the paper's forty formats on every model, what sharing across a level saves, what
# restarting and unrolling do to speed, and the report. Ended in any way, it goes on where it was when it is given again.
#   scripts/evaluate.sh VOXC OUT FORMATS CAMERAS.json MODEL...
# FORMATS holds paper-512.txt and paper-2048.txt; a MODEL is what voxc bench takes, named after its camera; more options for
# every sweep in BENCH_OPTIONS, for the report in REPORT_OPTIONS.
set -euo pipefail
readonly voxc="$1" out="$2" formats="$3" cameras="$4"
shift 4
mkdir -p "$out"

# The formats of the paper's two studies, by their labels.
with_labels() { cat "$formats"/paper-*.txt | awk -F '\t' -v labels=" $* " 'index(labels, " " $1 " ")'; }
with_labels 11 13 14 15 23 29 30 31 > "$out/sharing.txt"
with_labels 16 18 19 20 23 29 39 40 > "$out/walks.txt"

# Cells that fail, such as those that are too large, are part of the evaluation: then the exit code is 1.
sweep() {
  # shellcheck disable=SC2086 # Options are words.
  "$voxc" bench "${models[@]}" --cameras "$cameras" -o "$out" ${BENCH_OPTIONS:-} "$@" || [ $? = 1 ]
}
readonly models=("$@")
sweep --formats "$formats/paper-512.txt" --formats "$formats/paper-2048.txt" --passes whole-level-dedup
sweep --formats "$out/sharing.txt" --passes none
# All walks in turn, so a walk that was measured above is measured again.
if [ ! -e "$out/walks.done" ]; then
  sweep --formats "$out/walks.txt" --passes whole-level-dedup --passes whole-level-dedup,restart-sv \
    --passes whole-level-dedup,unroll-sv --again
  touch "$out/walks.done"
fi
# shellcheck disable=SC2086
"$voxc" bench report "$out" -o "$out/report.html" ${REPORT_OPTIONS:-}
