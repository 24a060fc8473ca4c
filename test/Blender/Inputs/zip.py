"""Installs the zip file that lies in a folder, and says where it went and what an import says without the module."""
import glob
import os
import sys

import bpy

folder = sys.argv[sys.argv.index("--") + 1]
[package] = glob.glob(os.path.join(folder, "*.zip"))
bpy.ops.preferences.addon_install(filepath=package)
bpy.ops.preferences.addon_enable(module="voxc_blender")
print("installed:", os.path.dirname(sys.modules["voxc_blender"].__file__))
open(os.path.join(folder, "some.hvx"), "wb").close()
sys.modules["voxc"] = None  # As where it is not installed, whatever this machine has.
try:
    bpy.ops.import_scene.voxc_mesh(filepath=os.path.join(folder, "some.hvx"))
except RuntimeError as reason:
    print("refused:", str(reason).strip())
