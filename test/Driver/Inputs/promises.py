"""A printed command is a promise: runs what suggest, search and the records of a search print for an input of each kind, and
compares the bytes that were predicted with those that come out.

promises.py VOXC FOLDER
"""
import csv
import json
import re
import shlex
import subprocess
import sys
from pathlib import Path

from kinds import inputs

voxc, folder = sys.argv[1], Path(sys.argv[2])


def run(*words):
    done = subprocess.run([voxc, *map(str, words)], cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"`voxc {' '.join(map(str, words))}` ended with {done.returncode}: {done.stderr}")
    return done.stdout


# A search takes its time: one input of each class of options.
SEARCHED = ("box.obj", "ball.vox", "ball.nii.gz", "ball.hvx", "ball%02d.png")


def build(command):
    """Runs a printed command; the bytes of its volume."""
    words = shlex.split(command)
    assert words[:2] == ["voxc", "build"], command
    output = words[words.index("-o") + 1]
    run(*words[1:], "--stats", "built.json", "--quiet")
    return json.loads((folder / "built.json").read_text())["bytes"], output


def last_command(text):
    return re.findall(r"^voxc build .*$", text, re.M)[-1]


def check(name, predicted, command):
    found, _ = build(command)
    if found != predicted:
        sys.exit(f"{name}: `{command}` makes {found} bytes, and {predicted} were predicted")


for name in inputs(folder, run):
    run("run", name, "-o", "p.png", "--size", "48x32", "--device", "cpu", "--quiet")
    text = run("suggest", name, "--stats", "suggest.json")
    formats = json.loads((folder / "suggest.json").read_text())["formats"]
    chosen = [row for row in formats if row["chosen"]]
    check(f"suggest {name}", chosen[0]["words"] * 4, last_command(text))
    if name not in SEARCHED:
        print(f"{name}: kept")
        continue
    (folder / "formats.txt").write_text("\n".join({row["format"] for row in [formats[0], *chosen]}) + "\n")
    text = run("search", name, "--budget", "30s", "--formats", "formats.txt", "--all", "--check", "0", "--size", "48x32", "--device", "cpu", "-o",
               "search", "--quiet")
    build(last_command(text))
    with open(folder / "search/report.csv") as file:
        for row in csv.DictReader(file):
            if row["rays"] == "overview":
                check(f"search {name}, report.csv", int(row["bytes"]), row["build"])
    subprocess.run(["rm", "-r", folder / "search"], check=True)
    print(f"{name}: kept, and what a search prints")
