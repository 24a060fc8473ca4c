// Lists of numbers as people and Slurm write them: "0,3,5-9".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voxc::tool::cluster {

/// The numbers of a list, each below `limit`, in the order in which they are written; nothing if the text is
/// no such list.
std::optional<std::vector<std::uint64_t>> parseNumberList(std::string_view text, std::uint64_t limit);

/// Numbers, ascending, as a list: those that follow one another as a range.
std::string numberListText(const std::vector<std::uint64_t> &numbers);

} // namespace voxc::tool::cluster
