"""Faults of files, disks and processes, as cases of a campaign.

A case starts a command that writes over an earlier file and disturbs it. Afterwards the file must be the earlier one or
whole, nothing may lie beside it, and a command that failed must have said why. A case returns what is wrong, or None.

faults.py VOXC MOMENTS [CASE...]    so many moments of each case, or of those that are named
"""
import errno
import os
import random
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

NOT_HERE = "cannot be tried here"
EARLIER = b"earlier\n"
SCENE = "builtin:terrain:256"
FORMATS = ["R(2^3) G(6)", "D(4^3,6) S(4)", "G(8)", "S(8)"]
CALLS = {"pwrite": [errno.ENOSPC, errno.EIO, errno.EFBIG], "fdatasync": [errno.ENOSPC, errno.EIO],
         "linkat": [errno.ENOSPC, errno.EACCES], "rename": [errno.EIO], "mmap": [errno.EIO, errno.ENOMEM],
         "pthread_create": [errno.EAGAIN]}
# Exit codes of commands that failed in good order; docs/command-line.md.
TOLD = (0, 1, 2, 3, 130)
# 0 and these are what a kill may end with.
KILLED = (0, -signal.SIGKILL)


def build_words(bench, target):
    more = bench.random.choice([[], ["--compress"], ["--memory", "16MiB"], ["--threads", "1"]])
    return ["build", bench.random.choice(FORMATS), SCENE, "-o", target, *more]


def page_words(bench, _):
    """Pages of a volume that is compressed anew."""
    return ["--compress", "--page-bytes", bench.random.choice(["4KiB", "64KiB", "1MiB"])]


EDITS = ["--clear", "0,0,0,90,90,90", "--fill", "100,100,100,140,160,130=ff8000"]
# Each a command that writes the target, of the words that follow `voxc`; docs/command-line.md.
COMMANDS = {
    "build": build_words,
    "merge": lambda bench, target: ["merge", *map(str, bench.fragments), "-o", target],
    "export": lambda bench, target: ["export", str(bench.volume), "-o", target, "--compress"],
    "pages": lambda bench, target: ["export", str(bench.volume), "-o", target, *page_words(bench, target)],
    "edit": lambda bench, target: ["edit", str(bench.volume), "-o", target, *EDITS],
    "attach": lambda bench, target: ["attach", str(bench.volume), "--normals", "-o", target],
    "edit in place": lambda bench, target: ["edit", target, "-o", target, *EDITS],
    "attach in place": lambda bench, target: ["attach", target, "--normals", "-o", target, "--compress"],
}


class Bench:
    """A folder to work in, with volumes and fragments to begin with. `only` names commands; else all are tried."""

    def __init__(self, voxc, folder, random, only=None):
        self.voxc, self.random, self.only = str(voxc), random, list(only or COMMANDS)
        shutil.rmtree(folder, ignore_errors=True)
        self.out = (folder / "out").resolve()
        self.out.mkdir(parents=True)
        self.folder = folder.resolve()
        self.target = self.out / "v.hvx"
        self.volume = self.folder / "sound.hvx"
        self.fragments = [self.folder / f"{i}.hvf" for i in range(3)]
        self.build(self.volume)
        for i, path in enumerate(self.fragments):
            self.build(path, "--fragment", f"{i}/3")
        self.shim = self.folder / "fault.so"
        compiled = subprocess.run([os.environ.get("CXX", "c++"), "-shared", "-fPIC", "-o", self.shim,
                                   "test/Faults/Inputs/fault.cpp", "-ldl"])
        if compiled.returncode != 0:
            self.shim = None

    def build(self, path, *more):
        subprocess.run([self.voxc, "build", FORMATS[0], SCENE, "-o", path, "--quiet", *more], check=True)

    def begin(self, kinds=None, target=None):
        """A command that writes the target, where an earlier file lies."""
        target = target or self.target
        kind = self.random.choice(kinds or self.only)
        self.earlier = self.volume.read_bytes() if "in place" in kind else EARLIER
        target.write_bytes(self.earlier)
        return [self.voxc, *COMMANDS[kind](self, str(target)), "--quiet"]

    def judge(self, command, code, words, allowed):
        """What is wrong after a command, or None."""
        said = f"`{' '.join(command)}` "
        if code not in allowed:
            return said + f"ended with {code}: {words[-200:]}"
        if code not in (0, -signal.SIGKILL) and "error:" not in words:
            return said + f"ended with {code} and did not say why"
        beside = [p.name for p in self.out.iterdir() if p != self.target]
        # A kill may fall between the two calls that give the name; the next command clears that up.
        beside = [name for name in beside if not (code == -signal.SIGKILL and name.endswith(".voxc-new"))]
        if beside:
            return said + f"left {beside}"
        if self.target.read_bytes() == self.earlier:
            return said + "succeeded and wrote nothing" if code == 0 else None
        # An export reads all of a volume; `voxc info` would read its head alone.
        whole = subprocess.run([self.voxc, "export", self.target, "-o", self.folder / "again.hvx", "--quiet"],
                               capture_output=True, text=True)
        return None if whole.returncode == 0 else said + f"left half a file: {whole.stderr}"


