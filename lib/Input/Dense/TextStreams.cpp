// Samples that are written in digits.
#include "Input/Dense/ByteStream.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <string>
#include <string_view>

namespace voxc {

namespace {

std::string_view textOf(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char *>(bytes.data()), bytes.size()};
}

constexpr std::string_view kBlanks = " \t\r\n\v\f";

class HexStream final : public ByteStream {
public:
  explicit HexStream(std::span<const std::byte> bytes) : text_(textOf(bytes)), most_(bytes.size() / 2) {}

  Expected<std::size_t> readSome(std::span<std::byte> target) override {
    for (std::size_t i = 0; i < target.size(); ++i) {
      const int high = nextDigit();
      if (high == kEnd)
        return i;
      const int low = high < 0 ? high : nextDigit();
      if (high < 0 || low < 0)
        return Error::input(
            "its data in hexadecimal digits have another character between them, or one digit too few");
      target[i] = static_cast<std::byte>(high << 4 | low);
    }
    return target.size();
  }
  std::uint64_t mostBytes() const override { return most_; }

private:
  static constexpr int kEnd = -1;
  static constexpr int kNone = -2;

  int nextDigit() {
    text_.remove_prefix(std::min(text_.find_first_not_of(kBlanks), text_.size()));
    if (text_.empty())
      return kEnd;
    int digit = 0;
    const auto parsed = std::from_chars(text_.data(), text_.data() + 1, digit, 16);
    text_.remove_prefix(1);
    return parsed.ec == std::errc() ? digit : kNone;
  }

  std::string_view text_;
  std::uint64_t most_;
};

/// Writes a number as a sample. False: it is none of the type.
using Store = bool (*)(std::string_view word, std::byte *target);

template <typename Stored> bool store(std::string_view word, std::byte *target) {
  word.remove_prefix(word.starts_with('+') ? 1 : 0);
  Stored value{};
  const auto parsed = std::from_chars(word.data(), word.data() + word.size(), value);
  if (parsed.ec != std::errc() || parsed.ptr != word.data() + word.size())
    return false;
  std::memcpy(target, &value, sizeof value);
  return true;
}

/// In the order of `SampleType`.
constexpr std::array<Store, 10> kStores{store<std::int8_t>,   store<std::uint8_t>,  store<std::int16_t>,
                                        store<std::uint16_t>, store<std::int32_t>,  store<std::uint32_t>,
                                        store<std::int64_t>,  store<std::uint64_t>, store<float>,
                                        store<double>};

class TextStream final : public ByteStream {
public:
  TextStream(std::span<const std::byte> bytes, SampleType type)
      : text_(textOf(bytes)), most_((bytes.size() / 2 + 1) * byteSize(type)), bytes_(byteSize(type)),
        store_(kStores[static_cast<std::size_t>(type)]) {}

  Expected<std::size_t> readSome(std::span<std::byte> target) override {
    std::size_t done = 0;
    while (done < target.size()) {
      if (left_ == 0) {
        const std::string_view word = nextWord();
        if (word.empty())
          return done;
        if (!store_(word, sample_.data()))
          return Error::input("its data have '" + std::string(word.substr(0, 40)) +
                              "', which is no number of its type");
        left_ = bytes_;
      }
      const std::size_t count = std::min(left_, target.size() - done);
      std::memcpy(target.data() + done, sample_.data() + (bytes_ - left_), count);
      left_ -= count;
      done += count;
    }
    return done;
  }
  std::uint64_t mostBytes() const override { return most_; }

private:
  std::string_view nextWord() {
    constexpr std::string_view kBetween = " \t\r\n\v\f,";
    text_.remove_prefix(std::min(text_.find_first_not_of(kBetween), text_.size()));
    const std::string_view word = text_.substr(0, text_.find_first_of(kBetween));
    text_.remove_prefix(word.size());
    return word;
  }

  std::string_view text_;
  std::uint64_t most_;
  std::size_t bytes_;
  Store store_;
  std::array<std::byte, 8> sample_{};
  std::size_t left_ = 0; ///< Bytes of `sample_` that were not read yet.
};

} // namespace

std::unique_ptr<ByteStream> makeHexStream(std::span<const std::byte> bytes) {
  return std::make_unique<HexStream>(bytes);
}
std::unique_ptr<ByteStream> makeTextStream(std::span<const std::byte> bytes, SampleType type) {
  return std::make_unique<TextStream>(bytes, type);
}

} // namespace voxc
