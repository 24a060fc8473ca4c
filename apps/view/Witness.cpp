// Hits and the oracle in words.
#include "view/Witness.h"

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

std::string describe(const Testimony &testimony) {
  const std::string cells = std::to_string(testimony.cells) + (testimony.cells == 1 ? " cell" : " cells");
  std::string text = describe(testimony.touch.hit) + "; the oracle ";
  text += agree(testimony.touch.hit, testimony.exact) ? "agrees" : "says: " + describe(testimony.exact);
  return text + (testimony.exact.isHit()
                     ? ": entered by " + faceName(testimony.face) + ", the last of " + cells
                     : ", after " + cells);
}

void Witness::ask(const Touch &touch) {
  thread_.post([this, touch](const std::atomic<bool> &stop) {
    Expected<Testimony> testimony = answer(touch, stop);
    if (!testimony && testimony.error().kind == ErrorKind::Interrupted)
      return;
    testimony_.put(std::move(testimony));
    wake_();
  });
}

Expected<Testimony> Witness::answer(const Touch &touch, const std::atomic<bool> &stop) {
  if (touch.shot.scene->model.pagedBytes > 0)
    return Error::usage(describe(touch.hit) + "; no oracle has a volume in pages");
  if (const auto volume = touch.shot.scene->frozen(); volume_ != volume) {
    oracle_.reset();
    Expected<Oracle> oracle = Oracle::of(*volume, {.stop = &stop});
    if (!oracle)
      return oracle.error();
    oracle_.emplace(std::move(*oracle));
    volume_ = volume;
  }
  const Explanation explanation = oracle_->explain(touch.ray.ray(), kMostCells, touch.ray.bounds());
  return Testimony{touch, explanation.hit, explanation.face, explanation.cells.size()};
}

} // namespace voxc::view
