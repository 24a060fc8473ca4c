// JSON as it comes from a stranger: nothing is an error to ask, and nothing is taken for what it is not.
#pragma once

#include "voxc/Support/Error.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace voxc {

/// A value of a document, or nothing; valid while the document is.
class Json {
public:
  Json() = default;

  explicit operator bool() const { return value_ != nullptr; }
  bool isArray() const;
  bool isObject() const;

  /// Number of elements of an array; else 0.
  std::size_t size() const;
  /// An element of an array, or nothing.
  Json operator[](std::size_t index) const;
  /// A member of an object, or nothing.
  Json operator[](std::string_view key) const;
  /// The names of an object's members, in order.
  std::vector<std::string_view> keys() const;

  std::optional<double> number() const;
  /// A whole number from 0 to 2^53, however it is written.
  std::optional<std::uint64_t> count() const;
  std::optional<std::string_view> text() const;
  std::optional<bool> flag() const;

private:
  friend class JsonDocument;
  explicit Json(const void *value) : value_(value) {}

  const void *value_ = nullptr;
};

class JsonDocument {
public:
  /// Errors: what is no JSON, and from which byte on.
  static Expected<JsonDocument> parse(std::span<const std::byte> text);

  Json root() const { return Json(value_.get()); }

private:
  std::shared_ptr<const void> value_;
};

} // namespace voxc
