#!/usr/bin/env python3
"""Builds one scene in many formats through the command line: every export must equal the input's, byte for byte, and
every kernel must agree with the oracle but for float rounding at cell boundaries, whose count is printed.

  sweep.py VOXC INPUT --formats FILE        the formats of a list (label<TAB>format)
  sweep.py VOXC INPUT --random 50 --log2 6  random compositions, 2^6 voxels an axis; --seed to repeat a run
"""
import argparse
import hashlib
import json
import random
import subprocess
import sys
import tempfile
from pathlib import Path


def random_level(rng, side):
    kind = rng.choice("RDSG")
    if kind in "SG":
        return f"{kind}({side})"
    return f"R({side}^3)" if kind == "R" else f"D({side}^3, {rng.randint(1, 12)})"


def random_format(rng, log2):
    levels = []
    while log2 > 0 or not levels:
        side = rng.randint(0, log2) if len(levels) < 3 else log2
        levels.append(random_level(rng, side))
        log2 -= side
    return " ".join(levels)


def digest(path):
    with open(path, "rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest() if sys.version_info >= (3, 11) else \
            hashlib.sha256(file.read()).hexdigest()


def run(*command):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"failed: {' '.join(map(str, command))}\n{done.stdout}{done.stderr}")


def sweep_format(voxc, source, form, passes, rays, folder):
    volume, raw, stats = folder / "v.hvx", folder / "v.raw", folder / "v.json"
    run(voxc, "build", form, source, *passes, "-o", volume, "--quiet")
    run(voxc, "export", volume, "-o", raw, "--quiet")
    traversal = [option for option in passes if option.endswith("-sv")]
    run(voxc, "verify", volume, *traversal, "--rays", rays, "--stats", stats, "--quiet")
    return digest(raw), json.loads(stats.read_text())["error"], volume.stat().st_size


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("voxc")
    parser.add_argument("input")
    parser.add_argument("--formats")
    parser.add_argument("--random", type=int, default=0)
    parser.add_argument("--log2", type=int, default=6)
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randint(1, 10**6))
    parser.add_argument("--rays", type=int, default=100000)
    options = parser.parse_args()

    rng = random.Random(options.seed)
    formats = [random_format(rng, options.log2) for _ in range(options.random)]
    if options.formats:
        formats += [line.split("\t")[-1] for line in Path(options.formats).read_text().splitlines() if line]
    print(f"{len(formats)} formats, seed {options.seed}")
    passes = [["--whole-level-dedup"], ["--whole-level-dedup", "--restart-sv"], ["--restart-sv"],
              ["--unroll-sv"], []]
    expected = None
    total = 0
    with tempfile.TemporaryDirectory() as name:
        for i, form in enumerate(formats):
            used = passes[i % len(passes)] if options.random else passes[0]
            found, error, size = sweep_format(options.voxc, options.input, form, used, options.rays, Path(name))
            expected = expected or found
            wrong = error["missed"] + error["ghost"] + error["wrong"]
            total += wrong
            print(f"{form:45} {size:12} bytes, {wrong} of {options.rays} rays wrong by rounding, {' '.join(used)}",
                  flush=True)
            if found != expected:
                sys.exit(f"{form}: its export differs from the first format's")
    print(f"all {len(formats)} exports are equal; {total} of {len(formats) * options.rays} rays are wrong by rounding")
    if options.input.startswith("grid:") and digest(options.input.split(":", 2)[2]) != expected:
        sys.exit("the exports differ from the input grid")


if __name__ == "__main__":
    main()
