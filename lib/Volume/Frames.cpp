// Frames of a volume, and the names of files with the number of one.
#include "Frames.h"

#include <charconv>

namespace voxc {

std::span<const Frame> framesOf(const Volume &volume) {
  const Stream *const stream = volume.findStream(kFrameStream);
  return stream ? stream->as<Frame>() : std::span<const Frame>();
}

Stream frameStream(std::span<const Frame> frames) {
  return {std::string(kFrameStream), sizeof(Frame), std::as_bytes(frames)};
}

Expected<void> checkFrames(const Volume &volume) {
  const Stream *const stream = volume.findStream(kFrameStream);
  if (!stream)
    return {};
  const std::span<const Frame> frames = framesOf(volume);
  if (frames.empty())
    return Error::input("its stream of frames has no elements of " + std::to_string(sizeof(Frame)) +
                        " bytes");
  if (volume.layout().ranksVoxels())
    return Error::input("a volume with values apart cannot have frames, for ranks count all voxels");
  const Frame shown{volume.words()[0], 0, volume.info().voxels};
  if (frames.front() != shown)
    return Error::input("its words do not begin with its first frame");
  return {};
}

Expected<void> checkFrameNumber(int number, std::uint64_t frames) {
  if (number >= 1 && static_cast<std::uint64_t>(number) <= frames)
    return {};
  return Error::input("it has no frame " + std::to_string(number) + "; there " +
                      (frames < 2 ? std::string("is one") : "are " + std::to_string(frames)));
}

namespace {

/// Where "#N" begins at the end of a path; its length where there is none.
std::size_t frameMark(const std::string &text) {
  const std::size_t mark = text.rfind('#');
  const bool isNumber = mark != std::string::npos && mark + 1 < text.size() &&
                        text.find_first_not_of("0123456789", mark + 1) == std::string::npos;
  return isNumber ? mark : text.size();
}

} // namespace

std::string withoutFrame(const std::string &text) { return text.substr(0, frameMark(text)); }

Expected<FramePath> parseFramePath(const std::string &text) {
  const std::size_t mark = frameMark(text);
  FramePath named{text.substr(0, mark)};
  if (mark == text.size())
    return named;
  const char *const end = text.data() + text.size();
  const auto [at, failure] = std::from_chars(text.data() + mark + 1, end, named.frame);
  if (failure != std::errc() || named.frame < 1)
    return Error::input("'" + text + "' names no frame; the first is #1");
  return named;
}

} // namespace voxc
