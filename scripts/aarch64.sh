#!/usr/bin/env bash
# aarch64.sh [VOXC]: what voxc is on 64-bit Arm processors, which qemu plays: the unit tests of what makes code and runs it, a kernel for
# others to link, and volumes and hits, which must be those that VOXC (default: build/release/bin/voxc) makes here, byte for byte.
#
# Rays go in packets of four, a register of NEON for each value. There is no Vulkan driver in qemu: tests of devices skip themselves, and are
# counted. Words.* of Construct are left to scripts/compilers-words.sh, which compares all 520 of them, and three tests of 17 to 40 minutes to
# a call by hand; they pass. On two cores volumes and hits take 5 minutes, Trace 17 on one, Oracle 6; Construct, which compiles most, longer.
cd "$(dirname "$0")/.."
source scripts/lib.sh

readonly here=${1:-build/release/bin/voxc}
readonly there=build/aarch64 sysroot=build/aarch64-sysroot
readonly out=$there/same
readonly parts=(Emit Jit Trace Construct Oracle)
readonly edge=256 rays=20000
readonly left_out='Words.*:HostileEdit.*:Parts.GiveTheSameBytesInEveryFormat'
# Every kind of level, 2^8 voxels an axis, with what shares and packs.
readonly formats=(
  "R(4,4,4) G(4)|--whole-level-dedup"
  "D(6^3, 15) M(2^3)|"
  "G(8)|--palette"
  "R(2^3) G(2, 2) H(1^3) M(3^3)|"
  "D(2^3, 3) S(6)|--share-grids --octant-distances --df-packing"
)

# Each volume that is built reserves 2^35 bytes of addresses, some tests build several, and qemu keeps a table of every page that was ever
# reserved: within 2^39 bytes it takes the same addresses again, in 3.4 GB a process. 2^37 are too few for Edit.GivesTheWordsOfABuild.
emulated() { qemu-aarch64 -R 0x8000000000 -L "$sysroot" "$@"; }

counted() { # PART RESULT: its tests that ended so.
  awk -v result="$2" '$2 == result && $5 ~ /^tests?[.,]/ { count += $4 } END { print count + 0 }' "$there/$1".*.log
}

test_part() { # PART: a share of its tests on each core.
  local begin=$SECONDS cores share jobs=()
  cores=$(nproc)
  rm -f "$there/$1".*.log
  for ((share = 0; share < cores; share++)); do
    mkdir -p "$out/$share" # Two shares may write files of the same names.
    TMPDIR=$PWD/$out/$share GTEST_TOTAL_SHARDS=$cores GTEST_SHARD_INDEX=$share emulated "$there/bin/voxc-test-$1" --gtest_filter="-$left_out" \
      > "$there/$1.$share.log" 2>&1 &
    jobs+=($!)
  done
  for ((share = 0; share < cores; share++)); do
    wait "${jobs[share]}" || { grep -v -E '^\[ +(OK|RUN)' "$there/$1.$share.log" | tail -40; exit 1; }
  done
  printf '%s: %s passed, %s skipped, %d s\n' "$1" "$(counted "$1" PASSED)" "$(counted "$1" SKIPPED)" $((SECONDS - begin))
}

# The object that others link: for this architecture, with packets, in registers of NEON, and without a name that it asks for.
look_at_kernel() {
  local object=$out/intersect.o vectors
  emulated "$there/bin/voxc" compile "D(6^3, 15) M(2^3)" --emit=cpu -o "$out" --quiet
  aarch64-linux-gnu-gcc -shared -nostdlib -Wl,-z,defs "$object" -o "$out/kernel.so"
  aarch64-linux-gnu-nm "$object" | grep -q trace_packet || fail "$object has no packets"
  vectors=$(llvm-objdump-19 --disassemble "$object" | grep -c -E '\bv[0-9]+\.(16b|8b|8h|4h|4s|2s|2d)\b') || fail "$object uses no vector of NEON"
  printf '%s, %d instructions with vectors of NEON\n' "$(llvm-objdump-19 --file-headers "$object" | sed -n 's/^architecture: //p')" "$vectors"
}

# Builds a volume and traces the rays through it, exactly and fast.
build_and_trace() { # FOLDER FORMAT PASSES VOXC...
  local to=$out/$1 format=$2 passes=$3 precision
  shift 3
  mkdir -p "$to"
  # shellcheck disable=SC2086 # Passes are words.
  "$@" build "$format" builtin:terrain $passes -o "$to/volume.hvx" --quiet
  for precision in exact fast; do
    "$@" trace "$to/volume.hvx" --rays "$out/rays" --device cpu --precision "$precision" -o "$to/$precision" --quiet
  done
}

same_as_here() { # FORMAT PASSES
  local begin=$SECONDS
  rm -rf "$out"/{here,there}
  build_and_trace here "$@" "$here"
  build_and_trace there "$@" emulated "$there/bin/voxc"
  diff -r "$out/here" "$out/there" || fail "'$1' is another volume, or has other hits, on aarch64"
  printf '%s: a volume of %d bytes and two times %d rays, the same; %d s\n' "$1" "$(stat -c %s "$out/there/volume.hvx")" $rays $((SECONDS - begin))
}

build aarch64 voxc "${parts[@]/#/voxc-test-}"
rm -rf "$out"
mkdir -p "$out"
# Files that stay behind, and code that is kept, are those of this run.
export TMPDIR=$PWD/$out VOXC_CACHE=off VOXC_TEST_FACTOR=1
say "A kernel for others"
look_at_kernel
say "Volumes and hits, here and there"
python3 -B scripts/aarch64-rays.py "$out/rays" $edge $rays
for row in "${formats[@]}"; do
  same_as_here "${row%|*}" "${row#*|}"
done
say "Unit tests"
for part in "${parts[@]}"; do
  test_part "$part"
done
