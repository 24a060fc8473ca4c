// Warnings of a reader, of which no file can make too many.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace voxc {

/// Keeps the first warnings and counts the rest.
class Warnings {
public:
  void add(std::string sentence) {
    if (kept_.size() < kMost)
      kept_.push_back(std::move(sentence));
    else
      ++surplus_;
  }

  std::vector<std::string> take() {
    if (surplus_ != 0)
      kept_.push_back("there are " + std::to_string(surplus_) + " more warnings, which are not shown");
    return std::exchange(kept_, {});
  }

private:
  static constexpr std::size_t kMost = 50;

  std::vector<std::string> kept_;
  std::uint64_t surplus_ = 0;
};

} // namespace voxc
