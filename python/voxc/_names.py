"""Names of options: what there is none of is told with the function that was called, and with names near to it."""
import difflib


def refuse_unknown(function, given, known):
    """TypeError for the first of these names that the function does not know."""
    for name in given:
        if name not in known:
            near = difflib.get_close_matches(name, known, 1)
            raise TypeError(f"{function} has no option {name}; " + (f"did you mean {near[0]}?" if near else f"there are {', '.join(known)}"))
