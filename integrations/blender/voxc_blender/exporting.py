"""The operator that exports selected meshes as a volume of voxels."""
import contextlib
import io
import os
import tempfile

import bpy
from bpy_extras.io_utils import ExportHelper

from .module import Refused, path_of, progress, reporting, voxc

# What the options of `voxc build` of these names take.
COVERAGES = [("conservative", "Conservative", "All voxels that a triangle touches"), ("thin", "Thin", "Fewer of them"),
             ("inner", "Inner", "Thin, with one where a face lies between two"), ("centre", "Centre", "All whose centre is inside")]
INTERIORS = [("keep", "Keep", "As the meshes are"), ("drop", "Drop", "Leave out what no ray from outside reaches"),
             ("fill", "Fill", "Bodies in place of surfaces")]


@contextlib.contextmanager
def model_of_selection(context):
    """The path of a .glb file, for as long as the context lasts, of the selected meshes as they are seen: with modifiers, where they stand in
    the world, with materials, colours of vertices and textures. glTF's +y is up, as voxc's is."""
    if not any(chosen.type in {"MESH", "CURVE", "SURFACE", "FONT", "META"} for chosen in context.selected_objects):
        raise Refused("no mesh is selected; select what shall become voxels")
    with tempfile.TemporaryDirectory() as scratch:
        path = os.path.join(scratch, "selection.glb")
        with contextlib.redirect_stdout(io.StringIO()):
            bpy.ops.export_scene.gltf(filepath=path, export_format="GLB", use_selection=True, export_apply=True, export_yup=True, export_animations=False,
                                      export_skins=False, export_morph=False, export_cameras=False, export_lights=False)
        yield path


class ExportVolume(bpy.types.Operator, ExportHelper):
    """Export the selected meshes as a volume of voxels"""
    bl_idname = "export_scene.voxc"
    bl_label = "Export voxels"
    filename_ext = ".hvx"
    filter_glob: bpy.props.StringProperty(default="*.hvx", options={"HIDDEN"})
    format: bpy.props.StringProperty(
        name="Format", default="auto",
        description="Levels from the top down, such as R(4^3) G(5), or auto: as voxc suggests; the button in the sidebar searches one")
    passes: bpy.props.StringProperty(name="Passes", description="Passes of the format with blanks between, such as whole-level-dedup")
    resolution: bpy.props.IntProperty(
        name="Resolution", default=128, min=0, max=1 << 16,
        description="Voxels on the longest axis; 0: what the format holds")
    coverage: bpy.props.EnumProperty(name="Coverage", items=COVERAGES, description="Which voxels a mesh has")
    interior: bpy.props.EnumProperty(name="Interior", items=INTERIORS, description="What becomes of the inside")
    compress: bpy.props.BoolProperty(name="Compress", description="About half the bytes on disk")

    def invoke(self, context, event):
        chosen = context.scene.voxc_chosen
        if chosen.format:
            self.format, self.passes, self.resolution = chosen.format, chosen.passes, chosen.resolution
        return super().invoke(context, event)

    def execute(self, context):
        with reporting(self), model_of_selection(context) as model, progress(context) as report:
            options = dict(coverage=self.coverage, interior=self.interior, compress=self.compress, path=path_of(self.filepath))
            if self.resolution:
                options["resolution"] = self.resolution
            if self.format.strip() != "auto":
                options.update(passes=self.passes.replace(",", " ").split(), progress=report)
            volume = voxc().build(self.format, model, **options)
            self.report({"INFO"}, f"{volume.voxels:,} voxels, {volume.bytes:,} bytes, {volume.format}")
        return self.result


def menu(self, context):
    self.layout.operator(ExportVolume.bl_idname, text="Voxels (.hvx)")


def register():
    bpy.utils.register_class(ExportVolume)
    bpy.types.TOPBAR_MT_file_export.append(menu)


def unregister():
    bpy.types.TOPBAR_MT_file_export.remove(menu)
    bpy.utils.unregister_class(ExportVolume)
