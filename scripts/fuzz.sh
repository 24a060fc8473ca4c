#!/usr/bin/env bash
# fuzz.sh SECONDS [TARGET...]: builds the fuzzers and runs each of them, or those that are named, for that long, one on each core,
# from fuzz/seeds, the corpus of the unit tests, and what earlier runs have found in build/fuzz/corpus. Ends at the first finding,
# which it keeps in build/fuzz/findings.
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

mkdir -p build/fuzz/findings

# Ends with 255, after which xargs starts no other, when the fuzzer finds something.
fuzz() {
  local target=$1 corpus=build/fuzz/corpus/$1 seeds=("fuzz/seeds/$1") said status=0
  if [ -d "unittests/Mesh/Corpus/$target" ]; then
    seeds+=("unittests/Mesh/Corpus/$target")
  fi
  mkdir -p "$corpus"
  said=$(nice "build/fuzz/bin/voxc-fuzz-$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=4096 -max_len=65536 \
    -print_final_stats=1 -verbosity=0 -artifact_prefix="build/fuzz/findings/$target-" "$corpus" "${seeds[@]}" 2>&1) || status=255
  say "Fuzzed $target for $seconds s"
  printf '%s\n' "$said"
  return $status
}
export -f fuzz say
export seconds

printf '%s\n' "${targets[@]}" | xargs -P "$(nproc)" -I{} bash -c 'fuzz {}'
