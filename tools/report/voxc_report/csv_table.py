"""All cells as comma-separated values, for spreadsheets and scripts (RFC 4180)."""
import csv
import io

from .build_command import build_command
from .passes import pass_list


def number(value):
    """The shortest text that reads back as the same number."""
    return next(text for digits in (15, 16, 17) if float(text := f"{value:.{digits}g}") == value or digits == 17)


def text_of(value):
    """A figure with all of its digits, "" for one that was not taken."""
    return "" if value is None else number(value) if isinstance(value, float) else str(value)


def real(value):
    return None if value is None else float(value)


def of_section(section, name, convert=lambda value: value):
    return lambda entry: convert(entry.record.get(section, {}).get(name))


def of_speed(name):
    return lambda entry: real(getattr(entry.speed, name)) if entry.speed else None


def frontier(entry):
    return None if not entry.has_point else "on" if entry.is_leading else "as good" if entry.is_as_good else "off"


def level_words(entry):
    return " ".join(map(str, entry.record["volume"].get("level_words", [])))


COLUMNS = {
    "model": lambda entry: entry.model,
    "input": of_section("model", "input"),
    "resolution": lambda entry: entry.record.get("resolution"),
    "rays": of_section("rays", "name"),
    "ray_count": of_section("rays", "count"),
    "asked_order": lambda entry: entry.record["rays"].get("order", "auto"),
    "order": of_section("speed", "order"),
    "device": lambda entry: entry.device,
    "clock": of_section("device", "clock"),
    "precision": lambda entry: entry.precision,
    "format": of_section("format", "name"),
    "passes": lambda entry: pass_list(entry.passes),
    "label": of_section("format", "label"),
    "status": lambda entry: entry.record["status"],
    "frontier": frontier,
    "bytes": of_section("volume", "bytes"),
    "bytes_per_voxel": of_section("volume", "bytes_per_voxel", real),
    "level_words": level_words,
    "mrays_per_s": of_speed("median"),
    "slowest_mrays_per_s": of_speed("min"),
    "fastest_mrays_per_s": of_speed("max"),
    "rounds": of_section("speed", "rounds"),
    "steady": lambda entry: None if entry.speed is None else "yes" if entry.is_steady else "no",
    "lookups_per_ray": of_section("work", "steps_per_ray", real),
    "words_per_ray": of_section("work", "words_per_ray", real),
    "checked_rays": of_section("error", "rays"),
    "missed": of_section("error", "missed"),
    "ghost": of_section("error", "ghost"),
    "wrong": of_section("error", "wrong"),
    "build_seconds": of_section("build", "build_seconds", real),
    "build_cpu_seconds": of_section("build", "build_cpu_seconds", real),
    "peak_rss_bytes": of_section("build", "peak_rss_bytes"),
    "predicted_words": of_section("predicted", "words"),
    "predicted_mrays_per_s": of_section("predicted", "mrays_per_s", real),
    "failure": of_section("failure", "reason"),
    "build": lambda entry: build_command(entry.record),
}


def answered(catalogue, entry):
    """The questions that a format answers in the verdicts of searches: "smallest; balanced"."""
    return "; ".join(question for verdict in catalogue.verdicts for question in verdict.answered(entry.record["cell"]))


def to_csv(catalogue):
    """A line of headings and one for each cell. Figures are in the units that their headings say."""
    file = io.StringIO(newline="")
    writer = csv.writer(file, lineterminator="\r\n")
    writer.writerow([*COLUMNS, "verdict"])
    for entry in catalogue.entries:
        writer.writerow([*(text_of(value(entry)) for value in COLUMNS.values()), answered(catalogue, entry)])
    return file.getvalue()
