"""Runs the parts of a campaign, each for its share of the time, and writes build/campaign/report.md.

campaign.py HOURS    from the repository's root, with build/release and build/fuzz built
"""
import json
import os
import random
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

import faults
import signals

FOLDER = Path("build/campaign")
VOXC = Path("build/release/bin/voxc").resolve()
HARD_RAYS = Path("build/release/bin/voxc-hard-rays").resolve()
SEED = int(os.environ.get("VOXC_SEED") or time.time())
FUZZ_SECONDS_LEAST = 5

# Unit tests of random damage, by their program; VOXC_TEST_FACTOR makes them longer.
HOSTILE_TESTS = {"Volume": "Hostile*", "Construct": "Hostile*", "Pipeline": "Hostile*", "Layout": "*"}


def fuzz(seconds):
    """Every fuzzer for an equal share. A finding is a file in build/fuzz/findings."""
    targets = sorted(p.name for p in Path("fuzz/seeds").iterdir())
    each = max(int(seconds / len(targets)), FUZZ_SECONDS_LEAST)
    for target in targets:
        run = subprocess.run(["scripts/fuzz.sh", str(each), target], capture_output=True, text=True, errors="replace")
        executions = re.search(r"stat::number_of_executed_units: *(\d+)", run.stdout)
        yield f"fuzz {target}", int(executions[1]) if executions else 0, finding(run, f"scripts/fuzz.sh {each} {target}")


def hard_rays(seconds):
    """Random formats, scenes and rays against the oracle, on both devices."""
    for i, device in enumerate(["cpu", "llvmpipe"]):
        command = [HARD_RAYS, "--random", "12", "--device", device, "--seconds", str(max(int(seconds / 2), 1)),
                   "--rays", "200000", "--seed", str(SEED + i), "--quiet", "--stats", FOLDER / "rays.json"]
        run = subprocess.run([str(word) for word in command], capture_output=True, text=True,
                             env={**os.environ, "MESA_SHADER_CACHE_DISABLE": "true"})
        rays = json.loads((FOLDER / "rays.json").read_text())["error"]["rays"] if run.returncode == 0 else 0
        yield f"hard rays, {device}", rays, finding(run, " ".join(map(str, command)))


def hostile_tests(seconds):
    """The unit tests of damaged volumes, fragments and pages, again and again and longer."""
    end = time.monotonic() + seconds
    for part, tests in HOSTILE_TESTS.items():
        run = subprocess.run([f"build/release/bin/voxc-test-{part}", f"--gtest_filter={tests}", "--gtest_brief=1"],
                             capture_output=True, text=True,
                             env={**os.environ, "VOXC_TEST_FACTOR": str(max(int(seconds / 60), 1))})
        yield f"hostile tests, {part}", 1, finding(run, f"voxc-test-{part} --gtest_filter={tests}")
        if time.monotonic() > end:
            return


def fault_cases(seconds):
    """Cases of faults.py in turn until the time is over."""
    folder = FOLDER / "faults"
    bench = faults.Bench(VOXC, folder, random.Random(SEED))
    end = time.monotonic() + seconds
    counts, found = {}, {}
    while True:
        for case in faults.CASES:
            name = case.__doc__.split(".")[0]
            problem = case(bench)
            counts[name] = counts.get(name, 0) + (problem != faults.NOT_HERE)
            if problem and problem != faults.NOT_HERE:
                found.setdefault(name, problem)
            if time.monotonic() > end and len(counts) == len(faults.CASES):
                shutil.rmtree(folder, ignore_errors=True)
                for name in counts:
                    yield name, counts[name], found.get(name)
                return


def signal_cases(seconds):
    """Moments of signals.py until the time is over."""
    folder = FOLDER / "signals"
    bench = signals.Bench(VOXC, folder, random.Random(SEED), list(signals.WRITERS))
    end = time.monotonic() + seconds
    counts, found = dict.fromkeys(signals.FAULTS, 0), {}
    while time.monotonic() < end or not all(counts.values()):
        for fault in signals.FAULTS:
            counts[fault] += 1
            problem, _ = signals.moment_of(bench, fault, list(signals.WRITERS))
            if problem:
                found.setdefault(fault, problem)
    shutil.rmtree(folder, ignore_errors=True)
    for fault in counts:
        yield fault, counts[fault], found.get(fault)


def finding(run, command):
    """What a run that failed said last, or nothing."""
    if run.returncode == 0:
        return None
    lines = (run.stderr + run.stdout).strip().splitlines()
    return f"`{command}` ended with {run.returncode}: {' / '.join(lines[-3:])}"


# Each part and its share of the time.
PARTS = [(fuzz, 0.4), (hard_rays, 0.2), (fault_cases, 0.15), (signal_cases, 0.15), (hostile_tests, 0.1)]


def main(hours):
    FOLDER.mkdir(parents=True, exist_ok=True)
    rows, problems = [], []
    for part, share in PARTS:
        begin = time.monotonic()
        for name, cases, problem in part(hours * 3600 * share):
            now = time.monotonic()
            rows.append(f"| {name} | {cases} | {now - begin:.0f} | {'see below' if problem else 'none'} |")
            print(f"{name}: {cases} cases, {problem or 'nothing found'}", flush=True)
            if problem:
                problems.append(f"- **{name}**: {problem}")
            begin = now
    text = (f"# A campaign of {hours} hours\n\nSeed {SEED}, {os.cpu_count()} processors.\n\n"
            "| Part | Cases | Seconds | Findings |\n|---|---|---|---|\n" + "\n".join(rows) + "\n")
    if problems:
        text += "\n## Findings\n\n" + "\n".join(problems) + "\n"
    (FOLDER / "report.md").write_text(text)
    print(f"{FOLDER}/report.md: {len(problems)} findings")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(float(sys.argv[1])))
