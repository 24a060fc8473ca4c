"""Says what all rows of a file of voxc-gpu-day have together."""
import json
import sys

rows = [row for kernel in json.load(open(sys.argv[1]))["kernels"].values() for row in kernel["rows"]]
errors = [row["error"] for row in rows]
wrong = sum(error[kind] for error in errors for kind in ("missed", "ghost", "wrong", "colour"))
print(f"{len(rows)} rows, {wrong} wrong, {max(error['max_ulp_dt'] for error in errors)} ulp")
