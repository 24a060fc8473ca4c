#!/usr/bin/env bash
# Builds volumes by plans under a Slurm of its own (scripts/slurm-loopback.sh) and hurts it on the way: each time one voxc submit
# must finish with the bytes of one build, and no part that stood may have been built again. At the end a sweep is measured in
# shares, of which one is killed: it must come to the cells of one process. Part of ./check --full; takes about four minutes without
# a model, most of them waits for Slurm.
#
# Usage: scripts/slurm-loopback.sh scripts/cluster.sh BUILD [FORMAT INPUT]
set -euo pipefail

readonly voxc="${1:?usage: scripts/slurm-loopback.sh scripts/cluster.sh BUILD [FORMAT INPUT]}/bin/voxc"
readonly format="${2:-R(4^3) G(6)}" input="${3:-builtin:terrain:1024}"
: "${SLURM_LOOPBACK:?run this by scripts/slurm-loopback.sh}"
folder="$(mktemp -d -p "${TMPDIR:-/var/tmp}")"
readonly folder
readonly plan="$folder/p.plan"
trap 'rm -rf "$folder"' EXIT

fail() { echo "cluster: $*" >&2; exit 1; }
submit() { "$voxc" submit "$plan" --slurm --poll 0.5 --quiet "$@"; }

# Hands the plan over. With it begins each case.
begin() {
  rm -rf "$plan.d" "$folder/p.hvx"
  submit --no-wait "$@"
}

parts_stand() { [ "$(find "$plan.d" -name 'part-*.hvf' | wc -l)" -ge 4 ]; }

# Waits until four parts stand and a task (build or merge) runs, and stops it: a process that does not end before it has been hurt. Sets `task`, its
# process, and `node`, the number of its node.
catch() {
  local end=$((SECONDS + 60))
  node=
  # A task that ends just then has no environment any more: the next one is waited for.
  until [ -n "$node" ]; do
    [ $SECONDS -lt $end ] || fail "no $1 task ran"
    if parts_stand && task="$(pgrep -o -f -- " $1 --plan $plan")" && kill -STOP "$task" 2> /dev/null; then
      node="$(tr '\0' '\n' 2> /dev/null < "/proc/$task/environ" | sed -n 's/^SLURMD_NODENAME=node//p')" || node=
    fi
  done 2> /dev/null
}

# The parts that stand now, by their inodes.
note_parts() { find "$plan.d" -name 'part-*.hvf' -printf '%i %f\n' | sort > "$folder/stood.txt"; }

finish() {
  local name="$1"
  shift
  submit "$@"
  cmp "$folder/whole.hvx" "$folder/p.hvx"
  find "$plan.d" -name 'part-*.hvf' -printf '%i %f\n' | sort > "$folder/now.txt"
  [ -z "$(comm -23 "$folder/stood.txt" "$folder/now.txt")" ] || fail "$name: parts that stood were built again"
  echo "cluster: $name: the same bytes, and $(wc -l < "$folder/stood.txt") parts that stood were kept"
}

node_is_idle() { [ "$(sinfo --noheader --partition=long --nodes="node$1" --format=%T)" = idle ]; }
node_is_drained() { sinfo --noheader --partition=long --nodes="node$1" --format=%T | grep -q drain; }
await_node() {
  local end=$((SECONDS + 60))
  until node_is_idle "$1"; do
    [ $SECONDS -lt $end ] || fail "node$1 does not come back"
    sleep 0.2
  done
}

"$voxc" build "$format" "$input" --whole-level-dedup --threads 1 -o "$folder/whole.hvx" --quiet
"$voxc" plan "$format" "$input" --whole-level-dedup --parts 24 --fan-in 8 -o "$plan" --quiet

begin
note_parts
finish "no fault"

begin
catch build
note_parts
kill -9 "$task"
finish "a task killed"

begin
catch merge
note_parts
kill -9 "$task"
finish "a merge killed"

# With the node go the step and the task that it runs.
begin
catch build
note_parts
kill -9 "$(cat "$SLURM_LOOPBACK/node$node.pid")" "$(ps -o ppid= -p "$task" | tr -d ' ')" "$task"
finish "a node killed"
start_node "$node"
await_node "$node"

