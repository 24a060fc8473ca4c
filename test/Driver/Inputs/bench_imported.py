# bench_imported.py RESULTS.jsonl: compares what bench import took in with the cells that were exported.
import json
import sys

records = [json.loads(line) for line in open(sys.argv[1])]
here = [record for record in records if record["device"]["kind"] == "cpu"]
there = [record for record in records if record["device"]["name"].startswith("llvmpipe")]
repeats, checked = set(), set()
for record in there:
    twin = next(r for r in here if r["format"] == record["format"] and r["rays"] == record["rays"])
    assert record["cell"] != twin["cell"] and record["volume"] == twin["volume"]
    assert record["work"]["hits"] == twin["work"]["hits"] > 0
    assert record["error"]["missed"] == record["error"]["ghost"] == record["error"]["wrong"] == 0
    assert 0 < record["work"]["steps_per_ray"] < 3 * twin["work"]["steps_per_ray"] + 9
    repeats.add(record["speed"]["rounds"])
    checked.add(record["error"]["rays"])
print(f"{len({record['cell'] for record in records})} cells, {len(there)} of llvmpipe: {repeats.pop()} repeats each, "
      f"the hits and steps of the cpu, {max(checked)} rays checked")
