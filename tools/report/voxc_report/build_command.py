"""The command that builds the volume of a cell, from what its record says."""
import re

# Options that say how an input becomes voxels; all but --crop have a value.
INPUT_OPTIONS = {"--resolution", "--voxel-size", "--unit", "--align", "--bounds", "--up", "--coverage", "--colour", "--threshold",
                 "--colour-map", "--window", "--volume", "--grid", "--interior", "--fill-colour"}
CROP = "--crop"
PLAIN_WORD = re.compile(r"[A-Za-z0-9\-_.,:/=+@]+")
WORD = re.compile(r"(?:'[^']*'?|[^ '])+")


def shell_word(word):
    """A word as a shell takes it for one."""
    return word if PLAIN_WORD.fullmatch(word) else "'" + word.replace("'", "'\\''") + "'"


def words_of(command):
    """The words of a command, of which some stand in single quotes."""
    return [word.replace("'", "") for word in WORD.findall(command)]


def option_name(option):
    return option.split("=")[0]


def input_options(words):
    """The options of inputs among a command's words; values that follow one another as the same option are one."""
    options, rest = [], iter(words)
    for word in rest:
        name, equals, _ = word.partition("=")
        if word == CROP or (name in INPUT_OPTIONS and equals):
            options.append(word)
        elif name in INPUT_OPTIONS and (value := next(rest, None)) is not None:
            if options and options[-1].startswith(name + "="):
                options[-1] += "," + value
            else:
                options.append(f"{name}={value}")
    return options


def split_model(word, model):
    """A word as the model's argument, "NAME=INPUT OPTION...": the input and the words of the options; None if it is not that."""
    end = word.find(" --")
    given, options = (word, "") if end < 0 else (word[:end], word[end:])
    given = given.removeprefix(model["name"] + "=")
    if not model["input"] or given.split("/")[-1] != model["input"]:
        return None
    return given, words_of(options)


def find_model(record):
    """The input as the command named it, and its options: its own, and those of the whole command that they do not replace."""
    words = words_of(record["made_by"]["command"])
    common = input_options(words)
    named = [word for word in words if word.startswith(record["model"]["name"] + "=")]
    others = [word for word in words if "=" not in word.split("/")[0]]
    for word in [*named, *others, *words]:  # Models of several names can be files of one.
        if found := split_model(word, record["model"]):
            own = input_options(found[1])
            replaced = set(map(option_name, own))
            return found[0], [option for option in common if option_name(option) not in replaced] + own
    return record["model"]["input"], common


def no_option(word):
    """A word that a command takes for a path, whatever it begins with."""
    return "./" + word if word.startswith("-") else word


def build_command(record):
    """"voxc build 'R(4^3) G(7)' sponza.obj --whole-level-dedup -o sponza.hvx"."""
    given, options = find_model(record)
    passes = ["--" + name for name in record["format"]["passes"]]
    words = [record["format"]["name"], no_option(given), *options, *passes]
    return " ".join(["voxc build", *map(shell_word, words), "-o", shell_word(no_option(record["model"]["name"] + ".hvx"))])
