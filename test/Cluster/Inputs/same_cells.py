# same_cells.py A B: whether two folders hold records of the same cells, and how many files of records the second has.
import glob
import json
import sys


def cells_of(folder):
    return {json.loads(line)["cell"] for path in glob.glob(folder + "/*.jsonl") for line in open(path)}


first, second = map(cells_of, sys.argv[1:])
files = len(glob.glob(sys.argv[2] + "/*.jsonl"))
print(f"{len(second)} cells, {'the same' if first == second else 'others'}, in {files} file{'s' * (files != 1)}")
