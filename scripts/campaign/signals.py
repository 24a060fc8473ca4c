"""Signals, limits and lost processes, at random moments of every command that writes.

After each moment a file holds what was there before or the whole; then the same command runs undisturbed and must come to the
bytes of a run that nothing disturbed. Files are compared, never exit codes alone.

signals.py VOXC MOMENTS [FOLDER]    writes FOLDER/signals.md and fails if anything is found; VOXC_SEED makes other moments,
                                    VOXC_FAULTS and VOXC_WRITERS name those to try, with ; between
"""
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

from writers import EARLIER, WRITERS, make_inputs

PATIENCE = 60
# Ends in good order; docs/command-line.md.
TOLD = (0, 1, 2, 3, 130)


class Bench:
    """Inputs, and what each writer makes of them when nothing disturbs it."""

    def __init__(self, voxc, folder, dice, names):
        self.voxc, self.folder, self.random = str(voxc), folder.resolve(), dice
        shutil.rmtree(folder, ignore_errors=True)
        self.inputs, self.out = self.folder / "in", self.folder / "out"
        self.inputs.mkdir(parents=True)
        make_inputs(self.voxc, self.inputs)
        self.shim = self.folder / "fault.so"
        subprocess.run([os.environ.get("CXX", "c++"), "-shared", "-fPIC", "-o", self.shim, Path(__file__).parents[2] / "test/Faults/Inputs/fault.cpp", "-ldl"],
                       check=True)
        self.whole, self.seconds = {}, {}
        for name in names:
            writer = WRITERS[name]
            self.begin(writer)
            begin = time.monotonic()
            self.run(writer, check=True)
            self.seconds[name] = time.monotonic() - begin
            self.whole[name] = self.files(writer)
            assert self.whole[name], f"{name} wrote nothing"

    def begin(self, writer):
        shutil.rmtree(self.out, ignore_errors=True)
        self.out.mkdir()
        if writer.begins:
            writer.begins(self, self.out)

    def words(self, writer):
        return [self.voxc, *(word.format(out=self.out, **{"in": self.inputs}) for word in writer.words), "--quiet"]

    def run(self, writer, **options):
        return subprocess.run(self.words(writer), capture_output=True, text=True, timeout=PATIENCE * 5, **options)

    def files(self, writer):
        """What stands of a writer's files, as it is compared."""
        return {str(path.relative_to(self.out)): writer.compared(path)
                for pattern in writer.files for path in sorted(self.out.glob(pattern))}

    def start(self, writer, **options):
        """A process in a session of its own, over an earlier file where it makes but one."""
        if len(writer.files) == 1 and not writer.goes_on and "*" not in writer.files[0]:
            (self.out / writer.files[0]).write_bytes(EARLIER)
        options = {"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE, **options}
        return subprocess.Popen(self.words(writer), text=True, start_new_session=True, **options)


def descendants(pid):
    """The processes below one."""
    found = []
    for task in Path(f"/proc/{pid}/task").glob("*/children"):
        try:
            for child in task.read_text().split():
                found += [int(child), *descendants(int(child))]
        except OSError:
            pass
    return found


def send(pid, number):
    try:
        os.kill(pid, number)
    except ProcessLookupError:
        pass  # It was done.


def end_of(process, others=()):
    """Waits for a process and those below it, which may outlive it; its exit code and what it said."""
    said = process.communicate(timeout=PATIENCE)[1]
    end = time.monotonic() + PATIENCE
    while any(Path(f"/proc/{other}").exists() and "Z" not in Path(f"/proc/{other}/stat").read_text().split(")")[1][:3]
              for other in others if Path(f"/proc/{other}/stat").exists()):
        if time.monotonic() > end:
            raise TimeoutError(f"processes {others} go on")
        time.sleep(0.01)
    return process.returncode, said or ""


def moment(bench, name):
    time.sleep(bench.random.random() * bench.seconds[name] * 1.1)


def signalled(number):
    def fault(bench, name):
        process = bench.start(WRITERS[name])
        moment(bench, name)
        below = descendants(process.pid)
        send(process.pid, number)
        return end_of(process, below)
    return fault


def interrupted_group(bench, name):
    """As a terminal does it: the command and all that it has started."""
    process = bench.start(WRITERS[name])
    moment(bench, name)
    below = descendants(process.pid)
    try:
        os.killpg(process.pid, bench.random.choice([signal.SIGINT, signal.SIGHUP]))
    except ProcessLookupError:
        pass
    return end_of(process, below)


def halted(bench, name):
    """SIGSTOP and SIGCONT: it must go on as if nothing had been."""
    process = bench.start(WRITERS[name])
    moment(bench, name)
    send(process.pid, signal.SIGSTOP)
    time.sleep(bench.random.random() * 0.3)
    send(process.pid, signal.SIGCONT)
    code, said = end_of(process)
    return code if code == 0 else f"ended with {code} after SIGCONT", said


def halted_and_ended(bench, name):
    """As Slurm ends what it has suspended."""
    process = bench.start(WRITERS[name])
    moment(bench, name)
    below = descendants(process.pid)
    for pid in [process.pid, *below]:
        send(pid, signal.SIGSTOP)
    time.sleep(bench.random.random() * 0.1)
    for number in (signal.SIGTERM, signal.SIGCONT):
        for pid in [process.pid, *below]:
            send(pid, number)
    return end_of(process, below)


def closed_output(bench, name):
    """Nobody reads what it says: its pipes are closed."""
    writer = WRITERS[name]
    words = [*bench.words(writer)[:-1], *([] if "--stats" in writer.words else ["--stats", "-"])]
    process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True)
    moment(bench, name)
    process.stdout.close()
    process.stderr.close()
    code = process.wait(PATIENCE)
    return (0 if code == -signal.SIGPIPE else code), "error: (closed)"


