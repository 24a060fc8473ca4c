#!/usr/bin/env python3
"""Starts the report of voxc bench; voxc runs it with the folder that it lies in beside it."""
import sys

MISSING = 69

try:
    from voxc_report.main import main
except ModuleNotFoundError as error:
    print(error.name.split(".")[0], file=sys.stderr)
    sys.exit(MISSING)

if __name__ == "__main__":
    sys.exit(main())
