// Opening an input: a table of prefixes and endings, and which opener takes each.
#include "voxc/Source/Input.h"

#include "Source/GridExtent.h"
#include "Source/Openers/Openers.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace voxc {

namespace {

struct Kind {
  std::string_view mark; ///< A prefix if it ends in a colon, else an ending.
  Expected<Input> (*open)(const std::string &rest, const InputOptions &options);
};

constexpr std::array<Kind, 15> kKinds{{{"builtin:", openBuiltin},
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
                                       {".nii.gz", openNifti}}};

std::string inLowerCase(std::string_view text) {
  std::string lower(text);
  for (char &c : lower)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

Error unknownKind(const std::string &input) {
  std::string kinds;
  for (const Kind &kind : kKinds)
    kinds += (kinds.empty() ? "" : " ") + std::string(kind.mark);
  return Error::input("'" + input + "' is no kind of input that is known; there are " + kinds);
}

Expected<Input> dispatch(const std::string &input, const InputOptions &options) {
  const std::string name = inLowerCase(input.substr(input.find_last_of('/') + 1));
  for (const Kind &kind : kKinds) {
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
  const Int3 extent = opened->source->extent();
  const Int3 holds = options.formatExtent;
  if (extent.x > holds.x || extent.y > holds.y || extent.z > holds.z)
    return Error::input("'" + input + "' takes " + toText(extent) + " voxels, but the format holds " +
                        toText(holds));
  return opened;
}

} // namespace voxc
