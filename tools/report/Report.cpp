// Putting the sections into the page.
#include "report/Report.h"

#include "report/Csv.h"
#include "report/Html.h"
#include "report/RuntimeFile.h"
#include "report/Sections.h"
#include "report/Thumbnail.h"

#include <algorithm>
#include <map>

namespace voxc::report {
namespace {

/// What the page should not exceed, and what one picture may take of it at most, and at least if there are
/// few.
constexpr std::size_t kPageBytes = 980'000;
constexpr std::size_t kMostOfOne = 90'000, kLeastOfOne = 12'000;

/// The first picture of each model.
std::map<std::string, std::string> picturePaths(const std::vector<Cell> &cells) {
  std::map<std::string, std::string> paths;
  for (const Cell &cell : cells)
    if (cell.model.picture)
      paths.try_emplace(cell.model.name, *cell.model.picture);
  return paths;
}

/// The pictures, which share `bytes`.
Pictures loadPictures(const std::vector<Cell> &cells, std::size_t bytes, std::vector<std::string> &notes) {
  Pictures pictures;
  const auto paths = picturePaths(cells);
  const std::size_t most = paths.empty() ? 0 : std::clamp(bytes / paths.size(), kLeastOfOne, kMostOfOne);
  for (const auto &[model, path] : paths) {
    Expected<std::string> picture = thumbnail(path, most);
    if (picture)
      pictures[model] = std::move(*picture);
    else
      notes.push_back(picture.error().message);
  }
  return pictures;
}

/// The verdict of a search that has just ended, and those on stages that it says nothing of.
std::vector<SearchVerdict> allVerdicts(const std::vector<Cell> &cells, std::optional<SearchVerdict> own) {
  std::vector<SearchVerdict> verdicts = searchVerdicts(cells);
  if (!own)
    return verdicts;
  std::erase_if(verdicts, [&](const SearchVerdict &verdict) {
    return std::ranges::any_of(verdict.stages,
                               [&](const std::string &stage) { return own->stages.contains(stage); });
  });
  verdicts.insert(verdicts.begin(), std::move(*own));
  return verdicts;
}

/// A section with its place in the list of contents, which it has if it is not empty.
struct Section {
  const char *id, *name;
  std::string html;
};

std::string makePage(const Catalogue &catalogue, const Pictures &pictures, const ModelNotes &notes,
                     const std::string &csvName) {
  const Section sections[] = {
      {"models", "Models", modelSections(catalogue, pictures, notes)},
      {"frontier", "Frontiers", frontierSection(catalogue)},
      {"predictions", "Predictions", predictionSection(catalogue)},
      {"dedup", "Sharing", dedupSection(catalogue)},
      {"restart", "Restarting", restartSection(catalogue)},
      {"unroll", "Unrolling", unrollSection(catalogue)},
      {"precision", "Exactness", precisionSection(catalogue)},
      {"memory", "Memory", memorySection(catalogue)},
      {"failures", "Failures", failureSection(catalogue)},
      {"cells", "All figures", cellSection(catalogue, csvName)},
      {"method", "Method", methodSection(catalogue)},
  };
  std::string contents, body;
  for (const Section &section : sections)
    if (!section.html.empty()) {
      contents += tag("li", {}, textTag("a", {{"href", "#" + std::string(section.id)}}, section.name));
      body += tag("div", {{"id", section.id}}, section.html);
    }
  return fill("page.html", {{"style", std::string(runtimeFile("style.css"))},
                            {"script", std::string(runtimeFile("report.js"))},
                            {"introduction", introductionSection(catalogue)},
                            {"contents", contents},
                            {"sections", body}});
}

} // namespace

Report makeReport(const std::vector<Cell> &cells, const ModelNotes &modelNotes, const std::string &csvName,
                  std::optional<SearchVerdict> own) {
  Report report;
  const Catalogue catalogue = makeCatalogue(cells, allVerdicts(cells, std::move(own)));
  const std::size_t taken = makePage(catalogue, {}, modelNotes, csvName).size();
  const std::size_t left = taken < kPageBytes ? kPageBytes - taken : 0;
  report.html = makePage(catalogue, loadPictures(cells, left, report.notes), modelNotes, csvName);
  report.csv = toCsv(catalogue);
  return report;
}

} // namespace voxc::report