def killed(bench):
    """Killed at a random moment. kill -9 of what writes a volume."""
    command = bench.begin()
    process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    time.sleep(bench.random.random() ** 2 * 2)
    process.kill()
    return bench.judge(command, process.wait(), process.stderr.read(), KILLED)


def interrupted(bench):
    """Interrupted at a random moment. Heard within a second, and a bit for a busy machine."""
    command = bench.begin()
    process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    time.sleep(0.1 + bench.random.random())
    process.send_signal(signal.SIGINT)
    begin = time.monotonic()
    words = process.communicate()[1]
    if time.monotonic() - begin > 3:
        return f"`{' '.join(command)}` did not hear an interrupt for {time.monotonic() - begin:.1f} s"
    # Before the handler stands, a signal does what it always does.
    return None if process.returncode == -signal.SIGINT else bench.judge(command, process.returncode, words, TOLD)


def failing_calls(bench):
    """Failing system calls. Of one kind, from a random one on, with an error that it may have."""
    if not bench.shim:
        return NOT_HERE
    call = bench.random.choice(list(CALLS))
    outcome = bench.random.choice([*CALLS[call], "kill", "slow"])
    plan = f"{call}:{bench.random.choice([1, 1, 2, 3, 5, 10, 30])}:{outcome}"
    command = bench.begin()
    environment = {**os.environ, "LD_PRELOAD": str(bench.shim), "VOXC_FAULT": plan}
    run = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=600)
    allowed = KILLED if outcome == "kill" else TOLD
    problem = bench.judge(command, run.returncode, run.stderr, allowed)
    return f"VOXC_FAULT={plan}: {problem}" if problem else None


def small_files(bench):
    """A limit on the size of files."""
    command = bench.begin()
    limit = bench.random.choice([1, 4, 64, 512])
    run = subprocess.run(["bash", "-c", f'ulimit -f {limit}; exec "$@"', "-", *command], capture_output=True, text=True)
    return bench.judge(command, run.returncode, run.stderr, TOLD)


def vanished_input(bench):
    """An input that vanishes or is cut short meanwhile."""
    bench.begin(["merge"])
    copies = [bench.folder / f"copy{i}.hvf" for i in range(3)]
    for path, copy in zip(bench.fragments, copies):
        shutil.copy(path, copy)
    command = [bench.voxc, "merge", *map(str, copies), "-o", str(bench.target), "--quiet"]
    process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    time.sleep(bench.random.random() * 0.3)
    for copy in copies:
        os.truncate(copy, 1000) if bench.random.random() < 0.5 else copy.unlink()
    words = process.communicate()[1]
    return bench.judge(command, process.returncode, words, TOLD)


def full_disk(bench):
    """A full disk. A small file system in memory, where one may be mounted."""
    disk = bench.folder / "disk"
    disk.mkdir(exist_ok=True)
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "none", disk], capture_output=True).returncode != 0:
        return NOT_HERE
    try:
        target = disk / "v.hvx"
        command = bench.begin([kind for kind in bench.only if "in place" not in kind] or list(COMMANDS)[:1], target)
        run = subprocess.run(command, capture_output=True, text=True)
        if run.returncode != 3 or "error:" not in run.stderr:
            return f"`{' '.join(command)}` ended with {run.returncode} on a full disk: {run.stderr[-200:]}"
        left = sorted(p.name for p in disk.iterdir())
        return None if left == ["v.hvx"] and target.read_bytes() == bench.earlier else f"`{' '.join(command)}` left {left}"
    finally:
        subprocess.run(["umount", disk])


