#!/usr/bin/env bash
# campaign.sh HOURS: hostile input and faults for so long (0.1 is a look): every fuzzer, hard rays over random formats, the
# hostile unit tests, and faults of files, disks and processes. Writes build/campaign/report.md; fails if anything is found.
# VOXC_SEED makes another campaign.
cd "$(dirname "$0")/.."
source scripts/lib.sh

[ $# -eq 1 ] || fail "usage: scripts/campaign.sh HOURS"
build release
build fuzz
exec python3 -B scripts/campaign/campaign.py "$1"
