"""The operator that searches a format for the selected meshes, and the rows that it finds."""
import bpy

from .exporting import model_of_selection
from .module import reporting, voxc


class Row(bpy.types.PropertyGroup):
    """A format, and what is predicted or was measured of it."""
    format: bpy.props.StringProperty()
    passes: bpy.props.StringProperty()
    bytes: bpy.props.FloatProperty(description="Bytes of the volume")
    rays: bpy.props.FloatProperty(description="Rays of a camera a second")
    chosen: bpy.props.BoolProperty(description="What voxc would take")


class Chosen(bpy.types.PropertyGroup):
    """What the next export takes."""
    format: bpy.props.StringProperty(name="Format")
    passes: bpy.props.StringProperty(name="Passes")
    resolution: bpy.props.IntProperty(name="Resolution", default=128, min=1, max=1 << 16)
    budget: bpy.props.IntProperty(name="Measure for", default=0, min=0, description="Seconds in which formats are built and measured; 0: foretell alone")


class SearchFormat(bpy.types.Operator):
    """Look which formats are small and fast for the selected meshes"""
    bl_idname = "voxc.search_format"
    bl_label = "Search a format"

    def execute(self, context):
        scene = context.scene
        with reporting(self), model_of_selection(context) as model:
            options = dict(resolution=scene.voxc_chosen.resolution)
            if scene.voxc_chosen.budget:
                rows = measured(voxc().search(model, budget=scene.voxc_chosen.budget, **options))
            else:
                rows = predicted(voxc().suggest(model, **options))
            scene.voxc_rows.clear()
            for found in sorted(rows, key=lambda row: row["bytes"]):
                row = scene.voxc_rows.add()
                for name, value in found.items():
                    setattr(row, name, value)
            scene.voxc_row = next((index for index, row in enumerate(scene.voxc_rows) if row.chosen), 0)
        return self.result


def predicted(rows):
    """The rows that no other beats, and the one that is named."""
    return [dict(format=row["format"], passes=row["passes"], bytes=row["bytes"], rays=row["camera_rays_per_second"], chosen=row["chosen"])
            for row in rows if row["frontier"] or row["chosen"]]


def take_row(scene, context):
    """The next export takes the format of the row that is active."""
    if 0 <= scene.voxc_row < len(scene.voxc_rows):
        row = scene.voxc_rows[scene.voxc_row]
        scene.voxc_chosen.format, scene.voxc_chosen.passes = row.format, row.passes


def measured(rows):
    """The rows that no other beats; of their kinds of rays the slowest counts."""
    sets = [name for name in rows[0] if name.endswith("_predicted_rays_per_second")]
    speeds = [name.replace("_predicted", "") for name in sets]
    return [dict(format=row["format"], passes=row["passes"], bytes=row["bytes"], rays=min(row[speed] for speed in speeds), chosen=row["chosen"])
            for row in rows if row["frontier"]]


def register():
    for kind in (Row, Chosen, SearchFormat):
        bpy.utils.register_class(kind)
    bpy.types.Scene.voxc_rows = bpy.props.CollectionProperty(type=Row)
    bpy.types.Scene.voxc_chosen = bpy.props.PointerProperty(type=Chosen)
    bpy.types.Scene.voxc_row = bpy.props.IntProperty(update=take_row)


def unregister():
    del bpy.types.Scene.voxc_row, bpy.types.Scene.voxc_chosen, bpy.types.Scene.voxc_rows
    for kind in (SearchFormat, Chosen, Row):
        bpy.utils.unregister_class(kind)
