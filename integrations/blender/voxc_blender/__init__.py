"""voxc in Blender: volumes of voxels are imported as meshes or as Blender's volumes, and meshes exported to volumes (docs/blender.md)."""
bl_info = {
    "name": "voxc: hybrid voxel formats",
    "description": "Import and export voxels in compressed formats that rays go through fast",
    "author": "the authors of voxc",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "File > Import and Export; 3D View > Sidebar > voxc",
    "category": "Import-Export",
}

from . import exporting, importing, module, panel, searching  # noqa: E402

PARTS = (module, importing, exporting, searching, panel)


def register():
    for part in PARTS:
        part.register()


def unregister():
    for part in reversed(PARTS):
        part.unregister()
