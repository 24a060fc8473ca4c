"""Names of devices: as short as still keeps them apart."""
from .text import count_text


def short_name(record):
    return record["device"]["name"].split(" (")[0]


def whole_name(record):
    return record["device"]["name"]


def with_threads(record):
    threads = record["device"].get("threads")
    return whole_name(record) + ("" if threads is None else f", {count_text(threads)} threads")


def with_processor(record):
    return ", ".join(filter(None, [with_threads(record), record["made_by"]["processor"]]))


def with_driver(record):
    return ", ".join(filter(None, [with_processor(record), record["device"]["driver"]]))


# From short to long; the last tells apart what can be told apart.
NAMINGS = [short_name, whole_name, with_threads, with_processor, with_driver]


def device_names(records):
    """For each record what its device is called."""
    devices = len({with_driver(record) for record in records})
    for naming in NAMINGS:
        names = [naming(record) for record in records]
        if len(set(names)) == devices:
            return names
    return []
