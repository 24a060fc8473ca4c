// Build plans: how a volume is built in parts, by any number of processes and machines (docs/cluster.md).
#pragma once

#include "cluster/MergeTree.h"

#include "voxc/Construct/Constructor.h"
#include "voxc/IR/Format.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace voxc::tool::cluster {

/// The cubes of voxels [begin, end), in Morton order, that one part has, and what they are predicted to cost.
struct CubeRange {
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
  std::uint64_t cost = 0;

  bool operator==(const CubeRange &) const = default;
};

/// A file of an input, by its absolute path, and the digest of its content.
struct InputFile {
  std::string digest;
  std::string path;

  bool operator==(const InputFile &) const = default;
};

/// How many outputs a merge joins at most. Fewer make a merge look up again what those below it have looked
/// up already; more do not fit the open files that systems allow.
inline constexpr std::uint64_t kDefaultFanIn = 64;
inline constexpr std::uint64_t kLeastFanIn = 2;
inline constexpr std::uint64_t kMostFanIn = 512;

struct BuildPlan {
  Format format;                ///< As it is stored, without traversals.
  std::string input;            ///< As a command takes it, files by their absolute paths.
  std::vector<InputFile> files; ///< All that the input is read from.
  std::string volume;    ///< The file that is written in the end: absolute, or from the folder of the plan.
  bool compress = false; ///< The volume's pages.
  std::uint64_t fanIn = kDefaultFanIn;
  std::vector<std::string> options; ///< Of the input: "resolution=2048".
  Int3 extent;                      ///< Of the input, in voxels.
  PartNumbers cubes;                ///< What ranges count.
  std::vector<CubeRange> ranges;    ///< Of each part. They follow one another and cover all cubes.

  MergeTree tree() const { return MergeTree(ranges.size(), fanIn); }
  /// Which of the fragments of its level an item of the tree is, and what it has.
  FragmentShare shareOf(const WorkItem &item) const;
  /// The digest of the text: by it the outputs of a plan are known.
  std::string digest() const;
};

/// The digest of a file's content. Error: `Input` if it cannot be read.
Expected<std::string> fileDigest(const std::string &path);

/// Whether all files of the input are those that the plan was made for. Error (`Input`): one is not.
Expected<void> checkInput(const BuildPlan &plan);

/// The one text of a plan.
std::string printPlan(const BuildPlan &plan);

/// Reads the text of a plan. Errors (`Input`), which name it `name`: it is no plan, was damaged, or says what
/// cannot be.
Expected<BuildPlan> parsePlan(std::string_view text, const std::string &name);

/// Reads a file. Errors: as `readTextFile` and `parsePlan`.
Expected<BuildPlan> loadPlan(const std::string &path);

} // namespace voxc::tool::cluster
