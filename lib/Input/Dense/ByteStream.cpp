// Streams of bytes as they are or compressed, and what is done with any of them.
#include "Input/Dense/ByteStream.h"

#include "Input/Dense/GzipReader.h"
#include "Support/Text.h"

#include <algorithm>
#include <array>
#include <bzlib.h>
#include <cstring>
#include <string>
#include <vector>

namespace voxc {

namespace {

constexpr std::size_t kStep = std::size_t{1} << 18;

class RawStream final : public ByteStream {
public:
  explicit RawStream(std::span<const std::byte> bytes) : bytes_(bytes) {}

  Expected<std::size_t> readSome(std::span<std::byte> target) override {
    const std::size_t count = std::min(bytes_.size(), target.size());
    if (count > 0)
      std::memcpy(target.data(), bytes_.data(), count);
    bytes_ = bytes_.subspan(count);
    return count;
  }
  std::uint64_t mostBytes() const override { return bytes_.size(); }

private:
  std::span<const std::byte> bytes_;
};

class GzipStream final : public ByteStream {
public:
  GzipStream(std::span<const std::byte> bytes, GzipReader::Wrapping wrapping)
      : bytes_(bytes.size()), reader_(bytes, wrapping) {}

  Expected<std::size_t> readSome(std::span<std::byte> target) override { return reader_.readSome(target); }
  std::uint64_t mostBytes() const override { return (bytes_ + kMostPerByte) * kMostPerByte; }
  std::uint64_t bytesBehind() const override { return reader_.behind().size(); }

private:
  static constexpr std::uint64_t kMostPerByte = 1032; ///< Deflate makes no more of a byte.

  std::uint64_t bytes_;
  GzipReader reader_;
};

class Bzip2Stream final : public ByteStream {
public:
  explicit Bzip2Stream(std::span<const std::byte> bytes) : all_(bytes.size()), bytes_(bytes) {
    isOpen_ = BZ2_bzDecompressInit(&stream_, 0, 0) == BZ_OK;
  }
  ~Bzip2Stream() override { close(); }
  Bzip2Stream(const Bzip2Stream &) = delete;
  Bzip2Stream &operator=(const Bzip2Stream &) = delete;

  Expected<std::size_t> readSome(std::span<std::byte> target) override {
    const std::size_t wanted = target.size();
    while (!target.empty() && !isAtEnd_) {
      if (!isOpen_)
        return Error::environment("out of memory for bzip2");
      const std::size_t given = std::min(bytes_.size(), kMostAtOnce);
      const std::size_t room = std::min(target.size(), kMostAtOnce);
      stream_.next_in = const_cast<char *>(reinterpret_cast<const char *>(bytes_.data()));
      stream_.avail_in = static_cast<unsigned>(given);
      stream_.next_out = reinterpret_cast<char *>(target.data());
      stream_.avail_out = static_cast<unsigned>(room);
      const int result = BZ2_bzDecompress(&stream_);
      bytes_ = bytes_.subspan(given - stream_.avail_in);
      target = target.subspan(room - stream_.avail_out);
      if (result == BZ_STREAM_END)
        openNext();
      else if (result != BZ_OK)
        return Error::input("its bzip2 data is damaged");
      else if (bytes_.empty() && stream_.avail_out > 0)
        return Error::input("its compressed data ends too soon");
    }
    return wanted - target.size();
  }
  /// A block of 900 kB, each byte of which may stand for 52, takes some 40 bytes.
  std::uint64_t mostBytes() const override { return (std::uint64_t{all_} + 64) << 21; }
  std::uint64_t bytesBehind() const override { return bytes_.size(); }

private:
  static constexpr std::size_t kMostAtOnce = std::size_t{1} << 30;

  void close() {
    if (isOpen_)
      BZ2_bzDecompressEnd(&stream_);
    isOpen_ = false;
  }

