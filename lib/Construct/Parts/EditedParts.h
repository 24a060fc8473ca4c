// The parts of an edited volume: those that edits touch are built anew, and all others are taken out of the
// volume as they are.
#pragma once

#include "Extraction.h"
#include "PartBuilder.h"
#include "PartStream.h"

#include "voxc/Construct/Constructor.h"
#include "voxc/Source/Edit.h"

#include <span>

namespace voxc {

class EditedParts final : public PartStream {
public:
  /// The arguments outlive this, but for the source. Error: no memory.
  static Expected<std::unique_ptr<EditedParts>>
  create(const Volume &volume, std::unique_ptr<VoxelSource> edited, std::span<const VoxelEdit> edits,
         const ConstructCode &code, const BuildOptions &options);

  Next<Cube> next() override;
  Expected<Fragment> take() override;

private:
  EditedParts(const Volume &volume, std::unique_ptr<VoxelSource> edited, std::span<const VoxelEdit> edits,
              PartBuilder builder, const BuildOptions &options);
  bool isTouched(const Cube &cube) const;

  std::unique_ptr<VoxelSource> edited_;
  std::span<const VoxelEdit> edits_;
  Extraction extraction_;
  PartBuilder builder_;
  PartSequence sequence_;
  const Progress &progress_;
  /// The next part, once it was asked for: never an empty one, but maybe an error, which then stays.
  std::optional<Expected<Fragment>> ahead_;
};

} // namespace voxc
