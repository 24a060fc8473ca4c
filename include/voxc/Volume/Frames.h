// Volumes of several frames: states of one scene that share the words which are equal, each with a root of
// its own. A frame is chosen by its root alone.
#pragma once

#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace voxc {

/// The name of the stream that says where frames begin.
inline constexpr std::string_view kFrameStream = "frames";

/// An element of it; little-endian, as it is in the file.
struct Frame {
  std::uint32_t root = 0; ///< Word 0 of the volume when the frame is chosen; 0: the frame is empty.
  std::uint32_t reserved = 0;
  std::uint64_t voxels = 0; ///< Non-empty ones.

  friend bool operator==(const Frame &, const Frame &) = default;
};

/// How many an animation has at most where it is made.
inline constexpr std::uint64_t kMostFrames = std::uint64_t{1} << 22;

/// The frames of a volume, the first being the one that its words begin with; none of an ordinary volume.
std::span<const Frame> framesOf(const Volume &volume);

/// The stream of frames, which must outlive it.
Stream frameStream(std::span<const Frame> frames);

/// "FILE#N" is frame N, from 1 on, of an animation in a file; only digits behind the last '#' are a number.
struct FramePath {
  std::string path; ///< Without the number.
  int frame = 0;    ///< From 1 on; 0: none is named.
};
/// Error (`Input`): a number that is 0 or 2^31 and more.
Expected<FramePath> parseFramePath(const std::string &text);
/// The path alone, whatever the number is.
std::string withoutFrame(const std::string &text);

} // namespace voxc
