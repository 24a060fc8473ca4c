"""The panel in the sidebar of the 3D view: a search of formats, its rows, and what the next export takes."""
import bpy

from .exporting import ExportVolume
from .searching import SearchFormat


class Rows(bpy.types.UIList):
    bl_idname = "VOXC_UL_rows"

    def draw_item(self, context, layout, data, item, icon, active_data, active_property, index):
        split = layout.split(factor=0.6)
        split.label(text=item.format)
        split.label(text=bytes_text(item.bytes))
        split.label(text=f"{item.rays / 1e6:.1f} M/s")


class Panel(bpy.types.Panel):
    bl_idname = "VOXC_PT_formats"
    bl_label = "Voxels"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "voxc"

    def draw(self, context):
        scene, layout = context.scene, self.layout
        layout.prop(scene.voxc_chosen, "resolution")
        layout.prop(scene.voxc_chosen, "budget")
        layout.operator(SearchFormat.bl_idname, icon="VIEWZOOM")
        if scene.voxc_rows:
            layout.template_list(Rows.bl_idname, "", scene, "voxc_rows", scene, "voxc_row", rows=5)
        layout.prop(scene.voxc_chosen, "format")
        layout.prop(scene.voxc_chosen, "passes")
        layout.operator(ExportVolume.bl_idname, icon="EXPORT")


def bytes_text(count):
    for unit in ("B", "KiB", "MiB"):
        if count < 1024:
            return f"{count:.3g} {unit}"
        count /= 1024
    return f"{count:.3g} GiB"


def register():
    bpy.utils.register_class(Rows)
    bpy.utils.register_class(Panel)


def unregister():
    bpy.utils.unregister_class(Panel)
    bpy.utils.unregister_class(Rows)
