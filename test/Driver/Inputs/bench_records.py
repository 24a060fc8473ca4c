# bench_records.py RESULTS.jsonl: says what the records of the sweep in bench.test hold, in few words.
import json
import sys

lines = open(sys.argv[1]).read().splitlines()
records = [json.loads(line) for line in lines]
kinds = sorted({record["device"]["kind"] for record in records})
print(f"cells {len({record['cell'] for record in records})} of {len(lines)} lines, kinds {' '.join(kinds)}")
for record in records:
    label = record["format"]["label"]
    if record["status"] == "failed":
        figures = [key for key in ("speed", "work", "error", "kernel") if key in record]
        failure = record["failure"]
        print(f"failed '{label}' in {failure['stage']}, words {failure.get('words')}, figures {figures or 'none'}")
    elif record["device"]["kind"] == "cpu":
        twin = next(r for r in records if r["format"] == record["format"] and r["device"]["kind"] == "vulkan")
        # Devices round steps that are close calls as they like; what the rays hit is the same.
        pairs = [(twin["work"][name], record["work"][name]) for name in record["work"]]
        same = "same" if all(abs(a - b) <= 0.005 * b for a, b in pairs) and pairs[0][0] == pairs[0][1] else "other"
        assert record["speed"]["mrays_per_cpu_s"]["min"] > 0 and record["build"]["peak_rss_bytes"] > 0
        assert record["volume"]["bytes"] == 4 * record["volume"]["words"]
        print(f"measured '{label}': {record['resolution']} voxels an axis, {record['speed']['rounds']} rounds, "
              f"{record['error']['rays']} rays checked, {same} work on both devices")
