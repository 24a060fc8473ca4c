// Properties of PLY files by their names, and which of them nobody used.
#pragma once

#include "Mesh/Ply/PlyHeader.h"

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// Index of the property with one of these names, in letters of any case, that is a number, or a list.
std::optional<std::size_t> findNumber(const PlyElement &element, std::string_view name);
std::optional<std::size_t> findList(const PlyElement &element, std::span<const std::string_view> names);

/// Keeps what of a file is used, and tells the rest.
class PlyUse {
public:
  /// The header must outlive this.
  explicit PlyUse(const PlyHeader &header) : header_(header) {}

  /// A property, if there is one, is used.
  void take(const PlyElement &element, std::optional<std::size_t> property) {
    if (property)
      used_[&element].insert(*property);
  }

  /// A sentence for each element with properties that nobody took, and one for elements of which nobody took
  /// any. Normals count as used: they say nothing about where a surface is.
  std::vector<std::string> warnings() const;

private:
  std::string unusedOf(const PlyElement &element, const std::set<std::size_t> &used) const;

  const PlyHeader &header_;
  std::map<const PlyElement *, std::set<std::size_t>> used_;
};

} // namespace voxc
