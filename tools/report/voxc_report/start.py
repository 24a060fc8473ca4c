"""Starting a program of this package: what it needs may be missing, and what Matplotlib says of itself is of no use here."""
import importlib
import logging
import sys
import warnings

# The exit code by which voxc knows that a module is missing; its name is the last line of standard error.
MISSING = 69


def start(module):
    """Runs `main` of a module, and returns the exit code."""
    logging.getLogger("matplotlib").setLevel(logging.ERROR)
    warnings.simplefilter("ignore")
    try:
        return importlib.import_module("voxc_report." + module).main()
    except ModuleNotFoundError as error:
        print(error.name.split(".")[0], file=sys.stderr)
        return MISSING
