// Reading "I/N".
#include "building/FragmentOption.h"

#include <charconv>
#include <string_view>

namespace voxc::tool {
namespace {

constexpr std::uint64_t kMostFragments = std::uint64_t{1} << 20;

std::optional<FragmentChoice> parseFragment(std::string_view text) {
  FragmentChoice choice;
  const char *const end = text.data() + text.size();
  const auto [slash, badIndex] = std::from_chars(text.data(), end, choice.index);
  if (badIndex != std::errc() || slash == end || *slash != '/')
    return std::nullopt;
  const auto [rest, badCount] = std::from_chars(slash + 1, end, choice.count);
  if (badCount != std::errc() || rest != end || choice.index >= choice.count || choice.count > kMostFragments)
    return std::nullopt;
  return choice;
}

std::string checkFragment(const std::string &text) {
  return parseFragment(text) ? std::string()
                             : "'" + text + "' is no fragment; write i/N with i from 0 to N - 1";
}

} // namespace

void FragmentOption::declare(const CommandLine &command, const std::string &summary) {
  command.add("--fragment", text_, summary).takes("I/N").check(checkFragment);
}

std::optional<FragmentChoice> FragmentOption::choice() const { return parseFragment(text_); }

} // namespace voxc::tool
