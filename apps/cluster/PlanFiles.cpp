// Names and checks of outputs.
#include "cluster/PlanFiles.h"

#include "cluster/TextDigest.h"

#include "voxc/Support/File.h"

#include <filesystem>
#include <system_error>

namespace voxc::tool::cluster {

namespace fs = std::filesystem;

PlanFiles::PlanFiles(const BuildPlan &plan, const std::string &path)
    : plan_(plan), tree_(plan.tree()), folder_(path + ".d"),
      volume_((fs::absolute(path).parent_path() / plan.volume).string()), digest_(plan.digest()) {}

Expected<void> PlanFiles::makeFolder() const {
  std::error_code failure;
  fs::create_directories(folder_, failure);
  if (failure)
    return Error::environment("folder '" + folder_ + "' cannot be made: " + failure.message());
  return {};
}

std::string PlanFiles::output(const WorkItem &item) const {
  if (tree_.isRoot(item))
    return volume_;
  const FragmentShare share = plan_.shareOf(item);
  const std::string kind = item.level == 0 ? "part" : "merge" + std::to_string(item.level);
  return folder_ + "/" + kind + "-" + std::to_string(item.index) + "-" + std::to_string(share.begin) + "-" +
         std::to_string(share.end) + "-" + digest_ + ".hvf";
}

std::string PlanFiles::noteOfVolume() const { return folder_ + "/volume-" + digest_ + ".txt"; }

namespace {

/// Volumes were noted without this while their parts could lack voxels (SECURITY.md); they are made again.
constexpr const char *kWhole = "made of whole parts\n";

/// What is noted of a file; empty if it cannot be read.
std::string noteOf(const std::string &path) {
  TextDigest digest;
  return digest.addFile(path) ? kWhole + ("content " + digest.hex()) + "\n" : "";
}

} // namespace

Expected<void> PlanFiles::noteVolume() const { return writeFile(noteOfVolume(), noteOf(volume_)); }

bool PlanFiles::volumeStands() const {
  const auto note = readTextFile(noteOfVolume());
  return note && !note->empty() && *note == noteOf(volume_);
}

bool PlanFiles::stands(const WorkItem &item) const {
  if (tree_.isRoot(item))
    return volumeStands();
  const auto share = checkFragment(output(item));
  const FragmentShare expected = plan_.shareOf(item);
  return share && *share == expected;
}

} // namespace voxc::tool::cluster
