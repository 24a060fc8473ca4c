#!/usr/bin/env python3
"""Pictures of a report to look at, in strips: pictures.py REPORT.html FOLDER [WIDTH SCHEME]

Without a width and a scheme: 1280 and 390 pixels, light and dark.
"""
import sys
from pathlib import Path

from browser import Browser

STRIP = 1500


def take(report, folder, width, scheme):
    with Browser(width, 900) as browser:
        browser.prefer(scheme)
        browser.open(report)
        height = browser.evaluate("document.documentElement.scrollHeight")
        for i, top in enumerate(range(0, height, STRIP)):
            browser.picture(folder / f"{width}-{scheme}-{i:02}.png", top, min(STRIP, height - top))


def main():
    report, folder, *choice = sys.argv[1:]
    Path(folder).mkdir(parents=True, exist_ok=True)
    for width in [int(choice[0])] if choice else [1280, 390]:
        for scheme in choice[1:] or ["light", "dark"]:
            take(report, Path(folder), width, scheme)


if __name__ == "__main__":
    main()
