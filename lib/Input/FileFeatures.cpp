// The table of what is read, warned of and refused.
#include "voxc/Input/FileFeatures.h"

namespace voxc {

namespace {

using enum FileUse;

constexpr std::array kFeatures = std::to_array<FileFeature>({
    {"glb, gltf", "scenes, nodes, instances (`EXT_mesh_gpu_instancing`), all primitive modes", Read, ""},
    {"glb, gltf", "accessors: sparse, strided, normalized, without data; buffers beside, inside, base 64",
     Read, ""},
    {"glb, gltf", "skins, morph targets of positions", Read, "as the model stands without animation"},
    {"glb, gltf", "animations; morph targets of colours and texture coordinates", Warned,
     "not played, not applied"},
    {"glb, gltf", "base colour: factor, texture, `COLOR_0`", Read, "linear light, then sRGB"},
    {"glb, gltf", "emission and its strength; metal, roughness, transmission", Read,
     "emission is shown; attributes on request"},
    {"glb, gltf", "`alphaMode`, `alphaCutoff`", Read, "of factor, texture and vertices"},
    {"glb, gltf", "`KHR_texture_transform`, `KHR_materials_unlit`, diffuse of specular-glossiness", Read, ""},
    {"glb, gltf", "Draco, meshopt, WebP", Read, ""},
    {"glb, gltf", "other extensions that are used; textures without coordinates", Warned, "left out"},
    {"glb, gltf", "required extensions that are not known; KTX2 that is required", Refused, "convert it"},
    {"obj", "polygons of any number of corners, `l`, `p`, backward indices", Read, ""},
    {"obj", "vertices alone, or `p` alone", Read, "points, a voxel each"},
    {"obj", "colours of vertices, to 1; ZBrush's `#MRGB`", Read, ""},
    {"obj", "colours of vertices to 255 or 65535", Warned, "taken so"},
    {"obj", "`Kd`, `d`, `Tr`, `map_Kd`, `map_d`, `-clamp`, `-o`, `-s`; other options", Read,
     "others are skipped"},
    {"obj", "`Ke`, `map_Ke`; `Pm`, `Pr`", Read, "`Ke` is shown; attributes on request"},
    {"obj", "seven numbers of a vertex", Warned,
     "a colour and alpha; if the fourth is 1, a weight and a colour"},
    {"obj", "`Kd 0` beside a texture; materials that are wholly invisible", Warned, "white; opaque"},
    {"obj", "other maps; free-form curves; statements that are not known", Warned, "left out"},
    {"obj", "texture coordinates that do not exist", Warned, "no texture there"},
    {"obj", "libraries and images that lie elsewhere, or in other letters", Warned, "found beside the model"},
    {"obj", "libraries, images and materials that are missing", Warned, "white"},
    {"ply", "text and binary, both byte orders; polygons, strips; doubles", Read, ""},
    {"ply", "colours of vertices or faces, by many names", Read, "bytes, shorts, floats"},
    {"ply", "textures by `TextureFile`, per vertex or corner, `texnumber`", Read, ""},
    {"ply", "points; whole coordinates", Read, "a voxel each"},
    {"ply", "Gaussian splats", Warned, "their first colour; faint ones left out"},
    {"ply", "compressed splats", Refused, "export it as .ply without compression"},
    {"ply", "free text before the first element", Warned, "taken for a comment"},
    {"ply", "other properties and elements", Warned, "named"},
    {"stl", "text, binary; colours of VisCAM, SolidView and Magics", Read, ""},
    {"stl", "other bytes behind triangles", Warned, "left out"},
    {"fbx, dae, 3ds, off, x3d", "meshes, nodes; colours and emission with textures; metal and roughness",
     Read, "where built with assimp"},
    {"fbx, dae, 3ds, off, x3d", "skins, morph targets, animations, other textures", Warned, "left out"},
    {"all meshes", "coordinates that are not finite; indices that point nowhere", Refused, ""},
    {"obj, mtl, ply, stl", "text in UTF-16 or UTF-32", Refused, "a library is left out with a warning"},
    {"all meshes", "images: PNG, JPEG (CMYK too), WebP, BMP, TGA", Read, ""},
    {"all meshes", "images that are missing, broken or too large", Warned, "no texture"},
    {"vox", "models, scene graph, rotations, layers, frames, palette", Read, "frame by %d"},
    {"vox", "materials: emission and `_flux`, metal, roughness, glass", Warned,
     "dropped; attributes on request"},
    {"las", "1.0 to 1.4, formats 0 to 10; colours, else greys of intensities; doubles", Read,
     "up is +z, turned to +y"},
    {"las", "colours of bytes in place of 16 bits; withheld points", Warned, "taken so; left out"},
    {"las", "returns, classes, times, waveforms, coordinate systems", Warned, "left out"},
    {"laz, e57", "all", Refused, "save it as .las or .ply"},
    {"schem, litematic", "Sponge 1 to 3, Litematica with its regions, schematics of MCEdit; blocks by name",
     Read, "up is +y"},
    {"schem, litematic", "names that are not known; stairs, torches and all that does not fill its cell",
     Warned, "a colour of the name; a whole voxel"},
    {"schem, litematic", "entities, what chests hold, biomes", Warned, "left out"},
    {"mca, mcstructure", "all", Refused, "save it as .schem"},
    {"nvdb", "float, double, whole numbers, bool, mask, RGBA8, Fp4 to Fp16; ZIP, Blosc", Read, ""},
    {"nvdb", "several grids and segments", Warned, "one is taken, `--grid NAME` another"},
    {"nvdb", "vectors, FpN", Refused, "write it as float"},
    {"vdb", "level sets and fog of 32-bit floats", Read, "where built with OpenVDB"},
    {"vdb", "several grids", Warned, "one is taken, `--grid NAME` another"},
    {"vdb", "grids of other numbers", Refused, "write them as float"},
    {"nrrd, nhdr", "raw, text, hex, gzip, bzip2; lists and patterns of files; skips", Read, ""},
    {"nrrd, nhdr", "axes of colours; `space` and its directions", Read, "turned upright"},
    {"nrrd, nhdr", "axes of volumes or components", Warned, "the first; `--volume N` another"},
    {"nrrd, nhdr", "fields that the format does not have", Warned, ""},
    {"nii, hdr and img", "NIfTI 1 and 2, Analyze; sform, qform; RGB24, RGBA32; both byte orders", Read,
     "RAS+"},
    {"nii, hdr and img", "several volumes", Warned, "the first; `--volume N` another"},
    {"npy, npz", "numbers, bool, colours", Read, ""},
    {"vti", "ascii, binary, appended raw and base 64, zlib; both byte orders, UInt32 and UInt64 headers",
     Read, ""},
    {"vti", "points or cells; origin, spacing, direction; pieces that tile the extent; colours of bytes",
     Read, ""},
    {"vti", "several arrays or components; field data", Warned,
     "`--grid NAME` or `--volume N` takes another"},
    {"vti", "other compressors, other kinds of VTK data", Refused,
     "write it with zlib; resample it to image data"},
    {"png, tif", "grey of any depth, colours; sets by a pattern; pages", Read, ""},
    {"png, tif", "16 bits a channel of colours", Read, "become 8"},
    {"png, tif", "spacing and unit of ImageJ's stacks", Read, "with the resolution"},
    {"png, tif", "masks and small copies among pages", Warned, "left out"},
    {"png, tif", "a set with a gap", Refused, ""},
    {"all scans", "samples that are no cubes", Warned, "`--voxel-size` makes cubes"},
    {"all scans", "labels", Read, "all are kept"},
});

} // namespace

std::span<const FileFeature> fileFeatures() { return kFeatures; }

std::string fileFeatureTable() {
  std::string text = "| Format | What a file may have | | |\n|---|---|---|---|\n";
  for (const FileFeature &row : kFeatures)
    text += "| " + std::string(row.format) + " | " + std::string(row.feature) + " | " +
            std::string(toString(row.use)) + " | " + std::string(row.what) + " |\n";
  return text;
}

} // namespace voxc
