// Running a sweep: model by model, first the volumes, then the rays in groups.
#include "sweep/Sweep.h"

#include "sweep/Shares.h"

#include "common/FiguresFile.h"
#include "options/Outputs.h"
#include "voxc/Measure/SearchVerdict.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <tuple>

namespace voxc::tool::bench {
namespace {

namespace fs = std::filesystem;

constexpr double kStepsOfBuild = 5; ///< How many rounds a build counts for in the progress.
constexpr int kMostPictureWidth = 640;
constexpr const char *kCacheFolder = "cache", *kPictureFolder = "pictures"; ///< In that of results.

/// The words of each level, as a build tells them, or none.
std::optional<std::vector<std::uint64_t>> levelWords(const Json &figures) {
  const auto levels = figures.find("levels");
  if (levels == figures.end() || !levels->is_array())
    return std::nullopt;
  std::vector<std::uint64_t> words;
  for (const Json &level : *levels) {
    if (!level.is_object() || !level.contains("words") || !level["words"].is_number_unsigned())
      return std::nullopt;
    words.push_back(level["words"].get<std::uint64_t>());
  }
  return words;
}

/// A build's figures as parts of a record.
void addBuild(const CachedVolume &volume, Record &record) {
  const Json &figures = volume.figures;
  const auto figure = [&](const char *key) {
    const auto entry = figures.find(key);
    return entry != figures.end() && entry->is_number() ? Figure(entry->get<double>()) : std::nullopt;
  };
  const auto count = [&](const char *key) {
    const auto entry = figures.find(key);
    return entry != figures.end() && entry->is_number_unsigned() ? Count(entry->get<std::uint64_t>())
                                                                 : std::nullopt;
  };
  record.volume = {count("words"), count("bytes"), count("file_bytes"), {}, levelWords(figures)};
  record.model.voxels = count("voxels");
  if (record.volume.bytes && record.model.voxels.value_or(0) > 0)
    record.volume.bytesPerVoxel = double(*record.volume.bytes) / double(*record.model.voxels);
  record.build = {figure("load_seconds"),      figure("compile_seconds"), figure("build_seconds"),
                  figure("build_cpu_seconds"), figure("write_seconds"),   count("peak_rss_bytes")};
}

/// Of the input, as a build tells it; 0 if it does not, which no camera and no oracle minds.
Int3 extentOf(const CachedVolume &volume) {
  const auto entry = volume.figures.find("extent");
  if (entry == volume.figures.end() || !entry->is_array() || entry->size() != 3)
    return {};
  for (const Json &axis : *entry)
    if (!axis.is_number_integer())
      return {};
  return {(*entry)[0].get<int>(), (*entry)[1].get<int>(), (*entry)[2].get<int>()};
}

bool isSame(Int3 a, Int3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

/// Memory that an built takes beside its mapped volume, and that volume.
std::uint64_t bytesOf(const BuiltCell &built, std::size_t rays) {
  const std::uint64_t words = built.cell->record.volume.bytes.value_or(0);
  const std::uint64_t perRay = sizeof(Ray) + sizeof(Hit);
  return built.cell->record.device.kind == "vulkan" ? 2 * words + 2 * rays * perRay : words + rays * perRay;
}

/// Another model of the name, or the same after a change, has another picture.
std::string picturePath(const SweepModel &model) {
  return std::string(kPictureFolder) + "/" + model.model.name + "-" + model.model.digest.substr(0, 8) +
         ".png";
}

/// The camera of a model's picture: its first, no wider than a report wants it.
Camera pictureCamera(const SweepModel &model, Int3 extent) {
  Camera camera = frameExtent(extent, kMostPictureWidth, kMostPictureWidth * 9 / 16);
  const auto first = std::ranges::find_if(model.rays, [](const RaySet &set) { return bool(set.camera); });
  if (first != model.rays.end())
    camera = first->camera(extent);
  if (camera.width > kMostPictureWidth) {
    camera.height = std::max(1, camera.height * kMostPictureWidth / camera.width);
    camera.width = kMostPictureWidth;
  }
  return camera;
}

} // namespace

Expected<void> checkFiguresNoResults(const std::string &folder, const CommonOptions &common) {
  std::error_code ignored;
  const auto whole = [&](const fs::path &path) {
    return fs::weakly_canonical(fs::absolute(path, ignored), ignored);
  };
  const fs::path stats = whole(common.stats);
  const bool isResult = stats.extension() == fs::path(kResultsName).extension() ||
                        stats.filename().string().starts_with(kVerdictPrefix);
  if (!common.stats.empty() && isResult && stats.parent_path() == whole(folder + "/results").parent_path())
    return Error::usage("--stats '" + common.stats + "' would be read as results of '" + folder +
                        "'; give the figures another name, such as figures.json");
  return checkFiguresApart(common.stats, folder + "/" + kResultsName);
}

Expected<void> makeResultsFolder(const std::string &folder, const CommonOptions &common) {
  VOXC_TRY(checkFiguresNoResults(folder, common));
  for (const char *own : {"report.html", "report.csv", kCacheFolder, kPictureFolder})
    VOXC_TRY(checkFiguresApart(common.stats, folder + "/" + own));
  return makeOutputFolder(folder);
}

Expected<Sweep> Sweep::open(const SweepAxes &axes, std::vector<Cell> cells, SweepOptions options) {
  for (const char *below : {kCacheFolder, kPictureFolder})
    VOXC_TRY(makeOutputFolder(options.folder + "/" + below));
  for (const SweepModel &model : axes.models)
    for (const RaySet &rays : model.rays)
      VOXC_TRY(keepRays(rays, options.folder + "/cache"));
  const std::string path = options.folder + "/" + options.records;
  const bool isShare = options.records != kResultsName;
  auto writer = VOXC_TRY(RecordWriter::open(path));
  VOXC_TRY(isShare ? Expected<void>() : joinShares(options.folder, "", writer));
  const auto records = VOXC_TRY(readRecords(options.folder));
  const auto own = VOXC_TRY(isShare ? readRecordFile(path) : std::vector<Record>());
  Sweep sweep(axes, std::move(cells), std::move(options), std::move(writer));
  sweep.takeKnown(records, own);
  return sweep;
}

void Sweep::takeKnown(const std::vector<Record> &records, const std::vector<Record> &own) {
  std::map<std::string, const Record *> known;
  for (const Record &record : records)
    known[record.cell] = &record;
  std::set<std::string> isOwn;
  for (const Record &record : own)
    isOwn.insert(record.cell);
  for (Cell &cell : cells_) {
    const auto before = known.find(cell.record.cell);
    if (before == known.end())
      continue;
    cell.before = *before->second;
    cell.pending =
        !isOwn.contains(cell.record.cell) && (cell.before->isMeasured() ? options_.again : options_.retry);
    cell.isKept = !cell.pending;
    if (cell.isKept)
      cell.record = *cell.before;
  }
}

void Sweep::advance(double steps) {
  steps_ += steps;
  progress_.at("bench", steps_ / allSteps_);
}

std::vector<Cell *> Sweep::pendingOf(const SweepModel &model, const SweepFormat &format) {
  std::vector<Cell *> pending;
  for (Cell &cell : cells_)
    if (cell.pending && cell.model == &model && cell.format == &format)
      pending.push_back(&cell);
  return pending;
}

Expected<void> Sweep::finish(Cell &cell) {
  cell.pending = false;
  return writer_.append(cell.record);
}

Expected<void> Sweep::fail(std::span<Cell *const> cells, const Failure &failure) {
  for (Cell *cell : cells) {
    cell->record.failure = failure;
    VOXC_TRY(finish(*cell));
  }
  advance(double(stepsOf(cells.size(), options_.measure)));
  return {};
}

Expected<void> Sweep::run(const Progress &progress) {
  progress_ = progress;
  options_.measure.progress.stop = progress.stop;
  options_.measure.advance = [this] { advance(1); };
  for (const SweepModel &model : axes_->models)
    for (const SweepFormat &format : axes_->formats)
      if (const auto pending = pendingOf(model, format); !pending.empty())
        allSteps_ += kStepsOfBuild + double(stepsOf(pending.size(), options_.measure));
  for (const SweepModel &model : axes_->models)
    VOXC_TRY(runModel(model));
  return {};
}

Expected<void> Sweep::runModel(const SweepModel &model) {
  auto ready = VOXC_TRY(buildModel(model));
  oracles_.clear();
  for (Ready &set : ready)
    VOXC_TRY(measureAll(model, set));
  return {};
}

Expected<VolumeCache::Outcome> Sweep::buildFormat(const SweepModel &model, const SweepFormat &format) {
  if (!format.problem.empty())
    return VolumeCache::Outcome(Failure{"parse", format.problem, {}});
  return cache_.get(model.model, format.format, progress_, [this] { advance(0); });
}

Expected<std::vector<Sweep::Ready>> Sweep::buildModel(const SweepModel &model) {
  std::vector<Ready> ready;
  for (const SweepFormat &format : axes_->formats) {
    const std::vector<Cell *> pending = pendingOf(model, format);
    if (pending.empty())
      continue;
    auto outcome = VOXC_TRY(buildFormat(model, format));
    advance(kStepsOfBuild);
    if (const auto *failure = std::get_if<Failure>(&outcome)) {
      VOXC_TRY(fail(pending, *failure));
      continue;
    }
    const auto &volume = std::get<CachedVolume>(outcome);
    const Int3 extent = extentOf(volume);
    for (Cell *cell : pending) {
      addBuild(volume, cell->record);
      cell->record.model.size = {std::uint64_t(extent.x), std::uint64_t(extent.y), std::uint64_t(extent.z)};
      const auto fits = [&](const Ready &set) {
        return set.rays == cell->rays && isSame(set.extent, extent);
      };
      auto set = std::ranges::find_if(ready, fits);
      if (set == ready.end())
        set = ready.insert(ready.end(), {{}, cell->rays, extent});
      set->builtCells.push_back({cell, volume});
    }
  }
  return ready;
}

std::vector<std::span<const BuiltCell>> Sweep::groupsOf(const Ready &ready, std::size_t rays) const {
  std::vector<std::span<const BuiltCell>> groups;
  const std::span<const BuiltCell> all = ready.builtCells;
  std::size_t begin = 0;
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::uint64_t more = bytesOf(all[i], rays);
    if (i > begin && bytes + more > options_.groupBytes) {
      groups.push_back(all.subspan(begin, i - begin));
      begin = i;
      bytes = 0;
    }
    bytes += more;
  }
  groups.push_back(all.subspan(begin));
  return groups;
}

void Sweep::askOracle(const Ready &ready, GroupRays &rays) {
  const Extent extent{ready.extent.x, ready.extent.y, ready.extent.z};
  auto known = oracles_.find(extent);
  if (known == oracles_.end()) {
    // Every format holds the same voxels, so that the smallest volume gives the oracle of all.
    const auto bytes = [](const BuiltCell &built) { return built.cell->record.volume.bytes; };
    const BuiltCell &smallest = *std::ranges::min_element(ready.builtCells, {}, bytes);
    const Expected<Volume> volume = Volume::load(smallest.volume.path, {.trusted = true});
    if (!volume)
      return;
    Expected<Oracle> oracle = Oracle::of(*volume, {.stop = progress_.stop});
    if (!oracle)
      return;
    known = oracles_.emplace(extent, std::move(*oracle)).first;
  }
  auto exact = known->second.trace(rays.sampled.sample, 0, {.stop = progress_.stop});
  if (!exact)
    return;
  rays.sampled.exact = std::move(*exact);
  rays.oracle = &known->second;
}

Expected<void> Sweep::measureAll(const SweepModel &model, Ready &ready) {
  GroupRays rays{sampleRays(ready.rays->raysFor(ready.extent), options_.measure.check)};
  if (!rays.sampled.sample.empty())
    askOracle(ready, rays);
  for (const std::span<const BuiltCell> group : groupsOf(ready, rays.sampled.rays.size()))
    VOXC_TRY(measureGroup(model, ready, group, rays));
  return {};
}

Expected<void> Sweep::measureGroup(const SweepModel &model, const Ready &ready,
                                   std::span<const BuiltCell> group, const GroupRays &rays) {
  const std::string picture = picturePath(model), path = options_.folder + "/" + picture;
  std::error_code ignored;
  const bool isTaken = fs::exists(path, ignored);
  if (Expected<void> measured =
          measure(group, rays, options_.measure, isTaken ? "" : path, pictureCamera(model, ready.extent));
      !measured)
    return measured;
  for (const BuiltCell &built : group) {
    if (fs::exists(path, ignored))
      built.cell->record.model.picture = picture;
    VOXC_TRY(finish(*built.cell));
  }
  return {};
}

} // namespace voxc::tool::bench
