// Cutting a sweep by its volumes, and the files of its shares.
#include "sweep/Shares.h"

#include "voxc/Measure/Digest.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace voxc::tool::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char *kPrefix = "share-", *kEnding = ".jsonl";

/// By what the volume of a cell is known.
std::string volumeOf(const Cell &cell) {
  const SweepFormat &format = *cell.format;
  const bool isRead = format.problem.empty();
  return Digest()
      .add(cell.model->model.digest)
      .add(isRead ? printIr(storageFormat(format.format)) : format.line.text)
      .hex();
}

} // namespace

std::vector<std::uint64_t> shareOfEach(const std::vector<Cell> &cells, std::uint64_t count) {
  std::map<std::string, std::uint64_t> volumes; // By their places in the order of cells.
  std::vector<std::uint64_t> shares;
  shares.reserve(cells.size());
  for (const Cell &cell : cells)
    shares.push_back(volumes.emplace(volumeOf(cell), volumes.size()).first->second);
  for (std::uint64_t &share : shares)
    share = share * count / volumes.size();
  return shares;
}

void keepShare(std::vector<Cell> &cells, const Share &share) {
  const std::vector<std::uint64_t> shares = shareOfEach(cells, share.count);
  std::size_t next = 0;
  std::erase_if(cells, [&](const Cell &) { return shares[next++] != share.index; });
}

std::string sweepDigest(const SweepAxes &axes) {
  Digest digest;
  for (const SweepModel &model : axes.models) {
    digest.add(model.model.name).add(model.model.digest);
    for (const RaySet &rays : model.rays)
      digest.add(rays.part.digest).add(rays.part.order.value_or(""));
  }
  for (const SweepFormat &format : axes.formats) {
    digest.add(format.line.label).add(format.line.text);
    for (const std::string &pass : format.passes)
      digest.add(pass);
  }
  for (const std::string &precision : axes.precisions)
    digest.add(precision);
  for (const SweepDevice &device : axes.devices)
    digest.add(device.asked);
  return digest.hex();
}

std::string shareFileName(const std::string &sweepDigest, const Share &share) {
  return kPrefix + std::to_string(share.index) + shareFileEnding(sweepDigest, share.count);
}

std::string shareFileEnding(const std::string &sweepDigest, std::uint64_t count) {
  return "-of-" + std::to_string(count) + "-" + sweepDigest + kEnding;
}

Expected<void> joinShares(const std::string &folder, const std::string &but, RecordWriter &results) {
  std::error_code failure;
  std::vector<std::string> paths;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure))
    if (const std::string name = entry->path().filename().string();
        name.starts_with(kPrefix) && name.ends_with(kEnding) && (but.empty() || !name.ends_with(but)))
      paths.push_back(entry->path().string());
  if (failure)
    return Error::input("folder '" + folder + "' cannot be read: " + failure.message());
  std::ranges::sort(paths);
  for (const std::string &path : paths)
    VOXC_TRY(results.take(path));
  return {};
}

} // namespace voxc::tool::bench
