// Opening an input: a table of prefixes and endings, and which opener takes each.
#include "voxc/Input/Input.h"

#include "Input/Changes.h"
#include "Input/Openers/Openers.h"
#include "Source/GridExtent.h"
#include "Support/Text.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

namespace voxc {

namespace {

/// Stands for the optional component where it was left out.
Expected<Input> lackOpenVdb(const std::string &path, const InputOptions &) {
  return Error::environment("'" + path +
                            "' is an OpenVDB file, which this build does not read; build voxc with "
                            "VOXC_OPENVDB=ON");
}

constexpr std::array<InputKind, 18> kKinds{{{"builtin:", openBuiltin},
                                            {"grid:", openGrid},
                                            {"raw:", openRaw},
                                            {".obj", openMesh},
                                            {".glb", openMesh},
                                            {".gltf", openMesh},
                                            {".stl", openMesh},
                                            {".ply", openPly},
                                            {".hvx", openVolume},
                                            {".vox", openMagicaVoxel},
                                            {".binvox", openBinvox},
                                            {".nrrd", openNrrd},
                                            {".nhdr", openNrrd},
                                            {".nii", openNifti},
                                            {".nii.gz", openNifti},
                                            {".png", openSlices},
                                            {".nvdb", openNanoVdb},
                                            {".vdb", lackOpenVdb}}};

Error unknownKind(const std::string &input) {
  std::string kinds;
  for (const InputKind &kind : kKinds)
    kinds += (kinds.empty() ? "" : " ") + std::string(kind.mark);
  return Error::input("'" + input + "' is no kind of input that is known; there are " + kinds);
}

Expected<Input> dispatch(const std::string &input, const InputOptions &options) {
  const std::string name = lowerCase(input.substr(input.find_last_of('/') + 1));
  const std::span<const InputKind> others = options.otherKinds;
  for (const std::span<const InputKind> kinds : {others, std::span<const InputKind>(kKinds)})
    for (const InputKind &kind : kinds) {
      if (kind.mark.ends_with(':') && input.starts_with(kind.mark))
        return kind.open(input.substr(kind.mark.size()), options);
      if (name.ends_with(kind.mark))
        return kind.open(input, options);
    }
  return unknownKind(input);
}

} // namespace

Expected<Input> openInput(const std::string &input, const InputOptions &options) {
  InputOptions withMemory = options;
  if (!withMemory.memory)
    withMemory.memory = WorkingMemory::createDefault();
  Expected<Input> opened = dispatch(input, withMemory);
  if (!opened)
    return opened;
  if (auto changed = applyChanges(*opened, withMemory); !changed)
    return changed.error();
  const Int3 extent = opened->source->extent();
  const Int3 holds = options.formatExtent;
  if (extent.x > holds.x || extent.y > holds.y || extent.z > holds.z)
    return Error::input("'" + input + "' takes " + toText(extent) + " voxels, but the format holds " +
                        toText(holds));
  return opened;
}

} // namespace voxc
