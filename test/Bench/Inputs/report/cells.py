"""Made-up records for the tests of the report."""
import copy

from voxc_report.catalogue import make_catalogue
from voxc_report.page import make_page
from voxc_report.records import check_record

KIBI, MEBI = 1 << 10, 1 << 20
DEDUP, BOTH = ["whole-level-dedup"], ["whole-level-dedup", "restart-sv"]


def speed(median, spread=0.02):
    """Rounds about a median, from the slowest to the fastest by a share of it."""
    return {"min": median * (1 - spread / 2), "median": median, "max": median * (1 + spread / 2), "spread": spread}


def merged(record, changes):
    for name, value in changes.items():
        if isinstance(value, dict) and isinstance(record.get(name), dict):
            merged(record[name], value)
        else:
            record[name] = value
    return record


def cell(form, size, median, passes=(), **changes):
    """A measured cell with this size and speed, and all of its errors looked for; `changes` are sections with other values."""
    record = {
        "schema": 1, "cell": f"{form} {list(passes)} {median}", "status": "measured", "resolution": 2048, "precision": "exact",
        "model": {"name": "hut", "input": "", "digest": ""},
        "format": {"label": "", "name": form, "passes": list(passes), "digest": ""},
        "device": {"name": "llvmpipe (LLVM)", "kind": "vulkan", "driver": "Mesa", "threads": 2, "clock": "cpu"},
        "rays": {"name": "front", "kind": "camera", "count": 100, "digest": ""},
        "volume": {"bytes": size}, "speed": {"mrays_per_cpu_s": speed(median)},
        "error": {"rays": 1000, "missed": 0, "ghost": 0, "wrong": 0},
        "made_by": {"voxc": "", "llvm": "", "processor": "", "command": ""}}
    merged(record, copy.deepcopy(changes))
    check_record(record)
    return record


def failure(form, reason, **changes):
    record = cell(form, 1, 1, status="failed", failure={"stage": "build", "reason": reason, "words": 12345}, **changes)
    return {**record, "volume": {}, "speed": {}}


def page(records, csv_name="", notes=None):
    return make_page(make_catalogue(records), notes or {}, csv_name)[0]
