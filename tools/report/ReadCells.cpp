// Reading records: JSON lines of which nothing is believed until it is looked at.
#include "report/Cells.h"

#include "common/Json.h"
#include "voxc/Support/File.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <unordered_map>

namespace voxc::report {
namespace {

using tool::Json;
namespace fs = std::filesystem;

constexpr int kSchema = 1;

/// The member of an object, or null.
const Json &member(const Json &object, const char *key) {
  static const Json kNull;
  if (!object.is_object())
    return kNull;
  const auto found = object.find(key);
  return found == object.end() ? kNull : *found;
}

std::string text(const Json &object, const char *key) {
  const Json &value = member(object, key);
  return value.is_string() ? value.get<std::string>() : std::string();
}

Figure figureOf(const Json &value) {
  if (!value.is_number())
    return {};
  const double number = value.get<double>();
  return std::isfinite(number) && number >= 0 ? Figure(number) : Figure();
}

Figure figure(const Json &object, const char *key) { return figureOf(member(object, key)); }

template <std::size_t N> std::array<Figure, N> figures(const Json &object, const char *key) {
  std::array<Figure, N> result;
  const Json &list = member(object, key);
  for (std::size_t i = 0; i < N && list.is_array() && i < list.size(); ++i)
    result[i] = figureOf(list[i]);
  return result;
}

/// A picture is only taken from inside the records' own folder.
std::string picturePath(const std::string &name, const fs::path &folder) {
  const fs::path path(name);
  const bool leaves = path.is_absolute() || std::ranges::find(path, fs::path("..")) != path.end();
  return name.empty() || leaves ? std::string() : (folder / path).string();
}

ModelRecord readModel(const Json &json, const fs::path &folder) {
  return {text(json, "name"), text(json, "input"), figures<3>(json, "size"), figure(json, "voxels"),
          picturePath(text(json, "picture"), folder)};
}

FormatRecord readFormat(const Json &json) {
  FormatRecord format{text(json, "label"), text(json, "name"), {}};
  for (const Json &pass : member(json, "passes"))
    if (pass.is_string())
      format.passes.push_back(pass.get<std::string>());
  return format;
}

DeviceRecord readDevice(const Json &json) {
  return {text(json, "name"), text(json, "kind"), text(json, "driver"), figure(json, "threads"),
          text(json, "clock") == "gpu"};
}

BuildRecord readBuild(const Json &json) {
  return {figure(json, "load_seconds"),  figure(json, "compile_seconds"),
          figure(json, "build_seconds"), figure(json, "build_cpu_seconds"),
          figure(json, "write_seconds"), figure(json, "peak_rss_bytes")};
}

SpeedRecord readSpeed(const Json &json, bool hasClock) {
  const Json &speed = member(json, hasClock ? "mrays_per_device_s" : "mrays_per_cpu_s");
  const Json &steady = member(json, "steady");
  return {figure(json, "rounds"), figure(speed, "min"),    figure(speed, "median"),
          figure(speed, "max"),   figure(speed, "spread"), !steady.is_boolean() || steady.get<bool>()};
}

std::optional<ErrorRecord> readError(const Json &json) {
  const Figure rays = figure(json, "rays"), missed = figure(json, "missed"), ghost = figure(json, "ghost"),
               wrong = figure(json, "wrong");
  if (!rays || !missed || !ghost || !wrong)
    return {};
  return ErrorRecord{*rays, *missed, *ghost, *wrong, figure(json, "boundary"), figure(json, "max_dt")};
}

MakerRecord readMaker(const Json &json) {
  return {text(json, "voxc"), text(json, "llvm"), text(json, "processor"), text(json, "command"),
          figure(json, "cores")};
}

/// Nothing if the line is no record.
std::optional<Cell> readCell(std::string_view line, const fs::path &folder) {
  const Json json = Json::parse(line, nullptr, false);
  if (figure(json, "schema") != double(kSchema))
    return {};
  Cell cell;
  cell.id = text(json, "cell");
  cell.model = readModel(member(json, "model"), folder);
  cell.format = readFormat(member(json, "format"));
  const std::string status = text(json, "status");
  if (cell.id.empty() || cell.model.name.empty() || cell.format.name.empty() ||
      (status != "measured" && status != "failed"))
    return {};
  cell.resolution = figure(json, "resolution").value_or(0);
  cell.precision = text(json, "precision");
  cell.device = readDevice(member(json, "device"));
  const Json &rays = member(json, "rays");
  cell.rays = {text(rays, "name"), text(rays, "kind"), figure(rays, "count"), figures<2>(rays, "size")};
  cell.measured = status == "measured";
  const Json &failure = member(json, "failure");
  cell.failure = {text(failure, "stage"), text(failure, "reason"), figure(failure, "words")};
  const Json &volume = member(json, "volume");
  cell.volume = {figure(volume, "bytes"), figure(volume, "bytes_per_voxel"), figure(volume, "file_bytes")};
  cell.build = readBuild(member(json, "build"));
  const Json &kernel = member(json, "kernel");
  cell.kernel = {figure(kernel, "compile_seconds"), figure(kernel, "upload_seconds"),
                 figure(kernel, "first_dispatch_seconds")};
  cell.speed = readSpeed(member(json, "speed"), cell.device.hasClock);
  const Json &work = member(json, "work");
  cell.lookupsPerRay = figure(work, "steps_per_ray");
  cell.wordsPerRay = figure(work, "words_per_ray");
  cell.error = readError(member(json, "error"));
  cell.maker = readMaker(member(json, "made_by"));
  return cell;
}

class Reader {
public:
  Expected<void> readFolder(const std::string &folder);
  Expected<Records> finish();

private:
  Expected<void> readFile(const fs::path &path);

