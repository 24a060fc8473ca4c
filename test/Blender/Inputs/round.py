"""A coloured object is exported, and comes back as the mesh and as the volume of what the program says. Run by Blender: blender -b -P round.py -- SOURCE VOXC FOLDER"""
import os
import subprocess
import sys

import bpy
import numpy as np

source, program, folder = sys.argv[sys.argv.index("--") + 1:]
sys.path.insert(0, os.path.join(source, "integrations", "blender"))
bpy.ops.preferences.addon_enable(module="voxc_blender")
import voxc  # noqa: E402


def path(name):
    return os.path.join(folder, name)


def command(*words):
    subprocess.run([program, *words, "--quiet"], check=True, stdout=subprocess.DEVNULL)


def cells(volume):
    """Voxels as a table of places to colours, from where the program lists them."""
    volume.save(path("listed.hvx"))
    command("export", path("listed.hvx"), "-o", path("listed.raw"))
    words = np.fromfile(path("listed.raw"), "<u4").reshape(volume.extent[::-1])
    return {(x, y, z): int(words[z, y, x]) for z, y, x in zip(*map(np.ndarray.tolist, words.nonzero()))}


def coloured_object():
    """A box, off the origin, turned, taller than wide, with a modifier, faces of three colours, and a parent that is not selected."""
    bpy.ops.mesh.primitive_cube_add(size=2)
    box = bpy.context.object
    box.location, box.scale, box.rotation_euler = (3, -2, 5), (1, 2, 4), (0, 0, 0.3)
    box.parent = bpy.data.objects.new("parent", None)
    box.parent.location, box.parent.scale = (1, 20, -3), (2, 2, 2)
    bpy.context.collection.objects.link(box.parent)
    array = box.modifiers.new("two", "ARRAY")
    array.relative_offset_displace = (1.5, 0, 0)
    for index, colour in enumerate([(1, 0, 0, 1), (0, 1, 0, 1), (0.1, 0.2, 1, 1)]):
        material = bpy.data.materials.new(f"m{index}")
        material.use_nodes = True
        material.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = colour
        box.data.materials.append(material)
    for index, polygon in enumerate(box.data.polygons):
        polygon.material_index = index % 3
    return box


def faces_of(mesh):
    """Each face of a cell that a mesh covers: (axis, side, cell) to its colour as a word. A face that is covered twice fails."""
    covered = {}
    colours = np.empty(4 * len(mesh.loops), np.float32)
    mesh.color_attributes["Color"].data.foreach_get("color_srgb", colours)
    colours = np.rint(colours.reshape(-1, 4) * 255).astype(np.uint32)
    for polygon in mesh.polygons:
        corners = np.array([mesh.vertices[index].co[:] for index in polygon.vertices])
        low, high = corners.min(axis=0).astype(int), corners.max(axis=0).astype(int)
        axis = int(np.argmax(np.abs(polygon.normal)))
        side = 1 if polygon.normal[axis] > 0 else -1
        assert np.isclose(polygon.normal[axis], side), polygon.normal
        high[axis] = low[axis] + 1
        shift = np.zeros(3, int)
        shift[axis] = -1 if side > 0 else 0
        seen = {tuple(colours[loop]) for loop in polygon.loop_indices}
        assert len(seen) == 1, seen
        red, green, blue, alpha = map(int, seen.pop())
        for cell in np.ndindex(*(high - low)):
            face = axis, side, tuple((low + cell + shift).tolist())
            assert face not in covered, face
            covered[face] = red | green << 8 | blue << 16 | alpha << 24
    return covered


def visible_faces(voxels):
    found = {}
    for cell, word in voxels.items():
        for axis in range(3):
            for side in (-1, 1):
                beside = tuple(number + (side if number_axis == axis else 0) for number_axis, number in enumerate(cell))
                if beside not in voxels:
                    found[axis, side, cell] = word
    return found


def refusal(operator, **options):
    """What an operator reports as an error; data of Blender's must be as they were."""
    kinds = (bpy.data.objects, bpy.data.meshes, bpy.data.volumes, bpy.data.materials)
    before = [sorted(item.name for item in kind) for kind in kinds]
    try:
        operator(**options)
    except RuntimeError as reason:
        assert "Traceback" not in str(reason), reason
        assert before == [sorted(item.name for item in kind) for kind in kinds], reason
        return str(reason).strip()
    raise AssertionError("nothing was reported")


def bounds(made):
    points = [made.matrix_world @ vertex.co for vertex in made.data.vertices]
    return np.array([[f(point[axis] for point in points) for axis in range(3)] for f in (min, max)])


bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.preferences.addon_enable(module="voxc_blender")

