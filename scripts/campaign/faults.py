"""Faults of files, disks and processes, as cases of a campaign.

A case starts a command that writes over an earlier file and disturbs it. Afterwards the file must be the earlier one or
whole, nothing may lie beside it, and a command that failed must have said why. A case returns what is wrong, or None.
"""
import errno
import os
import shutil
import signal
import subprocess
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


class Bench:
    """A folder to work in, with volumes and fragments to begin with."""

    def __init__(self, voxc, folder, random):
        self.voxc, self.random = str(voxc), random
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

    def command(self, target=None):
        """A command that writes the target: a build, a merge or an export."""
        target = str(target or self.target)
        kind = self.random.randrange(3)
        if kind == 0:
            more = self.random.choice([[], ["--compress"], ["--memory", "16MiB"], ["--threads", "1"]])
            return [self.voxc, "build", self.random.choice(FORMATS), SCENE, "-o", target, "--quiet", *more]
        if kind == 1:
            return [self.voxc, "merge", *map(str, self.fragments), "-o", target, "--quiet"]
        return [self.voxc, "export", str(self.volume), "-o", target, "--quiet", "--compress"]

    def begin(self):
        self.target.write_bytes(EARLIER)

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
        if self.target.read_bytes() == EARLIER:
            return said + "succeeded and wrote nothing" if code == 0 else None
        whole = subprocess.run([self.voxc, "info", self.target, "--quiet"], capture_output=True, text=True)
        return None if whole.returncode == 0 else said + f"left half a file: {whole.stderr}"


def killed(bench):
    """Killed at a random moment. kill -9 of a build, a merge or an export."""
    bench.begin()
    command = bench.command()
    process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    time.sleep(bench.random.random() ** 2 * 2)
    process.kill()
    return bench.judge(command, process.wait(), process.stderr.read(), KILLED)


def interrupted(bench):
    """Interrupted at a random moment. Heard within a second, and a bit for a busy machine."""
    bench.begin()
    command = bench.command()
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
    bench.begin()
    call = bench.random.choice(list(CALLS))
    outcome = bench.random.choice([*CALLS[call], "kill", "slow"])
    plan = f"{call}:{bench.random.choice([1, 1, 2, 3, 5, 10, 30])}:{outcome}"
    command = bench.command()
    environment = {**os.environ, "LD_PRELOAD": str(bench.shim), "VOXC_FAULT": plan}
    run = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=600)
    allowed = KILLED if outcome == "kill" else TOLD
    problem = bench.judge(command, run.returncode, run.stderr, allowed)
    return f"VOXC_FAULT={plan}: {problem}" if problem else None


def small_files(bench):
    """A limit on the size of files."""
    bench.begin()
    command = bench.command()
    limit = bench.random.choice([1, 4, 64, 512])
    run = subprocess.run(["bash", "-c", f'ulimit -f {limit}; exec "$@"', "-", *command], capture_output=True, text=True)
    return bench.judge(command, run.returncode, run.stderr, TOLD)


def vanished_input(bench):
    """An input that vanishes or is cut short meanwhile."""
    bench.begin()
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
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=256k", "none", disk], capture_output=True).returncode != 0:
        return NOT_HERE
    try:
        target = disk / "v.hvx"
        target.write_bytes(EARLIER)
        command = bench.command(target)
        run = subprocess.run(command, capture_output=True, text=True)
        if run.returncode != 3 or "error:" not in run.stderr:
            return f"`{' '.join(command)}` ended with {run.returncode} on a full disk: {run.stderr[-200:]}"
        left = sorted(p.name for p in disk.iterdir())
        return None if left == ["v.hvx"] and target.read_bytes() == EARLIER else f"`{' '.join(command)}` left {left}"
    finally:
        subprocess.run(["umount", disk])


def closed_folder(bench):
    """A folder that cannot be written to."""
    if os.geteuid() == 0:
        return NOT_HERE  # Nothing is closed to root.
    bench.begin()
    command = bench.command()
    bench.out.chmod(0o500)
    try:
        run = subprocess.run(command, capture_output=True, text=True)
    finally:
        bench.out.chmod(0o700)
    return bench.judge(command, run.returncode, run.stderr, (3,))


def killed_sweep(bench):
    """A killed sweep goes on. voxc bench after kill -9: every record is whole, and the next run ends well."""
    folder = bench.folder / "sweep"
    shutil.rmtree(folder, ignore_errors=True)
    command = [bench.voxc, "bench", "builtin:terrain:64", "--formats", "R(2^3) G(4);G(6);S(6)", "--devices", "cpu",
               "--size", "64x48", "--repeat", "1", "-o", str(folder), "--quiet"]
    process = subprocess.Popen(command, stderr=subprocess.DEVNULL)
    time.sleep(bench.random.random() * 4)
    process.kill()
    process.wait()
    run = subprocess.run(command, capture_output=True, text=True)
    return None if run.returncode == 0 else f"`{' '.join(command)}` after a kill: {run.stderr[-300:]}"


CASES = [killed, interrupted, failing_calls, small_files, vanished_input, full_disk, closed_folder, killed_sweep]
