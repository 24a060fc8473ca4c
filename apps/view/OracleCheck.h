// What the exact oracle says of a ray: asked on a thread of its own, for an oracle reads all voxels first.
#pragma once

#include "view/JobThread.h"
#include "view/LatestValue.h"
#include "view/Pick.h"

#include "voxc/Oracle/Oracle.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

namespace voxc::view {

/// A hit with the oracle's.
struct CheckedHit {
  Pick pick;
  Hit exact;
  Face face;
  std::size_t cells = 0; ///< That the ray passes on its way, the voxel's included.
};

/// The hit and the oracle's word in one sentence: "voxel ..., t 17.25; the oracle agrees: entered by the face
/// -x, the last of 57 cells".
std::string describe(const CheckedHit &checked);

class OracleCheck {
public:
  /// `wake` is called from the thread when there is something to take.
  explicit OracleCheck(std::function<void()> wake) : wake_(std::move(wake)) {}

  /// Asks about `pick`, and no more about what was asked before.
  void ask(const Pick &pick);
  std::optional<Expected<CheckedHit>> take() { return checked_.take(); }

private:
  Expected<CheckedHit> answer(const Pick &pick, const std::atomic<bool> &stop);

  std::function<void()> wake_;
  LatestValue<Expected<CheckedHit>> checked_;
  std::shared_ptr<const Volume> volume_; ///< The oracle's; the thread's alone, as the oracle is.
  std::optional<Oracle> oracle_;
  JobThread thread_; // The last: it uses all others.
};

} // namespace voxc::view
