// A hand-written tracer beside voxc, on the same rays: one of a folder that is not part of the project.
#pragma once

#include "Stage.h"

#include <optional>
#include <string>

namespace voxc::cliffs {

class Peer {
public:
  /// Builds the tracer of `folder` (its t_own.cpp), with the compiler that is called c++. Error: it cannot be
  /// built.
  static Expected<Peer> build(const std::string &folder);
  ~Peer();
  Peer(Peer &&) noexcept;
  Peer &operator=(Peer &&) = delete;

  /// Nanoseconds of CPU time a ray on one thread. Nothing where the tracer cannot have the scene, or the rays
  /// are few.
  std::optional<double> nanoseconds(const Stage &stage, const std::vector<Ray> &rays) const;

private:
  explicit Peer(std::string room) : room_(std::move(room)) {}
  std::string room_; ///< A folder for its program and its files.
};

} // namespace voxc::cliffs
