// Work that is cut into numbered items: what processes of this machine and arrays of jobs carry out.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"

#include <cstdint>
#include <string>
#include <vector>

namespace voxc::tool {

/// Items of one level or more, one level above the other. Each is done by a command of this program, which
/// may be run any number of times and leaves alone what stands; each tells by what lies on the disk whether
/// it stands. An item needs those of the level below.
class Jobs {
public:
  virtual ~Jobs() = default;

  virtual std::size_t levels() const = 0;
  /// The numbers of each level's items that do not stand, ascending. Error: what tells it cannot be read.
  using Missing = std::vector<std::vector<std::uint64_t>>;
  virtual Expected<Missing> missing() const = 0;
  /// The words of the command that does items of a level, but for the program's name. `numbers`: "0,3,5-9".
  virtual std::vector<std::string> command(std::size_t level, const std::string &numbers) const = 0;
  /// What an item is expected to take, compared with the others of its level; 1 at least.
  virtual std::uint64_t costOf(std::size_t level, std::uint64_t number) const = 0;

  /// By which Slurm's jobs are known: the same for the same items, and for no others.
  virtual std::string name() const = 0;
  /// Where what jobs print is kept.
  virtual std::string folder() const = 0;
  /// The folder in which commands are run; "" where that does not matter.
  virtual std::string workingFolder() const { return ""; }
  /// What an item of a level is called, "a part", and what all of them are, "the plan's outputs".
  virtual std::string itemName(std::size_t level) const = 0;
  virtual std::string allName() const = 0;
};

/// How many items of all levels do not stand.
std::uint64_t countOf(const Jobs::Missing &missing);

/// How work is watched while others do it.
struct JobWatch {
  Progress progress;
  bool quiet = false; ///< No notes.
};

} // namespace voxc::tool
