"""Where the Python module voxc comes from, and how what it raises becomes a report of Blender's."""
import contextlib
import os
import sys
import warnings

import bpy
from mathutils import Matrix

# voxc's +y is up, as in glTF; Blender's is +z: (x, y, z) of voxc is (x, -z, y) of Blender. A rotation, so that what faces outwards goes on to.
TO_BLENDER = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))


class Refused(Exception):
    """What cannot be done, in one sentence for the user."""


class Preferences(bpy.types.AddonPreferences):
    bl_idname = __package__
    folder: bpy.props.StringProperty(
        name="Folder of the module", subtype="DIR_PATH",
        description="The folder that has the Python module voxc, if Blender's own Python does not find it: that of a virtual environment's "
                    "packages, where the wheel was installed, or lib/python3/dist-packages of an installation")

    def draw(self, context):
        self.layout.prop(self, "folder")


def voxc():
    """The module, looked for when it is first needed, so that the add-on can be switched on, and told the folder, without it."""
    addon = bpy.context.preferences.addons.get(__package__)
    folder = bpy.path.abspath(addon.preferences.folder) if addon else ""
    if folder and folder not in sys.path:
        sys.path.append(folder)
    try:
        import voxc
    except (ImportError, OSError) as reason:
        raise Refused(f"the Python module voxc is not found ({reason}); install its wheel for Blender's Python, "
                      "or name its folder in the preferences of this add-on") from None
    return voxc


@contextlib.contextmanager
def reporting(operator):
    """What goes wrong within becomes a report of an operator, and what the module warns of a warning. `operator.result` is what its `execute` returns."""
    operator.result = {"CANCELLED"}
    try:
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            yield
            operator.result = {"FINISHED"}
        for warning in told:
            if warning.category.__name__ == "InputWarning":
                operator.report({"WARNING"}, str(warning.message))
    except KeyboardInterrupt:
        operator.report({"WARNING"}, "stopped")
    except (Refused, ValueError, TypeError, OSError, RuntimeError, MemoryError) as reason:
        operator.report({"ERROR"}, str(reason) or "out of memory")
    except Exception as reason:  # voxc.Error, which is not imported where the module is not found.
        if type(reason).__module__ != "voxc":
            raise
        operator.report({"ERROR"}, str(reason))


@contextlib.contextmanager
def progress(context):
    """A function for `progress=` of the module, which moves Blender's pointer."""
    context.window_manager.progress_begin(0, 1)
    try:
        yield lambda stage, fraction, done: context.window_manager.progress_update(min(max(fraction, 0), 1))
    finally:
        context.window_manager.progress_end()


def path_of(text):
    """A path of a property, which may begin with // for the folder of the .blend file."""
    return os.path.abspath(bpy.path.abspath(text))


def register():
    bpy.utils.register_class(Preferences)


def unregister():
    bpy.utils.unregister_class(Preferences)
