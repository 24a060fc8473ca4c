// The options of the commands that measure in shares.
#pragma once

#include "jobs/JobOptions.h"
#include "sweep/Shares.h"

#include "common/CommandLine.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace voxc::tool::bench {

class ShareOptions {
public:
  /// Adds --share, --shares and those of `JobOptions` to a command. `defaultShares` says how many shares
  /// Slurm measures by default.
  void declare(const CommandLine &command, const std::string &defaultShares);

  /// The share that is to be measured here, if one is.
  std::optional<Share> share() const;
  /// Is all measured by others?
  bool areElsewhere() const { return jobs_.isGiven(); }
  /// How many shares there are then: `defaultShares` by Slurm, if nothing else was said.
  std::uint64_t count(std::uint64_t defaultShares) const;
  /// The words of the command `name` that measures one of them as this one would, but for --share.
  std::vector<std::string> command(const std::string &name) const;
  const JobOptions &jobs() const { return jobs_; }

private:
  JobOptions jobs_;
  std::string share_;
  std::uint64_t shares_ = 0;
  std::optional<CommandLine> command_;
};

} // namespace voxc::tool::bench