def no_more_cpu(bench, name):
    """RLIMIT_CPU of one second, of which some is used up before."""
    used = bench.random.random()
    burn = f"import time\nend={used}\nwhile time.process_time()<end: pass\nimport os,sys\nos.execv(sys.argv[1],sys.argv[1:])"
    limit = lambda: resource.setrlimit(resource.RLIMIT_CPU, (1, 3))
    process = subprocess.Popen([sys.executable, "-S", "-c", burn, *bench.words(WRITERS[name])], preexec_fn=limit,
                               stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, start_new_session=True)
    code, said = end_of(process)
    return (0 if code in (-signal.SIGXCPU, -signal.SIGKILL) else code), said


def lost_parent(bench, name):
    """Who started it is killed: its own children are to end, and what has none goes on alone."""
    parent = bench.start(WRITERS[name])
    moment(bench, name)
    below = descendants(parent.pid)
    send(parent.pid, signal.SIGKILL)
    code, said = end_of(parent, below)
    return (0 if code == -signal.SIGKILL else code), said


def hurt_child(bench, name):
    """One child gets a signal; its parent must make up for it."""
    process = bench.start(WRITERS[name])
    moment(bench, name)
    below = descendants(process.pid)
    if below:
        send(bench.random.choice(below), bench.random.choice([signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGKILL]))
    return end_of(process, below)


def no_memory(bench, name):
    """A helping thread gets no more memory from its n-th allocation on."""
    plan = f"malloc:{int(10 ** bench.random.uniform(0, 4))}:12"
    process = bench.start(WRITERS[name], env={**os.environ, "LD_PRELOAD": str(bench.shim), "VOXC_FAULT": plan})
    code, said = end_of(process, descendants(process.pid))
    return code, f"{plan}: {said}"


def two_at_once(bench, name):
    """Two of the same command, side by side; either may be ended."""
    processes = [bench.start(WRITERS[name]) for _ in range(2)]
    moment(bench, name)
    below = descendants(processes[0].pid)
    if bench.random.random() < 0.5:
        send(processes[0].pid, bench.random.choice([signal.SIGKILL, signal.SIGTERM]))
    first = end_of(processes[0], below)
    second = end_of(processes[1])
    return (second[0] if first[0] == -signal.SIGKILL else first[0] or second[0]), first[1] + second[1]


CHILDREN = [name for name, writer in WRITERS.items() if writer.children]
BUILDS = [name for name in WRITERS if name.startswith(("build", "a task", "a merge", "merge", "split", "edit"))]
# Each fault, and of which commands; what a fault returns is an exit code, or a text that says what is wrong with it.
FAULTS = {
    "SIGTERM": (signalled(signal.SIGTERM), list(WRITERS)),
    "SIGINT": (signalled(signal.SIGINT), list(WRITERS)),
    "SIGHUP": (signalled(signal.SIGHUP), list(WRITERS)),
    "SIGKILL": (signalled(signal.SIGKILL), list(WRITERS)),
    "interrupt of the group": (interrupted_group, list(WRITERS)),
    "SIGSTOP, SIGCONT": (halted, list(WRITERS)),
    "SIGSTOP, SIGTERM, SIGCONT": (halted_and_ended, list(WRITERS)),
    "closed output": (closed_output, list(WRITERS)),
    "no more CPU": (no_more_cpu, list(WRITERS)),
    "parent killed": (lost_parent, CHILDREN * 4 + list(WRITERS)),
    "a child hurt": (hurt_child, CHILDREN),
    "no memory in a thread": (no_memory, BUILDS),
    "two at once": (two_at_once, [name for name in BUILDS + ["submit"]]),
}


