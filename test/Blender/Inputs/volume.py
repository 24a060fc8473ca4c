"""A volume becomes OpenVDB grids in Blender, cell by cell and in its place; and colours of vertices and textures become voxels. Run as round.py is."""
import os
import sys

import bpy
import numpy as np
import pyopenvdb

source, program, folder = sys.argv[sys.argv.index("--") + 1:]
sys.path.insert(0, os.path.join(source, "integrations", "blender"))
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.preferences.addon_enable(module="voxc_blender")
import voxc  # noqa: E402


def path(name):
    return os.path.join(folder, name)


def linear(colours):
    value = colours / 255.0
    return np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)


def corners_of(made):
    """The least and the greatest corner of an object's box in the world, as Blender has it."""
    evaluated = made.evaluated_get(bpy.context.evaluated_depsgraph_get())
    corners = np.array([(made.matrix_world @ type(made.location)(corner))[:] for corner in evaluated.bound_box])
    return np.array([corners.min(axis=0), corners.max(axis=0)])


def coloured_voxels(material_of):
    """The colours of the voxels of a triangle with a colour at each corner, or with a texture."""
    mesh = bpy.data.meshes.new("triangle")
    mesh.from_pydata([(0, 0, 0), (4, 0, 0), (0, 0, 4)], [], [(0, 1, 2)])
    made = bpy.data.objects.new("triangle", mesh)
    bpy.context.collection.objects.link(made)
    for other in bpy.context.selected_objects:
        other.select_set(False)
    made.select_set(True)
    bpy.context.view_layer.objects.active = made
    mesh.materials.append(material_of(mesh))
    bpy.ops.export_scene.voxc(filepath=path("triangle.hvx"), format="S(5)", resolution=32)
    return voxc.Volume.load(path("triangle.hvx")).points()


def vertex_colours(mesh):
    attribute = mesh.color_attributes.new("Color", "FLOAT_COLOR", "POINT")
    for element, colour in zip(attribute.data, [(1, 0, 0, 1), (0, 1, 0, 1), (0, 0, 1, 1)]):
        element.color = colour
    material = bpy.data.materials.new("corners")
    material.use_nodes = True
    return material


def texture(mesh):
    image = bpy.data.images.new("halves", 2, 1)
    image.pixels = [1, 0, 1, 1, 1, 1, 0, 1]
    layer = mesh.uv_layers.new()
    for element, place in zip(layer.data, [(0.25, 0.5), (0.75, 0.5), (0.25, 0.5)]):
        element.uv = place
    material = bpy.data.materials.new("texture")
    material.use_nodes = True
    node = material.node_tree.nodes.new("ShaderNodeTexImage")
    node.image, node.interpolation = image, "Closest"
    material.node_tree.links.new(node.outputs["Color"], material.node_tree.nodes["Principled BSDF"].inputs["Base Color"])
    return material


# Larger than one box of cells that is copied at a time, and not at the origin of the model.
random = np.random.default_rng(7)
places = np.unique(random.integers(0, (150, 20, 140), (4000, 3)), axis=0)
colours = random.integers(0, 256, (len(places), 4)).astype(np.uint8)
colours[:, 3] = 255
volume = voxc.build("H(5^3) S(3)", places=places, colours=colours)
volume.save(path("points.hvx"))
bpy.ops.import_scene.voxc_volume(filepath=path("points.hvx"))
made = bpy.context.object
assert made.type == "VOLUME" and made.data.grids.load() and {grid.name for grid in made.data.grids} == {"density", "Cd"}
density, colour = pyopenvdb.read(made.data.filepath, "density"), pyopenvdb.read(made.data.filepath, "Cd")
active = {index: value for index, value in ((item.min, item.value) for item in density.citerOnValues() if item.count == 1) if value == 1}
assert active.keys() == set(map(tuple, places.tolist())) and density.activeVoxelCount() == len(places)
accessor = colour.getConstAccessor()
seen = np.array([accessor.getValue(tuple(place)) for place in places.tolist()])
np.testing.assert_allclose(seen, linear(colours[:, :3]), atol=1e-6)
box_of_volume = corners_of(made)
bpy.ops.import_scene.voxc_mesh(filepath=path("points.hvx"))
box_of_mesh = corners_of(bpy.context.object)
# Blender's box of a grid goes from the middle of the first voxel to that of the last, or around whole leaves of 8.
assert np.all(np.abs(box_of_mesh - box_of_volume) <= 8), (box_of_mesh, box_of_volume)
middle = np.array(density.transform.indexToWorld((0, 0, 0)))
np.testing.assert_allclose(middle, volume.to_model @ [0.5, 0.5, 0.5, 1])
print("grids:", len(active), "voxels")

# A file that is there stays, unless it may go.
before = open(path("points.vdb"), "rb").read()
for name, sentence in ("points.hvx", "is there already"), ("none.hvx", "is no file"):
    try:
        bpy.ops.import_scene.voxc_volume(filepath=path(name))
        raise AssertionError("nothing was reported")
    except RuntimeError as reason:
        assert sentence in str(reason), reason
assert open(path("points.vdb"), "rb").read() == before and len(bpy.data.volumes) == 1
bpy.ops.import_scene.voxc_volume(filepath=path("points.hvx"), overwrite=True)
assert len(bpy.data.volumes) == 2
print("kept: a file that was there")

points = coloured_voxels(vertex_colours)
for axis, channel in (0, 1), (1, 2):  # Green to the right, and blue up, which is y of voxels.
    most = points.colours[points.places[:, axis] == points.places[:, axis].max()].astype(int)
    assert np.all(most[:, channel] > 180) and np.all(np.delete(most[:, :3], channel, axis=1) < 120), most
print("colours of vertices:", len(points.places), "voxels")
points = coloured_voxels(texture)
assert set(map(tuple, points.colours.tolist())) == {(255, 0, 255, 255), (255, 255, 0, 255)}
left = points.colours[points.places[:, 0] < 12]
assert np.all(left == (255, 0, 255, 255))
print("a texture:", len(points.places), "voxels")
