// Passes in names: those that most cells have are told once, and a name says where it differs from them.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace voxc::report {

using Passes = std::vector<std::string>;

/// The passes that more than half of the lists have, in the order in which they first came.
Passes usualPasses(std::span<const Passes *const> lists);

/// " +restart-sv −whole-level-dedup": which passes a list has beside the usual ones, and which of those it
/// lacks; "" if it is the usual list, whatever the order.
std::string passDifference(const Passes &passes, const Passes &usual);

/// "whole-level-dedup, restart-sv", or "" for no passes.
std::string passList(const Passes &passes);

} // namespace voxc::report
