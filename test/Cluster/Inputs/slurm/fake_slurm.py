# A stand-in for Slurm: sbatch, squeue and sacct as far as voxc submit uses them, without daemons. Its state is a file in
# $FAKE_SLURM. Each question to squeue first runs one job whose dependencies have ended well; $FAKE_SLURM/fail names jobs
# ("LEVEL ITEM HOW", one a line, each used once) that fail before they begin: HOW is kill; hold, held until it is released; or bad,
# as often as they run on node n1. With $FAKE_SLURM_NO_ACCOUNTS there is no sacct.
import fcntl
import json
import os
import pathlib
import subprocess
import sys

FOLDER = pathlib.Path(os.environ["FAKE_SLURM"])


def load():
    file = FOLDER / "state.json"
    return json.loads(file.read_text()) if file.exists() else []


def save(arrays):
    (FOLDER / "state.json").write_text(json.dumps(arrays, indent=1))


def numbers_of(text):
    for piece in text.split(","):
        first, _, last = piece.partition("-")
        yield from range(int(first), int(last or first) + 1)


def sbatch(arguments):
    options = dict(word.lstrip("-").partition("=")[::2] for word in arguments)
    arrays = load()
    number = 1000 + len(arrays)
    if options["array"].endswith("1099"):
        sys.exit("sbatch: error: Batch job submission failed: Invalid job array specification")
    after = options.get("dependency", "afterok:").split(":")[1:]
    arrays.append({
        "array": number,
        "name": options["job-name"],
        "after": [int(job) for job in after if job],
        "command": options["wrap"],
        "log": options["output"],
        "node": "n2" if options.get("exclude") == "n1" else "n1",
        "options": [word for word in arguments if not word.startswith("--wrap=")],
        "jobs": {str(item): "PENDING" for item in numbers_of(options["array"])},
    })
    save(arrays)
    print(number)


def how_to_fail(name, item, node):
    file = FOLDER / "fail"
    lines = file.read_text().splitlines() if file.exists() else []
    for line in lines:
        level, which, how = line.split()
        if name.endswith("-" + level) and which == item:
            if how == "bad":
                return "kill" if node == "n1" else ""
            lines.remove(line)
            file.write_text("".join(rest + "\n" for rest in lines))
            return how
    return ""


def run(array, item):
    how = how_to_fail(array["name"], item, array["node"])
    if how == "hold":
        return "HELD"
    if how == "kill":
        return "FAILED"
    environment = dict(os.environ, SLURM_ARRAY_TASK_ID=item)
    log = array["log"].replace("%A", str(array["array"])).replace("%a", item)
    with open(log, "w") as output:
        code = subprocess.run(["/bin/sh", "-c", array["command"]], env=environment, stdout=output, stderr=output).returncode
    return "COMPLETED" if code == 0 and how != "nodefail" else "NODE_FAIL" if how else "FAILED"


def step(arrays):
    """Runs one job that may begin; cancels those that never may."""
    states = {array["array"]: set(array["jobs"].values()) for array in arrays}
    for array in arrays:
        below = [states[job] for job in array["after"]]
        waiting = [item for item, state in array["jobs"].items() if state == "PENDING"]
        if any(state - {"COMPLETED", "PENDING"} for state in below):
            for item in waiting:
                array["jobs"][item] = "CANCELLED by 0"
        elif waiting and all(state == {"COMPLETED"} for state in below):
            array["jobs"][waiting[0]] = run(array, waiting[0])
            return


def scontrol(arguments):
    arrays = load()
    for job in arguments[1].split(","):
        number, _, item = job.partition("_")
        array = next(array for array in arrays if str(array["array"]) == number)
        array["jobs"][item] = "PENDING"
    save(arrays)


def squeue(arguments):
    if "--states=all" in arguments:
        return print_accounts(arguments, "{0}_{1}|{2}|{3}|0:02|")
    print("squeue: warning: not a line of a job")
    names = next(word for word in arguments if word.startswith("--name=")).partition("=")[2].split(",")
    arrays = load()
    if "FAKE_SLURM_HOLD" not in os.environ:
        step(arrays)
        save(arrays)
    for array in arrays:
        for item, state in array["jobs"].items():
            if array["name"] in names and state in ("PENDING", "HELD"):
                print(array["array"], item, "PENDING", array["name"], "launch failed requeued held" if state == "HELD" else "None")


def sacct(arguments):
    if "FAKE_SLURM_NO_ACCOUNTS" in os.environ:
        sys.exit("Slurm accounting storage is disabled")
    print_accounts(arguments, "{0}_{1}|{2}|{3}|2|00:01.500\n{0}_{1}.batch|{2}|{3}|2|00:01.500")


def print_accounts(arguments, line):
    jobs = next(word for word in arguments if word.startswith("--jobs=")).partition("=")[2].split(",")
    for array in load():
        for item, state in array["jobs"].items():
            if str(array["array"]) in jobs:
                print(line.format(array["array"], item, "" if state.startswith("CANCELLED") else array["node"], state))


with open(FOLDER / "lock", "w") as lock:
    fcntl.flock(lock, fcntl.LOCK_EX)
    {"sbatch": sbatch, "squeue": squeue, "sacct": sacct, "scontrol": scontrol}[sys.argv[1]](sys.argv[2:])
