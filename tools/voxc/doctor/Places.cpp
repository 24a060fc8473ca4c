// Where voxc keeps things, and what stands beside it.
#include "doctor/Checks.h"

#include "common/Command.h"
#include "program/Applications.h"
#include "voxc/Components/Components.h"
#include "voxc/Measure/Machine.h"
#include "voxc/Support/UserCache.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>
#include <unistd.h>

namespace voxc::tool {
namespace {

namespace fs = std::filesystem;

constexpr double kMiB = 1 << 20, kGiB = 1 << 30;
/// Scratch files of a large build are as large as its volume.
constexpr double kLittleSpace = 1;

std::string withDigit(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.1f", value);
  return text.data();
}

bool isWritable(const fs::path &folder) { return ::access(folder.c_str(), W_OK | X_OK) == 0; }

Check checkCache() {
  const std::string subject = "compiled code";
  const std::string folder = compileCacheFolder();
  if (folder.empty())
    return {subject, Check::State::Missing, "is not kept: VOXC_CACHE is off, or there is no home folder",
            "VOXC_CACHE=FOLDER keeps it, so that later runs begin at once"};
  const Expected<CompileCache> cache = CompileCache::open(folder);
  if (!cache)
    return {subject, Check::State::Missing, "is not kept: " + cache.error().message,
            "VOXC_CACHE=FOLDER names a folder of your own"};
  if (!isWritable(folder))
    return {subject, Check::State::Missing, "is not kept: '" + folder + "' cannot be written to",
            "make it writable, or name another with VOXC_CACHE=FOLDER"};
  const CompileCache::Usage usage = cache->usage();
  return {subject, Check::State::Good,
          folder + ", " + std::to_string(usage.entries) + " entries, " +
              withDigit(static_cast<double>(usage.bytes) / kMiB) + " of at most " +
              std::to_string(cache->mostBytes() >> 20) + " MiB",
          ""};
}

/// Where scratch files go without --scratch.
std::string scratchFolder() {
  const char *const temporary = std::getenv("TMPDIR");
  return temporary && *temporary ? temporary : "/var/tmp";
}

Check checkScratch() {
  const std::string subject = "scratch files";
  const std::string folder = scratchFolder();
  std::error_code failure;
  const fs::space_info space = fs::space(folder, failure);
  if (failure || !isWritable(folder))
    return {subject, Check::State::Bad,
            "'" + folder + "' cannot be used: " + (failure ? failure.message() : "it cannot be written to"),
            "name a folder that can be written to with TMPDIR, or --scratch of a command"};
  const double free = static_cast<double>(space.available) / kGiB;
  const bool isLittle = free < kLittleSpace;
  return {subject, isLittle ? Check::State::Missing : Check::State::Good,
          folder + ", " + withDigit(free) + " GiB free",
          isLittle ? "builds that are larger than memory need more; name another folder with TMPDIR" : ""};
}

/// The folders in which Python looks first, and those beside this program and of the system.
std::optional<fs::path> findModule(bool &isOnPath) {
  std::error_code failure;
  const char *const named = std::getenv("PYTHONPATH");
  std::istringstream folders(named ? named : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (fs::exists(fs::path(folder) / "voxc" / "__init__.py", failure)) {
      isOnPath = true;
      return fs::path(folder);
    }
  const fs::path own = fs::read_symlink("/proc/self/exe", failure).parent_path();
  if (fs::exists(own / ".." / "__init__.py", failure)) { // A wheel's, which lies where Python looks.
    isOnPath = true;
    return fs::weakly_canonical(own / ".." / "..", failure);
  }
  for (const fs::path &place : {own / ".." / "lib" / "python3" / "dist-packages", // As installed.
                                own / ".." / ".." / ".." / "python"})             // As built.
    if (fs::exists(place / "voxc" / "__init__.py", failure)) {
      fs::path folder = fs::weakly_canonical(place, failure);
      isOnPath = folder == "/usr/lib/python3/dist-packages";
      return folder;
    }
  return std::nullopt;
}

Check checkPython() {
  const std::string subject = "Python module";
  bool isOnPath = false;
  const std::optional<fs::path> folder = findModule(isOnPath);
  if (!folder)
    return {subject, Check::State::Missing, "is not beside voxc",
            "cmake --install BUILD --prefix DIR installs it, the package python3-voxc too"};
  if (!isOnPath)
    return {subject, Check::State::Missing, "is in " + folder->string() + ", where Python does not look",
            "PYTHONPATH=" + folder->string() + " makes 'import voxc' find it"};
  return {subject, Check::State::Good, folder->string(), ""};
}

} // namespace

std::string_view wordOf(Check::State state) {
  constexpr std::string_view kWords[] = {"ok", "note", "bad"};
  return kWords[static_cast<std::size_t>(state)];
}

std::vector<Check> checkBuild() {
  const Check openVdb =
      hasOpenVdb()
          ? Check{"OpenVDB", Check::State::Good, "built in: .vdb files are read and written", ""}
          : Check{"OpenVDB", Check::State::Missing, "not built in: .vdb files are not read or written",
                  "build with -DVOXC_OPENVDB=ON where OpenVDB is installed; .nvdb files do without"};
  const Check assimp =
      hasAssimp()
          ? Check{"assimp", Check::State::Good, "built in: .fbx, .dae, .3ds, .off and .x3d are read", ""}
          : Check{"assimp", Check::State::Missing,
                  "not built in: .fbx, .dae, .3ds, .off and .x3d are not read",
                  "build with -DVOXC_ASSIMP=ON where assimp is installed, or convert such meshes to .glb"};
  return {{"voxc", Check::State::Good, versionText() + ", LLVM " + measure::madeBy("").llvm, ""},
          openVdb,
          assimp};
}

std::vector<Check> checkFolders() { return {checkCache(), checkScratch()}; }

std::vector<Check> checkPrograms() {
  const Check viewer = opensWindows()
                           ? Check{"viewer", Check::State::Good, "voxc view opens a window", ""}
                           : Check{"viewer", Check::State::Missing, "there is no voxc-viewer beside voxc",
                                   "it is built where GLFW and Dear ImGui are installed: cmake --build BUILD "
                                   "--target voxc-viewer, or the package voxc-viewer"};
  return {viewer, checkPython()};
}

} // namespace voxc::tool
