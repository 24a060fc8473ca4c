#!/usr/bin/env python3
"""voxc bench report: makes the page of records."""
import sys

from voxc_report.start import start

sys.exit(start("main"))
