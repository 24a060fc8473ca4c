#!/usr/bin/env bash
# Builds a mesh by a plan under a Slurm of its own (scripts/slurm-loopback.sh), again and again, and has Slurm end a task at a moment by
# chance: scancel, requeue, preemption by jobs of more priority, suspension, SIGTERM, a drained node. Each part that stands then has the bytes of
# an undisturbed one, and the next voxc submit comes to the volume of one build. Part of ./check --full.
#
# Usage: scripts/slurm-loopback.sh scripts/cluster-moments.sh BUILD MOMENTS
set -euo pipefail

readonly voxc="${1:?usage: scripts/slurm-loopback.sh scripts/cluster-moments.sh BUILD MOMENTS}/bin/voxc" moments="$2"
: "${SLURM_LOOPBACK:?run this by scripts/slurm-loopback.sh}"
folder="$(mktemp -d -p "${TMPDIR:-/var/tmp}")"
readonly folder
readonly plan="$folder/p.plan"
trap 'rm -rf "$folder"' EXIT
RANDOM="${VOXC_SEED:-$$}"

fail() { echo "cluster-moments: $*" >&2; exit 1; }
submit() { "$voxc" submit "$plan" --slurm --poll 0.2 --quiet "$@"; }

PYTHONPATH="$(dirname "$0")/campaign" python3 -B -c 'import sys, pathlib, writers; writers.write_shell(pathlib.Path(sys.argv[1]))' "$folder/shell.obj"
"$voxc" build "R(4^3) G(5)" "$folder/shell.obj" --whole-level-dedup --threads 1 -o "$folder/whole.hvx" --quiet
"$voxc" plan "R(4^3) G(5)" "$folder/shell.obj" --whole-level-dedup --parts 6 --fan-in 3 -o "$plan" --quiet
"$voxc" build --plan "$plan" --task 0-5 --quiet
mv "$plan.d" "$folder/undisturbed"

# The job of a task that runs, once one does; empty if they have ended before.
running() {
  local end=$((SECONDS + 30)) job
  until job="$(squeue --noheader --states=R --format=%i | shuf -n 1)" && [ -n "$job" ] || [ -z "$(squeue --noheader)" ]; do
    [ $SECONDS -lt $end ] || fail "no task runs"
    sleep 0.02
  done
  echo "$job"
}

# What Slurm does to a job, by name.
cancel() { scancel "$1"; }
cancel_all() { scancel --user=root; }
requeue() { scontrol requeue "$1"; }
suspend() { scontrol suspend "$1" && sleep 0.3 && scontrol resume "$1"; }
terminate() { scancel --full --signal=TERM "$1"; }
preempt() {
  for _ in 1 2 3; do sbatch --quiet --partition=urgent --output=/dev/null --wrap 'sleep 0.5'; done
}
drain() {
  local node
  node="$(squeue --noheader --jobs="$1" --format=%N)" && [ -n "$node" ] || return 0
  scontrol update NodeName="$node" State=DRAIN Reason=test && scancel "$1"
  sleep 0.2
  scontrol update NodeName="$node" State=RESUME
}
readonly kinds=(cancel cancel_all requeue suspend terminate preempt drain)

parts_are_whole() {
  for part in "$plan.d"/part-*.hvf; do
    [ -e "$part" ] || continue
    cmp "$folder/undisturbed/${part##*/}" "$part" || fail "after $1 a part stands that is not whole"
  done
}

for ((i = 0; i < moments; ++i)); do
  kind="${kinds[i % ${#kinds[@]}]}"
  rm -rf "$plan.d" "$folder/p.hvx"
  submit --no-wait
  job="$(running)"
  sleep "0.$(printf %03d $((RANDOM % 500)))"
  # The job may have ended by now: then nothing is hurt.
  [ -z "$job" ] || "$kind" "$job" &> "$folder/said.txt" || true
  sleep "0.$((RANDOM % 10))"
  parts_are_whole "$kind"
  submit || fail "after $kind the plan was not carried out"
  parts_are_whole "$kind"
  cmp "$folder/whole.hvx" "$folder/p.hvx" || fail "after $kind there is another volume"
done
echo "cluster-moments: $moments moments of ${kinds[*]}: parts that stood were whole, and all volumes the bytes of one build"
