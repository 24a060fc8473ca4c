// All fragments of a volume, as one stream of parts.
#pragma once

#include "FragmentFile.h"
#include "PartStream.h"

#include "voxc/Support/WorkingMemory.h"

namespace voxc {

class FragmentSet final : public PartStream {
public:
  /// Opens the files, in any order. Errors (`Input`): one is broken, belongs to another volume, is there
  /// twice or is missing.
  static Expected<FragmentSet> open(const std::vector<std::string> &paths,
                                    const std::shared_ptr<WorkingMemory> &memory);
  ~FragmentSet() override;
  FragmentSet(FragmentSet &&) noexcept = default;

  /// Of any of them: they agree but for the index.
  const FragmentInfo &info() const { return readers_.front().info(); }

  std::optional<Int3> next() override;
  Expected<Fragment> take() override;

private:
  FragmentSet(std::vector<FragmentReader> readers, std::shared_ptr<WorkingMemory> memory)
      : readers_(std::move(readers)), memory_(std::move(memory)) {}
  Expected<void> checkPart(const Fragment &fragment) const;

  std::vector<FragmentReader> readers_; ///< By index.
  std::shared_ptr<WorkingMemory> memory_;
  std::size_t current_ = 0;
  std::optional<std::uint64_t> lastCode_;
};

} // namespace voxc
