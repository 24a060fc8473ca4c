"""Reading the records of voxc bench; docs/bench.md has their schema.

A record is a dictionary as its line has it, but that every section is there, and that what is null is absent. `folder` is
where it was read.
"""
import json
import math
import os
import re

from .problems import Problem

SCHEMA = 1
MOST_COUNT = 2**64 - 1
SURROGATE = re.compile("[\ud800-\udfff]")


def is_text(value):
    """Half a character, as JSON may have it by its escapes, is no text."""
    return isinstance(value, str) and not SURROGATE.search(value)


def is_flag(value):
    return isinstance(value, bool)


def is_count(value):
    return isinstance(value, int) and not isinstance(value, bool) and 0 <= value <= MOST_COUNT


def is_number(value):
    try:
        return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)
    except OverflowError:  # An integer that no float holds.
        return False


def list_of(is_element, count=None):
    """Whether a value is a list of such elements, so many if their number is given."""
    return lambda value: isinstance(value, list) and len(value) in (count, len(value) if count is None else count) and all(
        map(is_element, value))


def required(**fields):
    return {name: (check, True) for name, check in fields.items()}


def optional(check, *names):
    return {name: (check, False) for name in names}


SPEED = required(min=is_number, median=is_number, max=is_number, spread=is_number)
RECORD = {**required(cell=is_text, precision=is_text, status=is_text), **optional(is_count, "resolution")}

# The fields of each section: a check, and whether the field must be there.
SECTIONS = {
    "model": {**required(name=is_text, input=is_text, digest=is_text), **optional(is_count, "voxels"),
              **optional(is_text, "picture"), **optional(list_of(is_count, 3), "size")},
    "format": required(label=is_text, name=is_text, passes=list_of(is_text), digest=is_text),
    "device": {**required(name=is_text, kind=is_text, driver=is_text, clock=is_text), **optional(is_count, "threads")},
    "rays": {**required(name=is_text, kind=is_text, count=is_count, digest=is_text), **optional(is_text, "order"),
             **optional(list_of(is_count, 2), "size")},
    "volume": {**optional(is_count, "words", "bytes", "file_bytes"), **optional(is_number, "bytes_per_voxel"),
               **optional(list_of(is_count), "level_words")},
    "build": {**optional(is_number, "load_seconds", "compile_seconds", "build_seconds", "build_cpu_seconds", "write_seconds"),
              **optional(is_count, "peak_rss_bytes")},
    "kernel": optional(is_number, "compile_seconds", "upload_seconds", "first_dispatch_seconds"),
    "speed": {**optional(is_count, "rounds"), **optional(is_flag, "steady"), **optional(is_text, "order")},
    "work": {**optional(is_count, "hits", "rays"), **optional(is_number, "steps_per_ray", "words_per_ray")},
    "error": {**optional(is_count, "rays", "missed", "ghost", "wrong", "boundary", "colour"),
              **optional(is_number, "max_dt", "rms_dt", "max_ulp_dt")},
    "made_by": {**required(voxc=is_text, llvm=is_text, processor=is_text, command=is_text), **optional(is_count, "cores")},
}
# Those that a record may lack as a whole.
OPTIONAL_SECTIONS = {
    "failure": {**required(stage=is_text, reason=is_text), **optional(is_count, "words")},
    "predicted": {**optional(is_count, "words"), **optional(is_number, "mrays_per_s", "turns", "lines")},
}
SPEEDS = ("mrays_per_s", "mrays_per_cpu_s", "mrays_per_device_s")


def check_fields(values, fields, where):
    """Holds a section to its fields; what is null in it goes."""
    for name, (check, is_required) in fields.items():
        value = values.get(name)
        if value is None and name in values and not is_required:
            del values[name]
        if name not in values and is_required:
            raise Problem(f'"{where}{name}" is missing')
        if name in values and not check(values[name]):
            raise Problem(f'"{where}{name}" has a value of another type than the schema says')


def section_of(values, name, where=""):
    section = values.setdefault(name, {})
    if not isinstance(section, dict):
        raise Problem(f'"{where}{name}" should be an object')
    return section


def check_record(record):
    check_fields(record, RECORD, "")
    for name, fields in SECTIONS.items():
        check_fields(section_of(record, name), fields, name + ".")
    for name, fields in OPTIONAL_SECTIONS.items():
        if name in record:
            check_fields(section_of(record, name), fields, name + ".")
    for name in SPEEDS:
        if name in record["speed"]:
            check_fields(section_of(record["speed"], name, "speed."), SPEED, f"speed.{name}.")
    if "failure" in record and record["status"] != "failed":
        raise Problem('"status" should be "failed", for there is a failure')
    if "failure" not in record and record["status"] != "measured":
        raise Problem('"status" should be "measured"')


def parse_record(line):
    """The record of a line. Raises Problem if it is none, by the name of what is wrong."""
    try:
        record = json.loads(line)
    except (ValueError, RecursionError):
        record = None
    if not isinstance(record, dict):
        raise Problem("a record should be a JSON object")
    if record.get("schema") is not SCHEMA:
        raise Problem(f'a record should have "schema": {SCHEMA}, the one that is read')
    check_record(record)
    return record


def read_file(path):
    """The records of a file; what stands behind its last line end was cut short."""
    try:
        with open(path, "rb") as file:
            lines = file.read().split(b"\n")[:-1]
    except OSError as error:
        raise Problem(f"'{path}' cannot be read: {error.strerror}") from error
    for number, line in enumerate(lines, 1):
        if line:
            try:
                yield parse_record(line)
            except Problem as problem:
                raise Problem(f"{path}:{number}: {problem}") from None


def names_in(folder, is_wanted):
    """The names of a folder's files that are wanted, in order."""
    try:
        return sorted(filter(is_wanted, os.listdir(folder)))
    except OSError as error:
        raise Problem(f"folder '{folder}' cannot be read: {error.strerror}") from error


def locate_picture(record, folder):
    """Makes of the picture a path that can be opened; one that lies outside the record's folder is left out."""
    picture = record["model"].pop("picture", None)
    if picture is not None and not os.path.isabs(picture) and ".." not in picture.split("/"):
        record["model"]["picture"] = os.path.join(folder, picture)


def read_folders(folders):
    """The records of all folders in the order in which their cells first came; of two of the same cell and processor the later
    counts."""
    cells = {}
    for folder in folders:
        for name in names_in(folder, lambda name: name.endswith(".jsonl")):
            for record in read_file(os.path.join(folder, name)):
                locate_picture(record, folder)
                cells[record["cell"], record["made_by"]["processor"]] = record
    if not cells:
        raise Problem("there are no records; a folder should hold .jsonl files of voxc bench")
    return list(cells.values())


def is_measured(record):
    return "failure" not in record


def rays_title(rays):
    """The rays' name, and the order that was asked for."""
    order = rays.get("order")
    return rays["name"] + ("" if order is None else " as given" if order == "given" else " " + order)
