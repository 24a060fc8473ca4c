// Checks of output paths.
#include "options/Outputs.h"

#include "common/FiguresFile.h"
#include "voxc/Volume/Volume.h"

#include <filesystem>
#include <system_error>

namespace voxc::tool {

namespace fs = std::filesystem;

Expected<void> checkOutputFile(const std::string &path) {
  if (path.empty())
    return Error::usage("the name of the output is empty; name a file");
  if (path == "-")
    return Error::usage("a volume cannot go to standard output; name a file");
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    return Error::input("output '" + path + "' is a directory; name a file");
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, ignored))
    return Error::input("output '" + path + "' lies in a folder that does not exist; make it first");
  return checkNoJournal(path); // Its edits would be of no file.
}

Expected<void> checkOutput(const std::string &path, const CommonOptions &common) {
  if (path != "-") {
    VOXC_TRY(checkOutputFile(path));
    return checkFiguresApart(common.stats, path);
  }
  if (common.stats == "-")
    return Error::usage("data and figures cannot both go to standard output; give one of them a file");
  return checkFiguresApart(common.stats, "/dev/stdout");
}

Expected<void> makeOutputFolder(const std::string &path) {
  std::error_code failure;
  if (fs::exists(path, failure) && !fs::is_directory(path, failure))
    return Error::input("output '" + path + "' is a file; name a folder");
  fs::create_directories(path, failure);
  if (failure)
    return Error::environment("folder '" + path + "' cannot be made: " + failure.message());
  return {};
}

} // namespace voxc::tool
