"""Takes what was predicted out of the records of a search, and breaks the figures beside its volumes."""
import glob
import json
import os
import sys

results = os.path.join(sys.argv[1], "results.jsonl")
records = [json.loads(line) for line in open(results)]
for record in records:
    record.pop("predicted", None)
with open(results, "w") as file:
    file.writelines(json.dumps(record) + "\n" for record in records)
for path in glob.glob(os.path.join(sys.argv[1], "cache", "*.json")):
    open(path, "w").write('{"words": "many", "levels": 3}')
