// Opening an input: a table of prefixes and endings, and which opener takes each.
#include "voxc/Input/Input.h"

#include "Input/Changes.h"
#include "Input/Openers/InputText.h"
#include "Input/Openers/Openers.h"
#include "Source/GridExtent.h"
#include "Support/Text.h"
#include "voxc/Volume/Frames.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <span>
#include <string_view>

namespace voxc {

namespace {

/// Stands for the optional component where it was left out.
Expected<Input> lackOpenVdb(const std::string &path, const InputOptions &) {
  return Error::environment(
      "'" + path + "' is an OpenVDB file, which this build does not read; build voxc with VOXC_OPENVDB=ON");
}

Expected<Input> lackAssimp(const std::string &path, const InputOptions &) {
  return Error::environment("'" + path +
                            "' is a mesh that assimp reads, which this build does not have; build voxc with "
                            "VOXC_ASSIMP=ON, or convert it to .glb");
}

constexpr std::array<InputKind, 36> kKinds{{{"builtin:", openBuiltin, "a built-in scene"},
                                            {"grid:", openGrid, "a grid of words"},
                                            {"raw:", openRaw, "a dense volume"},
                                            {".obj", openMesh, "a mesh", true},
                                            {".glb", openMesh, "a mesh", true},
                                            {".gltf", openMesh, "a mesh", true},
                                            {".stl", openMesh, "a mesh"},
                                            {".ply", openPly, "a mesh or points", true},
                                            {".hvx", openVolume, "a volume"},
                                            {".vox", openMagicaVoxel, "MagicaVoxel models"},
                                            {".schem", openMinecraft, "blocks of Minecraft"},
                                            {".schematic", openMinecraft, "blocks of Minecraft"},
                                            {".litematic", openMinecraft, "blocks of Minecraft"},
                                            {".binvox", openBinvox, "voxels without colours"},
                                            {".nrrd", openNrrd, "a dense volume", true},
                                            {".nhdr", openNrrd, "a dense volume", true},
                                            {".nii", openNifti, "a dense volume"},
                                            {".nii.gz", openNifti, "a dense volume"},
                                            {".hdr", openNifti, "a dense volume", true},
                                            {".hdr.gz", openNifti, "a dense volume", true},
                                            {".img", openNifti, "a dense volume", true},
                                            {".img.gz", openNifti, "a dense volume", true},
                                            {".npy", openNumpy, "an array"},
                                            {".npz", openNumpy, "arrays"},
                                            {".png", openSlices, "slices"},
                                            {".tif", openSlices, "slices"},
                                            {".tiff", openSlices, "slices"},
                                            {".nvdb", openNanoVdb, "a NanoVDB grid"},
                                            {".las", openLas, "points"},
                                            {".vti", openVtk, "image data of VTK"},
                                            {".vdb", lackOpenVdb, "an OpenVDB grid"},
                                            {".fbx", lackAssimp, "a mesh"},
                                            {".dae", lackAssimp, "a mesh"},
                                            {".3ds", lackAssimp, "a mesh"},
                                            {".off", lackAssimp, "a mesh"},
                                            {".x3d", lackAssimp, "a mesh"}}};

/// Whether an input is of this kind; `name` is its last part in lower case, without the number of a frame.
bool isOfKind(const InputKind &kind, const std::string &input, std::string_view name) {
  return kind.mark.ends_with(':') ? input.starts_with(kind.mark) : name.ends_with(kind.mark);
}

/// Of the kinds that this build reads.
Error unknownKind(const std::string &input, std::span<const InputKind> others) {
  std::string kinds;
  for (const InputKind &kind : kKinds)
    if (kind.open != lackOpenVdb && kind.open != lackAssimp)
      kinds += (kinds.empty() ? "" : " ") + std::string(kind.mark);
  for (const InputKind &kind : others)
    kinds += " " + std::string(kind.mark);
  return Error::input("'" + input + "' is no kind of input that is known; there are " + kinds);
}

const InputKind *kindOf(const std::string &input, std::span<const InputKind> others) {
  const std::string name = lowerCase(withoutFrame(input.substr(input.find_last_of('/') + 1)));
  for (const std::span<const InputKind> kinds : {others, std::span<const InputKind>(kKinds)})
    for (const InputKind &kind : kinds)
      if (isOfKind(kind, input, name))
        return &kind;
  return nullptr;
}

Expected<Input> dispatch(const std::string &input, const InputOptions &options) {
  const InputKind *const kind = kindOf(input, options.otherKinds);
  std::error_code ignored;
  if (!kind && std::filesystem::is_directory(input, ignored))
    return Error::input("'" + input + "' is a directory; name a file");
  if (auto refusal = kind ? std::nullopt : refusalOf(input))
    return *refusal;
  if (!kind)
    return unknownKind(input, options.otherKinds);
  const bool isPrefixed = kind->mark.ends_with(':');
  Expected<Input> opened = kind->open(isPrefixed ? input.substr(kind->mark.size()) : input, options);
  if (opened && options.describe && (opened->facts.empty() || opened->facts.front().name != "kind"))
    opened->facts.insert(opened->facts.begin(), {"kind", std::string(kind->holds), {}});
  return opened;
}

/// Whether two axes are not at right angles, as in scans of a tilted gantry.
bool isSheared(const Transform &map) {
  constexpr double kAlmost = 0.01;
  bool isSheared = false;
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 one(map[axis]), other(map[(axis + 1) % 3]);
    isSheared = isSheared || std::abs(glm::dot(one, other)) > kAlmost * glm::length(one) * glm::length(other);
  }
  return isSheared;
}

/// Warns of voxels that are no cubes, which most of what is made of them shows as if they were.
void tellSpacing(const std::string &text, const InputOptions &options, Input &input) {
  constexpr double kAlike = 0.01;
  const Transform map = input.source->voxelToModel();
  std::array<double, 3> sides{};
  for (int axis = 0; axis < 3; ++axis)
    sides[static_cast<std::size_t>(axis)] = glm::length(glm::dvec3(map[axis]));
  const auto [least, most] = std::ranges::minmax(sides);
  if (!options.isAutomatic || withoutFrame(lowerCase(text)).ends_with(".hvx"))
    return;
  if (isSheared(map))
    input.warnings.push_back(
        "its axes are not at right angles: pictures, pages, .glb, .nvdb, .vdb and .vti files "
        "keep that, all else shows it upright");
  if (!(most > least * (1 + kAlike)))
    return;
  std::array<char, 32> shortest{};
  std::snprintf(shortest.data(), shortest.size(), "%.6g", least);
  input.warnings.push_back(
      "its voxels are " + byThree(sides) +
      " and no cubes: pictures, pages, .glb, .nvdb, .vdb and .vti files keep that, all else "
      "shows it squashed; --voxel-size " +
      std::string(shortest.data()) + " makes cubes of them");
}

} // namespace

Expected<Input> openInput(const std::string &input, const InputOptions &options) {
  InputOptions withMemory = options;
  if (!withMemory.memory)
    withMemory.memory = WorkingMemory::createDefault();
  auto opened = VOXC_TRY(dispatch(input, withMemory));
  tellSpacing(input, options, opened);
  if (opened.words != options.materialWords)
    return Error::input("'" + input + "' says nothing of light and metal; meshes and .vox files do");
  VOXC_TRY(applyChanges(opened, withMemory));
  const Int3 extent = opened.source->extent();
  const Int3 holds = options.formatExtent;
  if (extent.x > holds.x || extent.y > holds.y || extent.z > holds.z)
    return Error::input("'" + input + "' takes " + extentText(extent) + " voxels, but the format holds " +
                        extentText(holds));
  return opened;
}

bool mayHaveSeveralFiles(const std::string &input, const InputOptions &options) {
  const InputKind *const kind = kindOf(input, options.otherKinds);
  return kind && kind->mayHaveSeveralFiles;
}

} // namespace voxc
