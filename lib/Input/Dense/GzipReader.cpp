// Inflating by zlib.
#include "Input/Dense/GzipReader.h"

#include <algorithm>
#include <limits>
#include <string>
#include <zlib.h>

namespace voxc {

namespace {

/// Deflate makes no more of a byte than this.
constexpr std::uint64_t kMostPerByte = 1032;

constexpr std::size_t kMostAtOnce = std::numeric_limits<uInt>::max();

} // namespace

struct GzipReader::State {
  z_stream stream{};
  bool isOpen = false;
};

bool isGzip(std::span<const std::byte> bytes) {
  return bytes.size() >= 2 && bytes[0] == std::byte{0x1f} && bytes[1] == std::byte{0x8b};
}

GzipReader::GzipReader(std::span<const std::byte> bytes, Wrapping wrapping)
    : bytes_(bytes), state_(std::make_unique<State>()) {
  // 16: a gzip header is expected. Either way the checksum is held against the data.
  const int windowBits = wrapping == Wrapping::Gzip   ? 16 + MAX_WBITS
                         : wrapping == Wrapping::Zlib ? MAX_WBITS
                                                      : -MAX_WBITS;
  state_->isOpen = inflateInit2(&state_->stream, windowBits) == Z_OK;
}

GzipReader::~GzipReader() {
  if (state_->isOpen)
    inflateEnd(&state_->stream);
}

Expected<void> GzipReader::read(std::span<std::byte> target) {
  const auto count = VOXC_TRY(readSome(target));
  return count == target.size() ? Expected<void>() : Error::input("its compressed data ends too soon");
}

Expected<std::size_t> GzipReader::readSome(std::span<std::byte> target) {
  const std::size_t wanted = target.size();
  z_stream &stream = state_->stream;
  if (!state_->isOpen)
    return Error::environment("out of memory for inflating");
  while (!target.empty()) {
    const std::size_t given = std::min(bytes_.size(), kMostAtOnce);
    const std::size_t room = std::min(target.size(), kMostAtOnce);
    stream.next_in = reinterpret_cast<Bytef *>(const_cast<std::byte *>(bytes_.data()));
    stream.avail_in = static_cast<uInt>(given);
    stream.next_out = reinterpret_cast<Bytef *>(target.data());
    stream.avail_out = static_cast<uInt>(room);
    const int result = inflate(&stream, Z_NO_FLUSH);
    bytes_ = bytes_.subspan(given - stream.avail_in);
    target = target.subspan(room - stream.avail_out);
    if (result == Z_STREAM_END && !target.empty()) {
      if (!isGzip(bytes_))
        break;
      inflateReset(&stream);
    } else if (result == Z_BUF_ERROR) {
      return Error::input("its compressed data ends too soon");
    } else if (result != Z_OK && result != Z_STREAM_END) {
      return Error::input(std::string("its compressed data is damaged") +
                          (stream.msg ? std::string(": ") + stream.msg : std::string()));
    }
  }
  return wanted - target.size();
}

Expected<std::shared_ptr<const InflatedBytes>> GzipReader::read(std::uint64_t count,
                                                                const std::shared_ptr<WorkingMemory> &memory,
                                                                const Progress &progress) {
  if (count / kMostPerByte > bytes_.size() + kMostPerByte)
    return Error::input("its " + std::to_string(bytes_.size()) + " compressed bytes cannot hold the " +
                        std::to_string(count) + " that its header speaks of");
  auto inflated = std::make_shared<InflatedBytes>(memory);
  VOXC_TRY(inflated->resize(count));
  constexpr std::uint64_t kStep = std::uint64_t{1} << 18;
  for (std::uint64_t done = 0; done < count; done += kStep) {
    progress.at("inflate", static_cast<double>(done) / static_cast<double>(count));
    if (progress.stopped())
      return Error::interrupted();
    VOXC_TRY(read(inflated->span().subspan(done, std::min(kStep, count - done))));
    memory->relieve();
  }
  return std::shared_ptr<const InflatedBytes>(std::move(inflated));
}

} // namespace voxc
