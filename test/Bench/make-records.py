#!/usr/bin/env python3
"""Writes made-up records of voxc bench into a folder, the same ones every time: what the report is tested with.

  make-records.py DIR [--whole | --predicted]    --whole: as many as an evaluation of 40 formats has
                                                --predicted: as a search of one model has, with what it predicted
"""
import hashlib
import json
import random
import struct
import sys
import zlib
from pathlib import Path

LARGE = ["D(4^3, 6) D(3^3, 6) G(4)", "D(4^3, 6) R(3^3) G(4)", "R(4^3) R(3^3) G(4)", "R(4^3) S(3) G(4)", "R(4^3) R(4^3) R(3^3)", "D(4^3, 6) S(7)",
         "D(4^3, 6) G(7)", "D(6^3, 6) S(5)", "D(6^3, 6) G(5)", "R(4^3) S(7)", "R(4^3) G(7)", "R(6^3) S(5)", "R(6^3) G(5)", "R(3^3) G(8)",
         "R(8^3) G(3)", "S(7) G(4)", "S(5) G(6)", "S(3) G(8)", "S(11)", "G(11)"]
SMALL = ["D(3^3, 6) D(3^3, 6) G(3)", "D(3^3, 6) R(3^3) G(3)", "R(3^3) R(3^3) G(3)", "R(3^3) R(3^3) R(3^3)", "R(4^3) R(1^3) R(4^3)", "D(4^3, 6) S(5)",
         "D(4^3, 6) G(5)", "R(4^3) S(5)", "R(4^3) G(5)", "R(2^3) G(7)", "R(7^3) G(2)", "S(5) R(4^3)", "G(5) R(4^3)", "D(5^3, 6) D(4^3, 6)",
         "D(5^3, 6) R(4^3)", "R(5^3) R(4^3)", "R(9^3)", "D(9^3, 6)", "S(9)", "G(9)"]
FEW = ["R(4^3) G(7)", "R(3^3) G(8)", "D(4^3, 6) G(7)", "R(4^3) S(7)", "S(11)", "G(11)", "R(6^3) G(5)", "R(4^3) R(4^3) R(3^3)"]
MODELS = [("pagoda", "pagoda.obj", [2048, 857, 1260]), ("tangle", "tangle.ply", [2048, 2048, 2011]), ("orchard", "orchard.glb", [1870, 411, 2048]),
          ("figurine", "figurine.ply", [840, 2048, 840])]
SOFTWARE = {"name": "llvmpipe (LLVM 15.0.6, 256 bits)", "kind": "vulkan", "driver": "llvmpipe 22.3.6", "threads": 2, "clock": "cpu"}
CPU = {"name": "cpu", "kind": "cpu", "driver": "voxc", "threads": 2, "clock": "cpu"}
GPU = {"name": "Imaginary GPU 9000", "kind": "vulkan", "driver": "1.2.3", "clock": "gpu"}
DEDUP = ["whole-level-dedup"]
FAILURES = {"R(4^3) R(4^3) R(3^3)": ("build", "the volume would take more than the 2^32 words that offsets reach", 4294967296),
            "D(9^3, 6)": ("build", "out of memory within the bound of 1 GiB", 134217728)}


def digest(*parts):
    return hashlib.sha256("|".join(map(str, parts)).encode()).hexdigest()[:16]


def chance(*parts):
    """A number from 0 to 1 that only depends on what it is for."""
    return random.Random(digest(*parts)).random()


def size_of(model, form, passes, side):
    factor = {"R": 1.0, "D": 1.25, "S": 5.5, "G": 0.8}
    kinds = [part[0] for part in form.split(") ")]
    words = 3e6 * (side / 2048) ** 2 * factor[kinds[-1]] * factor[kinds[0]] * (0.5 + 3 * chance(model, form))
    return int(words * (1 if "whole-level-dedup" in passes else 1 + 3.2 * chance("dedup", model, form)))


