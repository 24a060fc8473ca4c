// NBT, the tags of Minecraft's files: proven once, then looked at in place.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/FunctionRef.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace voxc {

enum class NbtKind : std::uint8_t {
  End,
  Byte,
  Short,
  Int,
  Long,
  Float,
  Double,
  ByteArray,
  String,
  List,
  Compound,
  IntArray,
  LongArray
};

/// A tag that was proven. What it says is of this kind or is nothing: what a file may lack is asked for in
/// one chain, and looked at in the end.
class NbtTag {
public:
  NbtTag() = default;
  NbtTag(NbtKind kind, std::string_view name, std::span<const std::byte> payload)
      : kind_(kind), name_(name), payload_(payload) {}

  explicit operator bool() const { return kind_ != NbtKind::End; }
  NbtKind kind() const { return kind_; }
  std::string_view name() const { return name_; }
  /// Its bytes, from behind the name to its end.
  std::span<const std::byte> payload() const { return payload_; }

  /// A tag of a compound by its name; none if this is no compound, or has none.
  NbtTag operator[](std::string_view name) const;
  /// Calls `visit` for each tag of a compound or a list, until it returns false.
  void forEach(FunctionRef<bool(const NbtTag &)> visit) const;
  /// Tags of a list or a compound, values of an array; else 0.
  std::uint64_t size() const;
  /// A whole number of any size.
  std::optional<std::int64_t> number() const;
  std::optional<std::string_view> text() const;
  /// The big-endian values of an array of this kind; empty if it is of another.
  std::span<const std::byte> array(NbtKind kind) const;

private:
  NbtKind kind_ = NbtKind::End;
  std::string_view name_;
  std::span<const std::byte> payload_;
};

/// The tag at the beginning of `bytes`, which it points into, and all in it proven. Errors: no compound; an
/// end within a tag; tags that are not known, or lie more than 512 deep; more than 2^24 of them, where
/// numbers of a list are one.
Expected<NbtTag> readNbt(std::span<const std::byte> bytes);

} // namespace voxc
