// All fragments of a volume, as one stream of parts.
#pragma once

#include "Construct/Parts/PartStream.h"
#include "FragmentFile.h"

#include "voxc/Support/WorkingMemory.h"

namespace voxc {

class FragmentSet final : public PartStream {
public:
  /// Opens all fragments of a volume, in any order. Errors (`Input`): one is broken, belongs to another
  /// volume, is there twice or is missing; their shares leave a gap or overlap.
  static Expected<FragmentSet> open(const std::vector<std::string> &paths,
                                    const std::shared_ptr<WorkingMemory> &memory);
  /// The same for some that follow one another.
  static Expected<FragmentSet> openRun(const std::vector<std::string> &paths,
                                       const std::shared_ptr<WorkingMemory> &memory);
  ~FragmentSet() override;
  FragmentSet(FragmentSet &&) noexcept = default;

  /// Of any of them: they agree but for their shares and voxels.
  const FragmentInfo &info() const { return readers_.front().info(); }
  const Layout &layout() const { return readers_.front().layout(); }
  /// The cubes [first, second) of all of them together.
  std::pair<std::uint64_t, std::uint64_t> cubes() const {
    return {info().share.begin, readers_.back().info().share.end};
  }
  /// The voxels of all of them, as their heads say; the stream has no end where its parts have others.
  std::uint64_t voxels() const;

  Next<Cube> next() override;
  Expected<Fragment> take() override;
  /// Bytes of the parts in a cube, those that were taken among them.
  std::uint64_t bytesIn(const Cube &cube) const;

private:
  FragmentSet(std::vector<FragmentReader> readers, std::shared_ptr<WorkingMemory> memory)
      : readers_(std::move(readers)), memory_(std::move(memory)) {}
  void sumBytes();
  Expected<void> checkPart(const Fragment &fragment) const;

  std::vector<FragmentReader> readers_; ///< By index.
  std::shared_ptr<WorkingMemory> memory_;
  std::size_t current_ = 0;
  std::uint64_t endOfLast_ = 0; ///< Where the next part may begin, as a Morton code of voxels.
  std::vector<std::pair<std::uint64_t, std::uint64_t>>
      sums_; ///< Where a part begins; the bytes up to its end.
};

} // namespace voxc
