#!/usr/bin/env python3
"""Starts the plots of voxc accuracy, as bench-report.py starts the report."""
import sys

MISSING = 69

try:
    from voxc_report.accuracy import main
except ModuleNotFoundError as error:
    print(error.name.split(".")[0], file=sys.stderr)
    sys.exit(MISSING)

if __name__ == "__main__":
    sys.exit(main())