# The task ends while there is no controller, which the submit asks in vain. The new controller starts from what the old one had
# saved. It may take jobs for running that have ended, until their nodes register again, and launch some a second time, which drains
# their nodes: whoever looks after the cluster has both put right.
resume_nodes() {
  for node in 1 2 3; do
    node_is_drained "$node" && scontrol update NodeName="node$node" State=RESUME || true
  done
}
begin
catch build
note_parts
(
  sleep 2
  kill -9 "$(cat "$SLURM_LOOPBACK/controller.pid")"
  kill -CONT "$task"
  sleep 4
  start_controller
  while sleep 5; do
    scontrol reconfigure || true
    resume_nodes
  done
) 2> /dev/null &
administrator=$!
finish "the controller killed and started again"
kill "$administrator"
wait "$administrator" || true
resume_nodes
for node in 1 2 3; do await_node "$node"; done

begin
catch build
note_parts
scontrol update NodeName="node$node" State=DRAIN Reason=test
kill -CONT "$task"
finish "a node drained"
scontrol update NodeName="node$node" State=RESUME
await_node "$node"

# Slurm counts limits in minutes. The task stays stopped.
begin --sbatch=--time=1
catch build
note_parts
finish "a task over its time limit"

# Two outputs are hurt between the parts and the merges.
begin
catch build
note_parts
mapfile -t hurt < <(find "$plan.d" -name 'part-*.hvf' | sort | head -n 2)
truncate --size=-100 "${hurt[0]}"
byte="$(od -An -tu1 -j 5000 -N 1 "${hurt[1]}")"
printf "\\x$(printf %x $((byte ^ 16)))" | dd of="${hurt[1]}" bs=1 seek=5000 conv=notrunc status=none
for output in "${hurt[@]}"; do sed -i "/ ${output##*/}\$/d" "$folder/stood.txt"; done
kill -CONT "$task"
finish "an output cut short, and one with a wrong bit"

# A share is killed when it has measured something; what it and the others have measured is kept.
sweep() {
  "$voxc" bench builtin:terrain:128 builtin:shell:64 --formats 'R(2^3) G(5);G(7);R(4^3) G(3);S(7)' --devices cpu --threads 1 --size 320x180 --repeat 40 \
    --check 100 --quiet "$@"
}
cells() { grep -ho '"cell":"[0-9a-f]*"' "$folder/$1"/*.jsonl | sort; }
share_runs() { share="$(pgrep -o -f -- "$folder/shared .*--share")" && ls "$folder"/shared/share-*.jsonl &> /dev/null; }
sweep -o "$folder/alone" > /dev/null
sweep -o "$folder/shared" --slurm --shares 4 --poll 0.5 --no-wait
end=$((SECONDS + 60))
until share_runs; do [ $SECONDS -lt $end ] || fail "no share ran"; done
kill -9 "$share"
sweep -o "$folder/shared" --slurm --shares 4 --poll 0.5 > /dev/null
[ "$(cells alone)" = "$(cells shared)" ] || fail "a sweep in shares has other cells than one of one process"
[ "$(find "$folder/shared" -name '*.jsonl' | wc -l)" = 1 ] || fail "records of shares are left"
echo "cluster: a sweep in shares, one of them killed: the $(cells shared | wc -l) cells of one process"

# The last merge of a grid does not fit into its memory, and the first node has no room for the rest.
readonly scratch="$SLURM_LOOPBACK/scratch"
if nsenter --mount --target "$(cat "$SLURM_LOOPBACK/node1.pid")" mountpoint --quiet "$scratch" 2> /dev/null; then
  nsenter --mount --target "$(cat "$SLURM_LOOPBACK/node1.pid")" dd if=/dev/zero of="$scratch/full" bs=1M status=none 2> /dev/null || true
  rm -rf "$plan" "$plan.d" "$folder/p.hvx"
  "$voxc" build "D(8^3,6)" builtin:shell:256 -o "$folder/whole.hvx" --quiet
  "$voxc" plan "D(8^3,6)" builtin:shell:256 --parts 9 --fan-in 8 -o "$plan" --quiet
  begin --memory 16MiB --scratch "$scratch"
  note_parts
  finish "a full scratch on one node" --memory 16MiB --scratch "$scratch"
  grep -q 'No space left on device' "$plan.d"/job-*.log || fail "no task came upon the full scratch"
else
  echo "cluster: no mount namespaces on this machine: a full scratch on one node is not tried"
fi