def what_stands(bench, name):
    """What is wrong with the files that stand, or None; and whether they are whole."""
    writer, whole = WRITERS[name], bench.whole[name]
    if writer.compared.__name__ != "content":
        return None, False
    stands = bench.files(writer)
    if writer.set_of_files and not any(path in stands for path in list(whole)[:2]):
        return None, False
    wrong = [path for path, found in stands.items() if found not in (whole.get(path), EARLIER)]
    if wrong:
        return f"{wrong[0]} is neither whole nor what was there ({len(stands[wrong[0]])} bytes of {len(whole.get(wrong[0], b''))})", False
    return None, stands == whole


def left_over(bench, code):
    """What lies beside the files. A kill may fall between the two calls that give a name; the next command clears that up."""
    names = [path.name for path in bench.out.rglob("*") if path.name.endswith(".voxc-new") or ".hvf." in path.name]
    return names if names and code != -signal.SIGKILL else []


def judge(bench, name, code, said):
    """What is wrong after a fault, and what is left when the same command runs again; or None, and how it ended."""
    writer = WRITERS[name]
    if isinstance(code, str):
        return code, ""
    # Before the handlers stand, a signal does what it always does.
    early = code in (-signal.SIGTERM, -signal.SIGINT, -signal.SIGHUP, -signal.SIGKILL)
    if code not in TOLD and not early:
        return f"ended with {code}: {said[-300:]}", ""
    if code not in (0, *([code] if early else [])) and "error:" not in said:
        return f"ended with {code} and did not say why: {said[-300:]}", ""
    problem, is_whole = what_stands(bench, name)
    if problem or (left := left_over(bench, code)):
        return problem or f"left {left}", ""
    again = bench.run(writer)
    if again.returncode != 0:
        return f"the next run ended with {again.returncode}: {again.stderr[-300:]}", ""
    if bench.files(writer) != bench.whole[name]:
        return "the next run did not come to the files of an undisturbed one", ""
    return None, "whole" if is_whole else "nothing"


def moment_of(bench, fault, among):
    """One moment of a fault, of one of its commands; what is wrong, with the command, or None, and how it ended."""
    act, names = FAULTS[fault]
    name = bench.random.choice([name for name in names if name in among])
    bench.begin(WRITERS[name])
    try:
        problem, end = judge(bench, name, *act(bench, name))
    except (TimeoutError, subprocess.TimeoutExpired) as hangs:
        problem, end = f"hangs: {hangs}", ""
    return problem and f"{name}: {problem}", end


def main(voxc, moments, folder):
    seed = int(os.environ.get("VOXC_SEED") or time.time())
    chosen = [word for word in os.environ.get("VOXC_FAULTS", "").split(";") if word] or list(FAULTS)
    among = [word for word in os.environ.get("VOXC_WRITERS", "").split(";") if word] or list(WRITERS)
    bench = Bench(voxc.resolve(), folder, random.Random(seed), among)
    chosen = [fault for fault in chosen if any(name in among for name in FAULTS[fault][1])]
    rows, found = {fault: dict.fromkeys(("tries", "whole", "nothing", "found"), 0) for fault in chosen}, []
    for i in range(moments):
        fault = chosen[i % len(chosen)]
        problem, end = moment_of(bench, fault, among)
        rows[fault]["tries"] += 1
        rows[fault][end or "found"] += 1
        if problem:
            found.append(f"- {fault}, {problem} (moment {i})")
            print(found[-1], flush=True)
    text = report(moments, seed, rows, found)
    (bench.folder / "signals.md").write_text(text)
    shutil.rmtree(bench.out, ignore_errors=True)
    print(text)
    return 1 if found else 0


def report(moments, seed, rows, found):
    table = "\n".join(f"| {fault} | {row['tries']} | {row['whole']} | {row['nothing']} | {row['found']} |" for fault, row in rows.items())
    return (f"# {moments} moments, seed {seed}\n\n| Fault | Tries | Whole | Nothing, or the earlier | Wrong |\n|---|---|---|---|---|\n"
            + table + "\n\n" + "\n".join(found) + "\n")


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), int(sys.argv[2]), Path(sys.argv[3] if len(sys.argv) > 3 else "build/campaign/signals")))
