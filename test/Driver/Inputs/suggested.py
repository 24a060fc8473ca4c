"""suggested.py VOXC REPORT STATS VOLUME: builds what a report says, and compares the words with those predicted."""
import json
import shlex
import struct
import subprocess
import sys

voxc, report, stats, volume = sys.argv[1:]
command = shlex.split(open(report).read().strip().split("\n")[-1])
command[0] = voxc
command[command.index("scene.hvx")] = volume
built = subprocess.run([*command, "--quiet", "--stats", "-"], check=True, capture_output=True, text=True)
chosen = next(f for f in json.load(open(stats))["formats"] if f["chosen"])
words = json.loads(built.stdout)["words"]
print("words as predicted" if words == chosen["words"] else f"{words} words, {chosen['words']} predicted")
