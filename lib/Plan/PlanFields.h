// What plan text says as name=value: one table for a plan as a whole and one for a stratum, from which
// printer, parser and docs draw.
#pragma once

#include "voxc/Plan/Plan.h"

#include <span>
#include <string>
#include <string_view>

namespace voxc {

/// A stratum, its traversal and its construction, as one line of text has them.
struct PlannedStratum : Stratum, Traversal, Construction {};

template <typename Owner> struct Field {
  std::string_view name;
  /// The value as text; "" if it is the default, which is not written.
  std::string (*print)(const Owner &owner);
  /// False if this is no value of it.
  bool (*parse)(Owner &owner, std::string_view value);
  std::string_view values;                     ///< What it takes, for diagnostics.
  bool (*taken)(const Owner &owner) = nullptr; ///< Whether the owner has such a field; null: each has.

  bool isOf(const Owner &owner) const { return !taken || taken(owner); }
};

/// In the order in which they are printed.
std::span<const Field<Plan>> planFields();
std::span<const Field<PlannedStratum>> stratumFields();

} // namespace voxc
