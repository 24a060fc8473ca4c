#!/usr/bin/env python3
"""voxc accuracy: draws the plots of its figures."""
import sys

from voxc_report.start import start

sys.exit(start("accuracy"))
