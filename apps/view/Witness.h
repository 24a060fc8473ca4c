// What the exact oracle says of a ray: asked on a thread of its own, for an oracle reads all voxels first.
#pragma once

#include "view/JobThread.h"
#include "view/Mailbox.h"
#include "view/Touch.h"

#include "voxc/Oracle/Oracle.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

namespace voxc::view {

/// A hit with the oracle's.
struct Testimony {
  Touch touch;
  Hit exact;
  Face face;
  std::size_t cells = 0; ///< That the ray passes on its way, the voxel's included.
};

/// The hit and the oracle's word in one sentence: "voxel ..., t 17.25; the oracle agrees: entered by the face
/// -x, the last of 57 cells".
std::string describe(const Testimony &testimony);

class Witness {
public:
  /// `wake` is called from the thread when there is something to take.
  explicit Witness(std::function<void()> wake) : wake_(std::move(wake)) {}

  /// Asks about `touch`, and no more about what was asked before.
  void ask(const Touch &touch);
  std::optional<Expected<Testimony>> take() { return testimony_.take(); }

private:
  Expected<Testimony> answer(const Touch &touch, const std::atomic<bool> &stop);

  std::function<void()> wake_;
  Mailbox<Expected<Testimony>> testimony_;
  std::shared_ptr<const Volume> volume_; ///< The oracle's; the thread's alone, as the oracle is.
  std::optional<Oracle> oracle_;
  JobThread thread_; // The last: it uses all others.
};

} // namespace voxc::view
