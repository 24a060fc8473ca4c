// The bytes of NBT. Sizes are proven against what is there before anything is looked at.
#include "Input/Minecraft/Nbt.h"

#include <array>
#include <string>

namespace voxc {

namespace {

constexpr int kMostDepth = 512;
constexpr std::uint64_t kMostTags = std::uint64_t{1} << 24;

/// Bytes of a payload; of arrays of each value; 0: it says itself how long it is.
constexpr std::array<std::uint8_t, 13> kSizes{0, 1, 2, 4, 8, 4, 8, 1, 0, 0, 0, 4, 8};

std::size_t sizeOf(NbtKind kind) { return kSizes[static_cast<std::size_t>(kind)]; }

bool isArray(NbtKind kind) {
  return kind == NbtKind::ByteArray || kind == NbtKind::IntArray || kind == NbtKind::LongArray;
}

bool isNumber(NbtKind kind) { return kind >= NbtKind::Byte && kind <= NbtKind::Double; }

std::int64_t numberOf(std::span<const std::byte> bytes) {
  std::uint64_t number = std::to_integer<unsigned>(bytes[0]) & 0x80u ? ~std::uint64_t{0} : 0;
  for (const std::byte byte : bytes)
    number = number << 8 | std::to_integer<std::uint64_t>(byte);
  return static_cast<std::int64_t>(number);
}

/// Reads on through bytes; after an end within a tag nothing more is read.
class NbtCursor {
public:
  explicit NbtCursor(std::span<const std::byte> bytes) : bytes_(bytes) {}

  bool isBroken() const { return isBroken_; }
  bool hasTooMany() const { return tags_ > kMostTags; }
  std::size_t at() const { return at_; }
  std::span<const std::byte> since(std::size_t begin) const { return bytes_.subspan(begin, at_ - begin); }

  std::span<const std::byte> take(std::uint64_t count) {
    isBroken_ = isBroken_ || count > bytes_.size() - at_;
    if (isBroken_)
      return {};
    at_ += count;
    return bytes_.subspan(at_ - count, count);
  }

  std::int64_t takeNumber(std::size_t size) {
    const auto bytes = take(size);
    return bytes.empty() ? 0 : numberOf(bytes);
  }

  NbtKind takeKind() {
    const std::int64_t kind = takeNumber(1);
    isBroken_ = isBroken_ || kind < 0 || kind >= static_cast<std::int64_t>(kSizes.size());
    return isBroken_ ? NbtKind::End : static_cast<NbtKind>(kind);
  }

  std::string_view takeText() {
    const auto bytes = take(static_cast<std::uint64_t>(takeNumber(2)) & 0xffff);
    return {reinterpret_cast<const char *>(bytes.data()), bytes.size()};
  }

  /// How many values follow. Negative is none, as Minecraft has it.
  std::uint64_t takeCount() {
    const std::int64_t count = takeNumber(4);
    return count < 0 ? 0 : static_cast<std::uint64_t>(count);
  }

  /// Passes over a payload, and proves it.
  void skip(NbtKind kind, int depth) {
    if (depth > kMostDepth || ++tags_ > kMostTags)
      isBroken_ = true;
    if (isBroken_)
      return;
    if (isArray(kind))
      take(takeCount() * sizeOf(kind));
    else if (kind == NbtKind::String)
      takeText();
    else if (kind == NbtKind::List)
      skipList(depth);
    else if (kind == NbtKind::Compound)
      skipCompound(depth);
    else
      take(sizeOf(kind));
  }

private:
  void skipList(int depth) {
    const NbtKind kind = takeKind();
    const std::uint64_t count = takeCount();
    // Values without bytes would be any number of turns.
    if (kind == NbtKind::End) {
      isBroken_ = isBroken_ || count > 0;
      return;
    }
    if (isNumber(kind))
      take(count * sizeOf(kind));
    else
      for (std::uint64_t i = 0; i < count && !isBroken_; ++i)
        skip(kind, depth + 1);
  }

  void skipCompound(int depth) {
    for (NbtKind kind = takeKind(); kind != NbtKind::End && !isBroken_; kind = takeKind()) {
      takeText();
      skip(kind, depth + 1);
    }
  }

  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  std::uint64_t tags_ = 0; ///< That were skipped.
  bool isBroken_ = false;
};

} // namespace

void NbtTag::forEach(FunctionRef<bool(const NbtTag &)> visit) const {
  NbtCursor cursor(payload_);
  const auto take = [&](NbtKind kind, std::string_view name) {
    const std::size_t begin = cursor.at();
    cursor.skip(kind, 0);
    return !cursor.isBroken() && visit({kind, name, cursor.since(begin)});
  };
  if (kind_ == NbtKind::List) {
    const NbtKind kind = cursor.takeKind();
    const std::uint64_t count = kind == NbtKind::End ? 0 : cursor.takeCount();
    for (std::uint64_t i = 0; i < count && take(kind, ""); ++i)
      ;
  } else if (kind_ == NbtKind::Compound) {
    for (NbtKind kind = cursor.takeKind(); kind != NbtKind::End; kind = cursor.takeKind()) {
      const std::string_view name = cursor.takeText();
      if (!take(kind, name))
        return;
    }
  }
}

NbtTag NbtTag::operator[](std::string_view name) const {
  NbtTag found;
  if (kind_ == NbtKind::Compound)
    forEach([&](const NbtTag &tag) {
      if (tag.name() == name)
        found = tag;
      return !found;
    });
  return found;
}

std::uint64_t NbtTag::size() const {
  std::uint64_t count = 0;
  if (isArray(kind_))
    return NbtCursor(payload_).takeCount();
  if (kind_ == NbtKind::List)
    return NbtCursor(payload_.subspan(1)).takeCount();
  forEach([&](const NbtTag &) { return ++count > 0; });
  return count;
}

std::optional<std::int64_t> NbtTag::number() const {
  const bool isWhole = kind_ >= NbtKind::Byte && kind_ <= NbtKind::Long;
  return isWhole ? std::optional(numberOf(payload_)) : std::nullopt;
}

std::optional<std::string_view> NbtTag::text() const {
  return kind_ == NbtKind::String ? std::optional(NbtCursor(payload_).takeText()) : std::nullopt;
}

std::span<const std::byte> NbtTag::array(NbtKind kind) const {
  return kind_ == kind && isArray(kind) ? payload_.subspan(4) : std::span<const std::byte>();
}

Expected<NbtTag> readNbt(std::span<const std::byte> bytes) {
  NbtCursor cursor(bytes);
  const NbtKind kind = cursor.takeKind();
  if (kind != NbtKind::Compound)
    return Error::input("it does not begin with a compound, as NBT files do");
  const std::string_view name = cursor.takeText();
  const std::size_t begin = cursor.at();
  cursor.skip(kind, 0);
  if (cursor.hasTooMany())
    return Error::input("it has more than " + std::to_string(kMostTags) + " tags");
  if (cursor.isBroken())
    return Error::input("its NBT is damaged behind byte " + std::to_string(cursor.at()) +
                        ": it ends too soon, has a tag that is not known, or lies more than " +
                        std::to_string(kMostDepth) + " deep");
  return NbtTag(kind, name, cursor.since(begin));
}

} // namespace voxc
