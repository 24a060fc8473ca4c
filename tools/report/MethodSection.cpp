// Introduction and method: what is compared, how it was measured, on what, and by which commands.
#include "report/FrontierChart.h"
#include "report/Html.h"
#include "report/Sections.h"
#include "report/Words.h"

#include <algorithm>
#include <set>

namespace voxc::report {
namespace {

/// Different texts of all entries, in their order, as items of a list.
template <typename TextOf> std::string differentItems(const Catalogue &catalogue, TextOf textOf) {
  std::string items;
  std::set<std::string> seen;
  for (const Entry &entry : catalogue.entries)
    if (const std::string text = textOf(entry); !text.empty() && seen.insert(text).second)
      items += tag("li", {}, text);
  return items;
}

/// Adds what is neither empty nor was said just now.
void append(std::string &text, const std::string &more) {
  if (!more.empty() && !text.ends_with(more))
    text += (text.empty() ? "" : ", ") + more;
}

std::string deviceItem(const Entry &entry) {
  const Cell &cell = *entry.cell;
  if (cell.device.name.empty())
    return {};
  std::string words;
  append(words, cell.device.kind == cell.device.name ? "" : cell.device.kind);
  append(words, cell.device.driver);
  append(words, cell.device.threads ? plural(static_cast<std::size_t>(*cell.device.threads), "thread") : "");
  append(words, entry.hasClock ? "speeds by its own timestamps" : "speeds by CPU seconds of the process");
  return textTag("b", {}, cell.device.name) + " " + escaped(words);
}

std::string makerItem(const Entry &entry) {
  const tool::bench::MadeByPart &maker = entry.cell->madeBy;
  std::string words = maker.voxc;
  append(words, maker.llvm.empty() ? "" : "LLVM " + maker.llvm);
  append(words, maker.processor);
  append(words, maker.cores ? plural(static_cast<std::size_t>(*maker.cores), "core") : "");
  return escaped(words);
}

std::string commandItem(const Entry &entry) {
  const std::string &command = entry.cell->madeBy.command;
  return command.empty() ? "" : textTag("code", {}, command);
}

std::string raysItem(const Entry &entry) {
  const tool::bench::RaysPart &rays = entry.cell->rays;
  if (rays.name.empty())
    return {};
  std::string words =
      countText(double(rays.count)) + " rays of a " + (rays.kind == "camera" ? "camera" : "file");
  if (rays.size)
    words +=
        ", " + std::to_string(rays.size->front()) + " × " + std::to_string(rays.size->back()) + " pixels";
  if (const auto &order = entry.cell->speed.order)
    words += *order == "binned" ? ", taken bin by bin" : ", taken as given";
  return textTag("b", {}, rays.name) + " " + escaped(words);
}

/// How far the speeds can be trusted, from what the records say of themselves.
std::string steadiness(const Catalogue &catalogue) {
  std::size_t speeds = 0, unsteady = 0;
  double widest = 0;
  for (const Entry &entry : catalogue.entries)
    if (entry.hasPoint()) {
      ++speeds;
      unsteady += !entry.isSteady;
      widest = std::max(widest, entry.speed->spread);
    }
  return plural(speeds, "speed") + ", the widest spread " + percentText(widest) + "; " +
         (unsteady == 0
              ? "all are within the spread that their commands state"
              : countText(double(unsteady)) + " of them are not steady: wider than their commands state");
}

} // namespace

std::string introductionSection(const Catalogue &catalogue) {
  const auto failed =
      std::ranges::count_if(catalogue.entries, [](const Entry &e) { return !e.cell->isMeasured(); });
  std::string devices;
  for (const std::string &device : catalogue.devices)
    append(devices, device);
  return fill(
      "section/introduction.html",
      {{"models", plural(catalogue.models.size(), "model")},
       {"formats", plural(catalogue.formats, "format")},
       {"cells", plural(catalogue.entries.size(), "measurement")},
       {"failed", failed > 0 ? countText(static_cast<double>(failed)) + " of them failed" : "none failed"},
       {"devices", escaped(devices)},
       {"marks", markDefinitions()}});
}

std::string methodSection(const Catalogue &catalogue) {
  std::vector<std::size_t> all(catalogue.entries.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = i;
  return fill("section/method.html", {{"devices", differentItems(catalogue, deviceItem)},
                                      {"makers", differentItems(catalogue, makerItem)},
                                      {"rays", differentItems(catalogue, raysItem)},
                                      {"commands", differentItems(catalogue, commandItem)},
                                      {"steadiness", escaped(steadiness(catalogue))},
                                      {"errors", escaped(errorSummary(catalogue, all))}});
}

} // namespace voxc::report
