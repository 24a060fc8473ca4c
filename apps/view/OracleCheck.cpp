// Hits and the oracle in words.
#include "view/OracleCheck.h"

#include <utility>

namespace voxc::view {
namespace {

/// Cells that are counted one by one.
constexpr std::size_t kMostCells = std::size_t{1} << 20;

std::string faceName(const Face &face) {
  return face.axis < 0 ? "no face, for the ray begins in it"
                       : std::string("the face ") + (face.side < 0 ? "-" : "+") + "xyz"[face.axis];
}

bool agree(const Hit &a, const Hit &b) {
  return a.voxel[0] == b.voxel[0] && a.voxel[1] == b.voxel[1] && a.voxel[2] == b.voxel[2] &&
         a.rgba == b.rgba && a.t == b.t;
}

} // namespace

std::string describe(const CheckedHit &checked) {
  const std::string cells = std::to_string(checked.cells) + (checked.cells == 1 ? " cell" : " cells");
  std::string text = describe(checked.pick.hit) + "; the oracle ";
  text += agree(checked.pick.hit, checked.exact) ? "agrees" : "says: " + describe(checked.exact);
  return text + (checked.exact.isHit() ? ": entered by " + faceName(checked.face) + ", the last of " + cells
                                       : ", after " + cells);
}

void OracleCheck::ask(const Pick &pick) {
  thread_.post([this, pick](const std::atomic<bool> &stop) {
    Expected<CheckedHit> checked = answer(pick, stop);
    if (!checked && checked.error().kind == ErrorKind::Interrupted)
      return;
    checked_.put(std::move(checked));
    wake_();
  });
}

Expected<CheckedHit> OracleCheck::answer(const Pick &pick, const std::atomic<bool> &stop) {
  if (pick.shot.scene->model.pagedBytes > 0)
    return Error::usage(describe(pick.hit) + "; no oracle has a volume in pages");
  if (const auto volume = pick.shot.scene->frozen(); volume_ != volume) {
    oracle_.reset();
    auto oracle = VOXC_TRY(Oracle::of(*volume, {.stop = &stop}));
    oracle_.emplace(std::move(oracle));
    volume_ = volume;
  }
  const Explanation explanation = oracle_->explain(pick.ray.ray(), kMostCells, pick.ray.bounds());
  return CheckedHit{pick, explanation.hit, explanation.face, explanation.cells.size()};
}

} // namespace voxc::view
