"""Introduction and method: what is compared, how it was measured, on what, and by which commands."""
from ..catalogue import different
from ..markup import escaped, fill, read_page, tag, text_tag
from ..text import count_text, percent_text, plural
from ..words import error_summary


def joined(*words):
    """What is neither empty nor was said just before."""
    kept = []
    for word in words:
        if word and not ", ".join(kept).endswith(word):
            kept.append(word)
    return ", ".join(kept)


def counted(count, noun):
    return "" if count is None else plural(count, noun)


def device_item(entry):
    device = entry.record["device"]
    if not device["name"]:
        return ""
    words = joined("" if device["kind"] == device["name"] else device["kind"], device["driver"],
                   counted(device.get("threads"), "thread"),
                   "speeds by its own timestamps" if entry.has_clock else "speeds by CPU seconds of the process")
    return text_tag("b", {}, device["name"]) + " " + escaped(words)


def maker_item(entry):
    maker = entry.record["made_by"]
    return escaped(joined(maker["voxc"], maker["llvm"] and "LLVM " + maker["llvm"], maker["processor"],
                          counted(maker.get("cores"), "core")))


def command_item(entry):
    command = entry.record["made_by"]["command"]
    return command and text_tag("code", {}, command)


def rays_item(entry):
    rays, order = entry.record["rays"], entry.record["speed"].get("order")
    if not rays["name"]:
        return ""
    words = f"{count_text(rays['count'])} rays of a {'camera' if rays['kind'] == 'camera' else 'file'}"
    if "size" in rays:
        words += f", {rays['size'][0]} × {rays['size'][1]} pixels"
    if order is not None:
        words += ", taken bin by bin" if order == "binned" else ", taken as given"
    return text_tag("b", {}, rays["name"]) + " " + escaped(words)


def steadiness(catalogue):
    """How far the speeds can be trusted, from what the records say of themselves."""
    points = [entry for entry in catalogue.entries if entry.has_point]
    unsteady = sum(not entry.is_steady for entry in points)
    widest = max((entry.speed.spread for entry in points), default=0)
    how = (f"{count_text(unsteady)} of them are not steady: wider than their commands state" if unsteady
           else "all are within the spread that their commands state")
    return f"{plural(len(points), 'speed')}, the widest spread {percent_text(widest)}; {how}"


def introduction_section(catalogue):
    failed = sum(not entry.is_measured for entry in catalogue.entries)
    return fill("section/introduction.html", models=plural(len(catalogue.models), "model"),
                formats=plural(catalogue.formats, "format"), cells=plural(len(catalogue.entries), "measurement"),
                failed=f"{count_text(failed)} of them failed" if failed else "none failed",
                devices=escaped(joined(*catalogue.devices)), marks=read_page("marks.html"))


def method_section(catalogue):
    items = {}
    for name, item in (("devices", device_item), ("makers", maker_item), ("rays", rays_item), ("commands", command_item)):
        items[name] = "".join(tag("li", {}, text) for text in different(map(item, catalogue.entries)) if text)
    return fill("section/method.html", **items, steadiness=escaped(steadiness(catalogue)),
                errors=escaped(error_summary(catalogue.entries)))