def closed_folder(bench):
    """A folder that cannot be written to."""
    if os.geteuid() == 0:
        return NOT_HERE  # Nothing is closed to root.
    command = bench.begin()
    bench.out.chmod(0o500)
    try:
        run = subprocess.run(command, capture_output=True, text=True)
    finally:
        bench.out.chmod(0o700)
    return bench.judge(command, run.returncode, run.stderr, (3,))


def disturbed(bench, command):
    """Runs a command and kills it and its tasks at a random moment, or takes its room away; what is wrong, or None."""
    seconds = bench.random.random() * 4
    if bench.random.random() < 0.3:
        limit = str(bench.random.choice([0, 1, 8, 64]))
        run = subprocess.run(["bash", "-c", 'ulimit -f "$0"; exec "$@"', limit, *command], capture_output=True, text=True)
        return None if run.returncode in TOLD else f"`{' '.join(command)}` in files of {limit} KiB: {run.returncode}"
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
    time.sleep(seconds)
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass  # It was done.
    process.wait()
    return None


def goes_on(bench, command, folder, last=()):
    """What is wrong with a command that is disturbed up to three times and then left alone, with words of its own, or None."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    for _ in range(bench.random.choice([1, 1, 2, 3])):
        if problem := disturbed(bench, command):
            return problem
    run = subprocess.run([*command, *last], capture_output=True, text=True)
    return None if run.returncode == 0 else f"`{' '.join([*command, *last])}` after a kill: {run.stderr[-300:]}"


def killed_sweep(bench):
    """A disturbed sweep goes on. voxc bench after kill -9 or without room: every record is whole, and the next run ends well. Cells that
    had no room have failed, and are tried again where that is asked for."""
    folder = bench.folder / "sweep"
    return goes_on(bench, [bench.voxc, "bench", "builtin:terrain:64", "--formats", "R(2^3) G(4);G(6);S(6)", "--devices", "cpu",
                           "--size", "64x48", "--repeat", "1", "-o", str(folder), "--quiet"], folder, ["--retry"])


def killed_search(bench):
    """A disturbed search goes on."""
    folder, formats = bench.folder / "search", bench.folder / "formats.txt"
    formats.write_text("R(2^3) G(4)\nG(6)\nR(3^3) R(3^3)\n")
    return goes_on(bench, [bench.voxc, "search", "builtin:terrain:64", "--resolution", "64", "--budget", "4s", "--formats",
                           str(formats), "--check", "0", "--size", "64x48", "--device", "cpu", "-o", str(folder), "--quiet"],
                   folder)


def killed_plan(bench):
    """A disturbed build plan goes on. voxc submit --local, and the volume is that of a build in one go."""
    folder, plan = bench.folder / "plan", bench.folder / "v.plan"
    volume = folder / "v.hvx"
    cut = [bench.voxc, "plan", FORMATS[0], SCENE, "--parts", "5", "--fan-in", "2", "--volume", str(volume), "-o", str(plan), "--quiet"]
    shutil.rmtree(bench.folder / "v.plan.d", ignore_errors=True)
    subprocess.run(cut, check=True)
    if problem := goes_on(bench, [bench.voxc, "submit", str(plan), "--local", "2", "--quiet"], folder):
        return problem
    return None if volume.read_bytes() == bench.volume.read_bytes() else f"`{' '.join(cut)}` made another volume"


CASES = [killed, interrupted, failing_calls, small_files, vanished_input, full_disk, closed_folder, killed_sweep,
         killed_search, killed_plan]


def main(voxc, moments, names):
    """So many moments of the cases of these names, or of all; 1 if anything was found."""
    folder = Path("build/campaign/faults")
    bench = Bench(Path(voxc).resolve(), folder, random.Random(int(os.environ.get("VOXC_SEED") or time.time())))
    found = 0
    for case in CASES:
        if names and case.__name__ not in names:
            continue
        problems = [case(bench) for _ in range(moments)]
        tried = [problem for problem in problems if problem != NOT_HERE]
        found += sum(problem is not None for problem in tried)
        print(f"{case.__name__}: {len(tried)} moments", *filter(None, tried), sep="\n  ", flush=True)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], int(sys.argv[2]), sys.argv[3:]))