def speed_of(model, form, passes, device, precision):
    base = {"llvmpipe (LLVM 15.0.6, 256 bits)": 0.5, "cpu": 0.8, "Imaginary GPU 9000": 900}[device["name"]]
    speed = base * (0.5 + chance("speed", model)) * (0.5 + chance("speed", form)) * (1.5 if form[0] == "D" else 1)
    if "restart-sv" in passes:
        speed *= 0.6 + 1.3 * chance("restart", form, model)
    return speed * (1.04 if precision == "fast" else 1) * (0.97 + 0.06 * chance(model, form, passes, device["name"]))


def speed_json(speed, spread):
    return {"min": speed * (1 - spread / 2), "median": speed, "max": speed * (1 + spread / 2), "spread": spread}


def record(model, form, passes, side, device, precision, label=""):
    name, source, size = model
    cell = digest(name, form, passes, side, device["name"], precision)
    line = {"schema": 1, "cell": cell,
            "model": {"name": name, "input": source, "digest": digest(name), "size": [n * side // 2048 for n in size],
                      "voxels": int(1e7 * (side / 2048) ** 2 * (0.5 + chance(name))), "picture": f"pictures/{name}.png"},
            "format": {"label": label, "name": form, "passes": passes, "digest": digest(form, passes)}, "resolution": side,
            "precision": precision, "device": device,
            "rays": {"name": name, "kind": "camera", "count": 1440000, "size": [1600, 900], "digest": digest("rays", name)}}
    made_by = {"voxc": "voxc 0.1.0", "llvm": "19.1.7", "processor": "Imaginary CPU", "cores": 2,
               "command": "voxc bench pagoda.obj tangle.ply --formats formats.txt -o results"}
    if form in FAILURES and name == "tangle":
        stage, reason, words = FAILURES[form]
        return {**line, "status": "failed", "failure": {"stage": stage, "reason": reason, "words": words}, "made_by": made_by}
    words = size_of(name, form, passes, side)
    spread = 0.005 + 0.05 * chance("spread", cell)
    speed = speed_json(speed_of(name, form, passes, device, precision), spread)
    kind = "mrays_per_device_s" if device["clock"] == "gpu" else "mrays_per_cpu_s"
    wrong = 3 if precision == "fast" and form[0] in "SG" else 0
    return {**line, "status": "measured",
            "volume": {"words": words, "bytes": 4 * words, "bytes_per_voxel": 4 * words / line["model"]["voxels"], "file_bytes": 4 * words + 4096},
            "build": {"load_seconds": 0.1, "compile_seconds": 0.08, "build_seconds": words / 2e6, "build_cpu_seconds": words / 1.2e6,
                      "write_seconds": 0.2, "peak_rss_bytes": 12 * words + 80000000},
            "kernel": {"compile_seconds": 0.05, "upload_seconds": 0.02, "first_dispatch_seconds": 0.4},
            "speed": {"rounds": 5, "mrays_per_s": speed, kind: speed, "steady": spread < 0.05},
            "work": {"hits": 1400000, "rays": 20000, "steps_per_ray": 10 + 30 * chance("steps", form, name), "words_per_ray": 15 + 40 * chance("words", form, name)},
            "error": {"rays": 20000, "missed": 0, "ghost": 0, "wrong": wrong, "boundary": wrong, "colour": 0, "max_dt": 0.0001, "rms_dt": 0.00001,
                      "max_ulp_dt": 1},
            "made_by": made_by}


def few_records():
    """Two models, eight formats, two devices; dedup and restart studied on some; fast steps on one model."""
    for model in MODELS[:2]:
        for device in (SOFTWARE, CPU):
            for i, form in enumerate(FEW):
                yield record(model, form, DEDUP, 2048, device, "exact", str(i + 1))
        for form in FEW[:3]:
            yield record(model, form, [], 2048, SOFTWARE, "exact")
        for form in FEW[4:6]:
            yield record(model, form, [*DEDUP, "restart-sv"], 2048, SOFTWARE, "exact")
            yield record(model, form, [*DEDUP, "unroll-sv"], 2048, SOFTWARE, "exact")
    for form in FEW[4:6]:
        yield record(MODELS[0], form, DEDUP, 2048, SOFTWARE, "fast")


def whole_records():
    label = 0
    for side, formats in ((2048, LARGE), (512, SMALL)):
        for form in formats:
            label += 1
            for model in MODELS:
                for device in (SOFTWARE, CPU, GPU):
                    yield record(model, form, DEDUP, side, device, "exact", str(label))
    for model in MODELS:
        for form in ("R(8^3) G(3)", "R(6^3) G(5)", "R(4^3) G(7)", "R(3^3) G(8)"):
            yield record(model, form, [], 2048, SOFTWARE, "exact")
        for form in ("R(7^3) G(2)", "R(3^3) R(3^3) G(3)", "R(4^3) G(5)", "R(2^3) G(7)"):
            yield record(model, form, [], 512, SOFTWARE, "exact")
        for device in (SOFTWARE, CPU, GPU):
            for form in ("S(11)", "G(11)", "S(3) G(8)", "S(7) G(4)"):
                yield record(model, form, [*DEDUP, "restart-sv"], 2048, device, "exact")
                yield record(model, form, [*DEDUP, "unroll-sv"], 2048, device, "exact")
            for form in ("S(9)", "G(9)", "R(4^3) G(5)", "R(3^3) R(3^3) G(3)"):
                yield record(model, form, [*DEDUP, "restart-sv"], 512, device, "exact")
                yield record(model, form, [*DEDUP, "unroll-sv"], 512, device, "exact")


def predicted_records():
    """120 formats of one model on one device, each with passes of its own; larger ones are faster."""
    for form in LARGE:
        for extra in ([], ["restart-sv"], ["flat-traversal"], ["short-pointers=20"], ["share-grids"], ["flat-traversal", "share-grids"]):
            line = record(("pagoda", "pagoda.obj", [2048, 857, 1260]), form, DEDUP + extra, 2048, CPU, "exact")
            volume, speed = line["volume"], line["speed"]
            volume["bytes"] = 4 * volume["words"]
            factor = (volume["words"] / 1e6) ** 0.3 * (0.9 + 0.2 * chance("traversal", form, extra))
            for key in ("mrays_per_s", "mrays_per_cpu_s"):
                speed[key] = {name: figure * (1 if name == "spread" else factor) for name, figure in speed[key].items()}
            levels = form.count("(")
            volume["level_words"] = [volume["words"] // 2 ** (levels - i) for i in range(levels)]
            median = speed["mrays_per_cpu_s"]["median"]
            line["predicted"] = {"words": volume["words"], "mrays_per_s": median * (0.85 + 0.3 * chance("predicted", form, extra)), "turns": 20 / median,
                                 "lines": 9 / median}
            line["made_by"]["command"] = "voxc search pagoda.obj --budget 180s -o results"
            yield line


def png(width, height, colour_at):
    rows = b"".join(b"\0" + b"".join(bytes(colour_at(x, y)) for x in range(width)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def write_picture(path, name):
    """Hills in a colour of the model's own."""
    tint = [80 + int(150 * chance("tint", name, channel)) for channel in range(3)]

    def colour_at(x, y):
        hill = 110 + 40 * ((x // 16 * 37 + len(name) * 11) % 7) / 7
        return [c * (300 - y) // 300 for c in tint] if y > hill else [190 - y // 3, 205 - y // 4, 225]

    path.write_bytes(png(400, 225, colour_at))


def main():
    folder = Path(sys.argv[1])
    records = {"--whole": whole_records, "--predicted": predicted_records}.get(sys.argv[-1], few_records)
    (folder / "pictures").mkdir(parents=True, exist_ok=True)
    for name, _, _ in MODELS:
        write_picture(folder / "pictures" / f"{name}.png", name)
    with open(folder / "records.jsonl", "w") as file:
        for line in records():
            file.write(json.dumps(line) + "\n")


if __name__ == "__main__":
    main()
