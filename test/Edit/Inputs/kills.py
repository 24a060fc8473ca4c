"""kills.py VOXC FOLDER KILLS [SEED]: edits a volume in its journal, and now and then puts the journal into its file, by processes
that are killed at any moment, and looks at what is left: every edit whose process came to its end, of the others the whole edit or
nothing, and never an error. VOXC_TEST_FACTOR in the environment multiplies KILLS."""
import os
import random
import signal
import subprocess
import sys
import time

SIDE = 32


def main():
    voxc, folder, kills = sys.argv[1], sys.argv[2], int(sys.argv[3]) * int(os.environ.get("VOXC_TEST_FACTOR", 1))
    random.seed(int(sys.argv[4]) if len(sys.argv) > 4 else 1)
    volume = os.path.join(folder, "kills.hvx")
    run = lambda *arguments: subprocess.run([voxc, *arguments, "--quiet"], check=True, capture_output=True, text=True)
    for old in (volume, volume + ".journal"):
        if os.path.exists(old):
            os.remove(old)
    run("build", "R(2^3) G(3)", f"builtin:empty:{SIDE}", "-o", volume)
    seconds = time_of(command(voxc, volume, 0))
    compaction = [voxc, "edit", volume, "--compact", "-o", volume, "--quiet"]
    compact_seconds = time_of(compaction)
    done, killed = set(), set()
    number = 0
    while len(killed) < kills:
        number += 1
        ended = ends(command(voxc, volume, number), random.uniform(0, 1.3) * seconds)
        (done if ended else killed).add(number)
        if random.random() < 0.1:
            ends(compaction, random.uniform(0, 1.3) * compact_seconds)
    run("export", volume, "-o", volume + ".raw")
    voxels = open(volume + ".raw", "rb").read()
    for i in range(1, number + 1):
        # An edit is two voxels that lie far apart.
        found = [words_at(voxels, place) == colour(i) for place in places(i)]
        if found[0] != found[1]:
            sys.exit(f"edit {i} is there in parts")
        if i in done and not found[0]:
            sys.exit(f"edit {i} is lost, whose process had ended")
    if not done:
        sys.exit("no process came to its end")
    print(f"{len(killed)} were killed, {len(done)} ended, and nothing is lost")


def places(number):
    x, y = number % SIDE, number // SIDE % (SIDE // 2)
    z = number // (SIDE * SIDE // 2)
    return (x, y, z % SIDE), (x, y + SIDE // 2, z % SIDE)


def colour(number):
    return (number & 255) | (number >> 8 & 255) << 8 | 0xFF8000 << 8 & 0xFF0000 | 0xFF000000


def words_at(voxels, place):
    at = 4 * (place[0] + SIDE * (place[1] + SIDE * place[2]))
    return int.from_bytes(voxels[at:at + 4], "little")


def command(voxc, volume, number):
    word = colour(number)
    text = "".join(f"{word >> shift & 255:02x}" for shift in (0, 8, 16))
    boxes = [",".join(map(str, place)) + "," + ",".join(str(i + 1) for i in place) for place in places(number)]
    return [voxc, "edit", volume, "--journal", "--quiet"] + [word for box in boxes for word in ("--fill", f"{box}={text}")]


def time_of(command):
    """How long a process takes."""
    begin = time.monotonic()
    subprocess.run(command, check=True)
    return time.monotonic() - begin


def ends(command, seconds):
    """True if the process ended before it was killed."""
    process = subprocess.Popen(command, stderr=subprocess.PIPE)
    try:
        _, error = process.communicate(timeout=seconds)
    except subprocess.TimeoutExpired:
        process.send_signal(signal.SIGKILL)
        process.communicate()
        return process.returncode == 0
    if process.returncode != 0:
        sys.exit(f"{' '.join(command)} failed: {error.decode()}")
    return True


main()
