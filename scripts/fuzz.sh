#!/usr/bin/env bash
# fuzz.sh SECONDS [TARGET...]: builds the fuzzers and runs each of them, or those that are named, for that long, from
# fuzz/seeds, the corpus of the unit tests, and what earlier runs have found in build/fuzz/corpus. Ends at the first finding, which it keeps there.
cd "$(dirname "$0")/.."
source scripts/lib.sh

[ $# -ge 1 ] || fail "usage: scripts/fuzz.sh SECONDS [TARGET...]"
seconds=$1
shift
build fuzz
targets=("$@")
if [ $# -eq 0 ]; then
  targets=($(ls fuzz/seeds))
fi

# Many fuzzers write a file and read it: in memory 20 times as often as on a disk.
if [ -z "${TMPDIR:-}" ] && [ -w /dev/shm ]; then
  export TMPDIR=/dev/shm
fi

for target in "${targets[@]}"; do
  say "Fuzzing $target for $seconds s"
  corpus=build/fuzz/corpus/$target
  seeds=("fuzz/seeds/$target")
  if [ -d "unittests/Mesh/Corpus/$target" ]; then
    seeds+=("unittests/Mesh/Corpus/$target")
  fi
  mkdir -p "$corpus" build/fuzz/findings
  nice "build/fuzz/bin/voxc-fuzz-$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=4096 -max_len=65536 \
    -print_final_stats=1 -verbosity=0 -artifact_prefix="build/fuzz/findings/$target-" "$corpus" "${seeds[@]}"
done
