// Files that assimp reads. It throws; nothing of that leaves this file.
#include "voxc/Assimp/Assimp.h"

#include "Assimp/AssimpScene.h"
#include "Assimp/TrialRead.h"
#include "Input/Openers/Openers.h"
#include "Mesh/NumberCheck.h"
#include "Support/PathEnding.h"
#include "Support/ResidentGrowth.h"
#include "Support/Text.h"

#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>

#include <exception>
#include <mutex>
#include <optional>
#include <string_view>

namespace voxc {

namespace {

/// assimp has one logger for all that it reads.
std::mutex logging;

/// Collects what assimp warns of.
class WarningStream final : public Assimp::LogStream {
public:
  explicit WarningStream(Warnings &warnings) : warnings_(warnings) {}
  void write(const char *message) override {
    std::string_view text(message);
    for (const std::string_view front : {"Warn,", "Error,"})
      if (const std::size_t at = text.find(front); at != std::string_view::npos)
        text = text.substr(text.find(':', at) + 1);
    warnings_.add("assimp says: " + std::string(trimmed(text)));
  }

private:
  Warnings &warnings_;
};

/// Logs while it lives.
class Logging {
public:
  explicit Logging(Warnings &warnings) : lock_(logging), stream_(warnings) {
    Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
    Assimp::DefaultLogger::get()->attachStream(&stream_, Assimp::Logger::Warn);
  }
  ~Logging() {
    Assimp::DefaultLogger::get()->detachStream(&stream_, Assimp::Logger::Warn);
    Assimp::DefaultLogger::kill();
  }
  Logging(const Logging &) = delete;
  Logging &operator=(const Logging &) = delete;

private:
  std::lock_guard<std::mutex> lock_;
  WarningStream stream_;
};

/// True if a face of an .off file has numbers behind its corners: a colour, which assimp passes over.
bool hasFaceColours(std::string_view text) {
  TextLines lines(text);
  const auto next = [&]() -> std::optional<std::string_view> {
    while (const auto line = lines.next())
      if (const auto content = trimmed(line->substr(0, line->find('#'))); !content.empty())
        return content;
    return std::nullopt;
  };
  auto counts = next();
  if (counts && counts->find("OFF") != std::string_view::npos) {
    takeWord(*counts);
    if (trimmed(*counts).empty())
      counts = next();
  }
  const auto vertices = counts ? parseInteger(takeWord(*counts)) : std::nullopt;
  for (std::int64_t i = 0; vertices && i < *vertices; ++i)
    if (!next())
      return false;
  while (auto face = next()) {
    const auto corners = parseInteger(takeWord(*face));
    std::int64_t words = 0;
    while (!takeWord(*face).empty())
      ++words;
    if (!corners || words > *corners)
      return corners.has_value();
  }
  return false;
}

/// A scene without meshes stays without: assimp would make some of its skeleton. Later versions of it turn
/// the up of .fbx files, which is done here of all.
const aiScene *readWith(Assimp::Importer &importer, const std::string &path) {
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
#ifdef AI_CONFIG_IMPORT_FBX_IGNORE_UP_DIRECTION
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_IGNORE_UP_DIRECTION, true);
#endif
  return importer.ReadFile(path, 0);
}

/// Tries the file in a process of its own, as there are files that assimp does not survive.
Expected<void> tryOut(const MeshInput &input) {
  constexpr std::uint64_t kBytesAByte = 256, kBytes = std::uint64_t{1} << 30;
  auto tried = tryToRead(
      [&]() -> std::string {
        Assimp::Importer importer;
        return readWith(importer, input.path) ? std::string() : importer.GetErrorString();
      },
      kBytes + kBytesAByte * input.file->bytes().size(), input.progress);
  if (!tried && tried.error().kind == ErrorKind::Input)
    return Error::input("'" + input.path + "' cannot be read through assimp: " + tried.error().message);
  return tried;
}

Expected<TriangleScene> read(const MeshInput &input) {
  VOXC_TRY(tryOut(input));
  Warnings warnings;
  const ResidentGrowth growth;
  Assimp::Importer importer;
  const aiScene *found = nullptr;
  {
    const Logging log(warnings);
    found = readWith(importer, input.path);
  }
  if (!found)
    return Error::input("'" + input.path + "' cannot be read through assimp: " + importer.GetErrorString());
  const std::uint64_t taken = growth.bytes();
  const auto bytes = input.file->bytes();
  if (pathEnding(input.path) == ".off" &&
      hasFaceColours({reinterpret_cast<const char *>(bytes.data()), bytes.size()}))
    warnings.add("colours of faces are not read, and those of vertices are");
  auto scene = VOXC_TRY(sceneOf(*found, input, warnings));
  scene.loaderPeakBytes += taken;
  scene.warnings = warnings.take();
  if (auto checked = checkNumbers(scene, input); !checked)
    return Error{checked.error().kind, "'" + input.path + "': " + checked.error().message};
  return scene;
}

Expected<TriangleScene> load(const std::string &path, const std::shared_ptr<WorkingMemory> &memory,
                             const Progress &progress) {
  auto file = VOXC_TRY(WatchedFile::open(path, memory));
  try {
    return read({path, file, memory, progress});
  } catch (const std::bad_alloc &) {
    return Error::environment("there is not enough memory to read '" + path + "'");
  } catch (const std::exception &problem) {
    return Error::input("'" + path + "' cannot be read through assimp: " + problem.what());
  }
}

Expected<Input> open(const std::string &path, const InputOptions &options) {
  return openMeshBy(load, path, options);
}

} // namespace

std::vector<InputKind> assimpKinds() {
  std::vector<InputKind> kinds;
  for (const std::string_view ending : {".fbx", ".dae", ".3ds", ".off", ".x3d"})
    kinds.push_back({ending, open, "a mesh", true});
  return kinds;
}

} // namespace voxc