  void openNext() {
    constexpr std::string_view kMagic = "BZh";
    isAtEnd_ = bytes_.size() < kMagic.size() || std::memcmp(bytes_.data(), kMagic.data(), kMagic.size()) != 0;
    if (isAtEnd_)
      return;
    close();
    stream_ = {};
    isOpen_ = BZ2_bzDecompressInit(&stream_, 0, 0) == BZ_OK;
  }

  std::size_t all_;
  std::span<const std::byte> bytes_;
  bz_stream stream_{};
  bool isOpen_ = false;
  bool isAtEnd_ = false;
};

Error tooFew(std::uint64_t found, std::uint64_t needed) {
  return Error::input("its data end after " + std::to_string(found) + " bytes, but it needs " +
                      std::to_string(needed));
}

} // namespace

std::unique_ptr<ByteStream> makeRawStream(std::span<const std::byte> bytes) {
  return std::make_unique<RawStream>(bytes);
}
std::unique_ptr<ByteStream> makeGzipStream(std::span<const std::byte> bytes) {
  return std::make_unique<GzipStream>(bytes, GzipReader::Wrapping::Gzip);
}
std::unique_ptr<ByteStream> makeDeflateStream(std::span<const std::byte> bytes) {
  return std::make_unique<GzipStream>(bytes, GzipReader::Wrapping::None);
}
std::unique_ptr<ByteStream> makeBzip2Stream(std::span<const std::byte> bytes) {
  return std::make_unique<Bzip2Stream>(bytes);
}

Expected<std::uint64_t> countBytes(ByteStream &stream, std::uint64_t most, const Progress &progress) {
  std::vector<std::byte> some(kStep);
  for (std::uint64_t count = 0;;) {
    if (progress.stopped())
      return Error::interrupted();
    const auto read = VOXC_TRY(stream.readSome(some));
    count += read;
    if (count > most)
      return Error::input("its data are more than the " + std::to_string(most) +
                          " bytes that they should be, with what they may skip");
    if (read < some.size())
      return count;
  }
}

Expected<void> skipBytes(ByteStream &stream, std::uint64_t count, const Progress &progress) {
  std::vector<std::byte> some(static_cast<std::size_t>(std::min<std::uint64_t>(kStep, count)));
  for (std::uint64_t done = 0; done < count;) {
    if (progress.stopped())
      return Error::interrupted();
    const std::size_t now = static_cast<std::size_t>(std::min<std::uint64_t>(some.size(), count - done));
    const auto read = VOXC_TRY(stream.readSome(std::span(some).first(now)));
    done += read;
    if (read < now)
      return Error::input("its data end within the " + std::to_string(count) + " bytes that it skips");
  }
  return {};
}

std::vector<std::string> saysBehind(ByteStream &stream) {
  std::array<std::byte, 64> some;
  const auto more = stream.readSome(some);
  if (!more)
    return {"behind the samples " + more.error().message};
  if (*more == 0 && stream.bytesBehind() == 0)
    return {};
  if (*more == 0)
    return {countedAre(stream.bytesBehind(), "byte") + " left out behind the compressed data"};
  return {"more is packed behind the samples, and is left out"};
}

Expected<void> appendBytes(ByteStream &stream, std::uint64_t count, ScratchArray<std::byte> &target,
                           WorkingMemory &memory, const Progress &progress) {
  if (count > stream.mostBytes())
    return tooFew(stream.mostBytes(), count);
  const std::uint64_t begin = target.size();
  for (std::uint64_t done = 0; done < count;) {
    progress.at("inflate", static_cast<double>(done) / static_cast<double>(count));
    if (progress.stopped())
      return Error::interrupted();
    const std::size_t now = static_cast<std::size_t>(std::min<std::uint64_t>(kStep, count - done));
    VOXC_TRY(target.resize(begin + done + now));
    const auto read = VOXC_TRY(stream.readSome(target.span().subspan(begin + done, now)));
    done += read;
    if (read < now)
      return tooFew(done, count);
    memory.relieve(now);
  }
  return {};
}

} // namespace voxc
