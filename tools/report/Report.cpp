// Putting the sections into the page.
#include "report/Report.h"

#include "report/Html.h"
#include "report/RuntimeFile.h"
#include "report/Sections.h"
#include "report/Thumbnail.h"

#include <algorithm>
#include <map>

namespace voxc::report {
namespace {

/// What all pictures together may take of the page.
constexpr std::size_t kPictureBytes = 360'000;
constexpr std::size_t kMostOfOne = 90'000;

/// The first picture of each model.
std::map<std::string, std::string> picturePaths(const std::vector<Cell> &cells) {
  std::map<std::string, std::string> paths;
  for (const Cell &cell : cells)
    if (cell.model.picture)
      paths.try_emplace(cell.model.name, *cell.model.picture);
  return paths;
}

Pictures loadPictures(const std::vector<Cell> &cells, std::vector<std::string> &notes) {
  Pictures pictures;
  const auto paths = picturePaths(cells);
  for (const auto &[model, path] : paths) {
    Expected<std::string> picture = thumbnail(path, std::min(kMostOfOne, kPictureBytes / paths.size()));
    if (picture)
      pictures[model] = std::move(*picture);
    else
      notes.push_back(picture.error().message);
  }
  return pictures;
}

/// A section with its place in the list of contents, which it has if it is not empty.
struct Section {
  const char *id, *name;
  std::string html;
};

} // namespace

Report makeReport(const std::vector<Cell> &cells) {
  Report report;
  const Catalogue catalogue = makeCatalogue(cells);
  const Section sections[] = {
      {"models", "Models", modelSections(catalogue, loadPictures(cells, report.notes))},
      {"frontier", "Frontiers", frontierSection(catalogue)},
      {"dedup", "Sharing", dedupSection(catalogue)},
      {"restart", "Restarting", restartSection(catalogue)},
      {"precision", "Exactness", precisionSection(catalogue)},
      {"memory", "Memory", memorySection(catalogue)},
      {"failures", "Failures", failureSection(catalogue)},
      {"cells", "All figures", cellSection(catalogue)},
      {"method", "Method", methodSection(catalogue)},
  };
  std::string contents, body;
  for (const Section &section : sections)
    if (!section.html.empty()) {
      contents += tag("li", {}, textTag("a", {{"href", "#" + std::string(section.id)}}, section.name));
      body += tag("div", {{"id", section.id}}, section.html);
    }
  report.html = fill("page.html", {{"style", std::string(runtimeFile("style.css"))},
                                   {"script", std::string(runtimeFile("report.js"))},
                                   {"introduction", introductionSection(catalogue)},
                                   {"contents", contents},
                                   {"sections", body}});
  return report;
}

} // namespace voxc::report
