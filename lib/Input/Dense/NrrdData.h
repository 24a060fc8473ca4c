// The samples of NRRD files, in one file or several, whatever they are encoded with.
#pragma once

#include "Input/Dense/NrrdHeader.h"
#include "Support/WatchedFile.h"
#include "voxc/Input/Input.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace voxc {

struct NrrdData {
  const std::byte *samples = nullptr;
  std::shared_ptr<const void> storage; ///< What `samples` points into.
  std::vector<std::string> warnings;   ///< Of what lies behind the samples.
};

/// All samples of a header: `behind` is what follows it in its own file, and `folder` has the files that it
/// names. Samples that lie as they are in one file stay there. Errors: unreadable; damaged; fewer than the
/// header speaks of; no memory; interrupted.
Expected<NrrdData> readNrrdData(const NrrdHeader &header, std::shared_ptr<const WatchedFile> file,
                                std::span<const std::byte> behind, const std::string &folder,
                                const InputOptions &options);

} // namespace voxc