  Records records_;
  std::unordered_map<std::string, std::size_t> indices_; ///< Of cells by their id.
};

Expected<void> Reader::readFolder(const std::string &folder) {
  std::error_code error;
  std::vector<fs::path> paths;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (entry->path().extension() == ".jsonl")
      paths.push_back(entry->path());
  if (error)
    return Error::input("cannot read the folder '" + folder + "': " + error.message());
  std::ranges::sort(paths);
  for (const fs::path &path : paths)
    if (Expected<void> read = readFile(path); !read)
      return read;
  return {};
}

Expected<void> Reader::readFile(const fs::path &path) {
  Expected<MappedFile> file = MappedFile::open(path.string());
  if (!file)
    return file.error();
  const std::span<const std::byte> bytes = file->bytes();
  std::string_view rest(reinterpret_cast<const char *>(bytes.data()), bytes.size());
  for (std::size_t number = 1; !rest.empty(); ++number) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    if (line.find_first_not_of(" \t\r") == std::string_view::npos)
      continue;
    std::optional<Cell> cell = readCell(line, path.parent_path());
    if (!cell) {
      records_.notes.push_back(path.string() + ":" + std::to_string(number) +
                               ": left out, because it is no record of schema " + std::to_string(kSchema));
      continue;
    }
    const auto [found, isNew] = indices_.try_emplace(cell->id, records_.cells.size());
    if (isNew)
      records_.cells.push_back(std::move(*cell));
    else
      records_.cells[found->second] = std::move(*cell);
  }
  return {};
}

Expected<Records> Reader::finish() {
  if (records_.cells.empty())
    return Error::input(records_.notes.empty() ? "there are no records; a folder should hold .jsonl files of voxc bench"
                                               : records_.notes.front());
  return std::move(records_);
}

} // namespace

Expected<Records> readCells(const std::vector<std::string> &folders) {
  Reader reader;
  for (const std::string &folder : folders)
    if (Expected<void> read = reader.readFolder(folder); !read)
      return read.error();
  return reader.finish();
}

} // namespace voxc::report
