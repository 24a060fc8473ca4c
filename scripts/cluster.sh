#!/usr/bin/env bash
# Builds volumes by plans under a Slurm of its own (scripts/slurm-loopback.sh), with faults on the way, and compares each with
# the volume of one build. Part of ./check --full; takes half a minute without a model.
#
# Usage: scripts/slurm-loopback.sh scripts/cluster.sh BUILD [FORMAT INPUT]
set -euo pipefail

readonly voxc="${1:?usage: scripts/slurm-loopback.sh scripts/cluster.sh BUILD [FORMAT INPUT]}/bin/voxc"
readonly format="${2:-R(3^3) G(6)}" input="${3:-builtin:terrain:512}"
: "${SLURM_LOOPBACK:?run this by scripts/slurm-loopback.sh}"
folder="$(mktemp -d -p "${TMPDIR:-/var/tmp}")"
readonly folder
trap 'rm -rf "$folder"' EXIT

"$voxc" build "$format" "$input" --whole-level-dedup --threads 1 -o "$folder/whole.hvx" --quiet
"$voxc" plan "$format" "$input" --whole-level-dedup --parts 64 -o "$folder/p.plan" --quiet

submit() { "$voxc" submit "$folder/p.plan" --slurm --poll 0.5 --quiet --threads 1 "$@"; }
same() {
  cmp "$folder/whole.hvx" "$folder/p.hvx"
  echo "cluster: $1: the same bytes"
  rm -rf "$folder/p.plan.d" "$folder/p.hvx"
}
kill_daemon() { kill -9 "$(cat "$SLURM_LOOPBACK/$1.pid")"; }

submit
same "no fault"

submit --no-wait
sleep 2
kill_daemon node2
submit || submit
same "a node daemon killed"
slurmd -N node2

submit --no-wait
sleep 1
kill_daemon controller
sleep 1
slurmctld
submit
same "the controller killed and started again"

submit --no-wait
scontrol update NodeName=node1 State=DRAIN Reason=test
submit
scontrol update NodeName=node1 State=RESUME
same "a node drained"

submit --no-wait
sleep 1
scancel --state=RUNNING --signal=KILL --full --user="$(id -un)" || true
submit || submit
same "tasks killed"
