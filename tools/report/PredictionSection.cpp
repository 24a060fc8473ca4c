// What a search foretold beside what was measured: a chart a stage, and how right it was in words.
#include "plot/Scale.h"
#include "report/ChartFrame.h"
#include "report/Html.h"
#include "report/Prediction.h"
#include "report/Sections.h"
#include "report/Words.h"

#include <algorithm>

namespace voxc::report {
namespace {

using plot::coordinate;
using plot::Scale;

constexpr int kTicks = 5;
/// Points of the band differ by no more than this share of the measured speed.
constexpr double kBand = 0.1;

class Drawing {
public:
  Drawing(const Catalogue &catalogue, const Stage &stage, const std::vector<Prediction> &predictions)
      : catalogue_(catalogue), stage_(stage), predictions_(predictions),
        x_({"", plot::Spacing::Linear}, {mostSpeed()}, 0, 100, kTicks),
        y_({"", plot::Spacing::Linear}, {mostSpeed()}, kChartHeight, 0, kTicks) {}

  std::string draw() const {
    const std::string unit = speedUnit(stage_.hasClock);
    std::string content = textTag("title", {}, stageTitle(stage_) + ": speeds foretold and measured") +
                          axes(x_, y_, "foretold", unit + " measured") + band();
    for (const Prediction &prediction : predictions_)
      content += point(prediction);
    return chartElement(predictions_.size(), content);
  }

private:
  double mostSpeed() const {
    double most = 0;
    for (const Prediction &prediction : predictions_)
      most = std::max({most, prediction.foretold, prediction.measured});
    return most;
  }

  /// The line on which speeds are as they were foretold, and what lies close to it.
  std::string band() const {
    const std::string height = coordinate(kChartHeight);
    const std::string up = coordinate(100 * (1 - kBand)),
                      down = coordinate(kChartHeight * (1 - 1 / (1 + kBand)));
    return tag(
        "svg",
        {{"width", "100%"},
         {"height", height},
         {"viewBox", "0 0 100 " + height},
         {"preserveAspectRatio", "none"}},
        tag("path", {{"class", "dominated"}, {"d", "M0," + height + "L" + up + ",0H100V" + down + "Z"}}, "") +
            tag("path", {{"class", "frontier"}, {"d", "M0," + height + "L100,0"}}, ""));
  }

  std::string point(const Prediction &prediction) const {
    const Entry &entry = *prediction.entry;
    const std::string x = fineShare(x_.place(prediction.foretold));
    const std::string y = coordinate(y_.place(prediction.measured));
    const std::string note = entry.name + "\n" + numberText(prediction.foretold) + " foretold, " +
                             numberText(prediction.measured) + " measured: off by " +
                             percentText(prediction.error()) + "\n" + standingWords(catalogue_, entry);
    const std::string style =
        "point f" + std::to_string(entry.look.family) + (entry.isLeading() ? " on" : "");
    return tag("a",
               {{"class", style},
                {"href", "#" + rowId(catalogue_, entry)},
                {"data-variant", std::to_string(entry.variant)}},
               textTag("title", {}, note) +
                   tag("use",
                       {{"href", markReference(entry.look.family, isCrowded(predictions_.size()))},
                        {"x", x},
                        {"y", y}},
                       ""));
  }

  const Catalogue &catalogue_;
  const Stage &stage_;
  const std::vector<Prediction> &predictions_;
  Scale x_;
  Scale y_;
};

std::string speedSentence(const std::vector<Prediction> &predictions) {
  const std::optional<double> order = rankCorrelation(predictions);
  return plural(predictions.size(), "speed") + ": median error " + percentText(medianError(predictions)) +
         (order ? ", rank correlation " + numberText(*order) : "") + ".";
}

std::string wordSentence(const WordPredictions &words) {
  if (words.all == 0)
    return {};
  if (words.exact == words.all)
    return " All " + plural(words.all, "size") + " are as foretold, to the word.";
  return " Of " + plural(words.all, "size") + " " + countText(double(words.exact)) +
         " are as foretold, to the word; the others are off by " + plural(words.worst, "word") + " at most.";
}

/// Who was misjudged most, for a reader who wants to know where not to trust it.
std::string worstSentence(const std::vector<Prediction> &predictions) {
  const auto worst = std::ranges::max_element(predictions, {}, &Prediction::error);
  return " Furthest off: " + worst->entry->name + ", " + numberText(worst->foretold) + " foretold and " +
         numberText(worst->measured) + " measured.";
}

std::string figure(const Catalogue &catalogue, const Stage &stage) {
  const std::vector<Prediction> predictions = predictionsOf(catalogue, stage);
  if (predictions.size() < 2)
    return {};
  const std::string words = speedSentence(predictions) + wordSentence(wordPredictionsOf(catalogue, stage)) +
                            worstSentence(predictions);
  return tag("figure", {{"class", "stage prediction"}},
             tag("figcaption", {}, textTag("b", {}, stage.model + ", " + stageTitle(stage))) +
                 Drawing(catalogue, stage, predictions).draw() +
                 textTag("p", {{"class", "remarks"}}, words)) +
         "\n";
}

} // namespace

std::string predictionSection(const Catalogue &catalogue) {
  std::string content;
  for (const Stage &stage : catalogue.stages)
    content += figure(catalogue, stage);
  return content.empty() ? "" : fill("section/predictions.html", {{"content", content}});
}

} // namespace voxc::report
