"""Holds what voxc search told against what it left and what a build makes."""
import json
import os
import shlex
import subprocess
import sys

voxc, report, stats, folder = sys.argv[1:]
records = [json.loads(line) for line in open(os.path.join(folder, "results.jsonl"))]
assert records and all(record["status"] == "measured" for record in records)
differ = [record for record in records if record["volume"]["words"] != record["predicted"]["words"]]
print("words as predicted" if not differ else differ[0])

command = shlex.split([line for line in open(report) if line.startswith("voxc build")][-1])
scene = os.path.join(folder, "scene.hvx")
subprocess.run([voxc, *command[1:-1], scene, "--quiet"], check=True)
frontier = json.load(open(stats))["frontier"]
chosen = next(entry for entry in frontier if entry["chosen"])
volumes = [os.path.join(folder, "cache", name) for name in os.listdir(os.path.join(folder, "cache")) if name.endswith(".hvx")]
same = [path for path in volumes if open(path, "rb").read() == open(scene, "rb").read()]
print("the command builds the volume that was chosen" if same else "no kept volume is as %s" % chosen)
print("volumes of the frontier are kept, and no others" if len(volumes) <= len(frontier) else "%d volumes of %d" % (len(volumes), len(frontier)))
