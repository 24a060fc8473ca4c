"""The operators that import volumes of voxels: as a mesh, or as a volume of Blender's."""
import os
import tempfile

import bpy
import numpy as np
from bpy_extras.io_utils import ImportHelper
from mathutils import Matrix

from . import faces, grids
from .module import Refused, TO_BLENDER, path_of, reporting, voxc


class VoxelFile(ImportHelper):
    """What both operators ask of a file."""
    filename_ext = ".hvx"
    filter_glob: bpy.props.StringProperty(
        default="*.hvx;*.vox;*.nvdb;*.vdb;*.nrrd;*.nhdr;*.nii;*.nii.gz;*.npy;*.npz;*.las;*.vti;*.schem;*.litematic;*.schematic;*.binvox;"
                "*.ply;*.obj;*.stl;*.glb;*.gltf;*.tif;*.tiff", options={"HIDDEN"})
    resolution: bpy.props.IntProperty(
        name="Resolution", default=0, min=0, max=1 << 16,
        description="Voxels on the longest axis, of files that are no voxels yet, such as meshes; 0: as voxc has it")

    def volume(self, context):
        """The volume of the file: that of a .hvx file itself, else one that is built of it."""
        path = path_of(self.filepath)
        if not os.path.isfile(path):
            raise Refused(f"'{path}' is no file")
        if path.lower().endswith(".hvx"):
            return voxc().Volume.load(path)
        options = {"resolution": self.resolution} if self.resolution else {}
        return voxc().build("auto", path, **options)

    def title(self):
        return bpy.path.display_name_from_filepath(self.filepath) or "voxels"


class ImportMesh(bpy.types.Operator, VoxelFile):
    """Import voxels as a mesh of their visible faces, with a colour attribute"""
    bl_idname = "import_scene.voxc_mesh"
    bl_label = "Import voxels as a mesh"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        with reporting(self):
            volume = self.volume(context)
            points = volume.points()
            corners, colours = faces.rectangles_of(points.places, faces.colours_of(points))
            if len(corners) == 0:
                raise Refused(f"'{self.filepath}' has no voxels")
            place(context, mesh_of(self.title(), corners, colours), self.title(), matrix_of(volume))
            self.report({"INFO"}, f"{volume.voxels:,} voxels, {len(corners):,} faces")
        return self.result


class ImportVolume(bpy.types.Operator, VoxelFile):
    """Import voxels as a volume of Blender's: OpenVDB grids of density and colour, in a file beside"""
    bl_idname = "import_scene.voxc_volume"
    bl_label = "Import voxels as a volume"
    bl_options = {"REGISTER", "UNDO"}
    grid_path: bpy.props.StringProperty(
        name="OpenVDB file", subtype="FILE_PATH",
        description="The file that gets the grids, which Blender reads whenever it opens the scene; empty: the name of the volume with .vdb")
    overwrite: bpy.props.BoolProperty(name="Overwrite", description="Replace an OpenVDB file of that name")

    def execute(self, context):
        with reporting(self):
            path = path_of(self.grid_path) if self.grid_path else os.path.splitext(path_of(self.filepath))[0] + ".vdb"
            if os.path.exists(path) and not self.overwrite:
                raise Refused(f"'{path}' is there already; switch on Overwrite, or name another OpenVDB file")
            volume = self.volume(context)
            if volume.voxels == 0:
                raise Refused(f"'{self.filepath}' has no voxels")
            with tempfile.TemporaryDirectory(dir=os.path.dirname(path)) as scratch:
                new = os.path.join(scratch, "grids.vdb")
                grids.write(volume, new)
                os.replace(new, path)
            data = bpy.data.volumes.new(self.title())
            data.filepath = path
            # The grids' own transform leads to the model, whose +y is up.
            place(context, data, self.title(), TO_BLENDER)
            self.report({"INFO"}, f"{volume.voxels:,} voxels in '{path}'")
        return self.result


def matrix_of(volume):
    """The matrix from voxels to Blender's space, where the model was."""
    rows = volume.to_model
    return TO_BLENDER @ Matrix([*map(list, rows), [0, 0, 0, 1]])


def mesh_of(name, corners, colours):
    """A mesh with corners in voxels, shared where faces meet, and a colour for each corner of a face."""
    vertices, indices = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    count = len(corners)
    mesh = bpy.data.meshes.new(name)
    mesh.vertices.add(len(vertices))
    mesh.vertices.foreach_set("co", vertices.astype(np.float32).ravel())
    mesh.loops.add(4 * count)
    mesh.loops.foreach_set("vertex_index", indices.astype(np.int32).ravel())
    mesh.polygons.add(count)
    mesh.polygons.foreach_set("loop_start", np.arange(0, 4 * count, 4, dtype=np.int32))
    if bpy.app.version < (4, 0, 0):  # Later it is told by loop_start.
        mesh.polygons.foreach_set("loop_total", np.full(count, 4, np.int32))
    mesh.update(calc_edges=True)
    attribute = mesh.color_attributes.new("Color", "BYTE_COLOR", "CORNER")
    attribute.data.foreach_set("color_srgb", (np.repeat(colours, 4, axis=0) / np.float32(255)).ravel())
    mesh.color_attributes.active_color = attribute
    mesh.materials.append(material_of(attribute.name, bool((colours[:, 3] < 255).any())))
    return mesh


def material_of(attribute, is_translucent):
    """A material that shows a colour attribute."""
    material = bpy.data.materials.new("voxels")
    material.use_nodes = True
    # The nodes that it has by now are those of the kind of object that is active.
    nodes = material.node_tree.nodes
    nodes.clear()
    colour, surface, output = (nodes.new("ShaderNode" + kind) for kind in ("VertexColor", "BsdfPrincipled", "OutputMaterial"))
    colour.layer_name = attribute
    colour.location, output.location = (-300, 0), (300, 0)
    material.node_tree.links.new(surface.outputs["BSDF"], output.inputs["Surface"])
    material.node_tree.links.new(colour.outputs["Color"], surface.inputs["Base Color"])
    if is_translucent:
        material.node_tree.links.new(colour.outputs["Alpha"], surface.inputs["Alpha"])
        material.blend_method = "BLEND"
    return material


def place(context, data, name, matrix):
    """A new object of a mesh or a volume, selected alone."""
    made = bpy.data.objects.new(name, data)
    made.matrix_world = matrix
    context.collection.objects.link(made)
    for other in context.selected_objects:
        other.select_set(False)
    made.select_set(True)
    context.view_layer.objects.active = made


def menu(self, context):
    self.layout.operator(ImportMesh.bl_idname, text="Voxels as a mesh (.hvx, .vox, ...)")
    self.layout.operator(ImportVolume.bl_idname, text="Voxels as a volume (.hvx, .vox, ...)")


def register():
    bpy.utils.register_class(ImportMesh)
    bpy.utils.register_class(ImportVolume)
    bpy.types.TOPBAR_MT_file_import.append(menu)


def unregister():
    bpy.types.TOPBAR_MT_file_import.remove(menu)
    bpy.utils.unregister_class(ImportVolume)
    bpy.utils.unregister_class(ImportMesh)
