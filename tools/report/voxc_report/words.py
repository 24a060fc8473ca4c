"""Sentences about cells that several sections say."""
from .catalogue import Errors
from .frontier import Place
from .markup import text_tag
from .passes import pass_list
from .speeds import are_equal, speed_unit
from .text import bytes_text, count_text, number_text, percent_text, plural


def counts(errors):
    return (f"missed {count_text(errors.missed)}, ghost {count_text(errors.ghost)}, wrong {count_text(errors.wrong)} of "
            f"{count_text(errors.rays)} rays")


def frame_words(entry):
    """How long a picture takes on a device that counts its own time."""
    rays = entry.record["rays"]
    if not entry.has_clock or rays["kind"] != "camera":
        return ""
    return f", {number_text(rays['count'] / entry.speed.median / 1000)} ms a picture"


def speed_words(entry):
    """"1.23 Mrays/CPU s, spread 2.1 %", with a warning if it was not steady."""
    if entry.speed is None:
        return "no speed"
    return (f"{number_text(entry.speed.median)} {speed_unit(entry.has_clock)}{frame_words(entry)}, spread "
            f"{percent_text(entry.speed.spread)}{'' if entry.is_steady else ' (not steady)'}")


def error_words(entry):
    return counts(entry.errors) if entry.errors else "errors were not checked"


def whole_name(entry):
    """"G(8), with whole-level-dedup, restart-sv"."""
    return entry.look.name + (", with " + pass_list(entry.passes) if entry.passes else ", without passes")


def standing_words(catalogue, entry):
    """How an entry stands to the frontier: "Beaten by G(8), 1.30× as fast at 0.800× the size"."""
    rival = catalogue.rival_of(entry)
    if entry.standing.place is Place.LEADING:
        return "On the frontier"
    if entry.standing.place is Place.AS_GOOD:
        return f"As good as {rival.name}, on the frontier"
    is_as_fast = are_equal(rival.speed, entry.speed)
    speed = "as fast" if is_as_fast else f"{number_text(rival.speed.median / entry.speed.median)}× as fast"
    size = "the same size" if rival.size == entry.size else f"{number_text(rival.size / entry.size)}× the size"
    return f"Beaten by {rival.name}, {speed} at {size}"


def point_note(catalogue, entry):
    """What is shown of a point: a line each for its name, size, speed, errors, work and standing."""
    per_voxel = entry.record["volume"].get("bytes_per_voxel")
    lookups = entry.record["work"].get("steps_per_ray")
    lines = [entry.name,
             bytes_text(entry.size) + ("" if per_voxel is None else f", {number_text(per_voxel)} bytes a voxel"),
             speed_words(entry), error_words(entry),
             "" if lookups is None else f"{number_text(lookups)} lookups a ray",
             standing_words(catalogue, entry)]
    return "\n".join(filter(None, lines))


def side_text(resolution):
    """"2048³" for a side, or nothing if it is not known."""
    return f"{min(resolution, 10**15)}³" if resolution > 0 else ""


def resolution_title(stage):
    """"inside, 2048³": the rays, where a model has several, and the side."""
    rays = "" if stage.column == stage.model else stage.column[len(stage.model) + 2:] + ", "
    return rays + side_text(stage.resolution)


def stage_title(stage):
    """"2048³ on llvmpipe, exact steps", with the rays likewise."""
    return f"{resolution_title(stage)} on {stage.device}" + (f", {stage.precision} steps" if stage.precision else "")


def common_words(passes, has_others):
    """The passes of most cells, and whether names say of others."""
    return (pass_list(passes) or "no passes") + (", unless a name says otherwise" if has_others else "")


def stage_conditions(stage):
    """"1,440,000 rays of camera inside; whole-level-dedup, unless a name says otherwise"."""
    rays = stage.entries[0].record["rays"]
    camera = f" of camera {rays['name']}" if rays["kind"] == "camera" else ""
    return f"{count_text(rays['count'])} rays{camera}; {common_words(stage.common_passes, stage.has_other_passes)}"


def error_summary(entries):
    """The errors of all these entries in one clause."""
    points = [entry for entry in entries if entry.has_point]
    checked = [entry.errors for entry in points if entry.errors]
    words = []
    if total := Errors(*map(sum, zip(*checked))) if checked else None:
        words += [counts(total) + " checked"] if total.rays > 0 else []
    if len(checked) < len(points):
        words.append(plural(len(points) - len(checked), "speed") + " with errors unchecked")
    return "; ".join(words)


def list_names(names, most):
    """At most so many names, as HTML: "G(8), R(4³) G(7) and 3 more"."""
    text = ", ".join(text_tag("span", {"class": "name"}, name) for name in names[:most])
    return text + (f" and {count_text(len(names) - most)} more" if len(names) > most else "")
