// Passes in names.
#include "report/PassNames.h"

#include <algorithm>
#include <map>

namespace voxc::report {
namespace {

bool has(const Passes &passes, const std::string &pass) {
  return std::ranges::find(passes, pass) != passes.end();
}

} // namespace

Passes usualPasses(std::span<const Passes *const> lists) {
  std::map<std::string, std::size_t> counts;
  Passes usual;
  for (const Passes *passes : lists)
    for (const std::string &pass : *passes)
      if (++counts[pass] == 1)
        usual.push_back(pass);
  std::erase_if(usual, [&](const std::string &pass) { return 2 * counts[pass] <= lists.size(); });
  return usual;
}

std::string passDifference(const Passes &passes, const Passes &usual) {
  std::string text;
  for (const std::string &pass : passes)
    if (!has(usual, pass))
      text += " +" + pass;
  for (const std::string &pass : usual)
    if (!has(passes, pass))
      text += " −" + pass;
  return text;
}

std::string passList(const Passes &passes) {
  std::string text;
  for (const std::string &pass : passes)
    text += (text.empty() ? "" : ", ") + pass;
  return text;
}

} // namespace voxc::report
