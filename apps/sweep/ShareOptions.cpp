// Reading what is said of shares.
#include "sweep/ShareOptions.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <string_view>

namespace voxc::tool::bench {
namespace {

constexpr std::uint64_t kMostShares = 1 << 20;

/// Options that say who measures, and not what.
constexpr std::string_view kNotForShares[] = {"--local",   "--slurm",  "--partition", "--sbatch", "--poll",
                                              "--no-wait", "--shares", "--share",     "--stats",  "--quiet"};

std::optional<Share> parseShare(std::string_view text) {
  Share share;
  const char *const end = text.data() + text.size();
  const auto [slash, badIndex] = std::from_chars(text.data(), end, share.index);
  if (badIndex != std::errc() || slash == end || *slash != '/')
    return std::nullopt;
  const auto [rest, badCount] = std::from_chars(slash + 1, end, share.count);
  if (badCount != std::errc() || rest != end || share.index >= share.count || share.count > kMostShares)
    return std::nullopt;
  return share;
}

std::string shareProblem(const std::string &text) {
  return parseShare(text) ? std::string() : "'" + text + "' is no share; write I/N with I from 0 to N - 1";
}

} // namespace

void ShareOptions::declare(const CommandLine &command, const std::string &defaultShares) {
  command_ = command;
  const OptionGroup group(command, "Shares");
  jobs_.declare(command);
  const Option local = command.option("--local"), slurm = command.option("--slurm");
  local.text("Measure in shares, on so many processes of this machine");
  slurm.text("Measure in shares, as an array of jobs of Slurm");
  command.add("--shares", shares_, "Shares that Slurm measures, each a job; default: " + defaultShares)
      .takes("N")
      .between(std::uint64_t{1}, kMostShares)
      .needs(slurm);
  command
      .add("--share", share_,
           "Measure share I of N alone, I from 0, which others may do with the other shares meanwhile")
      .takes("I/N")
      .check(shareProblem)
      .excludes(local)
      .excludes(slurm);
}

std::optional<Share> ShareOptions::share() const { return parseShare(share_); }

std::uint64_t ShareOptions::count(std::uint64_t defaultShares) const {
  if (shares_ > 0)
    return shares_;
  return jobs_.bySlurm() ? std::max<std::uint64_t>(defaultShares, 1) : jobs_.processes();
}

std::vector<std::string> ShareOptions::command(const std::string &name) const {
  std::vector<std::string> words{name};
  for (const Option &option : command_->options())
    if (std::ranges::find(kNotForShares, option.name()) == std::end(kNotForShares))
      std::ranges::copy(option.words(), std::back_inserter(words));
  words.emplace_back("--quiet");
  return words;
}

} // namespace voxc::tool::bench