# Out: the voxels are those of the program for what Blender's own exporter writes.
box = coloured_object()
bpy.ops.export_scene.voxc(filepath=path("box.hvx"), format="R(3^3) G(3)", passes="whole-level-dedup", resolution=40)
bpy.ops.export_scene.gltf(filepath=path("box.glb"), use_selection=True, export_apply=True)
command("build", "R(3^3) G(3)", path("box.glb"), "--resolution", "40", "-o", path("program.hvx"))
volume = voxc.Volume.load(path("box.hvx"))
voxels = cells(volume)
assert voxels == cells(voxc.Volume.load(path("program.hvx")))
assert len(set(voxels.values())) >= 3 and np.argmax(np.ptp(list(voxels), axis=0)) == 1, volume.extent
print("exported:", len(voxels), "voxels are those of the program")

# In, as a mesh: the faces are those between voxels and empty cells, once each, of the right colours, and where the box stands.
evaluated = box.evaluated_get(bpy.context.evaluated_depsgraph_get())
stood = bounds(evaluated)
bpy.ops.import_scene.voxc_mesh(filepath=path("box.hvx"))
made = bpy.context.object
assert made is not box and made.type == "MESH" and not made.data.validate()
assert faces_of(made.data) == visible_faces(voxels)
side = made.matrix_world.to_scale()[0]
assert np.all(np.abs(bounds(made) - stood) <= 1.001 * side), (bounds(made), stood, side)
print("imported:", len(made.data.polygons), "rectangles are all visible faces, within a voxel of the object")

# A sparse scene of chance, in which many faces meet at edges and none is merged by luck.
random = np.random.default_rng(5)
noise = random.integers(0, 3, (9, 8, 7)).astype(np.uint32) * (random.random((9, 8, 7)) < 0.5)
noise = np.where(noise == 1, 0xFF2080F0, np.where(noise == 2, 0x80FF00FF, 0)).astype(np.uint32)
voxc.build("S(4)", voxels=noise).save(path("noise.hvx"))
bpy.ops.import_scene.voxc_mesh(filepath=path("noise.hvx"))
expected = visible_faces({(x, y, z): int(noise[z, y, x]) for z, y, x in np.argwhere(noise)})
assert faces_of(bpy.context.object.data) == expected
assert bpy.context.object.active_material.blend_method == "BLEND"
print("imported:", len(expected), "faces of noise")

# Other files that voxc reads.
command("export", path("box.hvx"), "-o", path("box.vox"))
bpy.ops.import_scene.voxc_mesh(filepath=path("box.vox"))
assert len(faces_of(bpy.context.object.data)) == len(visible_faces(voxels))
print("imported: a .vox file")

# A format is searched; the export takes the row that is chosen.
scene = bpy.context.scene
scene.voxc_chosen.resolution = 40
for other in bpy.context.selected_objects:
    other.select_set(False)
box.select_set(True)
bpy.ops.voxc.search_format()
row = scene.voxc_rows[scene.voxc_row]
assert len(scene.voxc_rows) >= 1 and row.chosen and scene.voxc_chosen.format == row.format and row.bytes > 0 and row.rays > 0
bpy.ops.export_scene.voxc(filepath=path("searched.hvx"), format=row.format, passes=row.passes, resolution=40)
searched = voxc.Volume.load(path("searched.hvx"))
assert cells(searched) == voxels and searched.format.split("(")[0] == row.format.split("(")[0]
assert abs(searched.bytes - row.bytes) / row.bytes < 0.25, (searched.bytes, row.bytes)
print("searched:", len(scene.voxc_rows), "rows, and the export takes the chosen one")

# What goes wrong is one sentence, and changes nothing.
whole = open(path("box.hvx"), "rb").read()
with open(path("cut.hvx"), "wb") as file:
    file.write(whole[:len(whole) // 2])
print("refused:", refusal(bpy.ops.import_scene.voxc_mesh, filepath=path("cut.hvx")))
print("refused:", refusal(bpy.ops.import_scene.voxc_mesh, filepath=path("none.hvx")))
print("refused:", refusal(bpy.ops.export_scene.voxc, filepath=path("box.hvx"), format="R(3^3) Q(3)", resolution=40))
print("refused:", refusal(bpy.ops.export_scene.voxc, filepath=path("no/folder.hvx"), format="G(6)", resolution=40))
box.select_set(False)
print("refused:", refusal(bpy.ops.export_scene.voxc, filepath=path("box.hvx")))
print("refused:", refusal(bpy.ops.voxc.search_format))
assert open(path("box.hvx"), "rb").read() == whole
bpy.ops.preferences.addon_disable(module="voxc_blender")
assert not hasattr(bpy.types.Scene, "voxc_rows")
print("all is as it was")
