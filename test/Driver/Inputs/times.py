"""times.py TEXT STATS: whether the times of a run add up to its total, as they are printed and as figures; and which there are."""
import json
import re
import sys

text, figures = open(sys.argv[1]).read(), json.load(open(sys.argv[2]))
total, parts = re.search(r"^  took     ([0-9.]+) s: (.*)$", text, re.MULTILINE).groups()
printed = dict(part.split() for part in parts.split(", "))
stages = figures["stages"]
assert abs(sum(map(float, printed.values())) - float(total)) < 0.005, printed
assert abs(sum(stages.values()) - figures["total_seconds"]) < 1e-6, stages
assert all(seconds >= 0 for seconds in stages.values()), stages
assert set(printed) <= set(stages), printed
order = ["device", "format", "input", "code", "build", "kernel", "camera", "rays", "shading", "check", "writing", "rest"]
print("the parts are the total:", *(name for name in order if name in stages))
