#!python
"""voxc: becomes the program of that name which lies in the package voxc."""
import importlib.util
import os
import sys

program = os.path.join(importlib.util.find_spec("voxc").submodule_search_locations[0], "bin", "voxc")
os.execv(program, [program, *sys.argv[1:]])
