"""Renders each frame of a flight by itself: flight.py STATS FRAMES VOXC ARGUMENT...

STATS has the frames' cameras; FRAMES is the name of their pictures, with {} for the number. Prints how many are the same.
"""
import json
import os
import subprocess
import sys

stats, frames, command = sys.argv[1], sys.argv[2], sys.argv[3:]
folder = os.path.dirname(stats)
cameras, single = os.path.join(folder, "single.json"), os.path.join(folder, "single.png")
flown = json.load(open(stats))["frames"]
json.dump({"cameras": {f"frame{i}": camera for i, camera in enumerate(flown)}}, open(cameras, "w"))
same = 0
for i in range(len(flown)):
    subprocess.run(command + ["--camera", f"{cameras}:frame{i}", "-o", single, "--quiet"], check=True)
    same += open(single, "rb").read() == open(frames.format(f"{i:02}"), "rb").read()
print(f"{same} of {len(flown)} frames are the same")
