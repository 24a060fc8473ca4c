// How many words a format takes for a scene, exactly, without building it: layouts are deterministic, so what
// is counted here is what a build writes.
#pragma once

#include "voxc/Layout/Layout.h"
#include "voxc/Layout/SlotKind.h"
#include "voxc/Search/SceneDag.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace voxc {

struct Price {
  std::vector<std::uint64_t> levelWords; ///< Of each level.
  std::uint64_t otherWords = 0;          ///< Before the first node, and of values apart.
  /// False: a hashed grid may take more, where its cells' numbers collide often; or the values of voxels
  /// stand apart in the order of a masked grid that is not of 4^3, and take a little more or less; or nodes
  /// are filled up to granules.
  bool exact = true;

  std::uint64_t words() const;
};

/// Prices formats over one scene. What formats have in common is counted once.
class SizeModel {
public:
  /// `dag` must outlive the model, and has the detail of the layouts: colours where values are in place.
  explicit SizeModel(const SceneDag &dag);
  ~SizeModel();
  SizeModel(SizeModel &&) noexcept;

  /// The price of a layout. Errors (`Input`): the scene is larger than the layout; more than `indexBits` can
  /// number; more words than its references reach. Words of values apart are `valueWords`.
  Expected<Price> price(const Layout &layout, std::uint64_t valueWords = 0);

private:
  class Tables;

  std::uint64_t occurrencesAt(int height) const;
  std::uint64_t arrayWords(const SlotKind &slots, int height, bool shares) const;

  const SceneDag &dag_;
  std::unique_ptr<Tables> tables_;
};

} // namespace voxc
